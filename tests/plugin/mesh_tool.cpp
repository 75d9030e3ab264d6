// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes for the tests in meshlabserver:
//   plugin_mesh_tool make OUT.ply        a bumpy torus, 12,800 vertices, float coordinates; vertex
//                                        quality from 0 below to 1 above, some vertices and faces
//                                        selected
//   plugin_mesh_tool regions OUT.ply     the same torus with labels as the quality of its faces
//   plugin_mesh_tool labels A.ply B.ply  ends with 0 if the quality of all faces is the same
//   plugin_mesh_tool sized OUT.ply       the same torus with edge lengths as the vertex quality
//   plugin_mesh_tool scan OUT.ply N      the same torus with 2 N x N vertices and nothing else
//   plugin_mesh_tool roof OUT.ply        two square sheets of 41 x 41 vertices at a right angle
//   plugin_mesh_tool ridge OUT.ply       the common vertices of both sheets
//   plugin_mesh_tool same A.ply B.ply    ends with 0 if coordinates and faces are the same bits
//   plugin_mesh_tool marks A.ply B.ply   ends with 0 if quality and selection of all vertices
//                                        are the same
//   plugin_mesh_tool count A.ply         prints the number of vertices
//   plugin_mesh_tool selected A.ply      prints the numbers of selected vertices and faces
//   plugin_mesh_tool within A.ply B.ply D   ends with 0 if every vertex of A is at most D away
//                                           from a vertex of B

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <string>
#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/export_ply.h>
#include <wrap/io_trimesh/import_ply.h>

namespace {

class ToolVertex;
class ToolFace;
struct ToolTypes
		: vcg::UsedTypes<vcg::Use<ToolVertex>::AsVertexType, vcg::Use<ToolFace>::AsFaceType> {};
class ToolVertex : public vcg::Vertex<ToolTypes, vcg::vertex::Coord3f, vcg::vertex::Qualityf,
									  vcg::vertex::BitFlags> {};
class ToolFace : public vcg::Face<ToolTypes, vcg::face::VertexRef, vcg::face::Qualityf,
								  vcg::face::BitFlags> {};
class ToolMesh : public vcg::tri::TriMesh<std::vector<ToolVertex>, std::vector<ToolFace>> {};

/// A point of a torus with bumps, u and v in [0, 1).
vcg::Point3f torusPoint(double u, double v)
{
	const double turn  = 2 * M_PI;
	const double small = 0.4 + 0.03 * std::sin(5 * turn * u) * std::cos(3 * turn * v);
	const double ring  = 1 + small * std::cos(turn * v);
	return {float(ring * std::cos(turn * u)), float(ring * std::sin(turn * u)),
			float(small * std::sin(turn * v))};
}

void makeTorus(ToolMesh& mesh, int around, int across)
{
	vcg::tri::Allocator<ToolMesh>::AddVertices(mesh, std::size_t(around * across));
	const auto at = [&](int i, int j) {
		return &mesh.vert[std::size_t((i % around) * across + j % across)];
	};
	for (int i = 0; i < around; ++i) {
		for (int j = 0; j < across; ++j) {
			at(i, j)->P() = torusPoint(double(i) / around, double(j) / across);
			vcg::tri::Allocator<ToolMesh>::AddFace(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1));
			vcg::tri::Allocator<ToolMesh>::AddFace(mesh, at(i, j), at(i + 1, j + 1), at(i, j + 1));
		}
	}
}

void makeRoof(ToolMesh& mesh, int cells)
{
	const int across = 2 * cells + 1;
	vcg::tri::Allocator<ToolMesh>::AddVertices(mesh, std::size_t(across * (cells + 1)));
	const auto at = [&](int i, int j) { return &mesh.vert[std::size_t(j * across + i)]; };
	for (int j = 0; j <= cells; ++j) {
		for (int i = 0; i < across; ++i)
			at(i, j)->P() = vcg::Point3f(float(i), float(j), float(-std::abs(i - cells)));
	}
	for (int j = 0; j < cells; ++j) {
		for (int i = 0; i + 1 < across; ++i) {
			vcg::tri::Allocator<ToolMesh>::AddFace(mesh, at(i, j), at(i + 1, j), at(i + 1, j + 1));
			vcg::tri::Allocator<ToolMesh>::AddFace(mesh, at(i, j), at(i + 1, j + 1), at(i, j + 1));
		}
	}
}

void addAttributes(ToolMesh& mesh)
{
	for (ToolVertex& v : mesh.vert) {
		v.Q() = 0.5f + v.P()[2];
		if (v.P()[0] > 1) v.SetS();
	}
	for (ToolFace& f : mesh.face) {
		if (f.P(0)[1] > 1.2f) f.SetS();
	}
}

bool open(ToolMesh& mesh, const char* file)
{
	if (vcg::tri::io::ImporterPLY<ToolMesh>::Open(mesh, file) == 0) return true;
	std::fprintf(stderr, "cannot read %s\n", file);
	return false;
}

