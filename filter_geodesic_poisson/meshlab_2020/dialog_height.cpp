// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
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
#include <algorithm>

namespace gpr_filter {

namespace {

// The host's dialog, a dock widget with a grid:
//
//   row 0    what the filter says of itself
//   row 1    the frame with the parameters: label, value, help
//   row 2    Preview, where there is such a thing
//   row 2/3  Default, Help
//   row 3/4  Close, Apply
constexpr int kParameterRow = 1;

bool changesByWheel(const QObject* value)
{
	return qobject_cast<const QComboBox*>(value) != nullptr ||
		   qobject_cast<const QAbstractSpinBox*>(value) != nullptr;
}

/// The texts that Help shows get the height they need; the host's frame cuts them off.
void showInFull(QLabel& text)
{
	QSizePolicy policy = text.sizePolicy();
	policy.setHeightForWidth(true);
	text.setSizePolicy(policy);
}

/// Scrolls the parameters up and down, and keeps the dialog as wide as they need it.
class ParameterArea : public QScrollArea {
public:
	/// othersHeight: of all else in the dialog.
	ParameterArea(QWidget* parameters, int dialogHeight, int othersHeight) :
			_dialogHeight(dialogHeight), _othersHeight(othersHeight)
	{
		setFrameShape(QFrame::NoFrame);
		setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
		setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
		setWidgetResizable(true);
		setWidget(parameters);
		for (QWidget* part : parameters->findChildren<QWidget*>()) {
			auto* const text = qobject_cast<QLabel*>(part);
			if (text != nullptr && text->wordWrap()) showInFull(*text);
			if (changesByWheel(part)) part->installEventFilter(this);
		}
	}

	QSize sizeHint() const override
	{
		return {wantedWidth(),
				std::min(widget()->sizeHint().height(), _dialogHeight - _othersHeight)};
	}

	/// Takes the width that the parameters need now, and the dialog with it.
	void fitDialog()
	{
		QWidget&  inside = *parentWidget();
		const int frame  = window()->width() - inside.width();
		setMinimumWidth(wantedWidth());
		inside.layout()->activate();
		const int width = frame + inside.layout()->minimumSize().width();
		window()->setMinimumSize(
			width, std::min(_dialogHeight, _othersHeight + minimumSizeHint().height()));
		window()->resize(width, _dialogHeight);
		window()->installEventFilter(this);
	}

protected:
	bool eventFilter(QObject* object, QEvent* event) override
	{
		// The wheel scrolls; it does not change the value that happens to be under it.
		if (event->type() == QEvent::Wheel && changesByWheel(object)) {
			event->ignore();
			return true;
		}
		const bool seen = QScrollArea::eventFilter(object, event);
		if (event->type() == QEvent::Resize && object == window()) fitDialogAgain();
		// The help texts come and go beside the values.
		const bool moved = event->type() == QEvent::LayoutRequest && object == widget();
		if (moved && minimumWidth() != wantedWidth()) fitDialog();
		return seen;
	}

private:
	int _dialogHeight, _othersHeight;

	/// On a slow machine the window manager takes up the host's first, full height only after the
	/// change, and with it overrides the change.
	void fitDialogAgain()
	{
		const QScreen* const screen = window()->screen();
		if (screen == nullptr || window()->height() <= screen->availableGeometry().height()) return;
		QTimer::singleShot(0, this, [this] { fitDialog(); });
	}

	int wantedWidth() const
	{
		return widget()->sizeHint().width() + verticalScrollBar()->sizeHint().width();
	}
};

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
					  const QWidget& below)
{
	QWidget&  inside = *dialog.widget();
	const int most   = maxHeightOn(*dialog.screen());
	const int title  = dialog.height() - inside.height();
	const int others = title + parameters.y() + inside.height() - below.y() + grid.spacing();
	const int rows   = std::max(parameters.sizeHint().height(), parameters.height());
	// The host forgets the height of its own text, so that the last rows can be behind the buttons.
	const bool cutOff = parameters.geometry().bottom() > below.y();
	if (others + rows <= most && !cutOff) return;
	grid.removeWidget(&parameters);
	auto* const area = new ParameterArea(&parameters, std::min(most, others + rows), others);
	grid.addWidget(area, kParameterRow, 0, 1, 2);
	grid.setRowStretch(kParameterRow, 1);
	area->fitDialog();
}

} // namespace

void shortenDialog(const QString& title)
{
	QDockWidget* const dialog = shownDialog(title);
	if (dialog == nullptr || dialog->widget() == nullptr || dialog->screen() == nullptr) return;
	auto* const grid = qobject_cast<QGridLayout*>(dialog->widget()->layout());
	if (grid == nullptr) return;
	QWidget* const parameters = widgetAt(*grid, kParameterRow);
	QWidget* const below      = widgetAt(*grid, kParameterRow + 1);
	if (parameters == nullptr || below == nullptr) return;
	// Default, pressed in a dialog that was shortened, comes here, too.
	if (qobject_cast<QScrollArea*>(parameters) != nullptr) return;
	scrollParameters(*dialog, *grid, *parameters, *below);
}

void shortenDialogLater(const QString& title, QObject* alive)
{
	QTimer::singleShot(0, alive, [title] { shortenDialog(title); });
}

} // namespace gpr_filter
