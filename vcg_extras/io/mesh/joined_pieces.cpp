// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "joined_pieces.h"

#include <vcg_extras/core/base/triangle.h>
#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/triangle_tree.h>

#include <algorithm>
#include <map>

namespace gpr::app {

namespace {

constexpr std::int32_t none = -1;

Vec3d corner(const MeshView& mesh, std::int32_t face, int k)
{
	return mesh.position(std::size_t(mesh.triangle(std::size_t(face))[std::size_t(k)]));
}

/// The point of a face nearest to p.
BarycentricPoint nearestOnFace(const MeshView& mesh, std::int32_t face, const Vec3d& p)
{
	const Vec3f      a(corner(mesh, face, 0) - p), b(corner(mesh, face, 1) - p);
	const Vec3f      c(corner(mesh, face, 2) - p);
	const auto       weight = weightsAt(nearestOnTriangle(Vec3f(), a, b, c), a, b, c);
	BarycentricPoint at;
	at.face = face;
	std::copy(weight.begin(), weight.end(), at.weight);
	return at;
}

/// A list for all pieces, or an empty list if no piece has a list; pieces without a list have
/// `missing` for each element.
template <class T>
void append(const T* values, std::size_t num, std::size_t before, T missing, std::vector<T>& all)
{
	if (values == nullptr && all.empty()) return;
	all.resize(before, missing);
	if (values != nullptr) all.insert(all.end(), values, values + num);
	all.resize(before + num, missing);
}

} // namespace

JoinedPieces::JoinedPieces(std::vector<MeshView> pieces) : piece_(std::move(pieces))
{
	for (std::size_t k = 0; k < piece_.size(); ++k)
		add(k);
	firstFace_.push_back(std::int32_t(whole_.region.size()));
	firstVertex_.push_back(std::int32_t(whole_.positions.size()));
}

void JoinedPieces::add(std::size_t k)
{
	const MeshView&   piece  = piece_[k];
	const std::size_t before = whole_.positions.size();
	firstFace_.push_back(std::int32_t(whole_.region.size()));
	firstVertex_.push_back(std::int32_t(before));
	append(piece.line, 3 * piece.faceNum, 3 * whole_.region.size(), std::uint8_t(0), whole_.line);
	append(piece.selected, piece.vertexNum, before, std::uint8_t(0), whole_.selected);
	append(piece.wantedEdge, piece.vertexNum, before, 0.0f, whole_.wantedEdge);
	for (std::size_t v = 0; v < piece.vertexNum; ++v)
		whole_.positions.push_back(piece.position(v));
	for (std::size_t c = 0; c < 3 * piece.faceNum; ++c)
		whole_.triangles.push_back(piece.vertexOf(c) + std::int32_t(before));
	addRegions(k);
}

void JoinedPieces::addRegions(std::size_t k)
{
	const MeshView&                      piece = piece_[k];
	std::map<std::int32_t, std::int32_t> partOf; ///< by the piece's label
	for (std::size_t f = 0; f < piece.faceNum; ++f) {
		const std::int32_t label = piece.region == nullptr ? 0 : piece.region[f];
		const auto         found = partOf.emplace(label, std::int32_t(part_.size()));
		if (found.second) {
			const bool hasName = piece.region != nullptr && piece.regionNames != nullptr &&
								 std::size_t(label) < piece.regionNames->size();
			part_.push_back({k, label});
			names_.push_back(hasName ? (*piece.regionNames)[std::size_t(label)]
									 : "piece " + std::to_string(k + 1));
		}
		whole_.region.push_back(found.first->second);
	}
}

MeshView JoinedPieces::view() const
{
	MeshView v    = whole_.view();
	v.regionNames = &names_;
	return v;
}

bool JoinedPieces::hasFace(std::size_t k, std::int32_t face) const
{
	return face >= firstFace_[k] && face < firstFace_[k + 1];
}

RemeshResult JoinedPieces::ofPiece(const RemeshResult& whole, std::size_t k) const
{
	RemeshResult              part;
	std::vector<std::int32_t> newNumber(whole.mesh.vertexNum(), none);
	part.status     = whole.status;
	part.report     = whole.report;
	const auto take = [&](std::int32_t v) {
		std::int32_t& number = newNumber[std::size_t(v)];
		if (number != none) return number;
		number = std::int32_t(part.mesh.vertexNum());
		part.mesh.positions.push_back(whole.mesh.positions[std::size_t(v)]);
		if (!whole.surfacePoints.empty())
			part.surfacePoints.push_back(whole.surfacePoints[std::size_t(v)]);
		if (!whole.callersVertex.empty()) {
			const std::int32_t own   = whole.callersVertex[std::size_t(v)] - firstVertex_[k];
			const bool         isOwn = own >= 0 && std::size_t(own) < piece_[k].vertexNum;
			part.callersVertex.push_back(isOwn ? own : none);
		}
		return number;
	};
	for (std::size_t f = 0; f < whole.mesh.faceNum(); ++f) {
		const Part& region = part_[std::size_t(whole.region[f])];
		if (region.piece != k) continue;
		for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
			part.mesh.triangles.push_back(take(whole.mesh.triangles[c]));
		if (piece_[k].region != nullptr) part.region.push_back(region.label);
		if (whole.facePoints.empty()) continue;
		part.facePoints.push_back(whole.facePoints[f]);
		part.facePoints.back().face -= firstFace_[k];
	}
	movePoints(part.mesh, k, part.surfacePoints);
	turnAsPiece(k, part);
	return part;
}

void JoinedPieces::movePoints(const TriangleMesh& mesh, std::size_t k,
							  std::vector<BarycentricPoint>& points) const
{
	if (points.empty()) return;
	Workers            workers(1, nullptr);
	const MeshView&    piece = piece_[k];
	const Vec3d        origin(mesh.positions[0]); // finite, as all of a result
	const TriangleTree tree(piece, origin, workers);
	for (std::size_t v = 0; v < points.size(); ++v) {
		if (hasFace(k, points[v].face)) {
			points[v].face -= firstFace_[k];
			continue;
		}
		const Vec3d& p = mesh.positions[v];
		points[v]      = nearestOnFace(piece, tree.nearestFace(p - origin), p);
	}
}

/// Sewing turns pieces over so that neighbours agree.
void JoinedPieces::turnAsPiece(std::size_t k, RemeshResult& part) const
{
	double agreement = 0;
	for (std::size_t f = 0; f < part.facePoints.size(); ++f) {
		const Vec3d made = part.mesh.view().faceCross(f);
		const Vec3d own  = piece_[k].faceCross(std::size_t(part.facePoints[f].face));
		agreement += dot(made, own) / std::max(1e-300, length(own));
	}
	if (agreement >= 0) return;
	for (std::size_t f = 0; f < part.mesh.faceNum(); ++f)
		std::swap(part.mesh.triangles[3 * f + 1], part.mesh.triangles[3 * f + 2]);
}

} // namespace gpr::app
