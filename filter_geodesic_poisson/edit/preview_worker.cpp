// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview_worker.h"

#include <vcg_extras/complex/baselines/quadric_collapse.h>
#include <vcg_extras/core/mesh/measure.h>
#include <vcg_extras/core/prepared_surface.h>

#ifdef __linux__
#include <sys/resource.h>
#endif

#include <chrono>
#include <exception>
#include <utility>

namespace gpr_filter {

namespace {

/// The window comes first on machines with fewer cores than threads. The engine's threads are
/// children of this thread and inherit its priority.
void giveWayToTheWindow()
{
#ifdef __linux__
	constexpr int aLittleLess = 5;
	setpriority(PRIO_PROCESS, 0, aLittleLess); // on Linux, of the calling thread alone
#endif
}

} // namespace

/// The data of the thread: the surface, and its measures.
class PreviewWorker::Runs {
public:
	explicit Runs(PreviewWorker& owner) : owner_(owner) {}

	void setLayer(std::shared_ptr<const LayerCopy> layer)
	{
		const bool isSame = layer_ != nullptr && layer_->sameGeometry(*layer);
		const auto before =
			std::exchange(layer_, std::move(layer)); // the surface refers to the layer
		if (isSame)
			surface_->setInput(layer_->view());
		else
			surface_.emplace(layer_->view());
		if (isSame) return;
		target_.reset();
		isQualityKnown_ = false;
	}

	void run(const PreviewRequest& request)
	{
		if (!request.keepsResult && !remesh(request)) return;
		if (request.isDraft) return;
		gpr::Workers workers(request.options.threads, nullptr, 0, &owner_.stop_);
		measureLayer(workers);
		if (!last_.isMeasured) {
			last_ = measuredResult(last_, layer_->view(), target(workers), workers);
			show();
		}
		if (request.withQuadric) collapse(workers);
	}

	void fail(const PreviewRequest& request, const std::string& why)
	{
		owner_.tell([&](PreviewNews& news) {
			news.failure       = why.empty() ? "Internal error." : why;
			news.failedRequest = request.id;
		});
	}

	void rest()
	{
		owner_.tell([](PreviewNews& news) {
			news.share = 1;
			news.phrase.clear();
		});
	}

private:
	PreviewWorker&                      owner_;
	std::shared_ptr<const LayerCopy>    layer_;
	std::optional<gpr::PreparedSurface> surface_;
	std::optional<gpr::MeasuredSurface> target_;
	bool                                isQualityKnown_ = false;
	Preview                             last_;

	/// False without a result.
	bool remesh(const PreviewRequest& request)
	{
		auto made = std::make_shared<gpr::RemeshResult>(
			surface_->remesh(request.options, progress(), &owner_.stop_));
		if (made->status == gpr::Status::Cancelled) return false;
		if (made->status != gpr::Status::Ok) {
			fail(request, made->message);
			return false;
		}
		gpr::Workers workers(request.options.threads, nullptr, 0, &owner_.stop_);
		last_         = shownResult(std::move(made), workers);
		last_.request = request.id;
		last_.isDraft = request.isDraft;
		show();
		return true;
	}

	gpr::ProgressCallback progress()
	{
		return [this](double share, const char* phrase) {
			owner_.tell([&](PreviewNews& news) {
				news.share  = share;
				news.phrase = phrase;
			});
			return true;
		};
	}

	void show()
	{
		const auto shown = std::make_shared<const Preview>(last_);
		owner_.tell([&](PreviewNews& news) {
			news.preview = shown;
			news.failure.clear();
			news.phrase = shown->isDraft || shown->isMeasured ? "" : "Measuring distances";
			news.share  = news.phrase.empty() ? 1 : 0;
		});
	}

	const gpr::MeasuredSurface& target(gpr::Workers& workers)
	{
		if (!target_) target_.emplace(layer_->view(), workers);
		return *target_;
	}

