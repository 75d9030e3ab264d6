// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "remesh_panel.h"

#include "filter_rows.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QGroupBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QMouseEvent>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QSlider>
#include <QSpinBox>
#include <QStyle>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace gpr_filter {

namespace {

/// The rows of the table in the panel, in this order.
constexpr const char* kShownKeys[] = {
	"TargetVertexNum", "TargetPerc",    "TargetLen",        "Preset",   "Adapt",   "Lambda",
	"Features",        "FeatureRegion", "FeatureDiskScale", "Boundary", "Regions", "NewLayer"};
/// Other ways to give the size: a value above 0 takes the place of the count.
constexpr const char* kOtherSizes[] = {"TargetPerc", "TargetLen"};
/// The row of the slider, and the row for a slider that counts faces.
constexpr const char* kVertices       = "TargetVertexNum";
constexpr const char* kFaces          = "TargetFaceNum";
constexpr int         kFacesPerVertex = 2;

constexpr int    kSliderSteps = 1000;
constexpr double kUnitStep    = 0.05;
constexpr double kFewest      = 50;

/// The slider's end: twice the vertices of the layer.
double mostOnSlider(const gpr::MeshFacts& facts)
{
	return std::max(1000.0, 2.0 * double(facts.vertexNum));
}

/// Equal steps of the slider multiply the number alike. Three digits are enough to choose by.
std::int64_t countAt(int step, const gpr::MeshFacts& facts)
{
	const double ratio = mostOnSlider(facts) / kFewest;
	const double exact = kFewest * std::pow(ratio, double(step) / kSliderSteps);
	const double unit  = std::pow(10.0, std::max(0.0, std::floor(std::log10(exact)) - 2));
	return std::int64_t(std::llround(exact / unit) * std::llround(unit));
}

int stepOf(std::int64_t count, const gpr::MeshFacts& facts)
{
	const double ratio = std::log(mostOnSlider(facts) / kFewest);
	const double step  = std::log(std::max(1.0, double(count) / kFewest)) / ratio;
	return std::clamp(int(std::lround(kSliderSteps * step)), 0, kSliderSteps);
}

QString helpOf(const gpr::Parameter& row)
{
	// As HTML, so that the window breaks the lines.
	return "<p>" + QString::fromStdString(gpr::dialogHelp(row)).toHtmlEscaped() + "</p>";
}

double largestNumber(const gpr::Parameter& row, const gpr::MeshFacts& facts)
{
	const bool isLength = row.kind == gpr::ParameterKind::Length;
	return std::min(row.maximum, isLength && facts.diagonal > 0 ? facts.diagonal : 1e6);
}

/// Digits after the point, so that a length has some five digits in all.
int decimalsFor(double largest)
{
	return std::clamp(4 - int(std::floor(std::log10(std::max(largest, 1e-30)))), 2, 12);
}

QString inPerMille(double length, double diagonal)
{
	return QString::number(diagonal > 0 ? 1000 * length / diagonal : 0, 'f', 2) + " \u2030";
}

/// Texts that come and go shall not move the widgets below: a click would hit another widget.
void keepPlace(QWidget& widget)
{
	QSizePolicy policy = widget.sizePolicy();
	policy.setRetainSizeWhenHidden(true);
	widget.setSizePolicy(policy);
}

/// All of the panel shall fit beside a view of 760 pixels.
void beTight(QLayout& layout)
{
	layout.setSpacing(2);
	layout.setContentsMargins(8, 2, 8, 3);
}

/// A slider whose handle jumps to the pressed place, and is dragged from there.
class JumpingSlider : public QSlider {
public:
	JumpingSlider() : QSlider(Qt::Horizontal) {}

protected:
	void mousePressEvent(QMouseEvent* event) override
	{
		const int handle = style()->pixelMetric(QStyle::PM_SliderLength, nullptr, this);
		if (event->button() == Qt::LeftButton) {
			setValue(QStyle::sliderValueFromPosition(
				minimum(), maximum(), event->pos().x() - handle / 2, width() - handle));
		}
		QSlider::mousePressEvent(event);
	}
};

QGroupBox* groupIn(QVBoxLayout& column, const QString& title)
{
	auto* group = new QGroupBox(title);
	column.addWidget(group);
	return group;
}

} // namespace

