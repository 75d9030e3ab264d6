// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Attributes from a file over a remeshing into another file.
#include "file_folder.h"
#include "mesh_files.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/mesh_io.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <memory>
#include <sstream>

namespace gpr_test {

namespace {

using namespace gpr;
using namespace gpr::app;

class Attributes : public FileFolder {
protected:
	Attributes() : FileFolder("attributes") {}

	static InputMesh read(const std::string& file)
	{
		WantedAttributes wanted;
		wanted.carried = true;
		return readMesh(file, wanted);
	}

	/// Reads a mesh, remeshes to 300 vertices, writes the result, and reads the written file.
	InputMesh throughTheProgram(const std::string& from, const std::string& to, bool isSewn = true)
	{
		InputMesh                            input = read(from);
		const std::unique_ptr<TextureSource> texture =
			takeTexture(input.attributes, input.view(), isSewn);
		RemeshOptions options;
		options.sew                  = isSewn;
		options.targetMode           = TargetMode::VertexNum;
		options.targetVertexNum      = 300;
		options.surfacePointsOfFaces = true;
		MeshView view                = input.view();
		if (texture != nullptr) view.line = texture->seams().data();
		const RemeshResult result = remesh(view, options);
		EXPECT_EQ(result.status, Status::Ok) << result.message;
		MeshAttributes carried =
			carryAttributes(input.attributes, input.view(), texture.get(), result);
		writeMesh(result.mesh, false, carried, to, RunLimit());
		lost = carried.lost;
		return read(to);
	}

