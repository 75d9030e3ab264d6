// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_PYTHON_PROGRESS_H
#define VCG_EXTRAS_PYTHON_PYTHON_PROGRESS_H

#include <vcg_extras/core/progress.h>

#include <exception>
#include <nanobind/nanobind.h>

namespace gpr::python {

/// Lets Python have a word while the engine runs without the interpreter's lock: signals such as
/// that of Ctrl+C, and the caller's progress function, which may return False to cancel. What they
/// raise ends the run and is raised again by rethrow.
class PythonProgress {
public:
	/// None calls nothing; signals are looked at all the same.
	explicit PythonProgress(nanobind::object function) : function_(std::move(function)) {}

	/// For the engine. This object must outlive the run.
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
			return function_.is_none() || !function_(share, phrase).is(nanobind::bool_(false));
		}
		catch (...) {
			raised_ = std::current_exception();
			return false;
		}
	}
};

} // namespace gpr::python

#endif