RemeshPanel::RemeshPanel(const gpr::MeshFacts& facts, const PanelValues& values,
						 const ViewChoices& choices, QWidget* parent) :
		QDockWidget("Geodesic Poisson Remeshing", parent),
		facts_(facts), values_(values), choices_(choices)
{
	setObjectName("gprRemeshPanel");
	setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
	auto* inside = new QWidget;
	auto* column = new QVBoxLayout(inside);
	column->setSpacing(2);
	column->setContentsMargins(4, 0, 4, 0);
	addParameters(*column);
	addView(*column);
	addOutcome(*column);
	column->addStretch(1);
	auto* scroll = new QScrollArea;
	scroll->setWidgetResizable(true);
	scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
	scroll->setFrameShape(QFrame::NoFrame);
	scroll->setWidget(inside);
	scroll->setMinimumWidth(inside->sizeHint().width() + 24);
	setWidget(scroll);
	showLegend();
}

// ---- parameters

void RemeshPanel::addParameters(QVBoxLayout& column)
{
	auto* form = new QFormLayout(groupIn(column, "Remeshing"));
	beTight(*form);
	for (const char* key : kShownKeys) {
		const gpr::Parameter& row = remeshRow(key);
		if (values_.count(key) == 0) values_[key] = row.defaultValue(facts_);
		if (values_.count(kFaces) == 0) values_[kFaces] = std::int64_t(0);
		addRow(row, *form);
	}
}

bool RemeshPanel::countsFaces() const
{
	return std::get<std::int64_t>(values_.at(kFaces)) > 0;
}

/// The number of the slider, in vertices and in the counted unit.
std::int64_t RemeshPanel::countOnSlider() const
{
	return countAt(countSlider_->value(), facts_) * (countsFaces() ? kFacesPerVertex : 1);
}

void RemeshPanel::moveSliderTo(std::int64_t count)
{
	countSlider_->setValue(stepOf(count / (countsFaces() ? kFacesPerVertex : 1), facts_));
}

void RemeshPanel::changeCount(std::int64_t count)
{
	change(countsFaces() ? kFaces : kVertices, count);
}

/// The same size in the other unit.
void RemeshPanel::countFaces(bool countsFaces)
{
	if (isShowing_ || countsFaces == this->countsFaces()) return;
	const std::int64_t vertexNum = std::get<std::int64_t>(values_[kVertices]);
	const std::int64_t faceNum   = std::get<std::int64_t>(values_[kFaces]);
	if (countsFaces)
		change(kFaces, kFacesPerVertex * vertexNum);
	else
		change(kVertices, std::max<std::int64_t>(1, faceNum / kFacesPerVertex));
	show(kVertices);
}

QComboBox* RemeshPanel::countUnit(const gpr::Parameter& row)
{
	auto* box = new QComboBox;
	box->setObjectName("CountUnit");
	box->addItems({QString::fromUtf8(row.label), "Number of faces"});
	box->setToolTip("Unit of the slider.");
	connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
			[this](int index) { countFaces(index == 1); });
	return countUnit_ = box;
}

void RemeshPanel::addRow(const gpr::Parameter& row, QFormLayout& form)
{
	QWidget* field = nullptr;
	switch (row.kind) {
	case gpr::ParameterKind::Count:
		form.addRow(countSlider_ = sliderFor(row));
		field = countField(row);
		field->setObjectName(row.key);
		field->setToolTip(helpOf(row));
		form.addRow(countUnit(row), field);
		return show(row.key);
	case gpr::ParameterKind::Switch:
		field = switchField(row);
		break;
	case gpr::ParameterKind::Choice:
		field = choiceField(row);
		break;
	default:
		field = numberField(row);
		break;
	}
	field->setObjectName(row.key);
	auto* label = new QLabel(QString::fromUtf8(row.label));
	field->setToolTip(helpOf(row));
	label->setToolTip(helpOf(row));
	form.addRow(label, field);
	show(row.key);
}

