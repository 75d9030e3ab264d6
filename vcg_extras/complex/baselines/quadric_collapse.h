// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_COMPLEX_BASELINES_QUADRIC_COLLAPSE_H
#define VCG_EXTRAS_COMPLEX_BASELINES_QUADRIC_COLLAPSE_H

#include <vcg_extras/core/mesh_view.h>

#include <cstdint>
#include <functional>
#include <memory>

namespace gpr::baselines {

/// MeshLab's "Simplification: Quadric Edge Collapse Decimation" (Garland, Heckbert 1997) with the
/// defaults of its dialog, for comparisons: quality threshold 0.3, optimal placement, clean-up at
/// the end; border, normals and topology are not preserved. vcglib's own code, in float as in
/// MeshLab. Sources with vcglib's headers are kept apart from the callers of this class. Not
/// re-entrant: vcglib keeps state in static variables.
class QuadricCollapse {
public:
	/// Copies the mesh. Drops corners that are not finite, and faces with a repeated vertex, as
	/// MeshLab does on opening a file.
	explicit QuadricCollapse(const MeshView& mesh);
	~QuadricCollapse();
	QuadricCollapse(const QuadricCollapse&)            = delete;
	QuadricCollapse& operator=(const QuadricCollapse&) = delete;

	/// Collapses edges until there are faceNum faces or no collapse is possible. Calls shallStop
	/// about ten times a second; returns false if stopped. To be called once. Cost: O(F log F), one
	/// thread.
	bool run(std::int64_t faceNum, const std::function<bool()>& shallStop);

	/// The mesh after run(); may have no face.
	TriangleMesh mesh() const;

private:
	struct Work;
	std::unique_ptr<Work> work_;
};

} // namespace gpr::baselines

#endif
