// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Selections in PLY files of MeshLab.
#include "mesh_files.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh_io.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <unistd.h>

namespace gpr_test {

namespace {

using gpr::app::InputMesh;
using gpr::app::readPlyAttributes;
using gpr::app::WantedAttributes;

const char* const formats[] = {"ascii", "binary_little_endian", "binary_big_endian"};

/// Writes values in a format of PLY files.
class Values {
public:
	explicit Values(const std::string& format) : format_(format) {}

	template <class T>
	void put(T value)
	{
		if (format_ == "ascii") {
			text += digits(double(value)) + " ";
		}
		else {
			putBinary(text, value, format_ == "binary_little_endian");
		}
	}

	std::string text;

private:
	std::string format_;
};

/// Four vertices with flags and quality, in the order of vcglib's exporter, and two triangles with
/// flags. Vertex 1 and the second face (0, 2, 3) are selected; other bits are set, too.
std::string attributedPly(const std::string& format)
{
	Values body(format);
	for (int v = 0; v < 4; ++v) {
		body.put(float(v % 2));
		body.put(float(v / 2));
		body.put(0.f);
		body.put(std::int32_t(v == 1 ? 0x120 : 0x100));
		body.put(std::uint8_t(7));
		body.put(float(0.5 * v - 1));
	}
	const int faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
	for (int f = 0; f < 2; ++f) {
		body.put(std::uint8_t(3));
		for (int k = 0; k < 3; ++k)
			body.put(std::int32_t(faces[f][k]));
		body.put(std::int32_t(f == 1 ? 0x20 : 0x40));
	}
	return "ply\nformat " + format +
		   " 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
		   "property int flags\nproperty uchar red\nproperty float quality\n"
		   "element face 2\nproperty list uchar int vertex_indices\nproperty int flags\n"
		   "end_header\n" +
		   body.text;
}

InputMesh read(const std::string& file, const WantedAttributes& wanted)
{
	InputMesh mesh = gpr::app::readPly(file);
	readPlyAttributes(file, wanted, mesh);
	return mesh;
}

std::string asciiWith(const std::string& property, const std::string& values)
{
	return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
		   "property float z\nproperty " +
		   property + "\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
		   values + "3 0 1 2\n";
}

} // namespace

TEST(PlyAttributes, SelectedVerticesOrElseCornersOfSelectedFaces)
{
	for (const char* format : formats) {
		std::string file = attributedPly(format);
		EXPECT_EQ(read(file, {true}).selected, (std::vector<std::uint8_t>{0, 1, 0, 0}));
		// Without the face's selection, by another name of its property.
		file.replace(file.rfind("int flags"), 9, "int marks");
		EXPECT_EQ(read(file, {true}).selected, (std::vector<std::uint8_t>{0, 1, 0, 0}));
		file.replace(file.find("int flags"), 9, "int marks");
		file.replace(file.rfind("int marks"), 9, "int flags");
		EXPECT_EQ(read(file, {true}).selected, (std::vector<std::uint8_t>{1, 0, 1, 1}));
	}
}

TEST(PlyAttributes, SelectedByItsOwnProperty)
{
	const std::string file = asciiWith("uchar selected", "0 0 0 0\n1 0 0 1\n0 1 0 200\n");
	EXPECT_EQ(read(file, {true}).selected, (std::vector<std::uint8_t>{0, 1, 1}));
}

TEST(PlyAttributes, WhatIsMissingIsTold)
{
	const std::string file = asciiWith("float weight", "0 0 0 1\n1 0 0 1\n0 1 0 1\n");
	try {
		read(file, {true});
		ADD_FAILURE() << "not refused";
	}
	catch (const gpr::app::AppError& error) {
		EXPECT_EQ(error.code, gpr::app::ExitCode::BadInput);
		EXPECT_NE(std::string(error.what()).find("selected"), std::string::npos);
	}
}

/// Also without other values, and only if anything is selected.
TEST(PlyAttributes, ASelectionThatIsNotWantedIsTold)
{
	const std::vector<std::string> both = {"the selection of vertices", "the selection of faces"};
	WantedAttributes               carried;
	carried.carried = true;
	for (const char* format : formats)
		EXPECT_EQ(read(attributedPly(format), carried).attributes.lost, both) << format;
	EXPECT_EQ(read(asciiWith("int flags", "0 0 0 0 0 1 0 32 1 0 0 256 "), carried).attributes.lost,
			  std::vector<std::string>{both[0]});
	EXPECT_TRUE(read(asciiWith("int flags", "0 0 0 0 0 1 0 2 1 0 0 256 "), carried)
					.attributes.lost.empty());
	WantedAttributes ofFaces = carried, ofVertices = carried;
	ofFaces.faceSelection  = true;
	ofVertices.ifSelected  = true;
	const std::string file = attributedPly("ascii");
	EXPECT_EQ(read(file, ofFaces).attributes.lost, std::vector<std::string>{both[0]});
	EXPECT_EQ(read(file, ofVertices).attributes.lost, std::vector<std::string>{both[1]});
}

TEST(PlyAttributes, AListIsNoSelection)
{
	const std::string file = asciiWith("list uchar float selected", "0 0 0 0\n1 0 0 0\n0 1 0 0\n");
	EXPECT_THROW(read(file, {true}), gpr::app::AppError);
}

TEST(PlyAttributes, OtherFormatsCarryNone)
{
	const std::string path =
		std::filesystem::temp_directory_path() / ("gpr_" + std::to_string(getpid()) + ".off");
	std::ofstream(path) << off(sphere(2));
	try {
		gpr::app::readMesh(path, {true});
		ADD_FAILURE() << "not refused";
	}
	catch (const gpr::app::AppError& error) {
		EXPECT_EQ(error.code, gpr::app::ExitCode::Usage);
		EXPECT_NE(std::string(error.what()).find("PLY"), std::string::npos);
	}
	std::filesystem::remove(path);
}

TEST(PlyAttributes, CutFilesAreRefusedWithoutHarm)
{
	for (const char* format : formats) {
		const std::string file  = attributedPly(format);
		const InputMesh   whole = gpr::app::readPly(file);
		for (std::size_t keep = 0; keep + 3 < file.size(); ++keep) {
			const std::vector<char> exact(file.begin(), file.begin() + long(keep));
			InputMesh               mesh = whole;
			EXPECT_THROW(readPlyAttributes({exact.data(), keep}, {true}, mesh), gpr::app::AppError)
				<< format << " " << keep;
		}
	}
}

} // namespace gpr_test
