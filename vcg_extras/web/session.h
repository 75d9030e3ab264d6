// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_WEB_SESSION_H
#define VCG_EXTRAS_WEB_SESSION_H

#include <vcg_extras/core/prepared_surface.h>
#include <vcg_extras/core/surface/surface_distance.h>
#include <vcg_extras/io/mesh/mesh_source.h>
#include <vcg_extras/io/report/json_parts.h>

#include <map>
#include <memory>
#include <string>
#include <string_view>

namespace gpr::web {

using app::Json;

/// How bytes come to the caller beside the JSON.
using Pack = Json (*)(std::string_view bytes);

/// One mesh, and what is made of it. One thread. Failures are AppError.
class Session {
public:
	Session(ProgressCallback progress, Pack pack);

	/// Takes a file, by the program's own readers. What was open is closed.
	Json open(const std::string& path);
	/// Takes arrays.
	Json take(app::InputMesh mesh);
	/// The input as the viewer takes it.
	Json shownInput();

	/// What a run will take. The options are those of the command line.
	Json estimate(const std::string& options);
	/// Remeshes; what comes back is the report. Refuses before the work what needs more memory than
	/// a page can have.
	Json remesh(const std::string& options);
	/// Quadric Edge Collapse.
	Json collapse(std::int64_t faceNum);

	/// A result as the viewer takes it: "result" or "quadricEdgeCollapse".
	Json shown(const std::string& key, const std::string& name) const;
	/// The same with its distances from the input, and its figures.
	Json measured(const std::string& key, const std::string& name);
	/// Bounds of its largest distance from the input.
	Json proven(const std::string& key);

	/// The last result, and what it carries over from its file, written as the program would.
	Json save(const std::string& path) const;
	/// The last result as arrays, in the input's precision.
	Json arrays() const;

private:
	ProgressCallback                    progress_;
	Pack                                pack_;
	std::string                         path_; ///< empty where arrays were taken
	app::WantedAttributes               wanted_;
	bool                                isSewn_ = true;
	app::MeshSource                     source_;
	std::unique_ptr<PreparedSurface>    surface_;
	std::unique_ptr<MeasuredSurface>    measured_; ///< the input; made when it is needed
	RemeshResult                        result_;   ///< its mesh is made_["result"]
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
