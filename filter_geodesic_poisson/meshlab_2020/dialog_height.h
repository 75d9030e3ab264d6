// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_DIALOG_HEIGHT_H
#define FILTER_GEODESIC_POISSON_DIALOG_HEIGHT_H

// The dialogs of MeshLab 2020.09 show every parameter of a filter and do not scroll: with many
// parameters, Apply is below the end of the screen. Parameters cannot be left out: the scripts of
// meshlabserver must have exactly the parameters of the dialog. So the dialog is changed: an arrow
// shows the parameters for experts, as in MeshLab 2025.07, and a dialog still too high scrolls.

#include <QString>

class QObject;

namespace gpr_filter {

/// Dialogs are made no higher than this, in pixels at 96 dpi, or than the screen allows.
constexpr int kMaxDialogHeight = 760;

/// Hides all but the first `everydayNum` parameters of the dialog with this title behind an arrow,
/// and makes the parameters scroll if the dialog is too high. Its buttons and values stay usable.
/// Does nothing if the dialog is missing, or has another form. To be called after the host has
/// shown the dialog.
void shortenDialog(const QString& title, int everydayNum);

/// Calls shortenDialog() as soon as the host is idle, unless `alive` is gone.
void shortenDialogLater(const QString& title, int everydayNum, QObject* alive);

} // namespace gpr_filter

#endif
