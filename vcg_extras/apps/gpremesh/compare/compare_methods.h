// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_METHODS_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_METHODS_H

#include <vcg_extras/apps/gpremesh/commands/command_line.h>
#include <vcg_extras/core/report.h>
#include <vcg_extras/core/surface/certified_distance.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <functional>
#include <string>
#include <vector>

namespace gpr::app {

/// Figures and quality of a mesh of any origin.
struct MeshRecord {
	MeshFigures    figures;
	QualityFigures quality;
	std::int64_t   nonManifoldEdges = 0; ///< edges of more than two faces
};

/// A method of the comparison and its outcome.
struct MethodRecord {
	std::string         key;     ///< in JSON: "default", "paper", ...
	std::string         name;    ///< for sentences: "Quadric Edge Collapse"
	std::string         column;  ///< for the table's head: "QEC"
	std::string         failure; ///< a sentence if there is no mesh; nothing below holds then
	TriangleMesh        mesh;
	std::vector<double> seconds;          ///< of each run, mesh in memory to mesh in memory
	std::vector<double> processorSeconds; ///< of each run, all threads together
	MeshRecord          record;
	bool                topologyKept = false;
	ComparedDistance    distance; ///< of input and result from each other
};

/// 0 if there are no values.
double median(std::vector<double> values);

/// The data of the table, the JSON and the page.
struct CompareRecord {
	CommandLine               line;
	bool                      inputDouble = false;
	MeshRecord                input;
	MeshFigures               cleanedInput; ///< as loaded by the engine
	int                       threads = 0;  ///< threads of the engine
	std::vector<MethodRecord> methods;
	std::vector<std::string>  notes; ///< sentences to read even after success

	double percentOfDiagonal(double distance) const
	{
		return input.figures.diagonal > 0 ? 100 * distance / input.figures.diagonal : 0;
	}
};

/// Receives a phrase about the work, and the share of all work done before; throws to stop.
using CompareProgress = std::function<void(double share, const std::string& phrase)>;

/// Runs every method on the mesh with the options and the number of runs of the line, in
/// alternation, and measures the results: the paper's Table 1 for any mesh. Quadric Edge Collapse
/// gets the number of faces of the default path's result, isotropic remeshing its mean edge length.
/// A failed method is recorded with the reason; only a failure of the default path throws AppError.
/// Cost: all methods, and some seconds per million faces for the distances of each method.
CompareRecord compareMethods(const InputMesh& input, const CommandLine& line,
							 const CompareProgress& progress);

} // namespace gpr::app

#endif
