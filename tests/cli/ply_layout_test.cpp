// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The PLY reader on files of every layout: properties of any type in any order.
#include "mesh_files.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/mesh_formats.h>

#include <cstdint>
#include <gtest/gtest.h>
#include <random>

namespace gpr_test {

namespace {

using gpr::app::InputMesh;
using gpr::app::lookAtPly;
using gpr::app::readPly;

enum class Format { Ascii, Little, Big };

const char* const formatNames[] = {"ascii", "binary_little_endian", "binary_big_endian"};

/// Builds a PLY body value by value.
class Body {
public:
	explicit Body(Format format) : format_(format) {}

	/// Puts a value of a PLY type; must fit.
	void put(const std::string& type, double value)
	{
		const bool little = format_ == Format::Little;
		if (format_ == Format::Ascii) {
			bytes += digits(value) + " ";
		}
		else if (type == "char" || type == "int8") {
			putBinary(bytes, std::int8_t(value), little);
		}
		else if (type == "uchar" || type == "uint8") {
			putBinary(bytes, std::uint8_t(value), little);
		}
		else if (type == "short" || type == "int16") {
			putBinary(bytes, std::int16_t(value), little);
		}
		else if (type == "ushort" || type == "uint16") {
			putBinary(bytes, std::uint16_t(value), little);
		}
		else if (type == "int" || type == "int32") {
			putBinary(bytes, std::int32_t(value), little);
		}
		else if (type == "uint" || type == "uint32") {
			putBinary(bytes, std::uint32_t(value), little);
		}
		else if (type == "float" || type == "float32") {
			putBinary(bytes, float(value), little);
		}
		else {
			putBinary(bytes, value, little);
		}
	}
	void endRecord()
	{
		if (format_ == Format::Ascii) bytes += "\n";
	}

	std::string bytes;

private:
	Format format_;
};

struct Property {
	std::string name;
	std::string type;
	std::string countType; ///< empty = no list
};

std::string declared(const Property& p)
{
	const std::string list = p.countType.empty() ? "" : "list " + p.countType + " ";
	return "property " + list + p.type + " " + p.name + "\n";
}

/// A random layout, and a file of a random mesh in this layout.
class RandomFile {
public:
	explicit RandomFile(std::uint32_t seed) : random_(seed)
	{
		format_ = Format(pick(3));
		makeMesh();
		layOut();
	}

	std::string text()
	{
		std::string header =
			std::string("ply\nformat ") + formatNames[int(format_)] + " 1.0\ncomment a test\n";
		Body body(format_);
		if (pick(2)) writeExtra(header, body);
		// Some programs write the faces first.
		const bool facesFirst = pick(4) == 0;
		if (facesFirst) writeFaces(header, body);
		writeVertices(header, body);
		if (pick(2)) writeExtra(header, body);
		if (!facesFirst) writeFaces(header, body);
		return header + "end_header\n" + body.bytes;
	}

	const TestMesh& mesh() const { return mesh_; }

private:
	std::mt19937          random_;
	Format                format_ = Format::Ascii;
	TestMesh              mesh_;
	std::vector<Property> vertexProperties_, faceProperties_;

	int pick(int num) { return int(random_() % std::uint32_t(num)); }
	template <std::size_t N>
	std::string oneOf(const char* const (&words)[N])
	{
		return words[pick(int(N))];
	}
	std::string scalarType()
	{
		static const char* const types[] = {
			"char", "uchar", "short", "ushort", "int",   "uint",   "float",   "double",
			"int8", "uint8", "int16", "uint16", "int32", "uint32", "float32", "float64"};
		return oneOf(types);
	}
	std::string indexType()
	{
		static const char* const types[] = {"char", "uchar", "short", "ushort",
											"int",  "uint",  "int32", "uint32"};
		return oneOf(types);
	}

