// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_DIALOG_HEIGHT_H
#define FILTER_GEODESIC_POISSON_DIALOG_HEIGHT_H

// The dialogs of MeshLab 2020.09 show every parameter of a filter and do not scroll: where there
// are many, Apply is below the end of the screen. To leave parameters out is no way: the scripts of
// meshlabserver must have those of the dialog, no more and no less. So the dialog is changed: an
// arrow shows the parameters for experts, as in MeshLab 2025.07, and what is still too high
// scrolls.

#include <QString>

class QObject;

namespace gpr_filter {

/// Dialogs are made no higher than this, in pixels at 96 dpi, or than the screen allows.
constexpr int kMaxDialogHeight = 760;

/// Hides all but the first `everydayNum` parameters of the dialog with this title behind an arrow,
/// and makes the parameters scroll where the dialog is too high. Its buttons and the host's ways
/// with its values stay. Does nothing where there is no such dialog, or one of another form. Not
/// before the host has shown it.
void shortenDialog(const QString& title, int everydayNum);

/// Calls shortenDialog() as soon as the host is done with what it does now, unless `alive` is gone.
void shortenDialogLater(const QString& title, int everydayNum, QObject* alive);

} // namespace gpr_filter

#endif
