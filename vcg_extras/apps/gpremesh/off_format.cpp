// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "off_format.h"

#include "exit_code.h"
#include "face_list.h"
#include "precision.h"
#include "text_scanner.h"

namespace gpr::app {

namespace {

/// Checks the keyword and returns the first of the three counts, which may share its line.
std::string_view readKeyword(TextScanner& text)
{
	const std::string_view keyword = text.word();
	const std::size_t      off     = keyword.find("OFF");
	if (off == keyword.npos || off + 3 != keyword.size()) {
		throw AppError(ExitCode::BadInput, "an OFF file must begin with the word OFF");
	}
	if (keyword.substr(0, off).find_first_of("4n") != keyword.npos) {
		text.fail("OFF files of other than three dimensions are not read");
	}
	const std::string_view next = text.word();
	if (next == "BINARY") text.fail("binary OFF files are not read");
	return next;
}

std::size_t checkedCount(std::int64_t count, const TextScanner& text)
{
	// A record takes at least a digit and a line break.
	if (count < 0) text.fail("a negative count");
	if (std::uint64_t(count) > (text.bytesLeft() + 1) / 2) text.failTruncated();
	return std::size_t(count);
}

void readPosition(TextScanner& text, CoordinateArray<double>& positions)
{
	for (int k = 0; k < 3; ++k)
		positions.push_back(text.nextNumber());
	text.nextLine();
}

void readFace(TextScanner& text, FaceList& faces, std::vector<std::int64_t>& corners)
{
	corners.resize(checkedCount(text.nextInteger(), text));
	for (std::int64_t& c : corners)
		c = text.nextInteger();
	faces.add(corners.data(), corners.size());
	text.nextLine();
}

} // namespace

InputMesh readOff(std::string_view file)
{
	InputMesh              mesh;
	FaceList               faces;
	TextScanner            text(file, '#');
	const std::string_view firstCount = readKeyword(text);
	if (firstCount.empty()) text.failTruncated();
	const std::size_t vertexNum = checkedCount(text.integer(firstCount), text);
	const std::size_t faceNum   = checkedCount(text.nextInteger(), text);
	text.nextLine(); // the number of edges is of no use and often left out

	mesh.doublePrecision = true;
	mesh.doubles.reserve(3 * vertexNum);
	for (std::size_t v = 0; v < vertexNum; ++v)
		readPosition(text, mesh.doubles);
	std::vector<std::int64_t> corners;
	for (std::size_t f = 0; f < faceNum; ++f)
		readFace(text, faces, corners);
	faces.finish(mesh);
	settlePrecision(mesh);
	return mesh;
}

void writeOff(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out)
{
	out.text("OFF\n");
	out.integer(std::int64_t(mesh.vertexNum()));
	out.text(" ");
	out.integer(std::int64_t(mesh.faceNum()));
	out.text(" 0\n");
	for (const Vec3d& p : mesh.positions) {
		out.position(p, doublePrecision);
		out.text("\n");
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		out.text("3");
		for (std::size_t k = 0; k < 3; ++k) {
			out.text(" ");
			out.integer(mesh.triangles[3 * f + k]);
		}
		out.text("\n");
	}
}

} // namespace gpr::app