bool same(const ToolMesh& a, const ToolMesh& b)
{
	if (a.vn != b.vn || a.fn != b.fn) {
		std::fprintf(stderr, "%d vertices, %d faces against %d, %d\n", a.vn, a.fn, b.vn, b.fn);
		return false;
	}
	for (int v = 0; v < a.vn; ++v) {
		const auto &p = a.vert[std::size_t(v)].cP(), &q = b.vert[std::size_t(v)].cP();
		if (std::memcmp(&p, &q, sizeof(p)) != 0) {
			std::fprintf(stderr, "vertex %d differs by %g\n", v, double((p - q).Norm()));
			return false;
		}
	}
	for (int f = 0; f < a.fn; ++f) {
		for (int k = 0; k < 3; ++k) {
			if (vcg::tri::Index(a, a.face[std::size_t(f)].cV(k)) !=
				vcg::tri::Index(b, b.face[std::size_t(f)].cV(k))) {
				std::fprintf(stderr, "face %d differs\n", f);
				return false;
			}
		}
	}
	return true;
}

bool sameMarks(const ToolMesh& a, const ToolMesh& b)
{
	if (a.vn != b.vn) return false;
	for (int v = 0; v < a.vn; ++v) {
		const ToolVertex &p = a.vert[std::size_t(v)], &q = b.vert[std::size_t(v)];
		if (p.cQ() == q.cQ() && p.IsS() == q.IsS()) continue;
		std::fprintf(stderr, "vertex %d: %g, %d against %g, %d\n", v, double(p.cQ()), p.IsS(),
					 double(q.cQ()), q.IsS());
		return false;
	}
	return true;
}

bool sameLabels(const ToolMesh& a, const ToolMesh& b)
{
	if (a.fn != b.fn) return false;
	for (int f = 0; f < a.fn; ++f) {
		const float one = a.face[std::size_t(f)].cQ(), other = b.face[std::size_t(f)].cQ();
		if (one == other) continue;
		std::fprintf(stderr, "face %d: %g against %g\n", f, double(one), double(other));
		return false;
	}
	return true;
}

template <class Container>
long selectedNum(const Container& elements)
{
	return std::count_if(elements.begin(), elements.end(), [](const auto& e) { return e.IsS(); });
}

bool within(const ToolMesh& a, const ToolMesh& b, float most)
{
	for (const ToolVertex& v : a.vert) {
		const bool found = std::any_of(b.vert.begin(), b.vert.end(), [&](const ToolVertex& w) {
			return (v.cP() - w.cP()).Norm() <= most;
		});
		if (!found) return false;
	}
	return true;
}

} // namespace

int main(int argc, char** argv)
{
	const std::string task = argc > 1 ? argv[1] : "";
	ToolMesh          a, b;
	if (task == "make" && argc == 3) {
		using vcg::tri::io::Mask;
		const int mask = Mask::IOM_VERTQUALITY | Mask::IOM_VERTFLAGS | Mask::IOM_FACEFLAGS;
		makeTorus(a, 160, 80);
		addAttributes(a);
		return vcg::tri::io::ExporterPLY<ToolMesh>::Save(a, argv[2], mask) == 0 ? 0 : 1;
	}
	if (task == "regions" && argc == 3) {
		makeTorus(a, 160, 80);
		for (ToolFace& f : a.face) // two bands and the faces between
			f.Q() = std::floor(1.99f * f.P(0)[0]);
		return vcg::tri::io::ExporterPLY<ToolMesh>::Save(a, argv[2],
														 vcg::tri::io::Mask::IOM_FACEQUALITY) == 0
				   ? 0
				   : 1;
	}
	if (task == "sized" && argc == 3) {
		makeTorus(a, 160, 80);
		for (ToolVertex& v : a.vert)
			v.Q() = 0.1f + 0.03f * v.P()[0];
		return vcg::tri::io::ExporterPLY<ToolMesh>::Save(a, argv[2],
														 vcg::tri::io::Mask::IOM_VERTQUALITY) == 0
				   ? 0
				   : 1;
	}
	if (task == "labels" && argc == 4) {
		return open(a, argv[2]) && open(b, argv[3]) && sameLabels(a, b) ? 0 : 1;
	}
	if (task == "scan" && argc == 4) {
		makeTorus(a, 2 * std::stoi(argv[3]), std::stoi(argv[3]));
		return vcg::tri::io::ExporterPLY<ToolMesh>::Save(a, argv[2]) == 0 ? 0 : 1;
	}
	if (task == "roof" && argc == 3) {
		makeRoof(a, 40);
		return vcg::tri::io::ExporterPLY<ToolMesh>::Save(a, argv[2]) == 0 ? 0 : 1;
	}
	if (task == "ridge" && argc == 3) {
		makeRoof(b, 40);
		for (const ToolVertex& v : b.vert)
			if (v.cP()[2] == 0) vcg::tri::Allocator<ToolMesh>::AddVertex(a, v.cP());
		return vcg::tri::io::ExporterPLY<ToolMesh>::Save(a, argv[2]) == 0 ? 0 : 1;
	}
	if (task == "marks" && argc == 4) {
		return open(a, argv[2]) && open(b, argv[3]) && sameMarks(a, b) ? 0 : 1;
	}
	if (task == "selected" && argc == 3 && open(a, argv[2])) {
		std::printf("%ld %ld\n", selectedNum(a.vert), selectedNum(a.face));
		return 0;
	}
	if (task == "same" && argc == 4) {
		return open(a, argv[2]) && open(b, argv[3]) && same(a, b) ? 0 : 1;
	}
	if (task == "within" && argc == 5) {
		return open(a, argv[2]) && open(b, argv[3]) && within(a, b, std::stof(argv[4])) ? 0 : 1;
	}
	if (task == "count" && argc == 3 && open(a, argv[2])) {
		std::printf("%d\n", a.vn);
		return 0;
	}
	return 2;
}