	void measureLayer(gpr::Workers& workers)
	{
		if (isQualityKnown_) return;
		const auto quality = std::make_shared<const gpr::QualityFigures>(
			gpr::measureQuality(layer_->view(), workers));
		isQualityKnown_ = true;
		owner_.tell([&](PreviewNews&) { owner_.qualityOfLayer_ = quality; });
	}

	void collapse(gpr::Workers& workers)
	{
		owner_.tell([](PreviewNews& news) {
			news.phrase = "Quadric Edge Collapse";
			news.share  = 0;
		});
		using Clock                            = std::chrono::steady_clock;
		const auto                      start  = Clock::now();
		const auto                      wanted = last_.result->mesh.faceNum();
		gpr::baselines::QuadricCollapse collapsing(layer_->view());
		if (!collapsing.run(std::int64_t(wanted), [&] { return bool(owner_.stop_); })) return;
		const std::chrono::duration<double> seconds = Clock::now() - start;
		const gpr::TriangleMesh             mesh    = collapsing.mesh();
		const auto                          faces   = std::make_shared<const DrawnFaces>(
            drawnFaces(mesh.view(), &target(workers), last_.largestDeviation, workers));
		owner_.tell([&](PreviewNews& news) {
			news.quadric        = faces;
			news.quadricSeconds = seconds.count();
			news.phrase.clear();
			news.share = 1;
		});
	}
};

PreviewWorker::PreviewWorker(std::shared_ptr<const LayerCopy> layer) : layer_(std::move(layer))
{
	thread_ = std::thread([this] { work(); });
}

PreviewWorker::~PreviewWorker()
{
	{
		const std::lock_guard<std::mutex> lock(mutex_);
		isQuitting_ = true;
		stop_       = true;
	}
	wake_.notify_all();
	thread_.join();
}

void PreviewWorker::setLayer(std::shared_ptr<const LayerCopy> layer)
{
	const std::lock_guard<std::mutex> lock(mutex_);
	layer_      = std::move(layer);
	isLayerNew_ = true;
}

void PreviewWorker::request(const PreviewRequest& request)
{
	{
		const std::lock_guard<std::mutex> lock(mutex_);
		wanted_ = request;
		stop_   = true;
	}
	wake_.notify_all();
}

PreviewNews PreviewWorker::takeNews()
{
	const std::lock_guard<std::mutex> lock(mutex_);
	PreviewNews                       news = std::move(news_);
	news_                                  = PreviewNews();
	news_.share                            = news.share;
	news_.phrase                           = news.phrase;
	return news;
}

std::shared_ptr<const gpr::QualityFigures> PreviewWorker::qualityOfLayer()
{
	const std::lock_guard<std::mutex> lock(mutex_);
	return qualityOfLayer_;
}

template <class Change>
void PreviewWorker::tell(const Change& change)
{
	{
		const std::lock_guard<std::mutex> lock(mutex_);
		change(news_);
	}
	emit newsArrived();
}

std::optional<PreviewRequest> PreviewWorker::nextRequest(std::shared_ptr<const LayerCopy>& newLayer)
{
	std::unique_lock<std::mutex> lock(mutex_);
	wake_.wait(lock, [&] { return isQuitting_ || wanted_; });
	if (isQuitting_) return std::nullopt;
	if (isLayerNew_) newLayer = layer_;
	isLayerNew_ = false;
	stop_       = false;
	return std::exchange(wanted_, std::nullopt);
}

void PreviewWorker::work()
{
	giveWayToTheWindow();
	Runs runs(*this);
	while (true) {
		std::shared_ptr<const LayerCopy>    newLayer;
		const std::optional<PreviewRequest> request = nextRequest(newLayer);
		if (!request) return;
		try {
			if (newLayer != nullptr) runs.setLayer(std::move(newLayer));
			runs.run(*request);
		}
		catch (const gpr::CancelledError&) {
		}
		catch (const std::bad_alloc&) {
			runs.fail(*request, "There is not enough memory for this.");
		}
		catch (const std::exception& error) {
			runs.fail(*request, error.what());
		}
		runs.rest();
	}
}

} // namespace gpr_filter
