// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Formats by other libraries: glTF as text, and 3MF. Builds without the library say so.
#include "mesh_files.h"
#include "program_runner.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

namespace gpr_test {

namespace {

using Json = nlohmann::json;

struct Format {
	const char* extension;
	const char* library;
	bool        isThere;
};

std::vector<Format> libraryFormats()
{
	return {{".gltf", "libtinygltf-dev", gpr::app::hasGltfText()},
			{".3mf", "lib3mf-dev", gpr::app::hasThreeMf()}};
}

std::uint32_t crcOf(const std::string& bytes)
{
	std::uint32_t crc = 0xffffffff;
	for (const char byte : bytes) {
		crc ^= std::uint8_t(byte);
		for (int bit = 0; bit < 8; ++bit)
			crc = (crc >> 1) ^ (crc & 1 ? 0xedb88320 : 0);
	}
	return ~crc;
}

/// An archive of files, names and contents, without compression.
std::string zipOf(const std::vector<std::pair<std::string, std::string>>& files)
{
	std::string zip, index;
	const auto  put = [](std::string& to, std::initializer_list<int> shorts) {
        for (const int value : shorts)
            putBinary(to, std::uint16_t(value), true);
	};
	for (const auto& [name, text] : files) {
		const auto  at = std::uint32_t(zip.size());
		std::string about; // the fields that both places have
		put(about, {20, 0, 0, 0, 33});
		for (const std::uint32_t value :
			 {crcOf(text), std::uint32_t(text.size()), std::uint32_t(text.size())})
			putBinary(about, value, true);
		put(about, {int(name.size()), 0});
		zip += "PK\3\4" + about + name + text;
		index += "PK\1\2";
		put(index, {20});
		index += about;
		put(index, {0, 0, 0, 0, 0});
		putBinary(index, at, true);
		index += name;
	}
	const auto begin = std::uint32_t(zip.size()), size = std::uint32_t(index.size());
	zip += index + "PK\5\6";
	put(zip, {0, 0, int(files.size()), int(files.size())});
	putBinary(zip, size, true);
	putBinary(zip, begin, true);
	put(zip, {0});
	return zip;
}

/// A 3MF file of one object. ofObject: attributes; resources: other resources, as XML.
std::string threeMf(const TestMesh& mesh, const std::string& unit, const std::string& ofObject = "",
					const std::string& resources = "")
{
	const std::string folder = "http://schemas.openxmlformats.org/package/2006/";
	const std::string own    = "http://schemas.microsoft.com/3dmanufacturing/";
	std::string       model  = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"" + unit +
						"\" xml:lang=\"en-US\" xmlns=\"" + own + "core/2015/02\" xmlns:m=\"" + own +
						"material/2015/02\"><resources>" + resources +
						"<object id=\"1\" type=\"model\" " + ofObject + "><mesh><vertices>";
	for (const auto& p : mesh.points)
		model += "<vertex x=\"" + digits(p[0], 9) + "\" y=\"" + digits(p[1], 9) + "\" z=\"" +
				 digits(p[2], 9) + "\"/>";
	model += "</vertices><triangles>";
	for (const auto& f : mesh.faces)
		model += "<triangle v1=\"" + std::to_string(f[0]) + "\" v2=\"" + std::to_string(f[1]) +
				 "\" v3=\"" + std::to_string(f[2]) + "\"/>";
	model +=
		"</triangles></mesh></object></resources><build><item objectid=\"1\"/></build></model>";
	return zipOf(
		{{"[Content_Types].xml",
		  "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Types xmlns=\"" + folder +
			  "content-types\"><Default Extension=\"rels\" ContentType=\"application/"
			  "vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"model\" "
			  "ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>"},
		 {"_rels/.rels", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<Relationships xmlns=\"" +
							 folder +
							 "relationships\"><Relationship Target=\"/3D/3dmodel.model\" "
							 "Id=\"r0\" Type=\"" +
							 own + "2013/01/3dmodel\"/></Relationships>"},
		 {"3D/3dmodel.model", model}});
}

} // namespace

class LibraryFormats : public CliTest {
protected:
	/// Coordinates and corners of a file with floats.
	static std::pair<std::vector<float>, std::vector<std::int32_t>> read(const std::string& file)
	{
		gpr::app::WantedAttributes wanted;
		const gpr::app::InputMesh  mesh = gpr::app::readMesh(file, wanted);
		return {{mesh.floats.begin(), mesh.floats.end()},
				{mesh.triangles.begin(), mesh.triangles.end()}};
	}
};

TEST_F(LibraryFormats, HoldTheMeshOfBinaryGltf)
{
	const std::string in = put("in.ply", binaryPly(sphere(20), true, false));
	ASSERT_EQ(run({"remesh", in, path("out.glb"), "--vertices", "100"}).exitCode, 0);
	for (const Format& format : libraryFormats()) {
		if (!format.isThere) continue;
		const std::string   file = path(std::string("out") + format.extension);
		const ProgramResult made = run({"remesh", in, file, "--vertices", "100"});
		ASSERT_EQ(made.exitCode, 0) << made.err;
		const auto [points, corners]  = read(file);
		const auto [expected, theirs] = read(path("out.glb"));
		EXPECT_EQ(corners, theirs) << format.extension;
		ASSERT_EQ(points.size(), expected.size());
		for (std::size_t i = 0; i < points.size(); ++i)
			EXPECT_NEAR(points[i], expected[i], 2e-7) << format.extension;
		const ProgramResult again = run({"remesh", file, path("again.ply"), "--vertices", "60"});
		EXPECT_EQ(again.exitCode, 0) << again.err;
	}
}

/// The library's own numbers of the parts of a file are random.
TEST_F(LibraryFormats, ThreeMfHasTheSameBytesInEveryRun)
{
	if (!gpr::app::hasThreeMf()) GTEST_SKIP() << "this build has no lib3mf";
	const std::string in = put("in.ply", binaryPly(sphere(20), true, false));
	for (const char* name : {"a.3mf", "b.3mf"})
		ASSERT_EQ(run({"remesh", in, path(name), "--vertices", "100"}).exitCode, 0);
	ASSERT_EQ(run({"remesh", in, path("c.3mf"), "--vertices", "101"}).exitCode, 0);
	EXPECT_EQ(content(path("a.3mf")), content(path("b.3mf")));
	EXPECT_NE(content(path("a.3mf")), content(path("c.3mf")));
}

TEST_F(LibraryFormats, ThreeMfKeepsItsUnit)
{
	if (!gpr::app::hasThreeMf()) GTEST_SKIP() << "this build has no lib3mf";
	for (const std::string unit : {"micron", "millimeter", "centimeter", "inch", "foot", "meter"}) {
		const std::string   in   = put("in.3mf", threeMf(sphere(20), unit));
		const ProgramResult made = run({"remesh", in, path("out.3mf"), "--vertices", "100"});
		ASSERT_EQ(made.exitCode, 0) << made.err;
		EXPECT_EQ(made.out.find("Not carried over"), std::string::npos) << made.out;
		gpr::app::WantedAttributes wanted;
		EXPECT_EQ(gpr::app::readMesh(path("out.3mf"), wanted).attributes.unit, unit);
	}
}

TEST_F(LibraryFormats, UnitThatNoOtherFormatHoldsIsTold)
{
	if (!gpr::app::hasThreeMf()) GTEST_SKIP() << "this build has no lib3mf";
	const std::string in = put("in.3mf", threeMf(sphere(20), "inch"));
	for (const char* name : {"out.ply", "out.obj", "out.off", "out.stl", "out.glb"}) {
		const ProgramResult made = run({"remesh", in, path(name), "--vertices", "100"});
		EXPECT_NE(made.out.find("Not carried over: the unit 'inch'."), std::string::npos)
			<< name << made.out;
	}
}

TEST_F(LibraryFormats, MaterialsAndNamesOfThreeMfAreTold)
{
	if (!gpr::app::hasThreeMf()) GTEST_SKIP() << "this build has no lib3mf";
	const std::string materials =
		"<basematerials id=\"2\"><base name=\"oak\" displaycolor=\"#FF0000\"/></basematerials>";
	const std::string in = put(
		"in.3mf", threeMf(sphere(20), "inch", "name=\"lid\" pid=\"2\" pindex=\"0\"", materials));
	const ProgramResult made = run({"remesh", in, path("out.3mf"), "--vertices", "100"});
	ASSERT_EQ(made.exitCode, 0) << made.err;
	EXPECT_NE(made.out.find("Not carried over: names of objects, materials."), std::string::npos)
		<< made.out;
}

TEST_F(LibraryFormats, CoordinatesTooLargeForThreeMfAreTold)
{
	if (!gpr::app::hasThreeMf()) GTEST_SKIP() << "this build has no lib3mf";
	TestMesh mesh = sphere(20);
	for (auto& p : mesh.points) {
		for (double& c : p)
			c *= 2e9;
	}
	const std::string in = put("in.ply", binaryPly(mesh, true, false));
	expectFailure(run({"remesh", in, path("out.3mf"), "--vertices", "100"}), 1,
				  "the coordinates are too large for 3MF, which lib3mf writes below 1,000,000,000");
	EXPECT_FALSE(exists(path("out.3mf")));
}

TEST_F(LibraryFormats, AreNamedWithTheirLibraryWhereItIsMissing)
{
	const std::string in = put("in.ply", binaryPly(sphere(20), true, false));
	for (const Format& format : libraryFormats()) {
		const std::string   file = path(std::string("out") + format.extension);
		const ProgramResult made = run({"remesh", in, file, "--vertices", "100"});
		EXPECT_EQ(made.exitCode, format.isThere ? 0 : 2) << made.err;
		EXPECT_EQ(made.err.find(format.library) == std::string::npos, format.isThere) << made.err;
	}
}

/// Texts name the formats of the build, and no other formats.
TEST_F(LibraryFormats, AreNamedInTextsOfBuildsWithTheLibrary)
{
	const std::vector<std::vector<std::string>> calls = {
		{"remesh", "--help"},   {"levels", "--help"}, {"info", "--help"},   {"compare", "--help"},
		{"features", "--help"}, {"--manual-page"},    {"info", "scan.tiff"}};
	for (const std::vector<std::string>& call : calls) {
		const ProgramResult made = run(call);
		std::string         text = made.out + made.err;
		std::replace(text.begin(), text.end(), '\n', ' ');
		const auto isRun = [](char a, char b) { return a == ' ' && b == ' '; };
		text.erase(std::unique(text.begin(), text.end(), isRun), text.end());
		EXPECT_NE(text.find(gpr::app::formatNames()), std::string::npos) << call.front();
		for (const Format& format : libraryFormats()) {
			const bool isNamed = text.find(format.extension) != std::string::npos;
			EXPECT_EQ(isNamed, format.isThere) << call.front() << format.extension;
		}
	}
}

TEST_F(LibraryFormats, RefuseFilesThatAreNone)
{
	for (const Format& format : libraryFormats()) {
		if (!format.isThere) continue;
		for (const char* text :
			 {"nonsense", "{", "{\"asset\": {\"version\": \"2.0\"}}", "PK\3\4"}) {
			const std::string   in   = put(std::string("in") + format.extension, text);
			const ProgramResult made = run({"remesh", in, path("out.ply"), "--vertices", "100"});
			EXPECT_EQ(made.exitCode, 3) << format.extension << text << made.err;
		}
	}
}

/// Buffers and images may be in other files, or inside as text: "AAAA" is three bytes 0.
TEST_F(LibraryFormats, GltfHasItsBuffersInOtherFiles)
{
	if (!gpr::app::hasGltfText()) GTEST_SKIP() << "this build has no TinyGLTF";
	const std::string in = put("in.ply", binaryPly(sphere(20), true, false));
	ASSERT_EQ(run({"remesh", in, path("one.gltf"), "--vertices", "100"}).exitCode, 0);
	Json              json = Json::parse(content(path("one.gltf")));
	const std::string glb  = gpr::app::glbOfGltf(content(path("one.gltf")), "");
	const std::size_t size = json["buffers"][0]["byteLength"];
	put("one.bin", glb.substr(glb.size() - size));
	json["buffers"][0]["uri"] = "one.bin";
	json["images"]            = {{{"uri", "data:image/png;base64,AAAA"}}};
	const std::string moved   = put("two.gltf", json.dump());
	EXPECT_EQ(read(moved), read(path("one.gltf")));
	const ProgramResult missing = run({"info", put("far/three.gltf", json.dump())});
	EXPECT_EQ(missing.exitCode, 3) << "the buffer is not there";
}

TEST_F(LibraryFormats, GltfKeepsMaterialsAndImages)
{
	if (!gpr::app::hasGltfText()) GTEST_SKIP() << "this build has no TinyGLTF";
	const std::string in = put("in.ply", binaryPly(sphere(20), true, false));
	ASSERT_EQ(run({"remesh", in, path("one.gltf"), "--vertices", "100"}).exitCode, 0);
	Json json         = Json::parse(content(path("one.gltf")));
	json["materials"] = Json::parse(R"([{"name": "oak", "pbrMetallicRoughness":
		{"baseColorTexture": {"index": 0}, "roughnessFactor": 0.5}}])");
	json["textures"]  = {{{"source", 0}}};
	json["images"]    = {{{"uri", "data:image/png;base64,AAAA"}}};
	json["meshes"][0]["primitives"][0]["material"] = 0;
	const std::string   with                       = put("two.gltf", json.dump());
	const ProgramResult made = run({"remesh", with, path("out.gltf"), "--vertices", "60"});
	ASSERT_EQ(made.exitCode, 0) << made.err;
	EXPECT_EQ(made.out.find("Not carried over"), std::string::npos) << made.out;
	const Json out = Json::parse(content(path("out.gltf")));
	EXPECT_EQ(out["materials"][0]["name"], "oak");
	EXPECT_EQ(out["materials"][0]["pbrMetallicRoughness"]["roughnessFactor"], 0.5);
	EXPECT_EQ(out["images"].size(), 1u);
	ASSERT_EQ(run({"remesh", with, path("out.ply"), "--vertices", "60"}).exitCode, 0);
	EXPECT_NE(content(path("out.ply")).find("comment name of material 0 oak"), std::string::npos);
}

TEST_F(LibraryFormats, ThreeMfHoldsNoAttributes)
{
	if (!gpr::app::hasThreeMf()) GTEST_SKIP() << "this build has no lib3mf";
	const std::string   in   = put("in.obj", "usemtl oak\n" + obj(sphere(20)));
	const ProgramResult made = run({"remesh", in, path("out.3mf"), "--vertices", "100"});
	ASSERT_EQ(made.exitCode, 0) << made.err;
	EXPECT_NE(made.out.find("any attribute, which this format does not hold"), std::string::npos)
		<< made.out;
}

} // namespace gpr_test
