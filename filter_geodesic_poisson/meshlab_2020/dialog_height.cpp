// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// A work-around for the filter dialog of MeshLab 2020.09, which is as high as all its parameters
// together and so higher than the screen.
#include "dialog_height.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QEvent>
#include <QGridLayout>
#include <QLabel>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

namespace gpr_filter {

namespace {

// The host's dialog, a dock widget with a grid:
//   row 0    description of the filter
//   row 1    the frame with the parameters: label, value, help
//   row 2    Preview, if there is one
//   row 2/3  Default, Help
//   row 3/4  Close, Apply
constexpr int kParameterRow = 1;

bool changesByWheel(const QObject* value)
{
	return qobject_cast<const QComboBox*>(value) != nullptr ||
		   qobject_cast<const QAbstractSpinBox*>(value) != nullptr;
}

/// Gives the texts of Help their full height; the host's frame cuts the texts off.
void showInFull(QLabel& text)
{
	QSizePolicy policy = text.sizePolicy();
	policy.setHeightForWidth(true);
	text.setSizePolicy(policy);
}

/// The rows of the host's frame: label, value, help.
class ParameterRows {
public:
	/// everydayNum: the number of rows, from the first row on, that are always shown.
	ParameterRows(QWidget& frame, int everydayNum) :
			_frame(frame), _grid(qobject_cast<QGridLayout*>(frame.layout())),
			_everydayNum(everydayNum)
	{
	}

	bool hasExpertRows() const { return _grid != nullptr && _everydayNum < _grid->rowCount(); }
	/// The host's Help shows and hides the help of all rows; this function corrects the hidden
	/// rows.
	void showExpertRows(bool shown)
	{
		if (!hasExpertRows()) return;
		const bool withHelp = isShown(_grid->itemAtPosition(0, kHelpColumn));
		for (int row = _everydayNum; row < _grid->rowCount(); ++row) {
			for (int column = 0; column < kHelpColumn; ++column)
				show(_grid->itemAtPosition(row, column), shown);
			show(_grid->itemAtPosition(row, kHelpColumn), shown && withHelp);
		}
		_frame.setMinimumSize(0, 0); // the host's, for all rows
		_grid->activate();
	}

private:
	static constexpr int kHelpColumn = 2;

	QWidget&     _frame;
	QGridLayout* _grid;
	int          _everydayNum;

	static bool isShown(QLayoutItem* item)
	{
		return item != nullptr && item->widget() != nullptr && !item->widget()->isHidden();
	}
	/// A value may be a layout of several widgets.
	static void show(QLayoutItem* item, bool shown)
	{
		if (item == nullptr) return;
		if (item->widget() != nullptr) item->widget()->setVisible(shown);
		const QLayout* const inside = item->layout();
		for (int i = 0; inside != nullptr && i < inside->count(); ++i)
			show(inside->itemAt(i), shown);
	}
};

/// Scrolls the parameters up and down, keeps the dialog as wide as needed, and hides the rows for
/// experts.
class ParameterArea : public QScrollArea {
public:
	/// othersHeight: of all else in the dialog.
	ParameterArea(QWidget* parameters, int everydayNum, int mostHeight, int othersHeight) :
			_rows(*parameters, everydayNum), _mostHeight(mostHeight), _othersHeight(othersHeight)
	{
		setFrameShape(QFrame::NoFrame);
		setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
		setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
		setWidgetResizable(true);
		setWidget(parameters);
		_rows.showExpertRows(false);
		for (QWidget* part : parameters->findChildren<QWidget*>()) {
			auto* const text = qobject_cast<QLabel*>(part);
			if (text != nullptr && text->wordWrap()) showInFull(*text);
			if (changesByWheel(part)) part->installEventFilter(this);
		}
	}

	QSize sizeHint() const override
	{
		return {wantedWidth(), std::min(rowsHeight(), _mostHeight - _othersHeight)};
	}

	/// Takes the present width of the parameters, also for the dialog.
	void fitDialog()
	{
		QWidget&  inside = *parentWidget()->parentWidget();
		const int frame  = window()->width() - inside.width();
		setMinimumWidth(wantedWidth());
		parentWidget()->layout()->activate();
		inside.layout()->activate();
		const int width = frame + inside.layout()->minimumSize().width();
		window()->setMinimumSize(width,
								 std::min(_mostHeight, _othersHeight + minimumSizeHint().height()));
		window()->resize(width, dialogHeight());
		window()->installEventFilter(this);
	}

	void showExpertRows(bool shown)
	{
		_expertsShown = shown;
		_rows.showExpertRows(shown);
		fitDialog();
	}

protected:
	bool eventFilter(QObject* object, QEvent* event) override
	{
		// The wheel scrolls, and does not change the value under the pointer.
		if (event->type() == QEvent::Wheel && changesByWheel(object)) {
			event->ignore();
			return true;
		}
		const bool seen = QScrollArea::eventFilter(object, event);
		if (event->type() == QEvent::Resize && object == window()) fitDialogAgain();
		// The help texts come and go beside the values.
		const bool moved = event->type() == QEvent::LayoutRequest && object == widget();
		if (moved && minimumWidth() != wantedWidth()) {
			_rows.showExpertRows(_expertsShown);
			fitDialog();
		}
		return seen;
	}

private:
	ParameterRows _rows;
	int           _mostHeight, _othersHeight;
	bool          _expertsShown = false;

