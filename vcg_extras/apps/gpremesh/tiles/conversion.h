// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_CONVERSION_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_CONVERSION_H

#include <vcg_extras/core/progress.h>
#include <vcg_extras/io/base/run_limit.h>

#include <string>
#include <vector>

// Conversion of files of other formats to binary PLY files, read and written piece by piece: a file
// may be larger than the memory. Vertices and faces have the same meaning as in the readers of
// whole files.

namespace gpr::app {

/// The conversion of a file.
struct Conversion {
	std::string             source, target;
	std::string             scratch;         ///< a folder for temporary files
	double                  memoryBytes = 0; ///< at most, approximately
	const RunLimit&         limit;
	const ProgressCallback& progress;

	/// Throws AppError (Stopped) if the run has to end.
	void tell(double share) const { limit.tell(progress, share, "Converting the input"); }
};

// Each function writes the target whole or not at all, and returns sentences for the report. Throws
// AppError: (BadInput) for a damaged source, for text with the line; (Failure) for a full disk;
// (Stopped) if the run has to end.

/// Converts vertices, colours if all vertices have a colour, and faces. Polygons stay polygons.
/// Texture coordinates, normals and materials are left out, with a note. Memory: 50 MB. Cost: one
/// pass by all threads, and two passes over temporary files.
std::vector<std::string> convertObj(const Conversion& job);

/// The same for an OFF file. Colours are left out, as by the reader of whole files.
std::vector<std::string> convertOff(const Conversion& job);

/// Converts all properties of vertices and faces, in their order; coordinates as floats or doubles.
/// Other elements are left out. Memory: 20 MB. Cost: one pass.
std::vector<std::string> convertTextPly(const Conversion& job);

/// Joins corners at the same position to a vertex, in the order of first use. Memory: as the job
/// allows, and half a byte per face. Cost: two passes, and temporary files of one and a half times
/// the size.
std::vector<std::string> convertBinaryStl(const Conversion& job);

} // namespace gpr::app

#endif
