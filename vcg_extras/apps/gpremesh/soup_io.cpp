// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The only file that includes CGAL: its headers take seconds to compile.
#include "soup_io.h"

#include "exit_code.h"
#include "face_list.h"
#include "ply_layout.h"
#include "precision.h"
#include "soup_text.h"
#include "text_lines.h"

#include <CGAL/IO/OBJ.h>
#include <CGAL/IO/OFF.h>
#include <CGAL/IO/PLY.h>
#include <CGAL/IO/STL.h>
#include <CGAL/Simple_cartesian.h>
#include <array>
#include <boost/container/small_vector.hpp>
#include <boost/interprocess/streams/bufferstream.hpp>
#include <boost/iostreams/stream.hpp>
#include <cctype>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gpr::app {

namespace {

using Point        = CGAL::Simple_cartesian<double>::Point_3;
using MemoryStream = boost::interprocess::ibufferstream;

[[noreturn]] void fail(const std::string& sentence)
{
	throw AppError(ExitCode::BadInput, sentence);
}

/// The corners of a face. Its size is bounded: CGAL resizes it to what an OFF file says before it
/// looks whether there are as many numbers.
struct Polygon : boost::container::small_vector<std::int32_t, 4> {
	static constexpr std::size_t maxCorners = 1 << 20;

	void resize(std::size_t num)
	{
		if (num > maxCorners) fail("a face with more than 1048576 corners");
		boost::container::small_vector<std::int32_t, 4>::resize(num);
	}
};

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

template <class P>
struct Soup {
	std::vector<P>       points;
	std::vector<Polygon> faces;
};

const auto silent = CGAL::parameters::verbose(false);

/// Calls one of CGAL's readers; false when it throws what a damaged file makes it throw.
template <class Reader>
bool succeeds(Reader read)
{
	try {
		return read();
	}
	catch (const std::ios_base::failure&) {
		return false;
	}
	catch (const std::length_error&) { // a negative number taken as a size
		return false;
	}
}

/// Names the line of the word that CGAL stopped at.
[[noreturn]] void failAt(const SoupText& soup, MemoryStream& in, const std::string& what)
{
	in.exceptions(std::ios::goodbit);
	in.clear();
	const std::size_t at  = std::size_t(in.tellg());
	const bool        end = at >= soup.text.size();
	fail("line " + std::to_string(lineAt(soup, at + 1)) + ": " + what +
		 (end ? ", or the file ends too early" : ""));
}

template <class P>
void copyPositions(const std::vector<P>& points, InputMesh& mesh)
{
	mesh.doublePrecision = true;
	mesh.doubles.reserve(3 * points.size());
	for (const P& p : points) {
		for (int k = 0; k < 3; ++k) {
			const double c = p[k];
			mesh.doubles.push_back(c != nonFiniteMark ? c : std::nan(""));
		}
	}
}

template <class P>
InputMesh meshOf(const Soup<P>& soup, std::size_t stripBegin = 0, std::size_t stripNum = 0)
{
	InputMesh                 mesh;
	FaceList                  list;
	std::vector<std::int64_t> corners;
	copyPositions(soup.points, mesh);
	for (std::size_t f = 0; f < soup.faces.size(); ++f) {
		corners.assign(soup.faces[f].begin(), soup.faces[f].end());
		if (f - stripBegin < stripNum) {
			list.addStrip(corners);
		}
		else {
			list.add(corners.data(), corners.size());
		}
	}
	list.finish(mesh);
	return mesh;
}

} // namespace

// ---- STL

namespace {

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

/// The first word decides, but binary files may begin with "solid" too: so the size that the count
/// asks for goes first, and zero bytes tell as well.
bool isBinaryStl(std::string_view file)
{
	if (file.size() < stlHeaderBytes + 4) return false;
	if (file.size() == promisedStlBytes(file)) return true;
	return !beginsWithSolid(file) || file.substr(0, 1024).find('\0') != file.npos;
}

InputMesh readAsciiStl(std::string_view file)
{
	const SoupText  text = prepareAsciiStl(file);
	MemoryStream    in(text.text.data(), text.text.size());
	Soup<StlCorner> soup;
	const bool      whole = CGAL::IO::read_STL(in, soup.points, soup.faces, silent);
	if (!whole || soup.faces.size() != text.faceNum) {
		fail("a facet is malformed or the file ends too early");
	}
	InputMesh mesh = meshOf(soup);
	if (!text.ended) mesh.notes.push_back("The STL file has no 'endsolid'; it may be cut off.");
	settlePrecision(mesh);
	return mesh;
}

} // namespace

