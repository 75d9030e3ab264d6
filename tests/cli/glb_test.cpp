// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Binary glTF files: read, refused, written, read again.
#include "mesh_files.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/glb_container.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh/mesh_attributes.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <unistd.h>

namespace gpr_test {

namespace {

using namespace gpr;
using namespace gpr::app;

/// A file from its two parts, written by nobody but this test.
std::string glbOf(const GltfJson& json, const std::string& binary)
{
	std::string text = json.dump();
	text.append((4 - text.size() % 4) % 4, ' ');
	std::string file;
	for (const std::size_t word :
		 {std::size_t(0x46546C67), std::size_t(2), 28 + text.size() + binary.size(), text.size(),
		  std::size_t(0x4E4F534A)})
		putBinary(file, std::uint32_t(word), true);
	file += text;
	putBinary(file, std::uint32_t(binary.size()), true);
	putBinary(file, std::uint32_t(0x4E4942), true);
	return file + binary;
}

/// A tetrahedron: 48 bytes of positions, 24 of indices.
std::string tetrahedronBytes()
{
	std::string bytes;
	for (const float c : {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1})
		putBinary(bytes, c, true);
	for (const int v : {0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3})
		putBinary(bytes, std::uint16_t(v), true);
	return bytes;
}

GltfJson tetrahedronJson()
{
	return GltfJson::parse(R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
		"nodes": [{"mesh": 0}],
		"meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
		"accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
			{"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"}],
		"bufferViews": [{"buffer": 0, "byteLength": 48},
			{"buffer": 0, "byteOffset": 48, "byteLength": 24}],
		"buffers": [{"byteLength": 72}]})");
}

std::string tetrahedron(const GltfJson& json = tetrahedronJson())
{
	return glbOf(json, tetrahedronBytes());
}

/// Six times the signed volume.
double volumeOf(const InputMesh& mesh)
{
	double         sum  = 0;
	const MeshView view = mesh.view();
	for (std::size_t f = 0; f < view.faceNum; ++f) {
		const auto t = view.triangle(f);
		sum += dot(view.position(std::size_t(t[0])),
				   cross(view.position(std::size_t(t[1])), view.position(std::size_t(t[2]))));
	}
	return sum;
}

/// The sentence of the refusal of a file; empty for a file that is read.
std::string refusal(const std::string& file)
{
	try {
		readGlb(file);
		return "";
	}
	catch (const AppError& error) {
		EXPECT_EQ(error.code, ExitCode::BadInput);
		return error.what();
	}
}

/// The sentence of the refusal of a tetrahedron whose JSON part is changed by a patch (RFC 7396).
std::string refusalOf(const char* patch)
{
	GltfJson json = tetrahedronJson();
	json.merge_patch(GltfJson::parse(patch));
	return refusal(tetrahedron(json));
}

TEST(GlbReader, ReadsAMesh)
{
	const InputMesh mesh = readGlb(tetrahedron());
	EXPECT_EQ(mesh.vertexNum(), 4u);
	EXPECT_EQ(mesh.faceNum(), 4u);
	EXPECT_FALSE(mesh.doublePrecision);
	EXPECT_FALSE(mesh.attributes.any());
	EXPECT_DOUBLE_EQ(volumeOf(mesh), 1);
}

TEST(GlbReader, PutsMeshesWhereTheirNodesAre)
{
	GltfJson json        = tetrahedronJson();
	json["nodes"]        = GltfJson::parse(R"([{"children": [1, 2], "translation": [10, 0, 0]},
		{"mesh": 0, "scale": [2, 2, 2], "rotation": [0, 0, 0.7071067811865476, 0.7071067811865476]},
		{"mesh": 0, "matrix": [1,0,0,0, 0,1,0,0, 0,0,-1,0, 0,0,5,1]}])");
	const InputMesh mesh = readGlb(tetrahedron(json));
	ASSERT_EQ(mesh.vertexNum(), 8u);
	// The second vertex, (1, 0, 0), turned by 90 degrees about z and made twice as far.
	const Vec3d turned = mesh.view().position(1), mirrored = mesh.view().position(7);
	EXPECT_NEAR(length(turned - Vec3d(10, 2, 0)), 0, 1e-6);
	EXPECT_NEAR(length(mirrored - Vec3d(10, 0, 4)), 0, 1e-6);
	// A mirror does not turn the surface inside out.
	EXPECT_NEAR(volumeOf(mesh), 8 + 1, 1e-4);
}

