// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef TESTS_CLI_MESH_FILES_H
#define TESTS_CLI_MESH_FILES_H

#include <array>
#include <cstddef>
#include <string>
#include <vector>

// Small meshes, and files written independently of the program's own writers.

namespace gpr_test {

struct TestMesh {
	std::vector<std::array<double, 3>> points;
	std::vector<std::array<int, 3>>    faces;
};

/// Sphere of radius 1: an octahedron with every edge cut into n pieces; 4n²+2 vertices.
TestMesh sphere(int n);
/// Flat square [0,1]² of n by n cells, one border loop.
TestMesh grid(int n);
/// The faces of grid(n) left and right of the middle, each half with all vertices.
std::array<TestMesh, 2> halvesOfGrid(int n);
/// Torus with radii 1 and 0.4, n by n cells, n² vertices.
TestMesh torus(int n);
/// The mesh moved by (dx, dy, dz).
TestMesh moved(TestMesh mesh, double dx, double dy, double dz);

/// Appends the bytes of a value in the wanted order.
template <class T>
void putBinary(std::string& bytes, T value, bool littleEndian)
{
	const char* const raw = reinterpret_cast<const char*>(&value);
	for (std::size_t i = 0; i < sizeof(T); ++i) {
		bytes += raw[littleEndian ? i : sizeof(T) - 1 - i]; // these tests run on little endian
	}
}

/// A number with `number` significant digits.
std::string digits(double value, int number = 17);

std::string asciiPly(const TestMesh& mesh);
std::string binaryPly(const TestMesh& mesh, bool littleEndian, bool doublePrecision);
std::string obj(const TestMesh& mesh);
/// Every face follows its vertices and counts back from the end.
std::string objWithNegativeIndices(const TestMesh& mesh);
std::string off(const TestMesh& mesh);
std::string asciiStl(const TestMesh& mesh);
std::string binaryStl(const TestMesh& mesh);

/// Reads a PLY file of gpremesh: binary little endian, three coordinates, triangles; skips other
/// scalars. precision receives "float" or "double". Throws std::runtime_error on other files.
TestMesh parseWrittenPly(const std::string& file, std::string& precision);

} // namespace gpr_test

#endif
