// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_REPORT_PROGRESS_BAR_H
#define VCG_EXTRAS_APPS_GPREMESH_REPORT_PROGRESS_BAR_H

#include <vcg_extras/io/base/stopwatch.h>

#include <string>

namespace gpr::app {

/// A line on standard error with the progress of the work; removed at the end.
class ProgressBar {
public:
	/// A bar that is not shown does nothing.
	explicit ProgressBar(bool shown) : shown_(shown) {}
	~ProgressBar() { clear(); }
	ProgressBar(const ProgressBar&)            = delete;
	ProgressBar& operator=(const ProgressBar&) = delete;

	/// Shows a share in [0, 1] and a phrase about the work; draws at most ten times a second.
	void show(double share, const char* phrase);
	/// Shows a line of words, and nothing else for a second and a half.
	void tell(const std::string& words);
	/// Leaves a clean line.
	void clear();

private:
	void draw(const std::string& line);

	bool        shown_;
	std::string drawn_;
	Stopwatch   clock_;
	double      nextDraw_ = 0;
};

} // namespace gpr::app

#endif