	std::vector<std::string> lost;
};

/// A flat square with the attributes of MeshLab's files and more; two charts, a seam at x = 0.5.
std::string attributedPly()
{
	const TestMesh    mesh = grid(30);
	std::stringstream text;
	text << "ply\nformat ascii 1.0\ncomment TextureFile wood of oak.png\nelement vertex "
		 << mesh.points.size()
		 << "\nproperty float x\nproperty float y\nproperty float z\nproperty float nx\n"
			"property float ny\nproperty float nz\nproperty uchar red\nproperty uchar green\n"
			"property uchar blue\nproperty double quality\nproperty int label\nelement face "
		 << mesh.faces.size()
		 << "\nproperty list uchar int vertex_indices\nproperty uchar red\n"
			"property list uchar float texcoord\nproperty int texnumber\n"
			"property list uchar float odd\nend_header\n";
	for (const auto& p : mesh.points) {
		text << p[0] << ' ' << p[1] << ' ' << p[2] << " 0.6 0 0.8 " << int(200 * p[0]) << " 77 "
			 << int(100 * p[1]) << ' ' << 3 * p[0] << ' ' << (p[0] > 0.5 ? 9 : 4) << '\n';
	}
	for (const auto& f : mesh.faces) {
		double middle = 0;
		for (const int v : f)
			middle += mesh.points[std::size_t(v)][0] / 3;
		const bool right = middle > 0.5;
		text << "3 " << f[0] << ' ' << f[1] << ' ' << f[2] << ' ' << (right ? 250 : 5) << " 6";
		for (const int v : f) {
			const auto& p = mesh.points[std::size_t(v)];
			text << ' ' << (right ? 1 - p[1] / 2 : p[0] / 2) << ' ' << p[1] / 2;
		}
		text << ' ' << int(right) << " 1 5\n";
	}
	return text.str();
}

const ValueColumn& columnOf(const std::vector<ValueColumn>& columns, const std::string& name)
{
	for (const ValueColumn& column : columns) {
		if (column.name == name) return column;
	}
	throw std::runtime_error("no column " + name);
}

TEST_F(Attributes, OfPlyFilesComeOutAgain)
{
	const InputMesh       mesh = throughTheProgram(put("in.ply", attributedPly()), path("out.ply"));
	const MeshAttributes& a    = mesh.attributes;
	ASSERT_EQ(mesh.vertexNum(), 300u);
	EXPECT_EQ(a.images, std::vector<std::string>{"wood of oak.png"});
	EXPECT_EQ(lost, std::vector<std::string>{"the list 'odd'"});
	EXPECT_EQ(columnOf(a.ofVertices, "quality").type, PlyType::Float64);
	EXPECT_EQ(columnOf(a.ofVertices, "red").type, PlyType::UInt8);
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v) {
		const Vec3d p = mesh.view().position(v);
		EXPECT_NEAR(columnOf(a.ofVertices, "quality").values[v], 3 * p.x, 1e-3);
		EXPECT_NEAR(columnOf(a.ofVertices, "red").values[v], 200 * p.x, 1.6);
		EXPECT_EQ(columnOf(a.ofVertices, "green").values[v], 77);
		EXPECT_NEAR(columnOf(a.ofVertices, "nx").values[v], 0.6, 1e-6);
		const double label = columnOf(a.ofVertices, "label").values[v];
		EXPECT_TRUE(label == 4 || label == 9) << "a label has no mean";
		if (std::abs(p.x - 0.5) > 0.04) {
			EXPECT_EQ(label, p.x > 0.5 ? 9 : 4);
		}
	}
	for (std::size_t f = 0; f < mesh.faceNum(); ++f) {
		double middle = 0;
		for (std::size_t k = 0; k < 3; ++k)
			middle += mesh.view().position(std::size_t(mesh.triangles[3 * f + k])).x / 3;
		const bool right = middle > 0.5;
		EXPECT_EQ(columnOf(a.ofFaces, "red").values[f], right ? 250 : 5);
		EXPECT_EQ(a.texture.image[f], right);
		for (std::size_t k = 0; k < 3; ++k) {
			const Vec3d p = mesh.view().position(std::size_t(mesh.triangles[3 * f + k]));
			EXPECT_NEAR(a.texture.uv[6 * f + 2 * k], right ? 1 - p.y / 2 : p.x / 2, 1e-4);
			EXPECT_NEAR(a.texture.uv[6 * f + 2 * k + 1], p.y / 2, 1e-4);
		}
	}
}

/// A square of two halves with separate vertices; the texture coordinates differ at x = 0.5.
std::string plyOfTwoHalves()
{
	const TestMesh                      mesh = grid(20);
	std::map<std::pair<bool, int>, int> vertexOf;
	std::stringstream                   vertices, faces;
	for (const auto& f : mesh.faces) {
		double middle = 0;
		for (const int v : f)
			middle += mesh.points[std::size_t(v)][0] / 3;
		const bool right = middle > 0.5;
		faces << 3;
		for (const int v : f) {
			const auto  added = vertexOf.insert({{right, v}, int(vertexOf.size())});
			const auto& p     = mesh.points[std::size_t(v)];
			faces << ' ' << added.first->second;
			if (!added.second) continue;
			vertices << p[0] << ' ' << p[1] << ' ' << p[2] << ' '
					 << (right ? 1 - p[1] / 2 : p[0] / 2) << ' ' << p[1] / 2 << '\n';
		}
		faces << '\n';
	}
	std::stringstream text;
	text << "ply\nformat ascii 1.0\ncomment TextureFile wood.png\nelement vertex "
		 << vertexOf.size()
		 << "\nproperty float x\nproperty float y\nproperty float z\nproperty float s\n"
			"property float t\nelement face "
		 << mesh.faces.size() << "\nproperty list uchar int vertex_indices\nend_header\n"
		 << vertices.str() << faces.str();
	return text.str();
}

/// After sewing, a vertex of the seam has two texture coordinates, which corners keep.
TEST_F(Attributes, TextureCoordinatesOfVerticesStayOnTheirSideOfASewnSeam)
{
	const std::string in   = put("in.ply", plyOfTwoHalves());
	const InputMesh   mesh = throughTheProgram(in, path("out.ply"));
	ASSERT_EQ(mesh.vertexNum(), 300u);
	EXPECT_EQ(mesh.attributes.images, std::vector<std::string>{"wood.png"});
	EXPECT_EQ(mesh.attributes.ofVertex("s"), nullptr);
	ASSERT_TRUE(mesh.attributes.hasTexture());
	for (std::size_t c = 0; c < 3 * mesh.faceNum(); ++c) {
		double middle = 0;
		for (std::size_t k = 0; k < 3; ++k)
			middle += mesh.view().position(std::size_t(mesh.triangles[c / 3 * 3 + k])).x / 3;
		const bool  right = middle > 0.5;
		const Vec3d p     = mesh.view().position(std::size_t(mesh.triangles[c]));
		EXPECT_NEAR(mesh.attributes.texture.uv[2 * c], right ? 1 - p.y / 2 : p.x / 2, 1e-4);
		EXPECT_NEAR(mesh.attributes.texture.uv[2 * c + 1], p.y / 2, 1e-4);
	}
	const InputMesh apart = throughTheProgram(in, path("apart.ply"), false);
	EXPECT_NE(apart.attributes.ofVertex("s"), nullptr) << "as it was";
	EXPECT_FALSE(apart.attributes.hasTexture());
}

TEST_F(Attributes, OfObjFilesComeOutAgain)
{
	const TestMesh    mesh = grid(20);
	std::stringstream text;
	text << "mtllib things.mtl\nvn 0 0 1\n";
	for (const auto& p : mesh.points)
		text << "v " << p[0] << ' ' << p[1] << ' ' << p[2] << ' ' << p[0] << " 0.5 0\nvt "
			 << p[0] / 2 << ' ' << p[1] << '\n';
	for (const auto& f : mesh.faces) {
		const bool right = mesh.points[std::size_t(f[0])][0] + mesh.points[std::size_t(f[1])][0] +
							   mesh.points[std::size_t(f[2])][0] >
						   1.5;
		text << "usemtl " << (right ? "old gold" : "wood") << "\nf";
		for (const int v : f)
			text << ' ' << v + 1 << '/' << v + 1 << "/1";
		text << '\n';
	}
	const std::string from = put("in.obj", text.str());
	const InputMesh   obj  = throughTheProgram(from, path("out.obj"));
	EXPECT_EQ(lost, std::vector<std::string>{"normals"});
	const MeshAttributes& a = obj.attributes;
	EXPECT_EQ(a.materialLibrary, "things.mtl");
	ASSERT_EQ(a.materials.size(), 2u);
	for (std::size_t c = 0; c < obj.triangles.size(); ++c) {
		const Vec3d p = obj.view().position(std::size_t(obj.triangles[c]));
		EXPECT_NEAR(a.texture.uv[2 * c], p.x / 2, 1e-4);
		EXPECT_NEAR(a.texture.uv[2 * c + 1], p.y, 1e-4);
		EXPECT_NEAR(a.ofVertex("red")->values[std::size_t(obj.triangles[c])], 255 * p.x, 1.6);
		const bool right = a.materials[std::size_t(a.texture.image[c / 3])] == "old gold";
		EXPECT_GE((p.x - 0.5) * (right ? 1 : -1), -1e-6) << "a face of two materials";
	}
	const InputMesh ply = throughTheProgram(from, path("out.ply"));
	EXPECT_TRUE(ply.attributes.hasTexture());
	throughTheProgram(from, path("out.off"));
	EXPECT_EQ(lost.size(), 2u);
}

/// The names of materials and images count from the folder of the file with the mesh.
TEST_F(Attributes, FilesBesideTheInputAreNamedFromTheFolderOfTheResult)
{
	std::filesystem::create_directories(path("there/deep"));
	const auto libraryIn = [&](const std::string& name, const std::string& out) {
		std::string text = "mtllib " + name + "\nusemtl oak\n" + obj(grid(20));
		return throughTheProgram(put("in.obj", text), path(out)).attributes.materialLibrary;
	};
	put("my oak.mtl", "newmtl oak\n");
	EXPECT_EQ(libraryIn("my oak.mtl", "out.obj"), "my oak.mtl");
	EXPECT_EQ(libraryIn("my oak.mtl", "there/deep/out.obj"), "../../my oak.mtl");
	EXPECT_EQ(libraryIn(path("my oak.mtl"), "there/out.obj"), path("my oak.mtl"));
	EXPECT_EQ(lost, std::vector<std::string>{"normals"});
	EXPECT_EQ(libraryIn("none.mtl", "there/out.obj"), "none.mtl");
	EXPECT_EQ(lost.back(), "the place of 'none.mtl', which is not beside the input");
	put("wood of oak.png", "an image");
	const InputMesh ply = throughTheProgram(put("in.ply", attributedPly()), path("there/out.ply"));
	EXPECT_EQ(ply.attributes.images, std::vector<std::string>{"../wood of oak.png"});
}

TEST_F(Attributes, PolygonsAreCutAsTheMeshIs)
{
	const std::string file =
		put("in.ply",
			"ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\n"
			"property float z\nelement face 3\nproperty list uchar int vertex_indices\n"
			"property float quality\nproperty uchar selected\nproperty list uchar float texcoord\n"
			"end_header\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 0\n"
			"4 0 1 4 3 0.5 1 8 0 0 1 0 1 1 0 1\n2 0 1 7 0 0\n3 1 2 4 0.25 0 6 1 0 2 0 1 1\n");
	WantedAttributes wanted;
	wanted.carried = wanted.faceSelection = true;
	const InputMesh mesh                  = readMesh(file, wanted);
	ASSERT_EQ(mesh.faceNum(), 3u);
	EXPECT_EQ(columnOf(mesh.attributes.ofFaces, "quality").values,
			  (std::vector<double>{0.25, 0.5, 0.5}));
	EXPECT_EQ(mesh.selectedFaces, (std::vector<std::uint8_t>{0, 1, 1}));
	for (std::size_t c = 0; c < 9; ++c) {
		const Vec3d p = mesh.view().position(std::size_t(mesh.triangles[c]));
		EXPECT_EQ(mesh.attributes.texture.uv[2 * c], float(p.x));
		EXPECT_EQ(mesh.attributes.texture.uv[2 * c + 1], float(p.y));
	}
}

TEST_F(Attributes, WithoutAnyTheFileIsTheSame)
{
	const InputMesh mesh = throughTheProgram(put("in.ply", asciiPly(sphere(20))), path("out.ply"));
	EXPECT_FALSE(mesh.attributes.any());
	EXPECT_EQ(contentOf(path("out.ply")).find("quality"), std::string::npos);
	EXPECT_TRUE(lost.empty());
}

TEST_F(Attributes, SelectionOfFacesMustBeThere)
{
	const std::string file = put("in.ply", asciiPly(sphere(4)));
	WantedAttributes  wanted;
	wanted.faceSelection = true;
	EXPECT_THROW(readMesh(file, wanted), AppError);
	EXPECT_THROW(readMesh(put("in.obj", obj(sphere(4))), wanted), AppError);
}

} // namespace

} // namespace gpr_test