TEST(GlbReader, ReadsStripsAndFansAndPassesOverLines)
{
	GltfJson json                 = tetrahedronJson();
	json["accessors"][1]["count"] = 4;
	json["meshes"][0]["primitives"] =
		GltfJson::parse(R"([{"attributes": {"POSITION": 0}, "mode": 5},
			{"attributes": {"POSITION": 0}, "mode": 6}, {"attributes": {"POSITION": 0}, "mode": 1}])");
	const InputMesh mesh = readGlb(tetrahedron(json));
	ASSERT_EQ(mesh.faceNum(), 4u);
	EXPECT_EQ(mesh.vertexNum(), 4u); // shared by both
	const std::vector<std::int32_t> expected = {0, 1, 2, 1, 3, 2, 0, 1, 2, 0, 2, 3};
	EXPECT_TRUE(std::equal(mesh.triangles.begin(), mesh.triangles.end(), expected.begin()));
	ASSERT_EQ(mesh.notes.size(), 1u);
	EXPECT_NE(mesh.notes[0].find("lines"), std::string::npos);
}

TEST(GlbReader, NamesWhatTheSceneHasBesideTheMesh)
{
	GltfJson json = tetrahedronJson();
	EXPECT_TRUE(readGlb(tetrahedron(json)).attributes.lost.empty());
	json["cameras"] = json["animations"] = GltfJson::parse("[{}]");
	json["extensionsUsed"]               = GltfJson::parse(R"(["KHR_lights_punctual"])");
	json["meshes"].push_back(json["meshes"][0]);
	const std::vector<std::string> expected = {"names of nodes and meshes", "cameras", "animations",
											   "lights"};
	EXPECT_EQ(readGlb(tetrahedron(json)).attributes.lost, expected);
}

