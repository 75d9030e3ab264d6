// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_REPORT_REPORT_JSON_H
#define VCG_EXTRAS_IO_REPORT_REPORT_JSON_H

#include <vcg_extras/core/remesh.h>
#include <vcg_extras/io/base/stopwatch.h>
#include <vcg_extras/io/report/mesh_parts.h>

#include <string>
#include <vector>

namespace gpr::app {

/// One of several files of a run.
struct MadeFile {
	std::string  path;
	std::int64_t vertices = 0, faces = 0;
};

/// All data for the JSON report of a run.
struct RunRecord {
	std::string              inputPath;
	std::vector<MadeFile>    files; ///< of several inputs; else empty
	std::string              outputPath;
	bool                     inputDouble  = false;
	bool                     outputDouble = false;
	RemeshOptions            options;
	RemeshReport             report;
	std::vector<std::string> notes;
	RunTimes                 times;
	std::int64_t             peakMemoryBytes = 0;
};

/// The report of a remeshing as JSON text. The keys are public: they change with a changelog line.
std::string remeshReportJson(const RunRecord& run);

/// The same for several results of one input: "levels" holds a report each.
std::string levelsReportJson(const std::vector<RunRecord>& levels);

/// All that `gpremesh info` tells of a mesh.
struct MeshInfo {
	std::string              path;
	bool                     doublePrecision = false;
	MeshFigures              figures;
	QualityFigures           quality;
	MeshParts                parts;
	std::vector<std::string> notes;
};

/// The figures of one mesh as JSON text.
std::string meshInfoJson(const MeshInfo& info);

} // namespace gpr::app

#endif
