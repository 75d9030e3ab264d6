// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_OPTIMIZATION_PATCH_MOVER_H
#define VCG_EXTRAS_CORE_OPTIMIZATION_PATCH_MOVER_H

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/features/boundary_curves.h>
#include <vcg_extras/core/mesh/connect.h>
#include <vcg_extras/core/surface/cells.h>
#include <vcg_extras/core/surface/result_mesh.h>
#include <vcg_extras/core/surface/surface_point.h>

#include <array>
#include <map>
#include <vector>

namespace gpr {

/// Cells of the faces of a result that may have changed since they were found.
struct CellsOfFaces {
	const Cells&     cells;
	std::vector<int> cell; ///< per face: the face whose cells it has now, -1: none; empty: its own
	float            largestGap = 0; ///< largest distance between result and input, if known

	int of(int f) const { return cell.empty() ? f : cell[f]; }
};

/// What changes of single patches for the sake of their angles share: what a patch' angles lack,
/// how far it leaves the surface, and the moves of its vertices. Vertices move along the surface,
/// those of curves along these, and keep their height above it; corners of curves, tips and pinned
/// ones stay altogether.
class PatchMover {
protected:
	/// `angle` in radians; room for so many more vertices is made.
	PatchMover(const Surface& surface, const BoundaryCurves& curves, float angle,
			   ResultMesh& result, Workers& workers, const CellsOfFaces& cells, int spare = 0);

	/// What faces lack in angle, and how well they lie on the surface.
	struct Quality {
		float cost      = 0;
		float agreement = 1;

		bool beats(const Quality& other) const;
	};

	/// How far vertices of the input lie from some faces.
	struct Distance {
		float  farthest = 0;
		double fourthPowers =
			0; ///< their sum, small distances counting alike; 0 if largestGap is not known

		/// Whether nothing has got farther off than `before`, neither the farthest nor those far.
		bool keeps(const Distance& before) const;
	};

	/// A vertex with what moves along.
	struct Place {
		Vec3f        position, normal;
		ResultVertex record;
	};

	/// The surface round a change may come to lie this share of an edge away, or as far as before.
	static constexpr float farthestOff = 0.05f;

	const Surface&        surface_;
	const BoundaryCurves& curves_;
	float                 angle_;
	ResultMesh&           r_;
	HalfEdgeMesh&         m_;
	Workers&              workers_;
	const CellsOfFaces&   cells_;
	int                   faceNum_; ///< at the start
	Buffer<Vec3f>         startPosition_;
	Buffer<Vec3f>         startNormal_, normal_; ///< of the surface at the vertices
	std::vector<char>     blocked_;              ///< vertices that are left alone
	/// Whether the fourth power of what angles lack is their cost, which presses the worst one, in
	/// place of the second: what is stuck by the one may move on by the other.
	bool worstFirst_ = false;

	/// What belongs to a face that is no more counts for another one from here on.
	void handCellsOn(int dead, int heir);
	/// Back to those of the start.
	void    resetNormals();
	Quality ringQuality(int v) const;
	/// Of the faces' sum.
	Quality patchQuality(const std::vector<int>& faces) const;
	/// How far the input's vertices in the cells of some faces lie from the nearest of `faces`.
	float farthestFrom(const std::vector<int>& faces, const std::vector<int>& ofCells) const;
	/// The distances of the input's vertices in the cells of some faces from the nearest of
	/// `faces`; those nearer than `enough` count as if they lay there.
	Distance distanceFrom(const std::vector<int>& faces, const std::vector<int>& ofCells,
						  float enough) const;
	/// Whether these keep what they were `before`. Cost: up to the first vertex that tells.
	bool keepsDistance(const std::vector<int>& faces, const std::vector<int>& ofCells, float enough,
					   const Distance& before) const;
	/// The root of the mean square of the same distances.
	float rmsFrom(const std::vector<int>& faces, const std::vector<int>& ofCells) const;
	float leastAngleOf(const std::vector<int>& faces) const;
	float meanEdge(int v) const;
	Place placeOf(int v) const;
	/// Of the surface at v, standing there, or of that beside the lip it lies on.
	Vec3f normalAt(int v, const Anchor& anchor) const;
	void  put(int v, const Place& p);
	/// Moves v to better places as long as there are any; true if it moved.
	bool moveToBest(int v);
	/// The ends of h and the corners beyond; h must be an inner edge.
	std::array<int, 4> cornersAt(int h) const;
	bool               mayMove(int v) const;
	/// Where v gets by a step of this length: along its curve, or over the surface.
	std::vector<Place> placesRound(int v, float reach, float edge) const;
	/// Whether the flip of h is allowed, leaves every vertex enough faces for good angles, and
	/// moves the surface little.
	bool mayFlip(int h) const;

private:
	std::map<int, std::vector<int>> handedOn_; ///< per face: cells besides its own

	/// Until a visit returns false.
	template <class Visit>
	void forCellVertices(const std::vector<int>& ofCells, const Visit& visit) const;
	/// False if a visit returned it.
	template <class Visit>
	bool visitCell(int cell, const Visit& visit) const;
	void addFace(int f, Quality& sum) const;
	/// As above, or until they do not keep `most` any more.
	Distance distanceFrom(const std::vector<int>& faces, const std::vector<int>& ofCells,
						  float enough, const Distance& most) const;
	bool     step(int v, float reach, float edge, Quality& quality);
	template <class Offer>
	void offerSlides(int v, float reach, const Offer& offer) const;
	/// v as high above its anchor as it is now.
	Place movedTo(int v, const ResultVertex& record) const;
	bool  isNearStart(int v, const Place& place, float edge) const;
	/// How far apart the diagonals of the faces on both sides of h lie.
	float gapOfDiagonals(int h) const;
	/// Three faces round an inner vertex have an angle of 30° at the most where one is small.
	bool maySpareFace(int v) const;
};

} // namespace gpr

#endif
