// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_TILES_CONVERSION_H
#define VCG_EXTRAS_APPS_GPREMESH_TILES_CONVERSION_H

#include <vcg_extras/core/progress.h>
#include <vcg_extras/io/base/run_limit.h>

#include <string>
#include <vector>

// Files of other formats as binary PLY files, read and written piece by piece, so that they may be
// larger than the memory. A vertex or face means what it means to the readers of whole files.

namespace gpr::app {

/// One file that is converted.
struct Conversion {
	std::string             source, target;
	std::string             scratch;         ///< a folder for what is put aside
	double                  memoryBytes = 0; ///< at most, about
	const RunLimit&         limit;
	const ProgressCallback& progress;

	/// Throws AppError (Stopped) where the run has to end.
	void tell(double share) const
	{
		limit.check();
		if (progress && !progress(share, "Converting the input")) limit.check();
	}
};

// Each writes the target whole or not at all, and returns sentences for the report. They throw
// AppError: (BadInput) where the source is damaged, with the line where it is text, (Failure) where
// the disk is full, (Stopped) when the run has to end.

/// Vertices, their colours where all have one, and faces. Polygons stay as they are. Texture
/// coordinates, normals and materials are left out, with a note. Memory: 50 MB. Cost: one pass by
/// all threads, and two over what is put aside.
std::vector<std::string> convertObj(const Conversion& job);

/// The same of an OFF file. Colours are left out, as the reader of whole files does.
std::vector<std::string> convertOff(const Conversion& job);

/// All properties of vertices and faces, in their order; coordinates as floats or doubles. Other
/// elements are left out. Memory: 20 MB. Cost: one pass.
std::vector<std::string> convertTextPly(const Conversion& job);

/// Corners at the same position become one vertex, in the order of their first use. Memory: that
/// of the job, and half a byte a face. Cost: two passes, and one and a half times as much put
/// aside.
std::vector<std::string> convertBinaryStl(const Conversion& job);

} // namespace gpr::app

#endif
