// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// The dialog of many parameters, compared with a model of the dialog of MeshLab 2020.09.

#include "dialog_height.h"

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QGridLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMainWindow>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QToolButton>
#include <QWheelEvent>
#include <gtest/gtest.h>
#include <vector>

namespace {

constexpr int kAllRows = 1000; // none is for experts

/// The widgets of MeshlabStdDialog::loadFrameContent().
class HostDialog {
public:
	explicit HostDialog(int rowNum) : _dialog("Plugin", &_window)
	{
		_dialog.setAllowedAreas(Qt::NoDockWidgetArea);
		_dialog.setFloating(true);
		_dialog.setWindowTitle("Many rows");
		auto* const inside = new QFrame(&_dialog);
		_dialog.setWidget(inside);
		auto* const grid = new QGridLayout(inside);
		auto* const info = new QLabel("<i>What the filter does.</i>", inside);
		info->setWordWrap(true);
		grid->addWidget(info, 0, 0, 1, 2, Qt::AlignTop);
		grid->addWidget(frameOf(rowNum), 1, 0, 1, 2);
		grid->addWidget(new QPushButton("Default", inside), 2, 0, Qt::AlignBottom);
		grid->addWidget(new QPushButton("Help", inside), 2, 1, Qt::AlignBottom);
		grid->addWidget(new QPushButton("Close", inside), 3, 0, Qt::AlignBottom);
		apply = new QPushButton("Apply", inside);
		grid->addWidget(apply, 3, 1, Qt::AlignBottom);
		inside->showNormal();
		inside->adjustSize();
		_dialog.setMinimumSize(inside->sizeHint());
		_dialog.showNormal();
		_dialog.adjustSize();
		QApplication::processEvents();
	}

	QWidget&     window() { return _dialog; }
	QToolButton* arrow() { return area()->parentWidget()->findChild<QToolButton*>(); }
	QScrollArea* area() { return _dialog.findChild<QScrollArea*>(); }
	/// As the host's toggleHelp().
	void toggleHelp()
	{
		for (QLabel* text : help) {
			text->setVisible(!text->isVisible());
		}
		_dialog.widget()->adjustSize();
		_dialog.adjustSize();
		QApplication::processEvents();
	}

	std::vector<QLineEdit*> values;
	std::vector<QLabel*>    help;
	QComboBox*              choice = nullptr;
	QPushButton*            apply  = nullptr;

private:
	QMainWindow _window;
	QDockWidget _dialog;