	void makeMesh()
	{
		// Small whole coordinates: every scalar type holds such values.
		const int vertexNum = 3 + pick(60);
		for (int v = 0; v < vertexNum; ++v)
			mesh_.points.push_back({double(pick(100)), double(pick(100)), double(pick(100))});
		for (int f = 1 + pick(60); f > 0; --f)
			mesh_.faces.push_back({pick(vertexNum), pick(vertexNum), pick(vertexNum)});
	}

	void addNoise(std::vector<Property>& properties, const std::string& prefix)
	{
		for (int i = pick(4); i > 0; --i) {
			const Property noise{prefix + std::to_string(i), scalarType(),
								 pick(4) == 0 ? indexType() : ""};
			properties.insert(properties.begin() + pick(int(properties.size()) + 1), noise);
		}
	}

	void layOut()
	{
		// Mostly x y z of the same type side by side: the reader has a separate path for such
		// files.
		const std::string type = pick(2) ? "float" : scalarType();
		const bool        same = pick(3) != 0;
		for (const char* name : {"x", "y", "z"})
			vertexProperties_.push_back({name, same ? type : scalarType(), ""});
		if (pick(3) == 0) std::shuffle(vertexProperties_.begin(), vertexProperties_.end(), random_);
		addNoise(vertexProperties_, "v");
		const char* const names[] = {"vertex_indices", "vertex_index"};
		faceProperties_.push_back(
			{oneOf(names), pick(2) ? "int" : indexType(), pick(2) ? "uchar" : indexType()});
		addNoise(faceProperties_, "f");
	}

	void writeNoise(const Property& p, Body& body)
	{
		const int num = p.countType.empty() ? 1 : pick(5);
		if (!p.countType.empty()) body.put(p.countType, num);
		for (int i = 0; i < num; ++i)
			body.put(p.type, pick(100));
	}

	void writeExtra(std::string& header, Body& body)
	{
		const int count = pick(5);
		header +=
			"element extra" + std::to_string(header.size()) + " " + std::to_string(count) + "\n";
		std::vector<Property> properties;
		addNoise(properties, "e");
		for (const Property& p : properties)
			header += declared(p);
		for (int i = 0; i < count; ++i) {
			for (const Property& p : properties)
				writeNoise(p, body);
			body.endRecord();
		}
	}

	void writeVertices(std::string& header, Body& body)
	{
		header += "element vertex " + std::to_string(mesh_.points.size()) + "\n";
		for (const Property& p : vertexProperties_)
			header += declared(p);
		for (const auto& point : mesh_.points) {
			for (const Property& p : vertexProperties_) {
				if (p.name == "x" || p.name == "y" || p.name == "z") {
					body.put(p.type, point[std::size_t(p.name[0] - 'x')]);
				}
				else {
					writeNoise(p, body);
				}
			}
			body.endRecord();
		}
	}

	void writeFaces(std::string& header, Body& body)
	{
		header += "element face " + std::to_string(mesh_.faces.size()) + "\n";
		for (const Property& p : faceProperties_)
			header += declared(p);
		for (const auto& face : mesh_.faces) {
			for (const Property& p : faceProperties_) {
				if (p.name.rfind("vertex_ind", 0) != 0) {
					writeNoise(p, body);
					continue;
				}
				body.put(p.countType, 3);
				for (const int i : face)
					body.put(p.type, i);
			}
			body.endRecord();
		}
	}
};

TestMesh asTestMesh(const InputMesh& mesh)
{
	TestMesh out;
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
		const gpr::Vec3d p = mesh.view().position(v);
		out.points.push_back({p.x, p.y, p.z});
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f)
		out.faces.push_back(mesh.view().triangle(f));
	return out;
}

std::string headerOf(const std::string& file)
{
	return file.substr(0, file.find("end_header"));
}

} // namespace

TEST(PlyLayout, RandomLayoutsAreReadExactly)
{
	for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
		RandomFile        random(seed);
		const std::string file = random.text();
		SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + headerOf(file));
		const TestMesh got = asTestMesh(readPly(file));
		ASSERT_EQ(got.points, random.mesh().points);
		ASSERT_EQ(got.faces, random.mesh().faces);
	}
}

