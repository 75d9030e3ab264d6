// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_files.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <map>
#include <sstream>
#include <stdexcept>

namespace gpr_test {

namespace {

constexpr double pi = 3.14159265358979323846;

std::string line(const char* first, const std::array<double, 3>& p)
{
	return std::string(first) + digits(p[0]) + " " + digits(p[1]) + " " + digits(p[2]) + "\n";
}

std::string counts(const TestMesh& m, const char* between)
{
	return std::to_string(m.points.size()) + between + std::to_string(m.faces.size());
}

std::string plyHeader(const TestMesh& m, const std::string& format, const std::string& type)
{
	return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(m.points.size()) +
		   "\nproperty " + type + " x\nproperty " + type + " y\nproperty " + type +
		   " z\nelement face " + std::to_string(m.faces.size()) +
		   "\nproperty list uchar int vertex_indices\nend_header\n";
}

} // namespace

std::string digits(double value, int number)
{
	char text[64];
	std::snprintf(text, sizeof text, "%.*g", number, value);
	return text;
}

TestMesh sphere(int n)
{
	// Lattice points |x|+|y|+|z| = n, pushed out to the sphere; each of the eight faces of the
	// octahedron is cut into n² triangles.
	TestMesh                          mesh;
	std::map<std::array<int, 3>, int> numbers;
	const auto                        vertex = [&](const std::array<int, 3>& p) {
        const auto [at, fresh] = numbers.emplace(p, int(mesh.points.size()));
        const double len = std::sqrt(double(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]));
        if (fresh) mesh.points.push_back({p[0] / len, p[1] / len, p[2] / len});
        return at->second;
	};
	for (int octant = 0; octant < 8; ++octant) {
		const int  sx = octant & 1 ? -1 : 1, sy = octant & 2 ? -1 : 1, sz = octant & 4 ? -1 : 1;
		const bool turned = sx * sy * sz < 0;
		const auto at  = [&](int i, int j) { return vertex({sx * i, sy * j, sz * (n - i - j)}); };
		const auto add = [&](int a, int b, int c) {
			mesh.faces.push_back(turned ? std::array<int, 3>{a, c, b}
										: std::array<int, 3>{a, b, c});
		};
		for (int i = 0; i < n; ++i) {
			for (int j = 0; i + j < n; ++j) {
				add(at(i, j), at(i + 1, j), at(i, j + 1));
				if (i + j + 1 < n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
			}
		}
	}
	return mesh;
}

TestMesh grid(int n)
{
	TestMesh mesh;
	for (int y = 0; y <= n; ++y) {
		for (int x = 0; x <= n; ++x)
			mesh.points.push_back({double(x) / n, double(y) / n, 0});
	}
	const auto at = [&](int x, int y) { return y * (n + 1) + x; };
	for (int y = 0; y < n; ++y) {
		for (int x = 0; x < n; ++x) {
			mesh.faces.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
			mesh.faces.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
		}
	}
	return mesh;
}

std::array<TestMesh, 2> halvesOfGrid(int n)
{
	const TestMesh whole = grid(n);
	TestMesh       left = whole, right = whole;
	left.faces.clear();
	right.faces.clear();
	for (const auto& f : whole.faces) {
		const double x = whole.points[std::size_t(f[0])][0] + whole.points[std::size_t(f[1])][0] +
						 whole.points[std::size_t(f[2])][0];
		(x < 1.5 ? left : right).faces.push_back(f);
	}
	return {left, right};
}

TestMesh torus(int n)
{
	TestMesh mesh;
	for (int i = 0; i < n; ++i) {
		for (int j = 0; j < n; ++j) {
			const double u = 2 * pi * i / n, v = 2 * pi * j / n, ring = 1 + 0.4 * std::cos(v);
			mesh.points.push_back({ring * std::cos(u), ring * std::sin(u), 0.4 * std::sin(v)});
		}
	}
	const auto at = [&](int i, int j) { return (i % n) * n + j % n; };
	for (int i = 0; i < n; ++i) {
		for (int j = 0; j < n; ++j) {
			mesh.faces.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
			mesh.faces.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
		}
	}
	return mesh;
}

TestMesh moved(TestMesh mesh, double dx, double dy, double dz)
{
	for (auto& p : mesh.points)
		p = {p[0] + dx, p[1] + dy, p[2] + dz};
	return mesh;
}

std::string asciiPly(const TestMesh& mesh)
{
	std::string text = plyHeader(mesh, "ascii", "float");
	for (const auto& p : mesh.points)
		text += line("", p);
	for (const auto& f : mesh.faces) {
		text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " +
				std::to_string(f[2]) + "\n";
	}
	return text;
}

std::string binaryPly(const TestMesh& mesh, bool littleEndian, bool doublePrecision)
{
	std::string bytes = plyHeader(mesh, littleEndian ? "binary_little_endian" : "binary_big_endian",
								  doublePrecision ? "double" : "float");
	for (const auto& p : mesh.points) {
		for (const double c : p) {
			if (doublePrecision) {
				putBinary(bytes, c, littleEndian);
			}
			else {
				putBinary(bytes, float(c), littleEndian);
			}
		}
	}
	for (const auto& f : mesh.faces) {
		bytes += char(3);
		for (const int i : f)
			putBinary(bytes, std::int32_t(i), littleEndian);
	}
	return bytes;
}

std::string obj(const TestMesh& mesh)
{
	std::string text = "# a test\nmtllib none.mtl\no thing\n";
	for (const auto& p : mesh.points)
		text += line("v ", p);
	text += "vn 0 0 1\nusemtl none\n";
	for (const auto& f : mesh.faces) {
		text += "f";
		for (const int i : f)
			text += " " + std::to_string(i + 1) + "//1";
		text += "\n";
	}
	return text;
}

std::string objWithNegativeIndices(const TestMesh& mesh)
{
	const int   num = int(mesh.points.size());
	std::string text;
	for (const auto& p : mesh.points)
		text += line("v ", p);
	for (const auto& f : mesh.faces) {
		text += "f";
		for (const int i : f)
			text += " " + std::to_string(i - num);
		text += "\n";
	}
	return text;
}

std::string off(const TestMesh& mesh)
{
	std::string text = "OFF\n# a test\n" + counts(mesh, " ") + " 0\n";
	for (const auto& p : mesh.points)
		text += line("", p);
	for (const auto& f : mesh.faces) {
		text += "3 " + std::to_string(f[0]) + " " + std::to_string(f[1]) + " " +
				std::to_string(f[2]) + " 255 0 0\n";
	}
	return text;
}

std::string asciiStl(const TestMesh& mesh)
{
	std::string text = "solid a test\n";
	for (const auto& f : mesh.faces) {
		text += "facet normal 0 0 0\n outer loop\n";
		for (const int i : f)
			text += line("  vertex ", mesh.points[std::size_t(i)]);
		text += " endloop\nendfacet\n";
	}
	return text + "endsolid a test\n";
}

std::string binaryStl(const TestMesh& mesh)
{
	std::string bytes = "solid in spite of being binary";
	bytes.resize(80, '\0');
	putBinary(bytes, std::uint32_t(mesh.faces.size()), true);
	for (const auto& f : mesh.faces) {
		bytes.append(12, '\0');
		for (const int i : f) {
			for (const double c : mesh.points[std::size_t(i)])
				putBinary(bytes, float(c), true);
		}
		bytes.append(2, '\0');
	}
	return bytes;
}

namespace {

template <class T>
T take(const std::string& bytes, std::size_t& at)
{
	T value;
	if (at + sizeof(T) > bytes.size()) throw std::runtime_error("the written PLY is too short");
	std::memcpy(&value, bytes.data() + at, sizeof(T));
	at += sizeof(T);
	return value;
}

} // namespace

TestMesh parseWrittenPly(const std::string& file, std::string& precision)
{
	const std::string ending    = "end_header\n";
	std::size_t       at        = file.find(ending);
	std::size_t       vertexNum = 0, faceNum = 0;
	std::size_t       extra[2] = {0, 0}; // bytes of other scalars of vertices and faces
	int               element  = 0;
	if (at == file.npos) throw std::runtime_error("the written PLY has no end of header");
	std::istringstream header(file.substr(0, at));
	for (std::string word, name; header >> word;) {
		if (word == "comment") std::getline(header, word);
		if (word == "vertex") header >> vertexNum;
		if (word == "face") {
			header >> faceNum;
			element = 1;
		}
		if (word != "property") continue;
		header >> word >> name;
		if (word == "list") {
			header >> word >> name;
			// A face's texture coordinates are always a pair for each corner.
			if (name == "texcoord")
				extra[element] += 1 + 6 * 4;
			else if (name != "vertex_indices")
				throw std::runtime_error("a list in the written PLY");
		}
		else if (name == "x" || name == "y" || name == "z") {
			precision = word;
		}
		else {
			extra[element] += word == "double" ? 8 : word == "uchar" ? 1 : 4;
		}
	}
	at += ending.size();
	TestMesh mesh;
	mesh.points.resize(vertexNum);
	mesh.faces.resize(faceNum);
	for (auto& p : mesh.points) {
		for (double& c : p) {
			c = precision == "double" ? take<double>(file, at) : double(take<float>(file, at));
		}
		at += extra[0];
	}
	for (auto& f : mesh.faces) {
		if (take<std::uint8_t>(file, at) != 3) throw std::runtime_error("a face of no triangle");
		for (int& i : f)
			i = take<std::int32_t>(file, at);
		at += extra[1];
	}
	if (at != file.size()) throw std::runtime_error("the written PLY is too long");
	return mesh;
}

} // namespace gpr_test