QSlider* RemeshPanel::sliderFor(const gpr::Parameter& row)
{
	auto* slider = new JumpingSlider;
	slider->setObjectName(QString(row.key) + "Slider");
	slider->setRange(0, kSliderSteps);
	slider->setPageStep(kSliderSteps / 20);
	slider->setToolTip(helpOf(row));
	const std::string key = row.key;
	connect(slider, &QSlider::valueChanged, this, [this, key] {
		if (isShowing_) return;
		changeCount(countOnSlider());
		show(key);
	});
	return slider;
}

QWidget* RemeshPanel::countField(const gpr::Parameter& row)
{
	auto* box = new QSpinBox;
	box->setRange(int(row.minimum), int(std::min(row.maximum, 2e9)));
	box->setKeyboardTracking(false);
	box->setGroupSeparatorShown(false);
	const std::string key = row.key;
	connect(box, QOverload<int>::of(&QSpinBox::valueChanged), this, [this](int count) {
		changeCount(count);
		const bool wasShowing = std::exchange(isShowing_, true);
		moveSliderTo(count);
		isShowing_ = wasShowing;
	});
	showValue_[key] = [this, box] {
		const std::int64_t count =
			std::get<std::int64_t>(values_[countsFaces() ? kFaces : kVertices]);
		countUnit_->setCurrentIndex(countsFaces() ? 1 : 0);
		box->setSingleStep(countsFaces() ? kFacesPerVertex : 1);
		box->setValue(int(count));
		// The slider stays at the user's place while the place means this number.
		if (countOnSlider() != count) moveSliderTo(count);
	};
	return box;
}

QWidget* RemeshPanel::numberField(const gpr::Parameter& row)
{
	auto*        box     = new QDoubleSpinBox;
	const double largest = largestNumber(row, facts_);
	const bool   isUnit  = largest <= 1 && row.kind == gpr::ParameterKind::Number;
	box->setDecimals(row.kind == gpr::ParameterKind::Length ? decimalsFor(largest) : 2);
	const double step = isUnit ? kUnitStep : std::min(1.0, largest / 1000);
	box->setSingleStep(step);
	box->setKeyboardTracking(false);
	// One step below the least number means none.
	const double least = row.isAutomatic ? row.minimum - step : row.minimum;
	box->setRange(least, largest);
	if (row.isAutomatic) box->setSpecialValueText(gpr::automaticName);
	const std::string key     = row.key;
	const auto        valueAt = [minimum = row.minimum](double number) {
        return number < minimum ? gpr::ParameterValue(gpr::Automatic()) : number;
	};
	connect(box, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this,
			[this, key, valueAt](double number) { change(key, valueAt(number)); });
	showValue_[key] = [this, box, key, least] {
		const auto* number = std::get_if<double>(&values_[key]);
		box->setValue(number != nullptr ? *number : least);
	};
	return box;
}

QWidget* RemeshPanel::switchField(const gpr::Parameter& row)
{
	auto*             box = new QCheckBox;
	const std::string key = row.key;
	connect(box, &QCheckBox::toggled, this, [this, key](bool on) { change(key, on); });
	showValue_[key] = [this, box, key] { box->setChecked(std::get<bool>(values_[key])); };
	return box;
}

QWidget* RemeshPanel::choiceField(const gpr::Parameter& row)
{
	auto* box = new QComboBox;
	for (const char* choice : row.choices)
		box->addItem(QString::fromUtf8(choice));
	const std::string key = row.key;
	connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
			[this, key](int index) { change(key, std::int64_t(index)); });
	showValue_[key] = [this, box, key] {
		box->setCurrentIndex(int(std::get<std::int64_t>(values_[key])));
	};
	return box;
}

void RemeshPanel::show(const std::string& key)
{
	const bool wasShowing = std::exchange(isShowing_, true);
	showValue_.at(key)();
	isShowing_ = wasShowing;
}

