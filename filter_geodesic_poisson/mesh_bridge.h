// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_MESH_BRIDGE_H
#define FILTER_GEODESIC_POISSON_MESH_BRIDGE_H

// Between MeshLab's mesh and the engine's flat arrays.

#include "layer_marks.h"
#include "meshlab_api.h"

#include <vcg_extras/complex/algorithms/attribute_transfer.h>
#include <vcg_extras/core/remesh.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace gpr_filter {

/// The copied parts of a mesh beside its vertices and faces.
struct CopiedParts {
	bool selection     = false; ///< of the vertices
	bool facesCorners  = false; ///< without selected vertices, the corners of selected faces
	bool faceSelection = false;
	bool texture       = false; ///< texture coordinates of the wedges
	bool edgeSelection = false; ///< of the faces' edges
};

/// A copy of a layer for the engine, without deleted elements.
/// A copy and no view: while the filter runs, the host's progress bar lets the user start other
/// filters on the same layer, which may move its vectors under the engine's threads.
struct LayerCopy {
	std::vector<gpr::Vec3<Scalarm>> positions;
	std::vector<std::int32_t>       triangles;     ///< 3 indices a face
	std::vector<std::uint8_t>       selected;      ///< one a vertex, or none; 1 = selected
	std::vector<std::uint8_t>       selectedFaces; ///< one a face, or none; 1 = selected
	std::vector<std::uint8_t> selectedEdges; ///< one a corner, or none; with the texture's seams

	std::shared_ptr<const gpr::TextureSource> texture; ///< of the wedges, or null

	LayerRegions       regions; ///< of the faces
	std::vector<float> sizes;   ///< wanted edge lengths, one a vertex, or none

	gpr::MeshView view() const;
	/// Bit by bit, so that a NaN equals itself.
	bool sameGeometry(const LayerCopy& other) const;
	bool anyFaceSelected() const;
};

LayerCopy copyLayer(const CMeshO& mesh, const CopiedParts& parts);

/// Whether points of a mesh with the transform `from` can be brought into the frame of a mesh with
/// the transform `to`: both are finite and `to` has an inverse.
bool canReach(const Matrix44m& to, const Matrix44m& from);

/// The vertices of a mesh in the frame of another, which has the transform `frame`. With equal
/// transforms they are the same numbers.
std::vector<gpr::Vec3d> copyPoints(const CMeshO& mesh, const Matrix44m& frame);

/// The named attributes of a mesh, read at surface points.
using UserAttributes = vcg::tri::gpr_detail::CarriedUserAttributes<CMeshO>;

/// Fills an empty mesh with the result. Vertex and face attributes are carried over from `source`,
/// the mesh of `copy` with the same vertices and faces still, and their optional components are
/// enabled; named attributes go to `user`. After a run on a selection, new faces are selected.
/// Normals and box are not computed. Throws std::bad_alloc only.
void buildMesh(const gpr::RemeshResult& result, const LayerCopy& copy, const CMeshO& source,
			   CMeshO& built, UserAttributes& user);

/// Fills an empty mesh with the samples as vertices: quality is the disk's radius, the normal the
/// normal of the face below the sample; the colour of `source`, the mesh of `copy`, is
/// interpolated. The box is not computed. Throws std::bad_alloc only.
void buildPoints(const gpr::SamplingResult& result, const LayerCopy& copy, const CMeshO& source,
				 CMeshO& built);

/// Fills an empty mesh with a mesh as it is. Throws std::bad_alloc only.
void buildPlain(const gpr::TriangleMesh& mesh, CMeshO& built);

/// Makes figures, one a face, the faces' quality, and their colour: red at `red` over green to blue
/// at `blue`. Both optional components must be enabled.
void colourFaces(const std::vector<float>& figures, double red, double blue, CMeshO& mesh);

/// The transform that puts a copy of a mesh `place` widths and a little beside it, along x.
Matrix44m movedAside(const CMeshO& mesh, int place);

/// Gives the copied mesh its features: strengths as vertex quality; marked vertices and no others
/// are selected. Faces keep their selection, which means the part to remesh alone. Needs no memory.
void markFeatures(const gpr::FeatureResult& result, CMeshO& mesh);

/// Puts the vertices and faces of `built`, with their optional components, in the place of the
/// elements of `layer`, and removes the old edges and per-element attributes. Needs no memory, so
/// the call does not fail half-way.
void replaceContents(CMeshO& layer, CMeshO& built);

/// Whether a transform scales by more than 2 % differently in different directions, or shears.
bool scalesUnevenly(const Matrix44m& transform);

} // namespace gpr_filter

#endif
