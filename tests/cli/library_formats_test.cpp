// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Formats by other libraries: glTF as text, and 3MF. Builds without the library say so.
#include "mesh_files.h"
#include "program_runner.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh_io.h>

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
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

} // namespace gpr_test
