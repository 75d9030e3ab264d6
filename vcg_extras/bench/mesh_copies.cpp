// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_copies.h"

#include <algorithm>

namespace gpr::bench {

namespace {

template <class T>
Buffer<T> copyOf(const Buffer<T>& buffer)
{
	Buffer<T> copy(buffer.size());
	std::copy(buffer.begin(), buffer.end(), copy.begin());
	return copy;
}

} // namespace

HalfEdgeMesh copyOf(const HalfEdgeMesh& mesh)
{
	HalfEdgeMesh copy;
	copy.vertexNum = mesh.vertexNum;
	copy.faceNum   = mesh.faceNum;
	copy.position  = copyOf(mesh.position);
	copy.origin    = copyOf(mesh.origin);
	copy.opposite  = copyOf(mesh.opposite);
	copy.outgoing  = copyOf(mesh.outgoing);
	if (mesh.hasCreases()) copy.crease = copyOf(mesh.crease);
	return copy;
}

ResultMesh copyOf(const ResultMesh& result)
{
	ResultMesh copy;
	copy.mesh      = copyOf(result.mesh);
	copy.vertex    = result.vertex;
	copy.idealEdge = result.idealEdge;
	return copy;
}

} // namespace gpr::bench
