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

/// A surface for many runs. What all of them have in common is made once and kept: the mesh taken
/// over, cleaned, sewn, ordered in space and connected, and the features of a detected region. So
/// other counts, sizes, presets and seeds cost only what follows from them.
///
///     gpr::PreparedSurface surface(view);
///     for (double percent : {5, 10, 20}) {
///         options.targetPercent = percent;
///         results.push_back(surface.remesh(options));
///     }
///
/// A result has the same bytes, and the same report but for its seconds, as that of gpr::remesh.
/// Another value of RemeshOptions::sew, dropComponentsBelow, featureThresholds or selectedOnly is
/// prepared for anew. The arrays of the view must stay as they are while the surface is used.
/// Memory beside that of a run: about 80 B a face of the input, until the surface goes.
class PreparedSurface {
public:
	/// Does nothing yet but note where the arrays are.
	explicit PreparedSurface(const MeshView& input);
	~PreparedSurface();
	PreparedSurface(PreparedSurface&&) noexcept;
	PreparedSurface& operator=(PreparedSurface&&) noexcept;

	/// Makes beforehand what runs with these options have in common. The first run does so by
	/// itself. The result has a status, a message and a report, and no mesh. Cost: linear.
	RemeshResult prepare(const RemeshOptions& options, const ProgressCallback& progress = nullptr,
						 const StopRequest* stop = nullptr);

	/// gpr::remesh of the surface. Where another thread sets `stop` the run ends with
	/// Status::Cancelled, within 50 ms on meshes of some million faces; what was prepared stays.
	/// A call waits for one that another thread has under way. Never throws but for programming
	/// errors.
	RemeshResult remesh(const RemeshOptions& options, const ProgressCallback& progress = nullptr,
						const StopRequest* stop = nullptr);

	/// The same vertices and faces with another selection or lines; the arrays may lie
	/// elsewhere. What was prepared stays, but for that of selected faces.
	void            setInput(const MeshView& sameMesh);
	const MeshView& input() const;

private:
	struct Kept;
	std::unique_ptr<Kept> kept_;
};

} // namespace gpr

#endif
