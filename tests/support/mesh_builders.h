// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_SUPPORT_MESH_BUILDERS_H
#define GPR_TESTS_SUPPORT_MESH_BUILDERS_H

#include "random_source.h"

#include <vcg_extras/core/mesh_view.h>

#include <functional>
#include <vector>

namespace gpr::test {

// Meshes made in code. Lengths in mesh units; all are oriented, closed meshes outwards, unless
// said.

// ---- open surfaces

/// nx × ny squares, each of two triangles, over [0, width] × [0, height] in the plane z = 0.
TriangleMesh grid(int nx, int ny, double width = 1, double height = 1);
/// The squares of grid(n, n, side, side) for which keep(i, j).
TriangleMesh gridWhere(int n, double side, const std::function<bool(int i, int j)>& keep);
/// Equilateral triangles of side 1, nx by ny pairs, in a parallelogram.
TriangleMesh lattice(int nx, int ny);
/// A square grid of side 1 whose inner points are moved by up to `jitter` of a cell.
TriangleMesh jitteredGrid(int n, double jitter, Random& random);
/// A square grid of side 1, folded along x = 0.5 by an angle (0 = flat).
TriangleMesh bentSheet(int n, double angleRad);
/// A square grid of side 1 with the slope `slope` in |x - 0.5| and |y - 0.5|: two creases cross in
/// the middle.
TriangleMesh crossedCreases(int n, double slope);
/// A square grid of side 1, folded along x = 0.5. The angle falls from angleRad at y = 0 to 0 at y
/// = 1.
TriangleMesh fadingCrease(int n, double angleRad);
/// Two square grids of side 1, one `gap` above the other: two components close to each other.
TriangleMesh twoSheets(int n, double gap);
/// A square of side 1 and n cells without the holeCells × holeCells in its middle; two border
/// loops.
TriangleMesh squareFrame(int n, int holeCells);
/// Side of a cylinder about the z axis; two border loops.
TriangleMesh openCylinder(int around, int along, double radius, double height);
/// Side of a cone with its apex at the origin, opening upwards; one border loop.
TriangleMesh cone(int around, int along, double radius, double height);
/// One side, one border loop; the strip is `across` squares wide.
TriangleMesh moebiusStrip(int around, int across);

// ---- closed surfaces

TriangleMesh icosphere(int level, double radius = 1);
/// Latitude and longitude: needles at both poles.
TriangleMesh uvSphere(int rings, int segments, double radius = 1);
/// n squares round the axis, m round the tube.
TriangleMesh torus(int n, int m, double axisRadius = 1, double tubeRadius = 0.4);
/// Surface of a box of nx × ny × nz cells, a corner at the origin.
TriangleMesh box(int nx, int ny, int nz, const Vec3d& size);
TriangleMesh cube(int n);
TriangleMesh thinPlate(int n, double thickness);
/// Half of a tube of radius 1 and length 4 with edges that turn by 30°. Its top is at (0, y, 1).
TriangleMesh arch();
/// An arch, and an upright leaf at y = 2 under its top, which nearly touches the arch.
TriangleMesh archOverLeaf();
/// A prism over an L: three cubes of side 1 and n cells in a corner.
TriangleMesh lPrism(int n);
TriangleMesh closedCylinder(int around, int along, double radius, double height);
/// A plate of radius 1 with a round hole, as CAD programs mesh such a plate: needles from rim to
/// rim.
TriangleMesh ringPlate(int around, double innerRadius, double height);
/// A sphere whose vertices are moved along their normals by up to `amplitude`.
TriangleMesh noisySphere(int level, double amplitude, Random& random);
/// Closed, with one side; cuts itself.
TriangleMesh kleinBottle(int n, int m);

// ---- defects

/// `fanNum` fans of three triangles with a common vertex.
TriangleMesh fansSharingVertex(int fanNum);
/// `finNum` triangles at one edge.
TriangleMesh finsOnEdge(int finNum);
/// Every face with three vertices of its own, each moved by up to `noise` per coordinate.
TriangleMesh soupOf(const TriangleMesh& mesh, double noise, Random& random);
/// A number below `partNum` for every face. Each part is linked over edges and has a random size.
std::vector<int> randomParts(const TriangleMesh& mesh, int partNum, Random& random);
/// The mesh without the faces round `holeNum` inner vertices far from each other: each hole makes a
/// border loop.
TriangleMesh withHoles(const TriangleMesh& mesh, int holeNum, Random& random);
/// `editNum` random acts of damage: faces dropped, doubled, turned over, corners renamed.
TriangleMesh damaged(const TriangleMesh& mesh, int editNum, Random& random);

// ---- random meshes

/// A sound shape of this file with random size, jitter, holes and further components.
TriangleMesh randomSurface(Random& random);
/// Every face made four by its edges' midpoints.
TriangleMesh subdivided(const TriangleMesh& mesh);

} // namespace gpr::test

#endif
