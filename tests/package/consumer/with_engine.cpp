// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a torus as the OFF file OUT and remeshes the torus; ends with 0 if the result has the
// wanted 300 vertices.
#include <vcg_extras/core/remesh.h>

#include <cmath>
#include <cstdio>

namespace {

constexpr int around = 60, across = 30;

gpr::TriangleMesh torus()
{
	constexpr double  pi = 3.14159265358979323846;
	gpr::TriangleMesh mesh;
	for (int i = 0; i < around; ++i) {
		for (int j = 0; j < across; ++j) {
			const double u = 2 * pi * i / around, v = 2 * pi * j / across, r = 3 + std::cos(v);
			mesh.positions.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
			const int i1 = (i + 1) % around, j1 = (j + 1) % across;
			const int a = i * across + j, b = i1 * across + j;
			const int c = i1 * across + j1, d = i * across + j1;
			mesh.triangles.insert(mesh.triangles.end(), {a, b, c, a, c, d});
		}
	}
	return mesh;
}

bool write(const char* path, const gpr::TriangleMesh& mesh)
{
	std::FILE* file = std::fopen(path, "w");
	if (file == nullptr) return false;
	std::fprintf(file, "OFF\n%zu %zu 0\n", mesh.vertexNum(), mesh.faceNum());
	for (const gpr::Vec3d& p : mesh.positions)
		std::fprintf(file, "%.17g %.17g %.17g\n", p.x, p.y, p.z);
	for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
		std::fprintf(file, "3 %d %d %d\n", mesh.triangles[i], mesh.triangles[i + 1],
					 mesh.triangles[i + 2]);
	return std::fclose(file) == 0;
}

} // namespace

int main(int argc, char** argv)
{
	const gpr::TriangleMesh mesh = torus();
	if (argc < 2 || !write(argv[1], mesh)) return 1;

	gpr::RemeshOptions options;
	options.targetMode             = gpr::TargetMode::VertexNum;
	options.targetVertexNum        = 300;
	const gpr::RemeshResult result = gpr::remesh(mesh.view(), options);
	std::printf("%s%zu vertices\n", result.message.c_str(), result.mesh.vertexNum());
	return result.mesh.vertexNum() == 300 ? 0 : 1;
}
