// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "old_parameters.h"

#include <QString>
#include <algorithm>

namespace gpr_filter {

namespace {

/// A former parameter that scripts may still name.
struct OldParameter {
	const char* key;
	double      usual;   ///< its default, which is the present behaviour
	const char* instead; ///< the present behaviour, and the replacement
};

constexpr OldParameter kOldParameters[] = {
	{"Placement", 0, "the preset paper places samples on border edges"},
	{"Retriangulation", 0, "the preset paper removes single vertices"},
	{"Smoothing", 0, "the preset paper smooths by the umbrella operator"},
	{"Equations", 0, "the preset paper takes the equations as they are printed"},
	{"Regularity", 0, "the preset fast leaves the steps for regularity out"},
	{"Fit", 0, "the preset paper leaves every vertex on the surface"},
	{"ExactCount", 0, "the number of vertices is exact but with the preset paper"},
	{"FeatureSampling", 0,
	 "the preset paper without a feature disk scale keeps each vertex of the feature region"},
	{"Sizing", 0, "the density follows the curvature"},
	{"MaxStretch", 4, "the smallest triangles are at most 4 times smaller than the largest"},
	{"Guard", 0, "results are always free of self-intersections but with the preset paper"},
};

double numberOf(const RichParameter& parameter)
{
	return parameter.stringType() == "RichFloat" ? double(parameter.value().getFloat())
												 : double(parameter.value().getInt());
}

/// The type first, because MeshLab asserts on the wrong type.
bool isNumber(const RichParameter& parameter)
{
	const QString type = parameter.stringType();
	return type == "RichFloat" || type == "RichInt" || type == "RichEnum";
}

} // namespace

std::vector<std::string> notesOnOldParameters(const RichParameterList& list)
{
	std::vector<std::string> notes;
	for (const OldParameter& old : kOldParameters) {
		if (!list.hasParameter(old.key)) continue;
		const RichParameter& parameter = list.getParameterByName(old.key);
		if (isNumber(parameter) && numberOf(parameter) == old.usual) continue;
		notes.push_back(std::string("The script's parameter ") + old.key +
						" is gone and was not followed: " + old.instead + ".");
	}
	return notes;
}

bool isOldScript(const RichParameterList& list)
{
	return std::any_of(std::begin(kOldParameters), std::end(kOldParameters),
					   [&](const OldParameter& old) { return list.hasParameter(old.key); });
}

} // namespace gpr_filter
