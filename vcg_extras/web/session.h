// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_WEB_SESSION_H
#define VCG_EXTRAS_WEB_SESSION_H

#include <vcg_extras/core/prepared_surface.h>
#include <vcg_extras/core/surface/surface_distance.h>
#include <vcg_extras/io/mesh/attribute_carry.h>
#include <vcg_extras/io/report/json_parts.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace gpr::web {

using app::Json;

/// Passes bytes to the caller beside the JSON.
using Pack = Json (*)(std::string_view bytes);

/// One open mesh, and its results. Not for several threads at a time. Failures are AppError.
class Session {
public:
	Session(ProgressCallback progress, Pack pack);

	/// Opens a file with the readers of the program. Closes the mesh that was open.
	Json open(const std::string& path);
	/// Opens a mesh of arrays.
	Json take(app::InputMesh mesh);
	/// The input, for the viewer.
	Json shownInput();

	/// Estimates time and memory of a run. The options are options of the command line.
	Json estimate(const std::string& options);
	/// Remeshes and returns the report. Refuses a run that needs more memory than a page can have,
	/// before the work.
	Json remesh(const std::string& options);
	/// Simplifies the input by Quadric Edge Collapse.
	Json collapse(std::int64_t faceNum);

	/// A result for the viewer: "result" or "quadricEdgeCollapse".
	Json shown(const std::string& key, const std::string& name) const;
	/// The same with figures and distances from the input.
	Json measured(const std::string& key, const std::string& name);
	/// Proven bounds of the largest distance of a result from the input.
	Json proven(const std::string& key);

	/// Writes the last result with the values of the input file, like the program.
	Json save(const std::string& path) const;
	/// The last result as arrays, in the precision of the input.
	Json arrays() const;

private:
	ProgressCallback                    progress_;
	Pack                                pack_;
	std::string                         path_; ///< empty for a mesh of arrays
	app::WantedAttributes               wanted_;
	bool                                isSewn_ = true;
	app::MeshSource                     source_;
	std::unique_ptr<PreparedSurface>    surface_;
	std::unique_ptr<MeasuredSurface>    measured_; ///< the input; null until needed
	RemeshResult                        result_;   ///< without the mesh, which is made_["result"]
	std::map<std::string, TriangleMesh> made_;
	double                              diagonal_ = 0;

	void                   readAs(const RemeshOptions& options);
	Json                   begin();
	void                   refuseWhatIsTooLarge(const RemeshOptions& options) const;
	const TriangleMesh&    made(const std::string& key) const;
	const MeasuredSurface& measuredInput(Workers& workers);
};

} // namespace gpr::web

#endif
