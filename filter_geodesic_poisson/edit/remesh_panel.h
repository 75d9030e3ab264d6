// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_REMESH_PANEL_H
#define FILTER_GEODESIC_POISSON_REMESH_PANEL_H

#include "preview.h"
#include "view_choices.h"

#include <vcg_extras/core/parameters.h>

#include <QDockWidget>
#include <functional>
#include <map>
#include <string>
#include <vector>

class QCheckBox;
class QComboBox;
class QFormLayout;
class QLabel;
class QProgressBar;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace gpr_filter {

/// Values of parameters by their keys.
using PanelValues = std::map<std::string, gpr::ParameterValue>;

/// The panel at the side of the view: wanted result, shown views and outcome. Independent of
/// MeshLab and of the engine's runs.
class RemeshPanel : public QDockWidget {
	Q_OBJECT

public:
	/// The defaults are the defaults for a mesh of these facts; `values` of an earlier panel win.
	RemeshPanel(const gpr::MeshFacts& facts, const PanelValues& values, const ViewChoices& choices,
				QWidget* parent);

	/// Of the rows in the panel.
	const PanelValues& values() const { return values_; }
	const ViewChoices& choices() const { return choices_; }
	/// The line was dragged in the view.
	void setWipeAt(double share);

	/// The line of figures; mesh units.
	void showFigures(const Preview& preview, double diagonal);
	void showQuadric(double seconds, std::size_t faceNum);
	/// share 1 hides the bar.
	void showProgress(double share, const std::string& phrase);
	/// The reason of a failure; empty without a failure.
	void showMessage(const std::string& sentence);
	void setApplying(bool isApplying);

signals:
	void valuesChanged();
	void choicesChanged();
	void applyPressed();
	void worstTrianglePressed();
	void farthestPressed();

private:
	gpr::MeshFacts                               facts_;
	PanelValues                                  values_;
	ViewChoices                                  choices_;
	std::map<std::string, std::function<void()>> showValue_; ///< puts a value into its widget
	bool                                         isShowing_   = false; ///< no change by the user
	QSlider*                                     countSlider_ = nullptr;
	QComboBox*                                   countUnit_   = nullptr;
	QLabel *      figures_ = nullptr, *message_ = nullptr, *quadric_ = nullptr, *legend_ = nullptr;
	QProgressBar* progress_ = nullptr;
	QPushButton * worst_ = nullptr, *farthest_ = nullptr, *apply_ = nullptr;
	QCheckBox*    wipe_            = nullptr;
	double        largestDistance_ = 0;

	void       addParameters(QVBoxLayout& column);
	void       addRow(const gpr::Parameter& row, QFormLayout& form);
	QWidget*   countField(const gpr::Parameter& row);
	QComboBox* countUnit(const gpr::Parameter& row);
	bool       countsFaces() const;
	void       countFaces(bool countsFaces);
	void       changeCount(std::int64_t count);
	void       moveSliderTo(std::int64_t count);

	std::int64_t countOnSlider() const;
	QWidget*     numberField(const gpr::Parameter& row);
	QWidget*     switchField(const gpr::Parameter& row);
	QWidget*     choiceField(const gpr::Parameter& row);
	QSlider*     sliderFor(const gpr::Parameter& row);
	void         addView(QVBoxLayout& column);
	void         addOutcome(QVBoxLayout& column);
	QCheckBox*   viewSwitch(const char* text, const char* name, bool ViewChoices::*choice);
	template <class Choice>
	QComboBox* viewBox(const char* name, const QStringList& texts, Choice ViewChoices::*choice);
	void       change(const std::string& key, const gpr::ParameterValue& value);
	void       show(const std::string& key);
	void       keepOneSize(const std::string& key);
	void       changeView();
	void       showLegend();
};

} // namespace gpr_filter

#endif