/// The size given last counts.
void RemeshPanel::keepOneSize(const std::string& key)
{
	for (const char* other : kOtherSizes) {
		if (key == other) continue;
		values_[other] = 0.0;
		show(other);
	}
	if (key == kFaces || !countsFaces()) return;
	values_[kFaces] = std::int64_t(0);
	show(kVertices);
}

void RemeshPanel::change(const std::string& key, const gpr::ParameterValue& value)
{
	if (isShowing_) return;
	values_[key] = value;
	if (gpr::isSizeParameter(remeshRow(key))) keepOneSize(key);
	emit valuesChanged();
}

// ---- the view

template <class Choice>
QComboBox* RemeshPanel::viewBox(const char* name, const QStringList& texts,
								Choice ViewChoices::*choice)
{
	auto* box = new QComboBox;
	box->setObjectName(name);
	box->addItems(texts);
	box->setCurrentIndex(int(choices_.*choice));
	connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this,
			[this, choice](int index) {
				choices_.*choice = Choice(index);
				changeView();
			});
	return box;
}

QCheckBox* RemeshPanel::viewSwitch(const char* text, const char* name, bool ViewChoices::*choice)
{
	auto* box = new QCheckBox(text);
	box->setObjectName(name);
	box->setChecked(choices_.*choice);
	connect(box, &QCheckBox::toggled, this, [this, choice](bool on) {
		choices_.*choice = on;
		changeView();
	});
	return box;
}

void RemeshPanel::addView(QVBoxLayout& column)
{
	auto* form = new QFormLayout(groupIn(column, "View"));
	beTight(*form);
	form->addRow("Result", viewBox("Place", {"over the original", "in place of the original"},
								   &ViewChoices::place));
	auto* drawn = new QHBoxLayout;
	drawn->addWidget(viewSwitch("Faces", "Faces", &ViewChoices::faces));
	drawn->addWidget(viewSwitch("Wireframe", "Wireframe", &ViewChoices::wireframe));
	form->addRow("Drawing", drawn);
	form->addRow("Colours",
				 viewBox("Colours", {"none", "quality of triangles", "distance from the input"},
						 &ViewChoices::colour));
	legend_ = new QLabel;
	legend_->setObjectName("Legend");
	legend_->setText("<b>0</b>");
	keepPlace(*legend_);
	form->addRow(legend_);
	wipe_ = viewSwitch("Dividing line (drag in the view)", "Wipe", &ViewChoices::isWiped);
	form->addRow(wipe_);
	form->addRow("Left of the line", viewBox("OtherSide", {"original", "Quadric Edge Collapse"},
											 &ViewChoices::otherSide));
	quadric_ = new QLabel;
	quadric_->setObjectName("QuadricFigures");
	keepPlace(*quadric_);
	form->addRow(quadric_);
	quadric_->hide();
}

void RemeshPanel::setWipeAt(double share)
{
	choices_.wipeAt = std::clamp(share, 0.0, 1.0);
}

void RemeshPanel::changeView()
{
	showLegend();
	emit choicesChanged();
}

/// From the worst to the best on MeshLab's scale.
void RemeshPanel::showLegend()
{
	const bool isDistance = choices_.colour == PreviewColour::Distance;
	legend_->setVisible(choices_.colour != PreviewColour::None);
	const QString left = isDistance ? QString("0") : QString("0, degenerate");
	const QString right =
		isDistance ? QString::number(largestDistance_, 'g', 3) : QString("1, equilateral");
	const QString stops = isDistance ? "stop:0 blue, stop:0.25 cyan, stop:0.5 lime, "
									   "stop:0.75 yellow, stop:1 red"
									 : "stop:0 red, stop:0.25 yellow, stop:0.5 lime, "
									   "stop:0.75 cyan, stop:1 blue";
	legend_->setStyleSheet("QLabel { color: black; padding: 2px; background: "
						   "qlineargradient(x1:0, y1:0, x2:1, y2:0, " +
						   stops + "); }");
	legend_->setText("<table width='100%'><tr><td><b>" + left + "</b></td><td align='right'><b>" +
					 right + "</b></td></tr></table>");
}

