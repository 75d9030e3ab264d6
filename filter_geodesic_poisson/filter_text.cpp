// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_text.h"

// The paper, without an opening "See:".
#define GPR_PAPER "<b>\"Fast Edge-based geodesic Poisson Disk Remeshing\"</b><br>"

namespace gpr_filter {

namespace {

const FilterText remeshing = {
	"Remeshing: Geodesic Poisson Disk",
	"meshing_geodesic_poisson_disk_remeshing",
	"Remeshes the surface with about-equilateral triangles of equal size and exactly as many "
	"vertices as asked for: samples at the borders of the geodesic disks of those before them, "
	"triangulated, relaxed on the surface and fitted to it. Components, holes and handles are "
	"kept; what is not a 2-manifold is repaired or cut first.<br>"
	"Colour, quality, textures and named attributes are carried over. Where faces are selected "
	"only they are remeshed. MeshLab has no undo: put the result into a new layer to keep the "
	"original.<br>"
	"<br>See:<br>" GPR_PAPER "and<br>"
	"<i>Yan Fu, Bingfeng Zhou</i>,<br>"
	"<b>\"Direct sampling on surfaces for high quality remeshing\"</b><br>"
	"ACM Symposium on Solid and Physical Modeling, 2008",
};

const FilterText sampling = {
	"Sampling: Geodesic Poisson Disk",
	"generate_sampling_geodesic_poisson_disk",
	"Makes a new layer of points that lie on the surface as densely as they can without two of "
	"them "
	"being nearer than the disk radius, measured along the surface. Their number comes out within "
	"about a tenth of what was asked for.<br>"
	"Each point's quality is its disk radius, its normal that of the surface; vertex colour is "
	"carried over. \"Remeshing: Retriangulate from Samples\" makes a mesh of the points.<br>"
	"<br>See:<br>" GPR_PAPER "section 3, steps 1 to 8, and<br>"
	"<i>Yan Fu, Bingfeng Zhou</i>,<br>"
	"<b>\"Direct sampling on surfaces for high quality remeshing\"</b><br>"
	"ACM Symposium on Solid and Physical Modeling, 2008",
};

const FilterText retriangulation = {
	"Remeshing: Retriangulate from Samples",
	"meshing_retriangulate_from_samples",
	"Gives the surface of the current layer new vertices: those of another layer, chosen by its "
	"number, whatever made them. Components, holes and handles are kept; where they need more "
	"vertices than there are samples, some of the original ones stay.<br>"
	"Samples off the surface are put on its nearest point, and the log tells how many and how far. "
	"The transforms of both layers are honoured. Attributes are carried over from the "
	"surface. MeshLab has no undo: put the result into a new layer to keep the "
	"original.<br>"
	"<br>See:<br>" GPR_PAPER "section 3, last paragraph",
};

const FilterText features = {
	"Feature Detection: Second-Order Difference",
	"compute_features_by_second_order_difference",
	"Finds creases and cone apexes. The strength of an edge is the angle, in degrees, "
	"between "
	"the mean normals of the two half-disks on its sides; all have one size, whatever the mesh is "
	"like there. A vertex's quality becomes the largest strength of its edges; vertices on feature "
	"lines and cone apexes are selected, and the faces that have one of them. What was selected "
	"before is "
	"not any more; nothing else is changed.<br>"
	"The selection can be corrected by hand and then be given to \"Remeshing: Geodesic Poisson "
	"Disk\" as its feature region; the same thresholds there, with the region \"detected\", find "
	"the same without this step. \"Colorize by vertex Quality\" shows the strength.<br>"
	"<br>See:<br>" GPR_PAPER "section 3.1, for the method's name and its use; the formula is "
	"documented with this plugin (docs/features.md)",
};

const FilterText comparison = {
	"Compare: Geodesic Poisson Disk vs Quadric Edge Collapse",
	"generate_geodesic_poisson_disk_vs_quadric_edge_collapse",
	"Makes two new layers of the current one, with the same number of faces: by \"Remeshing: "
	"Geodesic Poisson Disk\", and by MeshLab's \"Simplification: Quadric Edge Collapse "
	"Decimation\" "
	"with what its dialog proposes. They are coloured by the quality of their triangles or by the "
	"distance from the input, and the log has a table of both. The current layer stays as it "
	"is.<br>"
	"<br>See:<br>" GPR_PAPER "and<br>"
	"<i>M. Garland, P. S. Heckbert</i>,<br>"
	"<b>\"Surface simplification using quadric error metrics\"</b><br>"
	"SIGGRAPH, 1997",
};

} // namespace

const FilterText& textOf(gpr::Tool tool)
{
	switch (tool) {
	case gpr::SamplingTool:
		return sampling;
	case gpr::RetriangulateTool:
		return retriangulation;
	case gpr::FeatureTool:
		return features;
	case gpr::CompareTool:
		return comparison;
	default:
		return remeshing;
	}
}

const char* scriptType(gpr::ParameterKind kind)
{
	switch (kind) {
	case gpr::ParameterKind::Count:
		return "RichInt";
	case gpr::ParameterKind::Number:
		return "RichFloat";
	case gpr::ParameterKind::Length:
		return "RichAbsPerc";
	case gpr::ParameterKind::Switch:
		return "RichBool";
	case gpr::ParameterKind::Choice:
		return "RichEnum";
	}
	return "";
}

} // namespace gpr_filter
