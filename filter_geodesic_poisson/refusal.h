// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_REFUSAL_H
#define FILTER_GEODESIC_POISSON_REFUSAL_H

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gpr_filter {

/// Thrown if a filter cannot do its work: sentences for the user. Never leaves applyFilter, and
/// nothing was changed before.
class Refusal : public std::runtime_error {
public:
	explicit Refusal(std::vector<std::string> sentences) :
			std::runtime_error("refused"), _sentences(std::move(sentences))
	{
	}
	explicit Refusal(const std::string& sentence) : Refusal(std::vector<std::string>{sentence}) {}

	const std::vector<std::string>& sentences() const { return _sentences; }

private:
	std::vector<std::string> _sentences;
};

} // namespace gpr_filter

#endif