// ---- outcome

void RemeshPanel::addOutcome(QVBoxLayout& column)
{
	auto* lines = new QVBoxLayout(groupIn(column, "Result"));
	beTight(*lines);
	figures_ = new QLabel("\n\n");
	figures_->setObjectName("Figures");
	lines->addWidget(figures_);
	progress_ = new QProgressBar;
	progress_->setRange(0, 100);
	progress_->setMaximumHeight(16);
	keepPlace(*progress_);
	lines->addWidget(progress_);
	auto* spots = new QHBoxLayout;
	worst_      = new QPushButton("Worst triangle");
	worst_->setObjectName("WorstTriangle");
	worst_->setToolTip("Moves the camera to the triangle of the lowest quality.");
	farthest_ = new QPushButton("Largest distance");
	farthest_->setObjectName("LargestDistance");
	farthest_->setToolTip(
		"Moves the camera to the triangle with the largest distance from the input.");
	spots->addWidget(worst_);
	spots->addWidget(farthest_);
	lines->addLayout(spots);
	apply_ = new QPushButton("Apply");
	apply_->setObjectName("Apply");
	apply_->setToolTip("Puts the result into the document. The log and the clipboard get the "
					   "commands for the same mesh.");
	lines->addWidget(apply_);
	message_ = new QLabel;
	message_->setObjectName("Message");
	message_->setWordWrap(true);
	message_->setStyleSheet("QLabel { color: #b00000; }");
	message_->hide();
	lines->addWidget(message_);
	worst_->setEnabled(false);
	farthest_->setEnabled(false);
	connect(worst_, &QPushButton::clicked, this, &RemeshPanel::worstTrianglePressed);
	connect(farthest_, &QPushButton::clicked, this, &RemeshPanel::farthestPressed);
	connect(apply_, &QPushButton::clicked, this, &RemeshPanel::applyPressed);
}

void RemeshPanel::showFigures(const Preview& preview, double diagonal)
{
	const gpr::RemeshReport& report = preview.result->report;
	const QString            kind   = preview.isDraft ? " (draft)" : "";
	const QString vertices          = QString("%1 vertices").arg(preview.result->mesh.vertexNum());
	const QString faces             = QString("%1 faces").arg(preview.result->mesh.faceNum());
	QString       text              = QString("%1, %2, %3 s%4\n")
					   .arg(countsFaces() ? faces : vertices, countsFaces() ? vertices : faces)
					   .arg(report.remeshSeconds, 0, 'f', 3)
					   .arg(kind);
	text += QString("mean 2r/R %1, smallest angle %2\u00b0\n")
				.arg(report.quality.radiusRatioMean, 0, 'f', 3)
				.arg(report.quality.minAngleDeg, 0, 'f', 1);
	if (preview.isMeasured) {
		text += "distance / diagonal: RMS " + inPerMille(preview.distance.rms, diagonal) +
				", p99.9 " + inPerMille(preview.distance.p999, diagonal);
	}
	figures_->setText(text);
	worst_->setEnabled(preview.worstTriangle.isKnown);
	farthest_->setEnabled(preview.farthest.isKnown);
	largestDistance_ = preview.largestDeviation;
	showLegend();
}

void RemeshPanel::showQuadric(double seconds, std::size_t faceNum)
{
	quadric_->setText(
		QString("Quadric Edge Collapse: %1 faces, %2 s").arg(faceNum).arg(seconds, 0, 'f', 2));
	quadric_->show();
}

void RemeshPanel::showProgress(double share, const std::string& phrase)
{
	progress_->setVisible(share < 1);
	progress_->setValue(int(100 * share));
	progress_->setFormat(QString::fromStdString(phrase) + " %p%");
}

void RemeshPanel::showMessage(const std::string& sentence)
{
	message_->setText(QString::fromStdString(sentence));
	message_->setVisible(!sentence.empty());
}

void RemeshPanel::setApplying(bool isApplying)
{
	apply_->setEnabled(!isApplying);
	apply_->setText(isApplying ? "Applying" : "Apply");
}

} // namespace gpr_filter