TEST(GlbReader, RefusesWhatItDoesNotRead)
{
	EXPECT_NE(refusalOf(R"({"extensionsRequired": ["KHR_draco_mesh_compression"]})")
				  .find("KHR_draco_mesh_compression"),
			  std::string::npos);
	EXPECT_EQ(refusalOf(R"({"extensionsRequired": ["KHR_materials_unlit"]})"), "");
	EXPECT_NE(
		refusalOf(R"({"buffers": [{"byteLength": 72, "uri": "mesh.bin"}]})").find("another file"),
		std::string::npos);
	GltfJson json                                 = tetrahedronJson();
	json["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
	EXPECT_NE(refusal(tetrahedron(json)).find("morph targets"), std::string::npos);
	json                           = tetrahedronJson();
	json["accessors"][0]["sparse"] = GltfJson::object();
	EXPECT_NE(refusal(tetrahedron(json)).find("sparse"), std::string::npos);
}

TEST(GlbReader, RefusesWhatIsMalformed)
{
	const std::string good = tetrahedron();
	EXPECT_NE(refusal("glTF"), "");
	for (const std::size_t at : {std::size_t(0), std::size_t(4), std::size_t(8), std::size_t(16)}) {
		std::string bad = good;
		bad[at]         = char(bad[at] ^ 0x5a);
		EXPECT_NE(refusal(bad), "") << at;
	}
	for (std::size_t length = 1; length < good.size(); ++length)
		EXPECT_NE(refusal(good.substr(0, length)), "") << length;
	EXPECT_NE(refusalOf(R"({"nodes": [{"children": [0]}]})"), "");
	EXPECT_NE(refusalOf(R"({"nodes": [{"mesh": 1}]})"), "");
	EXPECT_NE(refusalOf(R"({"nodes": [{"mesh": -1}]})"), "");
	EXPECT_NE(refusalOf(R"({"nodes": [{"mesh": 0, "matrix": [1, 2]}]})"), "");
	EXPECT_NE(refusalOf(R"({"scenes": null})"), "");
	EXPECT_NE(refusalOf(R"({"bufferViews": [{"buffer": 0, "byteLength": 48}]})"), "");
	EXPECT_NE(refusalOf(R"({"bufferViews": 3})"), "");
	for (const char* change : {R"({"count": 5})", R"({"byteOffset": 4})", R"({"type": "VEC2"})",
							   R"({"count": 4611686018427387905})", R"({"componentType": 7})"}) {
		GltfJson json = tetrahedronJson();
		json["accessors"][0].merge_patch(GltfJson::parse(change));
		EXPECT_NE(refusal(tetrahedron(json)), "") << change;
	}
	GltfJson json                 = tetrahedronJson();
	json["accessors"][1]["count"] = 11; // a part of a triangle
	EXPECT_NE(refusal(tetrahedron(json)), "");
	std::string bytes = tetrahedronBytes();
	bytes[48]         = 4; // of four vertices
	EXPECT_NE(refusal(glbOf(tetrahedronJson(), bytes)).find("does not exist"), std::string::npos);
	EXPECT_NE(refusal(glbOf(
				  GltfJson::parse("[" + std::string(90, '[') + std::string(90, ']') + "]"), "")),
			  "");
	std::string deep(100000, '[');
	std::string file = glbOf(GltfJson::array(), "");
	file.replace(20, 2, deep);
	for (const auto& [at, length] :
		 {std::pair<std::size_t, std::size_t>(8, file.size()), {12, deep.size() + 2}}) {
		std::string word;
		putBinary(word, std::uint32_t(length), true);
		file.replace(at, 4, word);
	}
	EXPECT_NE(refusal(file).find("malformed"), std::string::npos);
}

/// A mesh with all attributes of the format, through a file.
class GlbRoundTrip : public ::testing::Test {
protected:
	GlbRoundTrip() :
			path_((std::filesystem::temp_directory_path() /
				   ("gpremesh_glb_" + std::to_string(getpid()) + ".glb"))
					  .string())
	{
		mesh_.positions = {{0.1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
		mesh_.triangles = {0, 1, 2, 0, 2, 3};
	}
	~GlbRoundTrip() override { std::filesystem::remove(path_); }

	InputMesh roundTrip()
	{
		OutputFile out(path_);
		lost_.clear();
		writeGlb(mesh_, attributes_, out);
		tellLostInGltf(attributes_, lost_);
		out.commit();
		std::stringstream text;
		text << std::ifstream(path_, std::ios::binary).rdbuf();
		file_ = text.str();
		return readGlb(file_);
	}

	std::string              path_, file_;
	TriangleMesh             mesh_;
	MeshAttributes           attributes_;
	std::vector<std::string> lost_;
};

TEST_F(GlbRoundTrip, KeepsPositionsAndFaces)
{
	const InputMesh back = roundTrip();
	EXPECT_TRUE(std::equal(back.triangles.begin(), back.triangles.end(), mesh_.triangles.begin(),
						   mesh_.triangles.end()));
	for (std::size_t v = 0; v < 4; ++v)
		EXPECT_EQ(Vec3f(back.view().position(v)).x, float(mesh_.positions[v].x));
	EXPECT_EQ(file_.size() % 4, 0u);
	const GltfJson position = glbChunksOf(file_).json["accessors"][0];
	EXPECT_EQ(position["min"], GltfJson({0.0, 0.0, 0.0}));
	EXPECT_EQ(position["max"], GltfJson({1.0, 1.0, 0.0}));
}

TEST_F(GlbRoundTrip, KeepsColoursNormalsAndNamesTheRest)
{
	const std::vector<double> some = {0, 10, 128, 255};
	for (const char* name : {"red", "green", "blue"})
		attributes_.ofVertices.push_back({name, PlyType::UInt8, some});
	for (const char* name : {"nx", "ny", "nz"})
		attributes_.ofVertices.push_back({name, PlyType::Float32, {1, 0, 0.6, -2}});
	attributes_.ofVertices.push_back({"quality", PlyType::Float32, some});
	const InputMesh back = roundTrip();
	for (const char* name : {"red", "green", "blue"}) {
		ASSERT_NE(back.attributes.ofVertex(name), nullptr);
		EXPECT_EQ(back.attributes.ofVertex(name)->values, some);
	}
	ASSERT_NE(back.attributes.ofVertex("ny"), nullptr);
	EXPECT_NEAR(back.attributes.ofVertex("ny")->values[0], std::sqrt(1.0 / 3), 1e-6);
	EXPECT_NEAR(back.attributes.ofVertex("ny")->values[3], -std::sqrt(1.0 / 3), 1e-6);
	EXPECT_EQ(lost_, std::vector<std::string>{"'quality' of vertices"});
}

TEST_F(GlbRoundTrip, KeepsTextureCoordinatesBesideASeam)
{
	attributes_.texture.uv = {0, 0, 0.5, 0, 0.5, 0.5, 0, 0, 0.75, 0.5, 0, 0.5}; // vertex 2 has two
	const InputMesh back   = roundTrip();
	EXPECT_EQ(back.vertexNum(), 5u);
	EXPECT_EQ(back.attributes.texture.uv, attributes_.texture.uv);
}

TEST_F(GlbRoundTrip, KeepsMaterialsAndImagesAsTheyWere)
{
	auto materials        = std::make_shared<GltfMaterials>();
	materials->json       = R"({"materials": [{"name": "a", "extras": {"x": [1]}},
		{"name": "b", "emissiveTexture": {"index": 0}}], "textures": [{"source": 1}],
		"images": [{"uri": "far.png"}, {"bufferView": 7, "mimeType": "image/png"}],
		"extensionsUsed": ["KHR_materials_unlit"]})";
	materials->imageBytes = {"", "bytes of an image"};
	attributes_.gltf      = materials;
	attributes_.materials = {"a", "b"};
	attributes_.texture   = {{0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1}, {1, 0}};
	const InputMesh first = roundTrip();
	const GltfJson  json = glbChunksOf(file_).json, wanted = GltfJson::parse(materials->json);
	EXPECT_EQ(json["materials"], wanted["materials"]);
	EXPECT_EQ(json["extensionsUsed"], wanted["extensionsUsed"]);
	EXPECT_EQ(json["meshes"][0]["primitives"].size(), 2u);
	ASSERT_NE(first.attributes.gltf, nullptr);
	EXPECT_EQ(first.attributes.gltf->imageBytes, materials->imageBytes);
	EXPECT_EQ(first.attributes.materials, attributes_.materials);
	// The faces are in the order of their materials now.
	EXPECT_EQ(first.attributes.texture.image, (std::vector<std::int32_t>{0, 1}));
	EXPECT_TRUE(lost_.empty());
}

