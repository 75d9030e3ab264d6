// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ply_layout.h"

#include <vcg_extras/io/base/exit_code.h>

#include <algorithm>

namespace gpr::app {

void checkElements(const PlyHeader& header)
{
	for (const char* name : {"vertex", "face", "tristrips"}) {
		const auto num = std::count_if(header.elements.begin(), header.elements.end(),
									   [&](const PlyElement& e) { return e.name == name; });
		if (num > 1) failInput("its header has the element '" + std::string(name) + "' twice");
	}
}

std::size_t usefulElementNum(const PlyHeader& header)
{
	std::size_t num = 0;
	for (std::size_t i = 0; i < header.elements.size(); ++i) {
		const std::string& name = header.elements[i].name;
		if (name == "vertex" || name == "face" || name == "tristrips") num = i + 1;
	}
	return num;
}

CoordinateProperties findCoordinates(const PlyElement& e)
{
	const CoordinateProperties c{e.find("x"), e.find("y"), e.find("z")};
	for (const int i : {c.x, c.y, c.z}) {
		if (i < 0 || e.properties[i].isList) failInput("its vertices have no x, y and z");
	}
	return c;
}

bool needsDouble(const PlyElement& e, const CoordinateProperties& c)
{
	for (const int i : {c.x, c.y, c.z}) {
		const PlyType type = e.properties[i].type;
		if (type == PlyType::Float64 || type == PlyType::Int32 || type == PlyType::UInt32) {
			return true;
		}
	}
	return false;
}

int findIndexList(const PlyElement& e)
{
	for (const char* name : {"vertex_indices", "vertex_index"}) {
		const int i = e.find(name);
		if (i >= 0 && e.properties[i].isList && isInteger(e.properties[i].type)) return i;
	}
	failInput("its element '" + e.name + "' has no list of vertex indices");
}

void failTruncated(const PlyElement& e)
{
	failInput("the file ends too early: its header promises " + std::to_string(e.count) +
			  " records of '" + e.name + "'");
}

} // namespace gpr::app
