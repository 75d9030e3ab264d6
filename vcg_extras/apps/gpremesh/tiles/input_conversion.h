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

/// How a run in tiles reads a file.
enum class TileInput {
	Directly,  ///< a binary PLY file
	Converted, ///< as a binary PLY file that is made of it
	NotAtAll,
};

/// Decides by the extension and the first bytes. Throws AppError: (Usage) for an extension that
/// stands for no format, (BadInput) where the file cannot be read.
TileInput tileInputOf(const std::string& path);

struct MeshSize {
	double vertexNum = 0, faceNum = 0;
};

/// Of a file, about: a PLY file tells its numbers, of others the size counts.
MeshSize estimatedSize(const std::string& path);

/// Makes binary PLY files of those inputs that need it, in the folder of the run, which is made.
/// Returns the files that the plan shall name. What was converted is not converted again: its
/// checksums are tested, and those of the inputs. Throws AppError: (BadInput) for an input that is
/// damaged, has changed since, or is of a format that tiles do not read, (Usage) where the folder
/// has the files of other inputs, (Failure) where the disk is too small, (Stopped) when the run has
/// to end. Memory: memoryBytes, 256 MB where that is 0, about. Cost: see conversion.h.
std::vector<std::string> convertInputs(const std::vector<std::string>& inputs, double memoryBytes,
									   const RunFolder& folder, const RunLimit& limit,
									   const ProgressCallback& progress);

/// Throws like convertInputs where the inputs are not those that were converted into the folder.
void requireSameInputs(const std::vector<std::string>& inputs, const RunFolder& folder);

/// What a report has to tell of so many inputs.
std::vector<std::string> conversionNotes(std::size_t inputNum, const RunFolder& folder);

} // namespace gpr::app

#endif