/// Labels of PLY, groups of OBJ, solids of STL.
TEST_F(GlbRoundTrip, RegionsBecomeMaterials)
{
	attributes_.ofFaces.push_back({"label", PlyType::Int32, {7, 3}});
	const MeshAttributes labels = roundTrip().attributes;
	EXPECT_EQ(labels.materials, (std::vector<std::string>{"label_3", "label_7"}));
	EXPECT_TRUE(lost_.empty());
	attributes_.ofFaces    = {{"group", PlyType::Int32, {0, 1}, {"wall", "in let"}},
							  {"object", PlyType::Int32, {0, 0}, {"pipe"}}};
	const InputMesh groups = roundTrip();
	EXPECT_EQ(groups.attributes.materials, (std::vector<std::string>{"wall pipe", "in let pipe"}));
	EXPECT_EQ(groups.attributes.ofFaces[0].values, (std::vector<double>{0, 1}));
	EXPECT_TRUE(lost_.empty());
	attributes_.ofFaces = {{"solid", PlyType::Int32, {0, 1}, {"", ""}}};
	EXPECT_EQ(roundTrip().attributes.materials, (std::vector<std::string>{"solid_0", "solid_1"}));
}

TEST_F(GlbRoundTrip, MaterialsGoBeforeOtherRegions)
{
	attributes_.ofFaces = {{"group", PlyType::Int32, {0, 1}, {"wall", "in let"}},
						   {"material", PlyType::Int32, {1, 0}, {"oak", "ash"}}};
	EXPECT_EQ(roundTrip().attributes.materials, (std::vector<std::string>{"oak", "ash"}));
	EXPECT_EQ(lost_, std::vector<std::string>{"'group' of faces"});
}

TEST_F(GlbRoundTrip, LevelsShareTheMaterialsOfTheirRegions)
{
	attributes_.ofFaces = {{"label", PlyType::Int32, {7, 3}}};
	GlbLevel fine{mesh_, attributes_}, coarse{mesh_, attributes_};
	coarse.mesh.triangles.resize(3);
	coarse.attributes.ofFaces[0].values = {7};
	OutputFile out(path_);
	writeGlbLevels({fine, coarse}, out);
	out.commit();
	std::stringstream text;
	text << std::ifstream(path_, std::ios::binary).rdbuf();
	const GltfJson json = glbChunksOf(text.str()).json;
	EXPECT_EQ(json["materials"].size(), 2u);
	EXPECT_EQ(json["materials"][1]["name"], "label_7");
	EXPECT_EQ(json["meshes"][1]["primitives"][0]["material"], 1);
}

TEST_F(GlbRoundTrip, GivesMaterialsOfOtherFilesByName)
{
	attributes_.materials = {"wood", "stone"};
	attributes_.ofFaces.push_back({"material", PlyType::Int32, {0, 1}});
	roundTrip();
	const GltfJson json = glbChunksOf(file_).json;
	EXPECT_EQ(json["materials"][1]["name"], "stone");
	EXPECT_EQ(json["meshes"][0]["primitives"][1]["material"], 1);
	attributes_         = MeshAttributes();
	attributes_.images  = {"wood.png"};
	attributes_.texture = {{0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1}, {}};
	roundTrip();
	EXPECT_EQ(glbChunksOf(file_).json["images"][0]["uri"], "wood.png");
}

} // namespace

} // namespace gpr_test
