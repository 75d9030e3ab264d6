// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CGAL: its headers take seconds to compile.
#include "soup_io.h"

#include "soup_text.h"
#include "stl_facets.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh/face_list.h>
#include <vcg_extras/io/mesh/precision.h>

#include <CGAL/IO/STL.h>
#include <array>
#include <boost/interprocess/streams/bufferstream.hpp>
#include <cctype>
#include <cmath>

namespace gpr::app {

namespace {

using MemoryStream = boost::interprocess::ibufferstream;

[[noreturn]] void fail(const std::string& sentence)
{
	throw AppError(ExitCode::BadInput, sentence);
}

/// A corner of an STL file. CGAL makes one vertex of equal ones by a std::map: so NaN, which would
/// put its order in disorder, comes after all numbers.
struct StlCorner : std::array<double, 3> {
	bool operator<(const StlCorner& b) const
	{
		for (std::size_t k = 0; k < 3; ++k) {
			if (isLess((*this)[k], b[k])) return true;
			if (isLess(b[k], (*this)[k])) return false;
		}
		return false;
	}

private:
	static bool isLess(double a, double b) { return std::isnan(b) ? !std::isnan(a) : a < b; }
};

struct Soup {
	std::vector<StlCorner>                   points;
	std::vector<std::array<std::int32_t, 3>> faces;
};

InputMesh meshOf(const Soup& soup)
{
	InputMesh mesh;
	mesh.doublePrecision = true;
	mesh.doubles.reserve(3 * soup.points.size());
	for (const StlCorner& p : soup.points) {
		for (const double c : p)
			mesh.doubles.push_back(c != nonFiniteMark ? c : std::nan(""));
	}
	FaceList list;
	for (const std::array<std::int32_t, 3>& face : soup.faces) {
		const std::array<std::int64_t, 3> corners = {face[0], face[1], face[2]};
		list.add(corners.data(), corners.size());
	}
	list.finish(mesh);
	return mesh;
}

constexpr std::size_t stlHeaderBytes = 80;

bool beginsWithSolid(std::string_view file)
{
	file.remove_prefix(std::min(file.find_first_not_of(" \t\r\n"), file.size()));
	std::string word(file.substr(0, 6));
	for (char& c : word)
		c = char(std::tolower(static_cast<unsigned char>(c)));
	return word == "solid" ||
		   (word.compare(0, 5, "solid") == 0 && std::isspace(static_cast<unsigned char>(word[5])));
}

InputMesh readAsciiStl(std::string_view file)
{
	const SoupText text = prepareAsciiStl(file);
	MemoryStream   in(text.text.data(), text.text.size());
	Soup           soup;
	const bool     whole =
		CGAL::IO::read_STL(in, soup.points, soup.faces, CGAL::parameters::verbose(false));
	if (!whole || soup.faces.size() != text.faceNum) {
		fail("a facet is malformed or the file ends too early");
	}
	InputMesh mesh = meshOf(soup);
	if (!text.ended) mesh.notes.push_back("The STL file has no 'endsolid'; it may be cut off.");
	settlePrecision(mesh);
	return mesh;
}

} // namespace

std::uint64_t promisedStlBytes(std::string_view begin)
{
	std::uint64_t faceNum = 0;
	for (std::size_t i = 4; i-- > 0;)
		faceNum = faceNum << 8 | std::uint8_t(begin[stlHeaderBytes + i]);
	return stlFacetsAt + stlFacetBytes * faceNum;
}

// The first word decides, but binary files may begin with "solid" too: so the size that the count
// asks for goes first, and zero bytes tell as well.
bool isBinaryStl(std::string_view begin, std::uint64_t fileBytes)
{
	if (begin.size() < stlFacetsAt) return false;
	if (fileBytes == promisedStlBytes(begin)) return true;
	return !beginsWithSolid(begin) || begin.substr(0, 1024).find('\0') != begin.npos;
}

void requireAllFacets(std::string_view begin, std::uint64_t fileBytes)
{
	if (promisedStlBytes(begin) <= fileBytes) return;
	fail("the file ends too early: its header promises " + std::to_string(promisedStlBytes(begin)) +
		 " bytes");
}

InputMesh readStl(std::string_view file)
{
	if (isBinaryStl(file, file.size())) {
		requireAllFacets(file, file.size());
		return readBinaryStl(file);
	}
	if (!beginsWithSolid(file)) fail("neither an ASCII nor a binary STL file");
	return readAsciiStl(file);
}

} // namespace gpr::app
