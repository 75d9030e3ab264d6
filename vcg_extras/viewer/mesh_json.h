// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_VIEWER_MESH_JSON_H
#define VCG_EXTRAS_VIEWER_MESH_JSON_H

#include "shown_mesh.h"

#include <vcg_extras/core/base/workers.h>
#include <vcg_extras/core/surface/surface_distance.h>
#include <vcg_extras/io/report/json_parts.h>

#include <string_view>

namespace gpr::app {

constexpr std::size_t mostFacesShown = 300000; ///< of each mesh: some 8 MB of a page

/// Meshes in the format of viewer.js, all in the frame of the input.
class MeshJson {
public:
	/// The conversion of an array's bytes to JSON.
	using Pack = Json (*)(std::string_view bytes);

	/// diagonal: mesh units; distances are in percent of the diagonal. The workers must outlive
	/// this object.
	MeshJson(const MeshView& input, double diagonal, Workers& workers, Pack pack);

	/// A mesh with the shape of its triangles. Cost: linear.
	Json ofMesh(const std::string& key, const std::string& name, const MeshView& mesh) const;
	/// The same with the distances of its triangles from the input. Cost: seven searches for each
	/// shown triangle, parallel.
	Json ofResult(const std::string& key, const std::string& name, const MeshView& mesh,
				  const MeasuredSurface& input) const;

private:
	ShownFrame frame_;
	double     diagonal_;
	Workers&   workers_;
	Pack       pack_;

	template <class Value>
	Json packed(const std::vector<Value>& values) const;
	Json jsonOf(const std::string& key, const std::string& name, const MeshView& mesh,
				const ShownMesh& shown) const;
	Json worstJson(const MeshView& mesh, const std::vector<float>& ratios) const;
	Json farthestJson(const MeshView& mesh, std::size_t face, const FarthestPoint& point) const;
};

} // namespace gpr::app

#endif
