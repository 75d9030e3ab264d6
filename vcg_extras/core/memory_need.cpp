// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory_need.h"

#include "failure.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gpr {

namespace {

/// Into how many parts an edge is halved until none is longer than maxLength.
double partsOfEdge(float length, float maxLength)
{
	if (!(length > maxLength)) return 1;
	return std::exp2(std::ceil(std::log2(double(length) / double(maxLength))));
}

/// Three faces come of one, time and again, where only the shortest edge is short enough.
double partsOfNeedle(double edgeParts)
{
	return std::exp2(std::log2(edgeParts) * std::log2(3.0));
}

/// All three edges are halved as long as the shortest is too long, then the longer two, then one.
double partsOfFace(const IndexedMesh& m, int f, float maxLength)
{
	const int*  t = &m.triangle[3 * f];
	const Vec3f a = m.position[t[0]], b = m.position[t[1]], c = m.position[t[2]];
	float       edge[3] = {length(b - a), length(c - b), length(a - c)};
	std::sort(edge, edge + 3);
	const double least  = partsOfEdge(edge[0], maxLength);
	const double middle = partsOfEdge(edge[1], maxLength);
	return least * least * partsOfNeedle(middle / least) * partsOfEdge(edge[2], maxLength) / middle;
}

} // namespace

double facesAfterSplitting(const IndexedMesh& mesh, const std::vector<int>& longFaces,
						   float maxLength)
{
	double faces = double(mesh.faceNum) - double(longFaces.size());
	for (int f : longFaces)
		faces += partsOfFace(mesh, f, maxLength);
	return faces;
}

double bytesNeeded(double faceNum, double resultVertexNum)
{
	// Fitted to the peak memory of runs with 3·10⁵ to 1.3·10⁷ faces after the splitting and 10⁴ to
	// 1.3·10⁶ vertices in the result, which they meet within a sixth.
	constexpr double bytesPerFace         = 90;
	constexpr double bytesPerResultVertex = 250;
	return bytesPerFace * faceNum + bytesPerResultVertex * resultVertexNum;
}

void requireMemory(double needed, std::int64_t available)
{
	if (available <= 0 || needed <= double(available)) return;
	char sentence[160];
	std::snprintf(sentence, sizeof sentence,
				  "About %.1f GB of memory would be needed, %.1f GB are free; ask for fewer "
				  "vertices, or remove huge stray triangles.",
				  needed * 1e-9, double(available) * 1e-9);
	throw Failure(Status::OutOfMemory, sentence);
}

} // namespace gpr
