// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_PREPARED_SURFACE_H
#define VCG_EXTRAS_CORE_PREPARED_SURFACE_H

#include "mesh_view.h"
#include "options.h"
#include "progress.h"
#include "results.h"

#include <memory>

namespace gpr {

/// A surface for many runs. The common work of all runs is done once and kept: loading, cleaning,
/// sewing, spatial order, connectivity, and the features of a detected region. Runs with other
/// counts, sizes, presets or seeds cost only the rest.
///
///     gpr::PreparedSurface surface(view);
///     for (double percent : {5, 10, 20}) {
///         options.targetPercent = percent;
///         results.push_back(surface.remesh(options));
///     }
///
/// Each result and its report equal the result and report of gpr::remesh, except for the seconds.
/// Another value of RemeshOptions::sew, dropComponentsBelow, featureThresholds or selectedOnly
/// needs a new preparation. The arrays of the view must stay unchanged as long as the surface is in
/// use. Memory, in addition to a run: about 80 B a face of the input, until destruction.
class PreparedSurface {
public:
	/// Only stores the view.
	explicit PreparedSurface(const MeshView& input);
	~PreparedSurface();
	PreparedSurface(PreparedSurface&&) noexcept;
	PreparedSurface& operator=(PreparedSurface&&) noexcept;

	/// Does the common work of runs with these options, which otherwise the first run does. The
	/// result has a status, a message and a report, and no mesh. Cost: linear.
	RemeshResult prepare(const RemeshOptions& options, const ProgressCallback& progress = nullptr,
						 const StopRequest* stop = nullptr);

	/// As gpr::remesh. Ends with Status::Cancelled if another thread sets `stop`, within 50 ms on
	/// meshes of some million faces; the prepared work stays. Waits until a call by another thread
	/// has ended. Throws on programming errors only.
	RemeshResult remesh(const RemeshOptions& options, const ProgressCallback& progress = nullptr,
						const StopRequest* stop = nullptr);

	/// Sets a view of the same vertices and faces with another selection or other lines; the arrays
	/// may have moved. The prepared work stays, except for selected faces.
	void            setInput(const MeshView& sameMesh);
	const MeshView& input() const;

private:
	struct Kept;
	std::unique_ptr<Kept> kept_;
};

} // namespace gpr

#endif