	/// On a slow machine the window manager applies the host's first, full height after the change,
	/// and so overrides the change.
	void fitDialogAgain()
	{
		const QScreen* const screen = window()->screen();
		if (screen == nullptr || window()->height() <= screen->availableGeometry().height()) return;
		QTimer::singleShot(0, this, [this] { fitDialog(); });
	}

	int rowsHeight() const { return widget()->sizeHint().height(); }
	int dialogHeight() const { return std::min(_mostHeight, _othersHeight + rowsHeight()); }
	int wantedWidth() const
	{
		return widget()->sizeHint().width() + verticalScrollBar()->sizeHint().width();
	}
};

/// The arrow that shows the parameters for experts, and hides these again.
QToolButton* makeArrow(QWidget* parent)
{
	auto* const arrow = new QToolButton(parent);
	arrow->setText("Parameters for experts");
	arrow->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
	arrow->setArrowType(Qt::RightArrow);
	arrow->setAutoRaise(true);
	arrow->setCheckable(true);
	return arrow;
}

/// With the Tab key the arrow comes after the parameters.
void putAfterParameters(QToolButton* arrow, const QWidget& parameters)
{
	QWidget* last = nullptr;
	for (QWidget* part : parameters.findChildren<QWidget*>()) {
		if ((part->focusPolicy() & Qt::TabFocus) != 0) last = part;
	}
	if (last != nullptr) QWidget::setTabOrder(last, arrow);
}

void connectArrow(QToolButton* arrow, ParameterArea* area)
{
	QObject::connect(arrow, &QToolButton::toggled, area, [arrow, area](bool shown) {
		arrow->setArrowType(shown ? Qt::DownArrow : Qt::RightArrow);
		area->showExpertRows(shown);
	});
}

QDockWidget* shownDialog(const QString& title)
{
	for (QWidget* widget : QApplication::topLevelWidgets()) {
		auto* const dialog = qobject_cast<QDockWidget*>(widget);
		if (dialog != nullptr && dialog->isVisible() && dialog->windowTitle() == title)
			return dialog;
	}
	return nullptr;
}

QWidget* widgetAt(const QGridLayout& grid, int row)
{
	QLayoutItem* const item = grid.itemAtPosition(row, 0);
	return item == nullptr ? nullptr : item->widget();
}

/// Of a window's inside, for the frame and title that the window manager adds.
int maxHeightOn(const QScreen& screen)
{
	constexpr int decoration = 40;
	const int     most       = int(kMaxDialogHeight * screen.logicalDotsPerInch() / 96);
	return std::min(most, screen.availableGeometry().height() - decoration);
}

void scrollParameters(QDockWidget& dialog, QGridLayout& grid, QWidget& parameters,
					  const QWidget& below, int everydayNum)
{
	QWidget&   inside  = *dialog.widget();
	const int  most    = maxHeightOn(*dialog.screen());
	const int  title   = dialog.height() - inside.height();
	const int  others  = title + parameters.y() + inside.height() - below.y() + grid.spacing();
	const int  rows    = std::max(parameters.sizeHint().height(), parameters.height());
	const bool experts = ParameterRows(parameters, everydayNum).hasExpertRows();
	// The host forgets the height of its own text, so the last rows can be behind the buttons.
	const bool cutOff = parameters.geometry().bottom() > below.y();
	if (!experts && others + rows <= most && !cutOff) return;

	grid.removeWidget(&parameters);
	auto* const place  = new QWidget(&inside);
	auto* const column = new QVBoxLayout(place);
	column->setContentsMargins(0, 0, 0, 0);
	QToolButton* const arrow       = experts ? makeArrow(place) : nullptr;
	const int          arrowHeight = experts ? arrow->sizeHint().height() + column->spacing() : 0;
	// The filter's text may take a line more in the new width.
	const int   more = arrowHeight + dialog.fontMetrics().lineSpacing();
	auto* const area = new ParameterArea(&parameters, everydayNum, most, others + more);
	column->addWidget(area);
	if (experts) {
		column->addWidget(arrow);
		connectArrow(arrow, area);
		putAfterParameters(arrow, parameters);
	}
	grid.addWidget(place, kParameterRow, 0, 1, 2);
	grid.setRowStretch(kParameterRow, 1);
	area->fitDialog();
}

} // namespace

void shortenDialog(const QString& title, int everydayNum)
{
	QDockWidget* const dialog = shownDialog(title);
	if (dialog == nullptr || dialog->widget() == nullptr || dialog->screen() == nullptr) return;
	auto* const grid = qobject_cast<QGridLayout*>(dialog->widget()->layout());
	if (grid == nullptr) return;
	QWidget* const parameters = widgetAt(*grid, kParameterRow);
	QWidget* const below      = widgetAt(*grid, kParameterRow + 1);
	if (parameters == nullptr || below == nullptr) return;
	// Default, pressed in a shortened dialog, comes here, too.
	if (parameters->findChild<QScrollArea*>() != nullptr) return;
	scrollParameters(*dialog, *grid, *parameters, *below, everydayNum);
}

void shortenDialogLater(const QString& title, int everydayNum, QObject* alive)
{
	QTimer::singleShot(0, alive, [title, everydayNum] { shortenDialog(title, everydayNum); });
}

} // namespace gpr_filter
