// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_VCG_MESH_TYPES_H
#define GPR_TESTS_VCG_MESH_TYPES_H

// Mesh types, each for float and double: everything, nothing but the least, everything optional.

#include <vcg/complex/complex.h>

namespace gpr_test {

/// vcglib names its components by scalar (Coord3f, Coord3d); here the scalar is an argument.
template <class S>
struct Of {
	template <class T>
	using Coord = vcg::vertex::Coord<vcg::Point3<S>, T>;
	template <class T>
	using Normal = vcg::vertex::Normal<vcg::Point3<S>, T>;
	template <class T>
	using Quality = vcg::vertex::Quality<S, T>;
	template <class T>
	using QualityOcf = vcg::vertex::QualityOcf<S, T>;
	template <class T>
	using NormalOcf = vcg::vertex::NormalOcf<vcg::Point3<S>, T>;
	template <class T>
	using FaceNormal = vcg::face::NormalAbs<vcg::Point3<S>, T>;
};

template <class S>
class FullVertex;
template <class S>
class FullFace;
template <class S>
struct FullTypes : public vcg::UsedTypes<vcg::Use<FullVertex<S>>::template AsVertexType,
										 vcg::Use<FullFace<S>>::template AsFaceType> {
};
template <class S>
class FullVertex
		: public vcg::Vertex<FullTypes<S>, Of<S>::template Coord, Of<S>::template Normal,
							 Of<S>::template Quality, vcg::vertex::Color4b, vcg::vertex::Mark,
							 vcg::vertex::VFAdj, vcg::vertex::BitFlags> {
};
template <class S>
class FullFace : public vcg::Face<FullTypes<S>, vcg::face::VertexRef, Of<S>::template FaceNormal,
								  vcg::face::Mark, vcg::face::FFAdj, vcg::face::VFAdj,
								  vcg::face::BitFlags> {
};
template <class S>
class FullMesh : public vcg::tri::TriMesh<std::vector<FullVertex<S>>, std::vector<FullFace<S>>> {
};

template <class S>
class BareVertex;
template <class S>
class BareFace;
template <class S>
struct BareTypes : public vcg::UsedTypes<vcg::Use<BareVertex<S>>::template AsVertexType,
										 vcg::Use<BareFace<S>>::template AsFaceType> {
};
template <class S>
class BareVertex : public vcg::Vertex<BareTypes<S>, Of<S>::template Coord, vcg::vertex::BitFlags> {
};
template <class S>
class BareFace : public vcg::Face<BareTypes<S>, vcg::face::VertexRef, vcg::face::BitFlags> {
};
template <class S>
class BareMesh : public vcg::tri::TriMesh<std::vector<BareVertex<S>>, std::vector<BareFace<S>>> {
};

/// Too little: faces without flags cannot tell whether they are deleted.
template <class S>
class FlaglessVertex;
template <class S>
class FlaglessFace;
template <class S>
struct FlaglessTypes : public vcg::UsedTypes<vcg::Use<FlaglessVertex<S>>::template AsVertexType,
											 vcg::Use<FlaglessFace<S>>::template AsFaceType> {
};
template <class S>
class FlaglessVertex
		: public vcg::Vertex<FlaglessTypes<S>, Of<S>::template Coord, vcg::vertex::BitFlags> {
};
template <class S>
class FlaglessFace : public vcg::Face<FlaglessTypes<S>, vcg::face::VertexRef> {
};
template <class S>
class FlaglessMesh
		: public vcg::tri::TriMesh<std::vector<FlaglessVertex<S>>, std::vector<FlaglessFace<S>>> {
};

template <class S>
class OcfVertex;
template <class S>
class OcfFace;
template <class S>
struct OcfTypes : public vcg::UsedTypes<vcg::Use<OcfVertex<S>>::template AsVertexType,
										vcg::Use<OcfFace<S>>::template AsFaceType> {
};
template <class S>
class OcfVertex : public vcg::Vertex<OcfTypes<S>, vcg::vertex::InfoOcf, Of<S>::template Coord,
									 Of<S>::template NormalOcf, Of<S>::template QualityOcf,
									 vcg::vertex::Color4bOcf, vcg::vertex::VFAdjOcf,
									 vcg::vertex::BitFlags> {
};
template <class S>
class OcfFace : public vcg::Face<OcfTypes<S>, vcg::face::InfoOcf, vcg::face::VertexRef,
								 Of<S>::template FaceNormal, vcg::face::FFAdjOcf,
								 vcg::face::VFAdjOcf, vcg::face::BitFlags> {
};
template <class S>
class OcfMesh : public vcg::tri::TriMesh<vcg::vertex::vector_ocf<OcfVertex<S>>,
										 vcg::face::vector_ocf<OcfFace<S>>> {
};

} // namespace gpr_test

#endif