TEST(PlyLayout, LookedAtInTheFileItIsTheSame)
{
	int inFileNum = 0;
	for (std::uint32_t seed = 1; seed <= 2000; ++seed) {
		RandomFile        random(seed);
		const std::string file = random.text();
		SCOPED_TRACE("seed " + std::to_string(seed) + "\n" + headerOf(file));
		const InputMesh mesh = lookAtPly(file), copy = readPly(file);
		const TestMesh  got = asTestMesh(mesh);
		ASSERT_EQ(got.points, random.mesh().points);
		ASSERT_EQ(got.faces, random.mesh().faces);
		ASSERT_EQ(mesh.doublePrecision, copy.doublePrecision);
		inFileNum += mesh.isInFile();
	}
	EXPECT_GT(inFileNum, 5);
}

TEST(PlyLayout, WhatCannotBeUsedAsItLiesIsCopiedOrRefusedAsEver)
{
	const auto fileOf = [](const std::string& indexType, int corners, std::int32_t last) {
		std::string file = "ply\nformat binary_little_endian 1.0\nelement vertex 4\nproperty float "
						   "x\nproperty float y\nproperty float z\nelement face 1\nproperty list "
						   "uchar " +
						   indexType + " vertex_indices\nend_header\n";
		for (float c : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0})
			putBinary(file, c, true);
		file += char(corners);
		for (std::int32_t i = 0; i < corners; ++i)
			putBinary(file, i < corners - 1 ? i : last, true);
		return file;
	};
	EXPECT_TRUE(lookAtPly(fileOf("int", 3, 2)).isInFile());
	const InputMesh quad = lookAtPly(fileOf("int", 4, 3));
	EXPECT_FALSE(quad.isInFile());
	EXPECT_EQ(quad.faceNum(), 2u);
	for (const std::int32_t outside : {4, -1})
		EXPECT_THROW(lookAtPly(fileOf("int", 3, outside)), gpr::app::AppError);
	const std::string whole = fileOf("int", 3, 2);
	EXPECT_THROW(lookAtPly(whole.substr(0, whole.size() - 1)), gpr::app::AppError);
}

TEST(PlyLayout, EveryPrefixIsReadOrRefusedWithoutHarm)
{
	// Under the sanitizers this loop also shows reads beyond the end.
	for (std::uint32_t seed = 1; seed <= 40; ++seed) {
		const std::string file = RandomFile(seed).text();
		for (std::size_t keep = 0; keep < file.size(); keep += 1 + file.size() / 200) {
			const std::vector<char> exact(file.begin(), file.begin() + long(keep));
			try {
				readPly({exact.data(), exact.size()});
				lookAtPly({exact.data(), exact.size()});
			}
			catch (const gpr::app::AppError& error) {
				EXPECT_EQ(error.code, gpr::app::ExitCode::BadInput);
			}
		}
	}
}

TEST(PlyLayout, DamagedBytesAreReadOrRefusedWithoutHarm)
{
	std::mt19937 random(5);
	for (std::uint32_t seed = 1; seed <= 400; ++seed) {
		std::string file = RandomFile(seed).text();
		for (int i = 0; i < 5; ++i)
			file[random() % file.size()] = char(random());
		try {
			for (const InputMesh& mesh : {readPly(file), lookAtPly(file)}) {
				for (const std::int32_t i : gpr::triangleMeshOf(mesh.view()).triangles) {
					ASSERT_GE(i, 0) << seed;
					ASSERT_LT(std::size_t(i), mesh.vertexNum()) << seed;
				}
			}
		}
		catch (const gpr::app::AppError& error) {
			EXPECT_EQ(error.code, gpr::app::ExitCode::BadInput);
		}
	}
}

