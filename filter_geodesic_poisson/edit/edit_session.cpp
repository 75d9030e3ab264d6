// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_session.h"

#include "layer_job.h"
#include "parameter_bridge.h"
#include "recipe.h"
#include "refusal.h"
#include "run_report.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QLoggingCategory>
#include <QMainWindow>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <exception>

/// Switched on by QT_LOGGING_RULES="gpr.edit.debug=true"; for tests and for questions of users.
Q_LOGGING_CATEGORY(gprEdit, "gpr.edit", QtWarningMsg)

namespace gpr_filter {

namespace {

/// After so long without a change the whole preset follows the draft.
constexpr int kRestMs = 500;
/// A press nearer to the wipe line than this, in the window's pixels, drags the line.
constexpr double kWipeReach   = 8;
constexpr int    kFlightSteps = 12, kFlightStepMs = 30;
/// The length of the triangle after a flight, in a view of the height 3.5.
constexpr double kLengthInView = 0.35;
constexpr int    kBeatMs = 10, kStallMs = 50;

/// Whether a copy of the layer for one set of options serves the other set.
bool readTheSame(const gpr::RemeshOptions& a, const gpr::RemeshOptions& b)
{
	const auto readsRegion = [](const gpr::RemeshOptions& o) {
		return o.featureRegion == gpr::FeatureRegion::Selection;
	};
	return gpr::mayUseSelectedVertices(a) == gpr::mayUseSelectedVertices(b) &&
		   readsRegion(a) == readsRegion(b) &&
		   (a.featureMode == gpr::FeatureMode::Given) == (b.featureMode == gpr::FeatureMode::Given);
}

Background backgroundOf(const GLArea& view)
{
	Background background;
	for (int i = 0; i < 3; ++i) {
		background.top[i]    = view.glas.backgroundTopColor[i];
		background.bottom[i] = view.glas.backgroundBotColor[i];
	}
	return background;
}

/// The rotation from a direction to the eye.
vcg::Quaternionf towardsEye(const vcg::Point3f& direction)
{
	const vcg::Point3f eye(0, 0, 1);
	vcg::Point3f       axis  = direction ^ eye;
	const float        angle = std::atan2(axis.Norm(), direction * eye);
	if (axis.Norm() < 1e-6f) axis = vcg::Point3f(0, 1, 0);
	return vcg::Quaternionf(angle, axis.Normalize());
}

/// They are for a layer.
void forgetSizes(PanelValues& values)
{
	for (const gpr::Parameter& row : gpr::remeshParameters())
		if (gpr::isSizeParameter(row)) values.erase(row.key);
}

/// On the screen, in the debug output.
void tellPlace(const QWidget& widget, const QString& name)
{
	const QPoint at = widget.mapToGlobal(QPoint(0, 0));
	qCDebug(gprEdit).noquote() << "widget" << name << at.x() << at.y() << widget.width()
							   << widget.height();
}

vcg::Similarityf between(const vcg::Similarityf& a, const vcg::Similarityf& b, float share)
{
	vcg::Similarityf track;
	track.rot = vcg::Interpolate(vcg::Quaternionf(a.rot), vcg::Quaternionf(b.rot), share);
	track.sca = a.sca * std::pow(b.sca / a.sca, share);
	track.tra = a.tra + (b.tra - a.tra) * share;
	return track;
}

} // namespace

EditSession::EditSession(MeshDocument& document, MeshModel& layer, GLArea& view,
						 MLSceneGLSharedDataContext& context, EditMemory& memory) :
		document_(document),
		layerId_(layer.id()), view_(view), context_(context), memory_(memory),
		facts_(factsOf(document))
{
	auto* window = qobject_cast<QMainWindow*>(view.window());
	if (memory_.values.count("NewLayer") == 0) memory_.values["NewLayer"] = true;
	if (memory_.layerId != layerId_ || memory_.vertexNum != layer.cm.vn)
		forgetSizes(memory_.values);
	panel_ = new RemeshPanel(facts_, memory_.values, memory_.choices, window);
	if (window != nullptr) window->addDockWidget(Qt::LeftDockWidgetArea, panel_);
	memory_.layerId   = layerId_;
	memory_.vertexNum = layer.cm.vn;
	connect(panel_, &RemeshPanel::valuesChanged, this, &EditSession::changeValues);
	connect(panel_, &RemeshPanel::choicesChanged, this, &EditSession::changeChoices);
	connect(panel_, &RemeshPanel::applyPressed, this, &EditSession::apply);
	connect(panel_, &RemeshPanel::worstTrianglePressed, this,
			[this] { flyTo(shown_->worstTriangle); });
	connect(panel_, &RemeshPanel::farthestPressed, this, [this] { flyTo(shown_->farthest); });

	rest_.setSingleShot(true);
	connect(&rest_, &QTimer::timeout, this, &EditSession::requestFull);
	connect(&flight_, &QTimer::timeout, this, &EditSession::fly);
	watchForStalls();
	changeValues();
}

EditSession::~EditSession()
{
	if (panel_ != nullptr) memory_.choices = panel_->choices();
	worker_.reset();
	delete panel_;
	if (isViewGone_) return; // and the document with the view
	hideOriginal(false);
	view_.makeCurrent();
	painter_.release();
	view_.update();
}

MeshModel* EditSession::layer()
{
	return document_.getMesh(layerId_);
}

// ---- runs

ReadParameters EditSession::wantedParameters(bool isDraft)
{
	// From MeshLab's own list, so that the numbers are the numbers of the filter.
	const std::vector<gpr::Parameter>& table  = rowsOf(RemeshFilter);
	PanelValues                        values = panel_->values();
	if (isDraft) values["Preset"] = std::int64_t(gpr::Preset::Fast);
	RichParameterList list;
	fillParameterList(table, facts_, list, values);
	ReadParameters read = readParameterList(table, facts_, list);
	if (!read.complaints.empty()) throw Refusal(read.complaints);
	return read;
}

void EditSession::copyMarksFor(const ReadParameters& read, const gpr::RemeshOptions& options)
{
	const auto regions = RegionSource(read.own<std::int64_t>("Regions"));
	if (worker_ != nullptr && readTheSame(copiedFor_, options) && copiedRegions_ == regions) return;
	auto copy      = std::make_shared<const LayerCopy>(copyFor(*layer(), read, options));
	copiedFor_     = options;
	copiedRegions_ = regions;
	if (worker_ != nullptr) return worker_->setLayer(std::move(copy));
	worker_ = std::make_unique<PreviewWorker>(std::move(copy));
	connect(worker_.get(), &PreviewWorker::newsArrived, this, &EditSession::takeNews,
			Qt::QueuedConnection);
}

void EditSession::request(bool isDraft)
try {
	if (layer() == nullptr) return;
	const ReadParameters read = wantedParameters(isDraft);
	PreviewRequest       wanted;
	wanted.options = optionsFor(read, RemeshFilter, *layer());
	wanted.isDraft = isDraft;
	copyMarksFor(read, wanted.options);
	wanted.id    = ++lastRequest_;
	isDraftDone_ = isFullUnderWay_ = !isDraft;
	panel_->showMessage("");
	worker_->request(wanted);
}
catch (const Refusal& refusal) {
	panel_->showMessage(refusal.sentences().front());
	panel_->setApplying(isApplying_ = false);
}
catch (const std::bad_alloc&) {
	panel_->showMessage("There is not enough memory for this.");
}

/// After the draft, which a large layer may take longer for than the user's rest.
void EditSession::requestFull()
{
	if (!rest_.isActive() && isDraftDone_) request(false);
}

/// The full run follows, unless under way or over.
void EditSession::endDraft()
{
	if (isDraftDone_) return;
	isDraftDone_ = true;
	requestFull();
}

/// Beside the shown result.
void EditSession::requestQuadric()
{
	const ViewChoices& choices = panel_->choices();
	const bool         wanted  = choices.isWiped && choices.otherSide == OtherSide::QuadricCollapse;
	if (!wanted || painter_.hasQuadric() || !isUpToDate()) return;
	PreviewRequest request;
	request.id          = lastRequest_;
	request.withQuadric = request.keepsResult = true;
	worker_->request(request);
}

/// Without proposed values: the proposal may differ next time, for instance with selected vertices.
void EditSession::rememberValues()
{
	for (const auto& [key, value] : panel_->values()) {
		const bool isProposed = value == remeshRow(key).defaultValue(facts_);
		if (isProposed && key != "NewLayer")
			memory_.values.erase(key);
		else
			memory_.values[key] = value;
	}
}

void EditSession::changeValues()
{
	rememberValues();
	if (isApplying_) panel_->setApplying(isApplying_ = false);
	sinceChange_.start();
	qCDebug(gprEdit) << "asked for"
					 << std::get<std::int64_t>(panel_->values().at("TargetVertexNum"))
					 << "vertices";
	request(true);
	rest_.start(kRestMs);
}

void EditSession::changeChoices()
{
	memory_.choices = panel_->choices();
	requestQuadric();
	view_.update();
}

void EditSession::takeNews()
{
	if (worker_ == nullptr) return;
	PreviewNews news = worker_->takeNews();
	panel_->showProgress(news.share, news.phrase);
	if (!news.failure.empty() && news.failedRequest == lastRequest_) {
		isFullUnderWay_ = false;
		panel_->showMessage(news.failure);
		panel_->setApplying(isApplying_ = false);
		qCDebug(gprEdit) << "failed" << news.failure.c_str();
		endDraft();
	}
	if (news.preview != nullptr) showPreview(std::move(news.preview));
	if (news.quadric == nullptr) return;
	panel_->showQuadric(news.quadricSeconds, news.quadric->size() / 3);
	painter_.setQuadric(std::move(news.quadric));
	qCDebug(gprEdit) << "quadric drawn";
	view_.update();
}

void EditSession::showPreview(std::shared_ptr<const Preview> preview)
{
	if (shown_ != nullptr && preview->request < shown_->request) return;
	if (shown_ == nullptr || preview->request != shown_->request) painter_.setQuadric(nullptr);
	shown_ = std::move(preview);
	painter_.setResult(shown_->faces);
	panel_->showFigures(*shown_, facts_.diagonal);
	view_.update();
	if (shown_->request == lastRequest_) {
		isFullUnderWay_ = false;
		endDraft();
	}
	if (shown_->isMeasured) requestQuadric();
	if (isApplying_ && isUpToDate()) finishApply();
}

/// Whether the shown result is the wanted result of the panel, with its preset.
bool EditSession::isUpToDate() const
{
	return shown_ != nullptr && !shown_->isDraft && shown_->request == lastRequest_ &&
		   !rest_.isActive();
}

// ---- Apply

void EditSession::apply()
{
	panel_->setApplying(isApplying_ = true);
	if (isUpToDate()) return finishApply();
	if (isFullUnderWay_) return;
	rest_.stop();
	request(false);
}

void EditSession::finishApply()
try {
	isApplying_ = false;
	putResult();
	leave();
}
catch (const Refusal& refusal) {
	panel_->setApplying(false);
	panel_->showMessage(refusal.sentences().front());
}
catch (const std::exception& error) {
	panel_->setApplying(false);
	panel_->showMessage(error.what());
}

void EditSession::tell(const std::vector<std::string>& lines)
{
	for (const std::string& line : lines)
		if (!line.empty()) logLine(document_, line);
}

void EditSession::putResult()
{
	const PanelValues values = panel_->values();
	RichParameterList list;
	fillParameterList(rowsOf(RemeshFilter), facts_, list, values);
	if (document_.mm() == nullptr || document_.mm()->id() != layerId_)
		throw Refusal("The layer of the tool is no longer the current layer.");
	const LayerJob job(document_, RemeshFilter, list);
	const QString  file   = fileOf(*layer());
	const auto     before = worker_->qualityOfLayer();
	tell(remeshingLines(*shown_->result, before != nullptr ? *before : gpr::QualityFigures()));
	tell(job.put(*shown_->result, "_remeshed"));
	const Recipe recipe = recipeFor(values, facts_, file);
	logLine(document_, recipe.text().toStdString());
	QApplication::clipboard()->setText(recipe.text());
	if (std::get<bool>(values.at("NewLayer")))
		hideLayer(*layer());
	else
		showChangedMesh(context_, layerId_);
}

/// As by a press on the tool's icon: MeshLab then shows new layers.
void EditSession::leave()
{
	QAction* const action = view_.getCurrentEditAction();
	if (action != nullptr) QMetaObject::invokeMethod(action, "trigger", Qt::QueuedConnection);
}

// ---- the view

void EditSession::hideOriginal(bool isHidden)
{
	MeshModel* const model = layer();
	if (model == nullptr) return;
	view_.meshVisibilityMap[layerId_] = !isHidden && model->isVisible();
}

void EditSession::draw()
{
	if (panel_ == nullptr || layer() == nullptr) return;
	const ViewChoices& choices  = panel_->choices();
	const bool         isHidden = painter_.hasResult() && !choices.isWiped &&
						  choices.place == PreviewPlace::InPlaceOfOriginal;
	if (isHidden == view_.meshVisibilityMap.value(layerId_)) {
		hideOriginal(isHidden);
		view_.update(); // once more, with or without the result
	}
	vcg::Matrix44f transform = vcg::Matrix44f::Construct(layer()->cm.Tr);
	vcg::Transpose(transform); // OpenGL has the matrix column by column
	const QSize size = view_.size() * view_.devicePixelRatio();
	painter_.draw(choices, transform.V(), size, backgroundOf(view_));
	if (shown_ == nullptr || shown_->request == drawnRequest_) return;
	drawnRequest_ = shown_->request;
	qCDebug(gprEdit) << (shown_->isDraft ? "draft" : "full") << "drawn"
					 << shown_->result->mesh.vertexNum() << "vertices"
					 << shown_->result->mesh.faceNum() << "faces after" << sinceChange_.elapsed()
					 << "ms, request" << shown_->request << "of" << lastRequest_;
}

bool EditSession::isAtWipeLine(const QMouseEvent& event) const
{
	const ViewChoices& choices = panel_->choices();
	const double       column  = choices.wipeAt * view_.width();
	return choices.isWiped && std::abs(event.localPos().x() - column) < kWipeReach;
}

void EditSession::mousePressEvent(QMouseEvent& event)
{
	isWiping_ = event.button() == Qt::LeftButton && isAtWipeLine(event);
	if (!isWiping_) passOn(event);
}

void EditSession::mouseMoveEvent(QMouseEvent& event)
{
	if (!isWiping_) return passOn(event);
	panel_->setWipeAt(event.localPos().x() / std::max(1, view_.width()));
	view_.update();
}

void EditSession::mouseReleaseEvent(QMouseEvent& event)
{
	if (!isWiping_) passOn(event);
	isWiping_ = false;
}

void EditSession::passOn(QEvent& event)
{
	view_.suspendedEditor = true; // the view then takes the event itself
	QApplication::sendEvent(&view_, &event);
	view_.suspendedEditor = false;
}

void EditSession::flyTo(const Spot& spot)
{
	MeshModel* const model = layer();
	if (model == nullptr || !spot.isKnown) return;
	const vcg::Matrix44f transform = vcg::Matrix44f::Construct(model->cm.Tr);
	const auto           moved     = [&](const gpr::Vec3d& p) {
        return transform * vcg::Point3f(float(p.x), float(p.y), float(p.z));
	};
	const vcg::Point3f middle = moved(spot.middle);
	vcg::Point3f       normal = moved(spot.middle + spot.normal) - middle;
	const float        scale  = normal.Norm();
	flightStart_              = view_.trackball.track;
	flightEnd_.rot            = towardsEye(normal.Normalize());
	flightEnd_.sca            = float(kLengthInView / std::max(1e-30, spot.size * double(scale)));
	flightEnd_.tra            = -middle;
	flightStep_               = 0;
	flight_.start(kFlightStepMs);
}

void EditSession::fly()
{
	const float share     = float(++flightStep_) / kFlightSteps;
	view_.trackball.track = between(flightStart_, flightEnd_, share);
	if (flightStep_ >= kFlightSteps) {
		view_.trackball.track = flightEnd_;
		flight_.stop();
	}
	view_.update();
}

/// Tells in the debug output how long the window's thread was busy.
void EditSession::watchForStalls()
{
	if (!gprEdit().isDebugEnabled()) return;
	sinceBeat_.start();
	connect(&watch_, &QTimer::timeout, this, [this] {
		const qint64 late = sinceBeat_.restart() - kBeatMs;
		if (late > kStallMs) qCDebug(gprEdit) << "stall of" << late << "ms";
	});
	watch_.start(kBeatMs);
	QTimer::singleShot(400, this, [this] {
		tellPlace(view_, "View");
		for (const QWidget* widget : panel_->findChildren<QWidget*>()) {
			const QString name = widget->objectName();
			if (!name.isEmpty() && !name.startsWith("qt_")) tellPlace(*widget, name);
		}
	});
}

} // namespace gpr_filter