std::size_t promisedStlBytes(std::string_view file)
{
	std::size_t faceNum = 0;
	for (std::size_t i = 4; i-- > 0;)
		faceNum = faceNum << 8 | std::uint8_t(file[stlHeaderBytes + i]);
	return stlHeaderBytes + 4 + 50 * faceNum;
}

InputMesh readStl(std::string_view file)
{
	if (isBinaryStl(file)) {
		if (promisedStlBytes(file) > file.size()) {
			fail("the file ends too early: its header promises " +
				 std::to_string(promisedStlBytes(file)) + " bytes");
		}
		return readBinaryStl(file);
	}
	if (!beginsWithSolid(file)) fail("neither an ASCII nor a binary STL file");
	return readAsciiStl(file);
}

// ---- PLY

InputMesh readAsciiPly(const PlyHeader& header, std::string_view body)
{
	const SoupText text = prepareAsciiPly(header, body);
	MemoryStream   in(text.text.data(), text.text.size());
	Soup<Point>    soup;
	in.exceptions(std::ios::failbit | std::ios::badbit); // or a long list is read to its end
	const bool whole =
		succeeds([&] { return CGAL::IO::read_PLY(in, soup.points, soup.faces, silent); });
	if (!whole || soup.points.size() != text.vertexNum || soup.faces.size() != text.faceNum) {
		failAt(text, in, badNumber);
	}
	InputMesh mesh = meshOf(soup, text.stripBegin, text.stripNum);
	if (!text.doublePrecision) roundToFloat(mesh);
	return mesh;
}

// ---- writing

namespace {

/// An output file as the end of a stream.
class Sink {
public:
	using char_type = char;
	using category  = boost::iostreams::sink_tag;

	explicit Sink(OutputFile& out) : out_(&out) {}
	std::streamsize write(const char* data, std::streamsize num)
	{
		out_->bytes(data, std::size_t(num));
		return num;
	}

private:
	OutputFile* out_;
};

using Triangles = std::vector<std::array<std::int32_t, 3>>;

/// Hands points, triangles and a stream to one of CGAL's writers.
template <class Writer>
void writeSoup(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out, Writer write)
{
	constexpr std::size_t pollMask = 0xfffff;
	std::vector<Point>    points;
	points.reserve(mesh.vertexNum());
	for (const Vec3d& p : mesh.positions) {
		if ((points.size() & pollMask) == 0) out.poll();
		points.push_back(doublePrecision ? Point(p.x, p.y, p.z)
										 : Point(float(p.x), float(p.y), float(p.z)));
	}
	Triangles triangles(mesh.faceNum());
	for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
		if ((i & pollMask) == 0) out.poll();
		triangles[i / 3][i % 3] = mesh.triangles[i];
	}

	boost::iostreams::stream<Sink> stream(out);
	stream.exceptions(std::ios::badbit); // hands on what the output file throws
	stream.precision(doublePrecision ? std::numeric_limits<double>::max_digits10
									 : std::numeric_limits<float>::max_digits10);
	write(stream, points, triangles);
	stream.flush();
}

} // namespace

void writeObj(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out)
{
	writeSoup(mesh, doublePrecision, out, [](auto& stream, const auto& points, const auto& faces) {
		CGAL::IO::write_OBJ(stream, points, faces);
	});
}

void writeOff(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out)
{
	writeSoup(mesh, doublePrecision, out, [](auto& stream, const auto& points, const auto& faces) {
		CGAL::IO::write_OFF(stream, points, faces);
	});
}

void writeStl(const TriangleMesh& mesh, OutputFile& out)
{
	writeSoup(mesh, true, out, [](auto& stream, const auto& points, const auto& faces) {
		CGAL::IO::set_binary_mode(stream);
		CGAL::IO::write_STL(stream, points, faces);
	});
}

} // namespace gpr::app
