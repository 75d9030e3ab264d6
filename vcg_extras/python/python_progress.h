// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_PYTHON_PROGRESS_H
#define VCG_EXTRAS_PYTHON_PYTHON_PROGRESS_H

#include "parameter_values.h"

#include <vcg_extras/core/progress.h>

#include <exception>
#include <nanobind/nanobind.h>

namespace gpr::python {

/// Calls Python while the engine runs without the interpreter's lock: handles signals like Ctrl+C,
/// and calls the caller's progress function, which may return False to cancel. An exception from
/// either ends the run; rethrow raises the exception again.
class PythonProgress {
public:
	/// function: None is not called; signals are still handled.
	explicit PythonProgress(nanobind::object function) : function_(std::move(function)) {}

	/// The callback for the engine. This object must outlive the run.
	ProgressCallback callback()
	{
		return [this](double share, const char* phrase) { return goesOn(share, phrase); };
	}

	/// Needs the interpreter's lock.
	void rethrow() const
	{
		if (raised_) std::rethrow_exception(raised_);
	}

private:
	nanobind::object   function_;
	std::exception_ptr raised_;

	bool goesOn(double share, const char* phrase)
	{
		const nanobind::gil_scoped_acquire lock;
		try {
			if (PyErr_CheckSignals() != 0) nanobind::raise_python_error();
			return function_.is_none() || switchOf(function_(share, phrase)) != false;
		}
		catch (...) {
			raised_ = std::current_exception();
			return false;
		}
	}
};

} // namespace gpr::python

#endif
