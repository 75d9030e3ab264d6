// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_PAGE_H
#define VCG_EXTRAS_APPS_GPREMESH_COMPARE_COMPARE_PAGE_H

#include "compare_record.h"
#include "mesh_pictures.h"

namespace gpr::app {

/// Pictures with a caption.
struct CaptionedPictures {
	std::string  caption;
	MeshPictures pictures;
};

/// The comparison as an HTML page that needs no other file: contains the pictures and the viewer.
/// viewer: a piece of HTML, or empty.
std::string comparePage(const CompareRecord& record, const std::vector<CaptionedPictures>& pictures,
						const std::string& viewer);

} // namespace gpr::app

#endif
