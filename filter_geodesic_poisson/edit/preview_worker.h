// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_PREVIEW_WORKER_H
#define FILTER_GEODESIC_POISSON_PREVIEW_WORKER_H

#include "mesh_bridge.h"
#include "preview.h"

#include <vcg_extras/core/options.h>
#include <vcg_extras/core/progress.h>

#include <QObject>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace gpr_filter {

/// A wanted run.
struct PreviewRequest {
	std::uint64_t      id = 0; ///< ascending
	gpr::RemeshOptions options;
	bool               isDraft     = false; ///< neither measured nor compared
	bool               withQuadric = false; ///< Quadric Edge Collapse makes as many faces, too
	/// The last result, which was no draft, is still right; nothing is remeshed.
	bool keepsResult = false;
};

/// The news since the last request.
struct PreviewNews {
	std::shared_ptr<const Preview>    preview; ///< null: none
	std::shared_ptr<const DrawnFaces> quadric; ///< of the preview shown last; null: none
	double                            quadricSeconds = 0;
	std::string                       failure; ///< of the last request; empty without a failure
	std::uint64_t                     failedRequest = 0;
	double                            share         = 1; ///< of the work under way; 1: none
	std::string                       phrase;
};

/// Remeshes a copy of a layer in a thread of its own, again and again with other options. A new
/// request ends the run under way. All calls come from the window's thread, and return at once.
class PreviewWorker : public QObject {
	Q_OBJECT

public:
	explicit PreviewWorker(std::shared_ptr<const LayerCopy> layer);
	/// Ends the run and waits for the thread: some tens of milliseconds.
	~PreviewWorker() override;

	/// The same vertices and faces with other marks.
	void setLayer(std::shared_ptr<const LayerCopy> layer);
	void request(const PreviewRequest& request);
	/// Empties the returned data.
	PreviewNews takeNews();
	/// Figures of the layer, for the report; null until they are known.
	std::shared_ptr<const gpr::QualityFigures> qualityOfLayer();

signals:
	/// From the worker's thread; reaches a receiver of the window's thread there.
	void newsArrived();

private:
	class Runs; ///< data of the worker's thread only

	std::mutex                                 mutex_; ///< for all below but the thread
	std::condition_variable                    wake_;
	std::shared_ptr<const LayerCopy>           layer_;
	std::optional<PreviewRequest>              wanted_;
	PreviewNews                                news_;
	std::shared_ptr<const gpr::QualityFigures> qualityOfLayer_;
	bool                                       isLayerNew_ = true;
	bool                                       isQuitting_ = false;
	gpr::StopRequest                           stop_{false};
	std::thread                                thread_;

	void work();
	/// Waits for the next request; nothing at the end.
	std::optional<PreviewRequest> nextRequest(std::shared_ptr<const LayerCopy>& newLayer);
	template <class Change>
	void tell(const Change& change);
};

} // namespace gpr_filter

#endif
