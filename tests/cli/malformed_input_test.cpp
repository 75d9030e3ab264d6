// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Malformed input: exit code 3 with a sentence, soon, whatever is in the file.
#include "mesh_files.h"
#include "program_runner.h"

#include <cstdint>

namespace gpr_test {

namespace {

const char* const plyVertices =
	"element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
const char* const plyFaces = "element face 1\nproperty list uchar int vertex_indices\n";

std::string asciiPlyHeader(const std::string& elements)
{
	return "ply\nformat ascii 1.0\n" + elements + "end_header\n";
}

const std::string triangleBody = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
const std::string goodPly      = asciiPlyHeader(std::string(plyVertices) + plyFaces) + triangleBody;

} // namespace

class MalformedInput : public CliTest {
protected:
	void expectRefused(const std::string& name, const std::string& content,
					   const std::string& partOfSentence = "")
	{
		SCOPED_TRACE(name + ": " + content.substr(0, 200));
		const std::string in = put(name, content);
		expectFailure(run({"info", in}, 10), 3, partOfSentence);
		const ProgramResult remeshed = run({"remesh", in, path("out.ply")}, 10);
		expectFailure(remeshed, 3, partOfSentence);
		EXPECT_FALSE(exists(path("out.ply")));
	}
};

TEST_F(MalformedInput, TheGoodFileIsRead)
{
	// The file that other tests damage is valid.
	const ProgramResult result = run({"info", put("good.ply", goodPly)});
	EXPECT_EQ(result.exitCode, 0) << result.err;
}

TEST_F(MalformedInput, MissingFilesAndFolders)
{
	expectFailure(run({"info", path("nowhere.ply")}), 3, "nowhere.ply");
	expectFailure(run({"remesh", path("nowhere.ply"), path("out.ply")}), 3, "nowhere.ply");
}

TEST_F(MalformedInput, EmptyAndGarbageInEveryFormat)
{
	std::string   noise;
	std::uint32_t state = 12345;
	for (int i = 0; i < 5000; ++i) {
		state = state * 1664525 + 1013904223;
		noise += char(state >> 24);
	}
	for (const char* extension : {"ply", "obj", "off", "stl"}) {
		const std::string name = std::string("bad.") + extension;
		expectRefused(name, "", "empty");
		expectRefused(name, "\n");
		expectRefused(name, std::string(100, '\0'));
		expectRefused(name, noise);
		expectRefused(name, std::string(100000, 'x'));
	}
}

TEST_F(MalformedInput, PlyHeaders)
{
	const std::string v = plyVertices, f = plyFaces;
	expectRefused("h.ply", "ply\n", "header");
	expectRefused("h.ply", "ply\nformat ascii 1.0\n" + v + f, "header");
	expectRefused("h.ply", "ply\n" + v + f + "end_header\n" + triangleBody, "format");
	expectRefused("h.ply", "ply\nformat ebcdic 1.0\n" + v + f + "end_header\n", "format");
	expectRefused("h.ply", asciiPlyHeader("property float x\n" + v + f), "property");
	expectRefused("h.ply", asciiPlyHeader("element vertex\n"), "count");
	expectRefused("h.ply", asciiPlyHeader("element vertex -3\n"), "count");
	expectRefused("h.ply", asciiPlyHeader("element vertex 99999999999999999999999\n"), "count");
	expectRefused("h.ply", asciiPlyHeader(v + f + "property quaternion q\n"), "type");
	expectRefused("h.ply",
				  asciiPlyHeader(v + "element face 1\nproperty list float int vertex_indices\n"),
				  "list");
	expectRefused("h.ply", asciiPlyHeader(v + f + v) + triangleBody, "twice");
	expectRefused("h.ply",
				  asciiPlyHeader("element vertex 3\nproperty float x\nproperty float y\n" + f) +
					  "0 0\n1 0\n0 1\n3 0 1 2\n",
				  "no x, y and z");
	expectRefused("h.ply", asciiPlyHeader(v + "element face 1\nproperty int a\n") + triangleBody,
				  "vertex indices");
	expectRefused("h.ply", "ply\nformat ascii 1.0\n" + std::string(3000000, '\n'), "header");
	std::string comments = "ply\nformat ascii 1.0\n";
	for (int i = 0; i < 200000; ++i)
		comments += "comment for ever\n";
	expectRefused("h.ply", comments, "header");
}

TEST_F(MalformedInput, PlyCountsBeyondTheFile)
{
	const std::string huge = "99999999999";
	const std::string v =
		"element vertex " + huge + "\nproperty float x\nproperty float y\nproperty float z\n";
	const std::string f = "element face " + huge + "\nproperty list uchar int vertex_indices\n";
	for (const char* format : {"ascii", "binary_little_endian", "binary_big_endian"}) {
		const std::string begin = std::string("ply\nformat ") + format + " 1.0\n";
		expectRefused("huge.ply", begin + v + plyFaces + "end_header\n" + triangleBody,
					  "too early");
		expectRefused("huge.ply", begin + f + plyVertices + "end_header\n" + triangleBody,
					  "too early");
		expectRefused("huge.ply",
					  begin + "element cloud " + huge + "\nproperty int i\n" + plyVertices +
						  plyFaces + "end_header\n" + triangleBody,
					  "too early");
	}
}

TEST_F(MalformedInput, PlyListsBeyondTheFile)
{
	const std::string header =
		"ply\nformat binary_little_endian 1.0\n" + std::string(plyVertices) +
		"element face 1\nproperty list uint int vertex_indices\nend_header\n";
	std::string body(36, '\0');
	putBinary(body, std::uint32_t(4000000000u), true);
	expectRefused("list.ply", header + body + std::string(100, '\0'), "list");
	const std::string ascii = asciiPlyHeader(std::string(plyVertices) + plyFaces);
	expectRefused("list.ply", ascii + "0 0 0\n1 0 0\n0 1 0\n999999999 0 1 2\n", "line 13");
	expectRefused("list.ply", ascii + "0 0 0\n1 0 0\n0 1 0\n-3 0 1 2\n", "line 13");
}

TEST_F(MalformedInput, CutOffAtManyPlaces)
{
	// Every prefix that lacks at least one whole value is refused.
	const TestMesh    mesh    = sphere(2);
	const std::string files[] = {binaryPly(mesh, true, false), binaryPly(mesh, false, true)};
	for (const std::string& whole : files) {
		const std::size_t header = whole.find("end_header\n") + 11;
		for (const std::size_t keep :
			 {header - 5, header, header + 1, header + 100, whole.size() - 13, whole.size() - 1}) {
			expectRefused("cut.ply", whole.substr(0, keep));
		}
	}
	const std::string ascii = asciiPly(mesh), text = off(mesh), stl = asciiStl(mesh),
					  bytes = binaryStl(mesh);
	expectRefused("cut.ply", ascii.substr(0, ascii.size() / 2));
	expectRefused("cut.ply", ascii.substr(0, ascii.rfind(' ')), "too early");
	expectRefused("cut.off", text.substr(0, 4));
	expectRefused("cut.off", text.substr(0, text.size() / 3));
	expectRefused("cut.off", text.substr(0, text.rfind("3 ")), "too early");
	expectRefused("cut.stl", stl.substr(0, stl.rfind("vertex")), "too early");
	expectRefused("cut.stl", stl.substr(0, stl.rfind("endfacet")), "too early");
	expectRefused("cut.stl", bytes.substr(0, bytes.size() - 1), "too early");
	expectRefused("cut.stl", bytes.substr(0, 84));
	expectRefused("cut.stl", bytes.substr(0, 50));
}

TEST_F(MalformedInput, IndicesOutOfRange)
{
	for (const int bad : {-1, 3, 77, 2147483647}) {
		TestMesh mesh   = grid(1);
		mesh.points     = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
		mesh.faces      = {{0, 1, 2}, {0, 1, bad}};
		const char* say = "does not exist";
		expectRefused("range.ply", asciiPly(mesh), say);
		expectRefused("range.ply", binaryPly(mesh, true, false), say);
		expectRefused("range.ply", binaryPly(mesh, false, false), say);
		expectRefused("range.off", off(mesh), say);
		if (bad != 2147483647) expectRefused("range.obj", obj(mesh), say);
	}
	const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
	expectRefused("range.obj", points + "f 1 2 0\n", "does not exist");
	expectRefused("range.obj", points + "f 1 2 -4\n", "does not exist");
	expectRefused("range.obj", points + "f 1 2 99999999999\n", "does not exist");
	expectRefused("range.obj", points + "f 1 2 3 4\n", "does not exist");
	expectRefused("range.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n4 0 1 2 3\n", "does not exist");
}

TEST_F(MalformedInput, WordsInPlaceOfNumbers)
{
	std::string ply = goodPly;
	ply.replace(ply.find("1 0 0\n"), 1, "one");
	expectRefused("word.ply", ply, "line 11: a number is malformed");
	expectRefused("word.ply", goodPly.substr(0, goodPly.size() - 2) + "x\n",
				  "line 13: a number is malformed");
	expectRefused("word.obj", "v 0 zero 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1");
	expectRefused("word.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 c\n", "line 4");
	expectRefused("word.obj", "v 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "line 1");
	expectRefused("word.off", "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n", "line 4");
	expectRefused("word.off", "OFF\n3 one 0\n", "'one' is no count");
	expectRefused("word.off", "OFF\n-3 1 0\n", "negative");
	expectRefused("word.off", "OFF BINARY\n", "binary");
	expectRefused("word.off", "4OFF\n1 1 1\n", "dimensions");
	expectRefused("word.off", "OFF\n999999999 1 0\n0 0 0\n", "too early");
	expectRefused("word.stl", "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 z\n",
				  "malformed");
	expectRefused("word.stl", "solid x", "no faces");
	expectRefused("word.stl", "solid x\nwhat is this\n", "no faces");
}

TEST_F(MalformedInput, NothingToRemesh)
{
	TestMesh points = grid(3);
	points.faces.clear();
	expectRefused("points.ply", asciiPly(points), "no faces");
	expectRefused("points.ply", binaryPly(points, true, false), "no faces");
	expectRefused("points.obj", obj(points), "no faces");
	expectRefused("points.off", off(points), "no faces");
	expectRefused("points.stl", binaryStl(points), "no faces");
	expectRefused("lines.obj", "v 0 0 0\nv 1 0 0\nl 1 2\nf 1 2\n", "no faces");
}

} // namespace gpr_test
