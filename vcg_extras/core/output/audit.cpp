// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "audit.h"

#include "face_point.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/surface/junctions.h>
#include <vcg_extras/core/surface/normal_agreement.h>

#include <algorithm>
#include <array>

namespace gpr {

namespace {

/// The counts of a part of a mesh.
struct Findings : AuditFigures {
	std::int64_t corners = 0; ///< of the faces round the vertices

	Findings& operator+=(const Findings& o)
	{
		nonManifoldEdges += o.nonManifoldEdges;
		nonManifoldVertices += o.nonManifoldVertices;
		duplicateFaces += o.duplicateFaces;
		zeroAreaFaces += o.zeroAreaFaces;
		invertedFaces += o.invertedFaces;
		nonFinitePositions += o.nonFinitePositions;
		corners += o.corners;
		return *this;
	}
};

bool isSoundHalfEdge(const HalfEdgeMesh& m, int h)
{
	const int a = m.origin[h], b = m.target(h), g = m.opposite[h];
	if (a == b || a < 0 || a >= m.vertexNum) return false;
	if (g < 0) return true;
	return g < m.halfEdgeNum() && m.opposite[g] == h && m.origin[g] == b && m.target(g) == a;
}

/// Whether the star of v is a single fan of v's own half-edges, with every neighbour once.
bool isSoundVertex(const HalfEdgeMesh& m, int v, std::vector<int>& ring, std::int64_t& corners)
{
	ring.clear();
	const int first = m.outgoing[v];
	if (first < 0 || first >= m.halfEdgeNum()) return false;
	int h = first;
	do {
		if (m.origin[h] != v) return false;
		ring.push_back(m.target(h));
		++corners;
		const int in = prevInFace(h);
		h            = m.opposite[in];
		if (h < 0) ring.push_back(m.origin[in]);
		if (ring.size() > std::size_t(m.halfEdgeNum())) return false;
	} while (h >= 0 && h != first);
	std::sort(ring.begin(), ring.end());
	return std::adjacent_find(ring.begin(), ring.end()) == ring.end();
}

/// Whether a face before f has the same three vertices, in a table without faults. Two such faces
/// then share an edge, or one of their vertices would have a neighbour twice.
bool isDuplicate(const HalfEdgeMesh& m, int f)
{
	for (int h = 3 * f; h < 3 * f + 3; ++h) {
		const int g = m.opposite[h];
		if (g >= 0 && g / 3 < f && m.apex(g) == m.apex(h)) return true;
	}
	return false;
}

/// The number of duplicate faces, in any table.
std::int64_t countDuplicateFaces(const HalfEdgeMesh& m)
{
	std::vector<std::array<int, 3>> faces(m.faceNum);
	for (int f = 0; f < m.faceNum; ++f) {
		std::copy_n(&m.origin[3 * f], 3, faces[f].begin());
		std::sort(faces[f].begin(), faces[f].end());
	}
	std::sort(faces.begin(), faces.end());
	std::int64_t num = 0;
	for (std::size_t i = 1; i < faces.size(); ++i)
		num += faces[i] == faces[i - 1];
	return num;
}

void checkFace(const HalfEdgeMesh& m, const Buffer<Vec3f>& smoothNormal, int f, Findings& found)
{
	int badNum = 0;
	for (int h = 3 * f; h < 3 * f + 3; ++h)
		badNum += !isSoundHalfEdge(m, h);
	found.nonManifoldEdges += badNum;
	if (badNum > 0) return; // its corners may be no vertices
	found.duplicateFaces += isDuplicate(m, f);
	if (hasZeroArea(m.faceCross(f)))
		++found.zeroAreaFaces;
	else
		found.invertedFaces += normalAgreement(m, smoothNormal, f) < 0;
}

/// Counts inverted faces among faces with a normal against the mean normal of their corners. The
/// mean is not the normal of the assigned points at a fold, a thin rim or a spike.
std::int64_t invertedAmongSuspects(const Surface& surface, const ResultMesh& r,
								   const Buffer<Vec3f>& normals, Workers& workers)
{
	const std::vector<int> suspects = workers.collectIf(std::size_t(r.mesh.faceNum), [&](int f) {
		return !hasZeroArea(r.mesh.faceCross(f)) && normalAgreement(r.mesh, normals, f) < 0;
	});
	return std::count_if(suspects.begin(), suspects.end(),
						 [&](int f) { return isInverted(surface, r, f); });
}

/// Whether points and lines of the junctions are the same, with as many sheets, and no edge or face
/// would coincide with another after joining.
bool areJunctionsKept(const Surface& surface, const ResultMesh& r, Workers& workers)
{
	const Junctions before(surface.mesh, surface.meetings, workers);
	const Junctions after(r.mesh, surface.meetings, workers);
	return after.isSameAs(before) && after.copyNum() == r.copyNum &&
		   after.falseEdges(workers).empty() && !after.hasTwinFaces(workers);
}

/// The failed checks, without the check of the count.
std::string faultsOf(const AuditFigures& a)
{
	std::string what;
	const auto  add = [&](bool failed, const std::string& phrase) {
        if (failed) what += (what.empty() ? "" : ", ") + phrase;
	};
	add(a.nonManifoldEdges > 0, "non-manifold edges");
	add(a.nonManifoldVertices > 0, "non-manifold vertices");
	add(a.duplicateFaces > 0, std::to_string(a.duplicateFaces) + " duplicate faces");
	add(a.zeroAreaFaces > 0, std::to_string(a.zeroAreaFaces) + " degenerate faces");
	add(a.nonFinitePositions > 0, "non-finite coordinates");
	add(!a.componentsKept, "another number of components");
	add(!a.boundaryLoopsKept, "another number of border loops");
	add(!a.eulerKept, "another Euler characteristic");
	add(!a.junctionsKept, "other junctions");
	return what;
}

} // namespace

AuditFigures audit(const Surface& surface, const ResultMesh& r, const MeshFigures& input,
				   const MeshFigures& output, std::int64_t targetNum, Workers& workers)
{
	const HalfEdgeMesh& m       = r.mesh;
	const Buffer<Vec3f> normals = smoothNormals(surface, r, workers);
	Findings            found   = workers.sumEach<Findings>(
        m.faceNum, [&](int f, Findings& part) { checkFace(m, normals, f, part); });
	// Wrong half-edges could lead the walks round vertices astray.
	if (found.nonManifoldEdges == 0) {
		found += workers.sum<Findings>(m.vertexNum, [&](std::size_t begin, std::size_t end) {
			Findings         part;
			std::vector<int> ring;
			for (int v = int(begin); v < int(end); ++v) {
				part.nonManifoldVertices += !isSoundVertex(m, v, ring, part.corners);
				part.nonFinitePositions += !isFinite(m.position[v]);
			}
			return part;
		});
		// A corner out of reach of these walks belongs to a second fan.
		if (found.corners != m.halfEdgeNum()) ++found.nonManifoldVertices;
	}
	if (found.nonManifoldEdges > 0 || found.nonManifoldVertices > 0)
		found.duplicateFaces = countDuplicateFaces(m);
	else if (found.invertedFaces > 0)
		found.invertedFaces = invertedAmongSuspects(surface, r, normals, workers);
	found.componentsKept    = input.components == output.components;
	found.boundaryLoopsKept = input.boundaryLoops == output.boundaryLoops;
	found.eulerKept         = input.eulerCharacteristic == output.eulerCharacteristic;
	found.countExact        = targetNum == r.vertexNum();
	found.junctionsKept     = !m.meetsAtPlaces || areJunctionsKept(surface, r, workers);
	found.passed            = faultsOf(found).empty() && (targetNum == 0 || found.countExact);
	return found;
}

std::string describeFailure(const AuditFigures& a)
{
	if (a.passed) return "";
	std::string what = faultsOf(a);
	if (what.empty()) what = "another number of vertices than promised";
	return "The result was withheld because it has " + what + ".";
}

} // namespace gpr
