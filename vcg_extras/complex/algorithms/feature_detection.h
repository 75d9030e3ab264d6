// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_FEATURE_DETECTION_H
#define VCG_EXTRAS_FEATURE_DETECTION_H

#include <vcg_extras/complex/algorithms/geodesic_poisson_base.h>
#include <vcg_extras/complex/algorithms/mesh_conversion.h>

#include <cassert>
#include <cstdint>
#include <vector>

namespace vcg {
namespace tri {

/** \brief Creases and cone apexes of a surface, by a uniformly supported second-order difference.

"Fast Edge-based geodesic Poisson Disk Remeshing", section 3.1, finds features in this way, after
Wang 2006, "with user determined threshold values"; the formula is this project's, see
docs/features.md. The strength of an edge is the angle between the mean normals of the half-disks on
its two sides. All half-disks of a mesh have the same size, so the strength depends neither on the
density of the mesh nor on noise.

Works on any tri::TriMesh with coordinates in float or double; a minimal mesh type needs only
coordinates, flags and vertex references. For example:
\code
tri::FeatureDetection<MyMesh>::Features features;
tri::FeatureDetection<MyMesh>::Detect(m, features);
tri::FeatureDetection<MyMesh>::Select(features, m);
\endcode
*/
template <class MeshType>
class FeatureDetection {
public:
	typedef typename MeshType::ScalarType    ScalarType;
	typedef typename MeshType::VertexType    VertexType;
	typedef typename MeshType::VertexPointer VertexPointer;

	typedef GeodesicPoissonResult Result;

	/// featureThresholds, threads and timeLimitSeconds count; see GeodesicPoissonParams. The four
	/// members are shorter names of the thresholds.
	struct Params : public GeodesicPoissonParams {
		typedef gpr::FeatureFigures Stat;

		double& supportRatio   = featureThresholds.support;
		double& strongAngleDeg = featureThresholds.strongDeg;
		double& weakAngleDeg   = featureThresholds.weakDeg;
		double& minLenRatio    = featureThresholds.minLength;

		Params() = default;
		Params(const gpr::RemeshOptions& options) : GeodesicPoissonParams(options) {}
		// The members of a copy refer to the copy's own thresholds.
		Params(const Params& from) : GeodesicPoissonParams(from) {}
		Params& operator=(const Params& from)
		{
			GeodesicPoissonParams::operator=(from);
			return *this;
		}
	};
	typedef typename Params::Stat Stat;

	/// An edge of a feature line.
	struct FeatureEdge {
		VertexPointer v[2];     ///< the ends
		ScalarType    strength; ///< degrees
	};

	/// The features of a mesh. Each vector has the size of the mesh's container; deleted elements
	/// have 0.
	struct Features {
		std::vector<ScalarType>   vertexStrength; ///< degrees in [0, 180]
		std::vector<std::uint8_t> vertexFeature;  ///< gpr::VertexFeature bits, 0 = no feature
		std::vector<std::uint8_t> faceMark;       ///< 1 if a vertex of the face is marked
		std::vector<FeatureEdge>  edges;
	};

	/** \brief Finds the features of a surface.

	Source: paper section 3.1.

	Needs: per-vertex and per-face flags; deleted elements are left out, parts that are not
	2-manifold are cut for the detection only.

	\param m        the surface, any number of components, open or closed; not modified
	\param features receives the features in place of its former content
	\param params   thresholds and threads
	\param stat     null, or receives the counts, and the support in mesh units
	\param cb       null, or progress in percent; returning false cancels

	\return Ok; or the reason of the failure, with features unchanged

	\throw MissingComponentException if m has no flags

	Cost: about 2 s per million faces and core; threads never change the result. */
	static Result Detect(MeshType& m, Features& features, const Params& params = Params(),
						 Stat* stat = nullptr, vcg::CallBackPos* cb = nullptr)
	{
		gpr_detail::RequireReadableTriangles(m);
		try {
			const gpr_detail::FlatMesh<MeshType> flat(m);
			const gpr::FeatureResult             run =
				gpr::detectFeatures(flat.View(), params, gpr_detail::ProgressOf(cb));
			if (stat != nullptr) *stat = run.figures;
			if (run.status == gpr::Status::Ok) features = FeaturesOf(m, run);
			return gpr_detail::ResultOf(run);
		}
		catch (const std::bad_alloc&) {
			return gpr_detail::OutOfMemoryResult();
		}
	}

	/** \brief Puts the strengths, in degrees, into the vertices' quality.

	\throw MissingComponentException if m has no quality */
	static void WriteQuality(const Features& features, MeshType& m)
	{
		assert(features.vertexStrength.size() == m.vert.size());
		RequirePerVertexQuality(m);
		for (std::size_t v = 0; v < m.vert.size(); ++v)
			if (!m.vert[v].IsD())
				m.vert[v].Q() = typename VertexType::QualityType(features.vertexStrength[v]);
	}

	/// \brief Selects the marked vertices and faces, and deselects all other elements.
	static void Select(const Features& features, MeshType& m)
	{
		assert(features.vertexFeature.size() == m.vert.size());
		assert(features.faceMark.size() == m.face.size());
		for (std::size_t v = 0; v < m.vert.size(); ++v)
			SetSelected(m.vert[v], features.vertexFeature[v] != 0);
		for (std::size_t f = 0; f < m.face.size(); ++f)
			SetSelected(m.face[f], features.faceMark[f] != 0);
	}

private:
	template <class ElementType>
	static void SetSelected(ElementType& element, bool selectedFlag)
	{
		if (element.IsD()) return;
		if (selectedFlag)
			element.SetS();
		else
			element.ClearS();
	}

	/// The indices of the elements of a container, without deleted elements: the engine's
	/// numbering.
	template <class ContainerType>
	static std::vector<std::size_t> IndicesOf(const ContainerType& elements)
	{
		std::vector<std::size_t> indices;
		indices.reserve(elements.size());
		for (std::size_t i = 0; i < elements.size(); ++i)
			if (!elements[i].IsD()) indices.push_back(i);
		return indices;
	}

	static Features FeaturesOf(MeshType& m, const gpr::FeatureResult& run)
	{
		const std::vector<std::size_t> vertexOf = IndicesOf(m.vert), faceOf = IndicesOf(m.face);
		Features                       features;
		features.vertexStrength.assign(m.vert.size(), 0);
		features.vertexFeature.assign(m.vert.size(), 0);
		features.faceMark.assign(m.face.size(), 0);
		for (std::size_t i = 0; i < vertexOf.size(); ++i) {
			features.vertexStrength[vertexOf[i]] = ScalarType(run.vertexStrength[i]);
			features.vertexFeature[vertexOf[i]]  = run.vertexFeature[i];
		}
		for (std::size_t i = 0; i < faceOf.size(); ++i)
			features.faceMark[faceOf[i]] = run.faceMark[i];
		features.edges.reserve(run.edges.size());
		for (const gpr::FeatureEdge& e : run.edges)
			features.edges.push_back(
				{{&m.vert[vertexOf[e.vertex[0]]], &m.vert[vertexOf[e.vertex[1]]]},
				 ScalarType(e.strength)});
		return features;
	}
};

} // namespace tri
} // namespace vcg

#endif