	QFrame* frameOf(int rowNum)
	{
		auto* const frame = new QFrame(&_dialog);
		auto* const grid  = new QGridLayout;
		for (int row = 0; row < rowNum; ++row) {
			values.push_back(new QLineEdit(QString::number(row), frame));
			help.push_back(new QLabel(QString("Some words about a parameter. ").repeated(10)));
			help.back()->setWordWrap(true);
			help.back()->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
			help.back()->setMinimumWidth(250);
			help.back()->setVisible(false);
			grid->addWidget(new QLabel("A parameter", frame), row, 0);
			grid->addWidget(values.back(), row, 1);
			grid->addWidget(help.back(), row, 2, 1, 1, Qt::AlignLeft);
		}
		choice = new QComboBox(frame);
		choice->addItems({"one", "two", "three"});
		grid->addWidget(choice, rowNum, 1);
		frame->setLayout(grid);
		frame->setMinimumSize(grid->sizeHint());
		grid->setSizeConstraint(QLayout::SetMinimumSize);
		frame->showNormal();
		frame->adjustSize();
		return frame;
	}
};

int maxHeight()
{
	return std::min(gpr_filter::kMaxDialogHeight,
					QApplication::primaryScreen()->availableGeometry().height());
}

/// Whether a window shows the whole part.
bool isInside(const QWidget& part, const QWidget& window)
{
	const QRect place(part.mapTo(&window, QPoint(0, 0)), part.size());
	return window.rect().contains(place) && !part.visibleRegion().isEmpty();
}

TEST(DialogHeight, ManyRowsScrollAndApplyIsSeen)
{
	HostDialog host(40);
	ASSERT_GT(host.window().height(), maxHeight()) << "the model is no test";
	gpr_filter::shortenDialog("Many rows", kAllRows);
	QApplication::processEvents();
	EXPECT_LE(host.window().height(), maxHeight());
	EXPECT_TRUE(isInside(*host.apply, host.window()));
	EXPECT_TRUE(isInside(*host.values.front(), host.window()));
	EXPECT_TRUE(host.values.back()->visibleRegion().isEmpty());
	ASSERT_NE(host.area(), nullptr);
	host.area()->ensureWidgetVisible(host.values.back());
	EXPECT_FALSE(host.values.back()->visibleRegion().isEmpty());
	EXPECT_EQ(host.values.back()->text(), "39");
}

TEST(DialogHeight, FewRowsStayAsTheyAre)
{
	HostDialog  host(5);
	const QSize before = host.window().size();
	gpr_filter::shortenDialog("Many rows", kAllRows);
	EXPECT_EQ(host.area(), nullptr);
	EXPECT_EQ(host.window().size(), before);
}

TEST(DialogHeight, OtherDialogsStayAsTheyAre)
{
	HostDialog host(40);
	gpr_filter::shortenDialog("Another filter", 12);
	EXPECT_EQ(host.area(), nullptr);
}

// Default calls the plugin again while the dialog is open.
TEST(DialogHeight, TwiceIsOnce)
{
	HostDialog host(40);
	QObject    alive;
	gpr_filter::shortenDialogLater("Many rows", kAllRows, &alive);
	EXPECT_EQ(host.area(), nullptr);
	gpr_filter::shortenDialogLater("Many rows", kAllRows, &alive);
	QApplication::processEvents();
	EXPECT_EQ(host.window().findChildren<QScrollArea*>().size(), 1);
}

// A slow window manager may set the full height of the first request later.
TEST(DialogHeight, ResizedBeyondTheScreenComesBack)
{
	HostDialog host(40);
	gpr_filter::shortenDialog("Many rows", kAllRows);
	QApplication::processEvents();
	host.window().resize(host.window().width(), 3 * maxHeight());
	QApplication::processEvents();
	EXPECT_LE(host.window().height(), maxHeight());
	EXPECT_TRUE(isInside(*host.apply, host.window()));
}

TEST(DialogHeight, HelpWidensAndIsShownInFull)
{
	HostDialog host(40);
	gpr_filter::shortenDialog("Many rows", kAllRows);
	QApplication::processEvents();
	const QSize before = host.window().size();
	host.toggleHelp();
	EXPECT_GT(host.window().width(), before.width() + 200);
	EXPECT_EQ(host.window().height(), before.height());
	const QLabel& text = *host.help.front();
	EXPECT_GE(text.height(), text.heightForWidth(text.width()));
	host.toggleHelp();
	EXPECT_EQ(host.window().size(), before);
}

TEST(DialogHeight, TheWheelScrollsAndChangesNoValue)
{
	HostDialog host(40);
	gpr_filter::shortenDialog("Many rows", kAllRows);
	host.area()->ensureWidgetVisible(host.choice);
	QWheelEvent turn(QPointF(3, 3), host.choice->mapToGlobal(QPoint(3, 3)), QPoint(),
					 QPoint(0, -120), Qt::NoButton, Qt::NoModifier, Qt::NoScrollPhase, false);
	QApplication::sendEvent(host.choice, &turn);
	EXPECT_EQ(host.choice->currentIndex(), 0);
}

/// The number of shown values; fails if shown values are not the first values.
int shownRowNum(const HostDialog& host)
{
	int num = 0;
	while (num < int(host.values.size()) && host.values[num]->isVisible())
		++num;
	for (int row = num; row < int(host.values.size()); ++row)
		EXPECT_FALSE(host.values[row]->isVisible()) << row;
	return num;
}

TEST(DialogHeight, RowsForExpertsAreBehindAnArrow)
{
	HostDialog host(40);
	gpr_filter::shortenDialog("Many rows", 8);
	QApplication::processEvents();
	EXPECT_EQ(shownRowNum(host), 8);
	EXPECT_FALSE(host.choice->isVisible());
	EXPECT_TRUE(isInside(*host.values[7], host.window())) << "no scrolling for eight rows";
	EXPECT_TRUE(isInside(*host.apply, host.window()));
	const QSize before = host.window().size();
	ASSERT_NE(host.arrow(), nullptr);
	EXPECT_TRUE(isInside(*host.arrow(), host.window()));

	host.arrow()->click();
	QApplication::processEvents();
	EXPECT_EQ(shownRowNum(host), 40);
	EXPECT_TRUE(host.choice->isVisible());
	EXPECT_GT(host.window().height(), before.height());
	EXPECT_LE(host.window().height(), maxHeight());
	EXPECT_TRUE(isInside(*host.apply, host.window()));

	host.arrow()->click();
	QApplication::processEvents();
	EXPECT_EQ(shownRowNum(host), 8);
	EXPECT_EQ(host.window().size(), before);
}

TEST(DialogHeight, HelpIsForTheRowsThatAreShown)
{
	HostDialog host(40);
	gpr_filter::shortenDialog("Many rows", 8);
	QApplication::processEvents();
	host.toggleHelp();
	EXPECT_TRUE(host.help[7]->isVisible());
	EXPECT_FALSE(host.help[8]->isVisible());
	EXPECT_EQ(shownRowNum(host), 8);
	host.arrow()->click();
	QApplication::processEvents();
	EXPECT_TRUE(host.help[39]->isVisible());
	host.toggleHelp();
	EXPECT_FALSE(host.help[0]->isVisible());
	EXPECT_FALSE(host.help[39]->isVisible());
	EXPECT_EQ(shownRowNum(host), 40);
}

TEST(DialogHeight, AShortDialogWithoutExpertsIsLeftAlone)
{
	HostDialog host(5);
	gpr_filter::shortenDialog("Many rows", 6);
	EXPECT_EQ(host.area(), nullptr);
}

} // namespace