TEST(PlyLayout, PrecisionFollowsTheTypes)
{
	const auto precisionOf = [](const std::string& type) {
		const std::string header =
			"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty " + type +
			" y\nproperty float z\nelement face 0\nproperty list uchar int "
			"vertex_indices\nend_header\n";
		return readPly(header + "1 2 3\n").doublePrecision;
	};
	EXPECT_FALSE(precisionOf("float"));
	EXPECT_FALSE(precisionOf("short"));
	EXPECT_TRUE(precisionOf("double"));
	EXPECT_TRUE(precisionOf("int"));
}

TEST(PlyLayout, LineBreaksOfAllSystems)
{
	// The first byte of the body looks like a line break but is none.
	for (const std::string lineBreak : {"\n", "\r\n", "\r"}) {
		std::string header;
		for (const char* line :
			 {"ply", "format binary_little_endian 1.0", "element vertex 3", "property uchar x",
			  "property uchar y", "property uchar z", "element face 1",
			  "property list uchar uchar vertex_index", "end_header"}) {
			header += line + lineBreak;
		}
		const std::string body({'\n', 2, 3, 4, 5, 6, 7, 8, 9, 3, 2, 1, 0});
		const TestMesh    mesh = asTestMesh(readPly(header + body));
		ASSERT_EQ(mesh.points.size(), 3u);
		EXPECT_EQ(mesh.points[0], (std::array<double, 3>{10, 2, 3}));
		EXPECT_EQ(mesh.faces, (std::vector<std::array<int, 3>>{{2, 1, 0}}));
	}
}

TEST(PlyLayout, TriangleStrips)
{
	// 0---2---4      two strips; every second triangle is turned over, the repeated 4 steers only
	//  \ / \ / \       .
	//   1---3---5
	const std::string file =
		"ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
		"property float z\nelement tristrips 2\nproperty list int int vertex_indices\nend_header\n"
		"0 1 0\n.5 0 0\n1 1 0\n1.5 0 0\n2 1 0\n2.5 0 0\n"
		"8 0 1 2 3 -1 2 3 4\n4 3 4 4 5\n";
	EXPECT_EQ(asTestMesh(readPly(file)).faces,
			  (std::vector<std::array<int, 3>>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}}));
}

TEST(PlyLayout, StripsAndFacesInEitherOrder)
{
	const std::string vertices = "element vertex 4\nproperty float x\nproperty float y\n"
								 "property float z\n";
	const std::string strips   = "element tristrips 1\nproperty list int int vertex_indices\n";
	const std::string faces    = "element face 1\nproperty list uchar int vertex_indices\n";
	const std::string begin    = "ply\nformat ascii 1.0\n" + vertices,
					  points   = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
	const std::string face = "3 3 2 1\n", strip = "4 0 1 2 3\n";
	EXPECT_EQ(
		asTestMesh(readPly(begin + strips + faces + "end_header\n" + points + strip + face)).faces,
		(std::vector<std::array<int, 3>>{{0, 1, 2}, {2, 1, 3}, {3, 2, 1}}));
	EXPECT_EQ(
		asTestMesh(readPly(begin + faces + strips + "end_header\n" + points + face + strip)).faces,
		(std::vector<std::array<int, 3>>{{3, 2, 1}, {0, 1, 2}, {2, 1, 3}}));
}

TEST(PlyLayout, WhatFollowsTheFacesDoesNotMatter)
{
	const std::string file =
		"ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
		"property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
		"element other 99\nproperty float q\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\nbroken";
	EXPECT_EQ(readPly(file).faceNum(), 1u);
}

TEST(PlyLayout, PolygonsAmongTriangles)
{
	const std::string file =
		"ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
		"property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
		"0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 2 0\n"
		"4 0 1 2 3\n3 3 2 4\n2 0 1\n1 0\n";
	const InputMesh mesh = readPly(file);
	EXPECT_EQ(mesh.faceNum(), 3u);
	ASSERT_EQ(mesh.notes.size(), 1u);
	EXPECT_NE(mesh.notes[0].find("2 faces"), std::string::npos);
}

} // namespace gpr_test
