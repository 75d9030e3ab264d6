// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_LAYER_JOB_H
#define FILTER_GEODESIC_POISSON_LAYER_JOB_H

// The common work of all filters with MeshLab's document.

#include "comparison.h"
#include "mesh_bridge.h"
#include "parameter_bridge.h"

#include <string>
#include <vector>

namespace gpr_filter {

/// The facts for the dialog's defaults; a document without a layer has facts, too.
gpr::MeshFacts factsOf(const MeshDocument& document);

/// The proposals of the dialog beside these defaults: the layer of the samples.
GivenValues proposedFor(const MeshDocument& document);

/// The options for the parameters and the attributes of a layer.
gpr::RemeshOptions optionsFor(const ReadParameters& read, Filter filter, const MeshModel& layer);

/// The parts of a layer for a run with these options. Throws Refusal if the layer lacks the
/// selection or the attribute for the parameters.
LayerCopy copyFor(const MeshModel& layer, const ReadParameters& read,
				  const gpr::RemeshOptions& options);

/// One run of a filter on the current layer: the options, a copy of the mesh for the engine, and
/// the way back into the document.
class LayerJob {
public:
	/// Reads the parameters and copies the layer. Throws Refusal: no layer, values out of range, a
	/// layer without the selection that the values ask for.
	LayerJob(MeshDocument& document, Filter filter, const RichParameterList& list);

	const LayerCopy&          copy() const { return _copy; }
	const gpr::RemeshOptions& options() const { return _options; }

	/// Sentences about parts of the script without effect.
	const std::vector<std::string>& notes() const { return _read.notes; }

	/// The vertices of the layer that the parameter SampleLayer names, in the frame of ours.
	/// Throws Refusal: no such layer, an empty one, our own, a transform that has no inverse.
	std::vector<gpr::Vec3d> samples() const;
	/// How many these are, under the same conditions.
	std::int64_t sampleNum() const;

	/// The layer, for writing. Other filters can run during the run; throws Refusal if another
	/// filter removed the layer or changed its mesh.
	MeshModel& layer() const;

	/// For a user with selected faces who did not ask for a run on the selection; empty if no face
	/// was selected at the begin of the run.
	std::string sentenceOfSelectedFaces() const;

	/// Puts a result with the layer's attributes into the layer, or into a new layer if the
	/// parameters say so, whose label ends with the suffix. Returns sentences, some empty, about
	/// lost attributes and about the layer's transform. Throws as layer() does; the document is
	/// then unchanged.
	std::vector<std::string> put(const gpr::RemeshResult& result, const char* suffix) const;

	/// Makes strengths the layer's vertex quality and selects the marked vertices. Throws as
	/// layer() does.
	void mark(const gpr::FeatureResult& result) const;

	/// Puts samples, with quality and the layer's colour, into a new layer that becomes the current
	/// one. Throws as layer() does.
	void putPoints(const gpr::SamplingResult& result, const char* suffix) const;

	/// Puts both results of a comparison into new layers, coloured and placed by the parameters;
	/// the result of the remeshing becomes the current layer. Throws as layer() does.
	void putCompared(const Comparison& comparison) const;

private:
	MeshDocument&      _document;
	int                _layerId;
	ReadParameters     _read;
	gpr::RemeshOptions _options;
	LayerCopy          _copy;
	bool               _anyFaceSelected = false;

	const MeshModel& sampleModel() const;
	const MeshModel& reachableSampleModel() const;
	MeshModel&       addLayer(const MeshModel& source, int mask, const char* suffix,
							  bool makeCurrent = true) const;
	void addCompared(const MeshModel& source, const ComparedResult& result, const char* suffix,
					 int place, double largestDeviation) const;
};

} // namespace gpr_filter

#endif
