// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory_need.h"

#include "split_long_edges.h"

#include <vcg_extras/core/base/failure.h>
#include <vcg_extras/core/results.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace gpr {

namespace {

/// Number of times to halve an edge and its parts until no part is longer than maxLength.
int halvingsOfEdge(float length, float maxLength)
{
	constexpr int most = 300; // more than between any two floats
	int           num  = 0;
	for (double part = double(length); part > double(maxLength) && num < most; part *= 0.5)
		++num;
	return num;
}

/// The edges of a face by length, and the distance of the third corner from the longest edge.
struct FaceShape {
	float edge[3];
	float height;

	FaceShape(const IndexedMesh& m, int f)
	{
		const int*  t = &m.triangle[3 * f];
		const Vec3f a = m.position[t[0]], b = m.position[t[1]], c = m.position[t[2]];
		edge[0] = length(b - a);
		edge[1] = length(c - b);
		edge[2] = length(a - c);
		std::sort(edge, edge + 3);
		height = edge[2] > 0 ? length(cross(b - a, c - a)) / edge[2] : 0;
	}

	bool isNeedle(float maxLength) const
	{
		return edge[2] > minNeedleLength * maxLength && 2 * height <= maxLength;
	}
};

/// Estimates the parts of a face as splitLongEdges makes them: all edges are halved while the
/// shortest edge is too long; a needle becomes a strip; any other face with a short edge becomes
/// three faces, again and again.
double partsOfFace(const FaceShape& shape, float maxLength)
{
	double parts = 1;
	for (; shape.edge[0] > maxLength && !shape.isNeedle(maxLength); parts *= 4)
		maxLength *= 2; // exactly as good as to halve the face
	const int    halvings = halvingsOfEdge(shape.edge[1], maxLength);
	const double middle   = std::ldexp(1.0, halvings);
	const double longest  = std::ldexp(1.0, halvingsOfEdge(shape.edge[2], maxLength));
	if (shape.isNeedle(maxLength)) return 2.5 * parts * longest;
	if (longest > minNeedleLength) return 2 * parts * (middle + longest);
	for (int i = 0; i < halvings; ++i)
		parts *= 3;
	return parts * longest / middle;
}

} // namespace

double facesAfterSplitting(const IndexedMesh& mesh, const std::vector<int>& longFaces,
						   float maxLength)
{
	double faces = double(mesh.faceNum) - double(longFaces.size());
	for (int f : longFaces)
		faces += partsOfFace(FaceShape(mesh, f), maxLength);
	return faces;
}

double bytesNeeded(double faceNum, double resultVertexNum)
{
	// Fitted to the peak memory of runs with 3·10⁵ to 1.3·10⁷ faces after splitting and 10⁴ to
	// 1.3·10⁶ vertices in the result; all within a sixth.
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
