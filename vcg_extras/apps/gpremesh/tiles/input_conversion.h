// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_INPUT_CONVERSION_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_INPUT_CONVERSION_H

#include "run_folder.h"

#include <vcg_extras/core/progress.h>
#include <vcg_extras/io/base/run_limit.h>

#include <string>
#include <vector>

namespace gpr::app {

/// The way in which a run in tiles reads a file.
enum class TileInput {
	Directly,  ///< a binary PLY file
	Converted, ///< by way of a binary PLY file
	NotAtAll,
};

/// Decides by the extension and the first bytes. Throws AppError: (Usage) for an extension of no
/// format, (BadInput) for a file that cannot be read.
TileInput tileInputOf(const std::string& path);

struct MeshSize {
	double vertexNum = 0, faceNum = 0;
};

/// Approximate size of the mesh in a file: a PLY file has the numbers in its header, for other
/// files the size of the file counts.
MeshSize estimatedSize(const std::string& path);

/// Makes binary PLY files of the inputs that need a conversion, in the folder of the run; makes the
/// folder. Returns the files for the plan. An earlier conversion is used again after a test of its
/// checksums and the checksums of the inputs. Throws AppError: (BadInput) for an input that is
/// damaged, has changed since, or has a format that tiles do not read; (Usage) if the folder has
/// files of other inputs; (Failure) for a too small disk; (Stopped) if the run has to end. Memory:
/// about memoryBytes; 0: 256 MB. Cost: see conversion.h.
std::vector<std::string> convertInputs(const std::vector<std::string>& inputs, double memoryBytes,
									   const RunFolder& folder, const RunLimit& limit,
									   const ProgressCallback& progress);

/// Throws like convertInputs if the files in the folder were converted from other inputs.
void requireSameInputs(const std::vector<std::string>& inputs, const RunFolder& folder);

/// The notes on the inputs' conversions, for a report.
std::vector<std::string> conversionNotes(std::size_t inputNum, const RunFolder& folder);

} // namespace gpr::app

#endif
