// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
// gpr_big_mesh: makes large meshes for measurements out of small ones.
#include "built_in_meshes.h"
#include "mesh_growth.h"

#include <vcg_extras/io/base/run_limit.h>
#include <vcg_extras/io/mesh_io.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string>

namespace {

using namespace gpr;

constexpr const char* usage =
	"usage: gpr_big_mesh BASE OUT FACES [--roughness R] [--jitter J] [--seed S]\n"
	"Splits the edges of BASE (PLY, OBJ, OFF, STL, or stone, land, box) until there are about "
	"FACES\n"
	"faces, and displaces each new vertex at random:\n"
	"  --roughness R   by at most R edge lengths along the normal (0.04)\n"
	"  --jitter J      by at most J edge lengths along the edge, below 0.5, in the last passes "
	"(0.2)\n"
	"  --seed S        another seed, another mesh (1)\n";

struct Wishes {
	std::string       base, out;
	std::int64_t      faceNum = 0;
	bench::MeshGrowth growth;
};

bool toNumber(const char* text, double low, double high, double& number)
{
	char* end = nullptr;
	number    = std::strtod(text, &end);
	return end != text && *end == '\0' && number >= low && number <= high;
}

bool readOption(const std::string& name, const char* value, bench::MeshGrowth& growth)
{
	double     number = 0;
	const bool isSeed = name == "--seed";
	if (!toNumber(value, 0, isSeed ? 4294967295.0 : 0.499, number)) return false;
	if (isSeed) growth.seed = std::uint32_t(number);
	if (name == "--roughness") growth.roughness = number;
	if (name == "--jitter") growth.jitter = number;
	return isSeed || name == "--roughness" || name == "--jitter";
}

bool readWishes(int argc, char** argv, Wishes& wishes)
{
	double faceNum = 0;
	if (argc < 4 || argc % 2 != 0 || !toNumber(argv[3], 1, 7e8, faceNum)) return false;
	wishes.base    = argv[1];
	wishes.out     = argv[2];
	wishes.faceNum = std::int64_t(faceNum);
	for (int i = 4; i < argc; i += 2)
		if (!readOption(argv[i], argv[i + 1], wishes.growth)) return false;
	return true;
}

TriangleMesh readBase(const std::string& path)
{
	return triangleMeshOf(app::readMesh(path).view());
}

void makeMesh(const Wishes& wishes)
{
	TriangleMesh mesh;
	if (!bench::makeBuiltIn(wishes.base, wishes.faceNum, mesh))
		mesh = growMesh(readBase(wishes.base), wishes.faceNum, wishes.growth);
	app::MeshAttributes none;
	app::writeMesh(mesh, false, none, wishes.out, app::RunLimit());
	std::printf("%zu vertices, %zu faces\n", mesh.vertexNum(), mesh.faceNum());
}

} // namespace

int main(int argc, char** argv)
{
	Wishes wishes;
	if (!readWishes(argc, argv, wishes)) {
		std::fputs(usage, stderr);
		return 2;
	}
	try {
		makeMesh(wishes);
	}
	catch (const std::exception& error) {
		std::fprintf(stderr, "gpr_big_mesh: %s\n", error.what());
		return 1;
	}
	return 0;
}
