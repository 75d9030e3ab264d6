// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_EXAMPLE_MESH_H
#define VCG_EXTRAS_EXAMPLE_MESH_H

// The mesh type of the examples, as every vcglib program declares its own.

#include <vcg/complex/complex.h>

#ifndef EXAMPLE_SCALAR
#define EXAMPLE_SCALAR float
#endif

template <class T>
using Coord = vcg::vertex::Coord<vcg::Point3<EXAMPLE_SCALAR>, T>; // vcg::vertex::Coord3f or Coord3d
template <class T>
using Quality = vcg::vertex::Quality<EXAMPLE_SCALAR, T>;

class MyVertex;
class MyFace;
struct MyTypes
		: public vcg::UsedTypes<vcg::Use<MyVertex>::AsVertexType, vcg::Use<MyFace>::AsFaceType> {};
class MyVertex : public vcg::Vertex<MyTypes, Coord, Quality, vcg::vertex::BitFlags> {};
class MyFace : public vcg::Face<MyTypes, vcg::face::VertexRef, vcg::face::BitFlags> {};
class MyMesh : public vcg::tri::TriMesh<std::vector<MyVertex>, std::vector<MyFace>> {};

#endif
