// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_text.h"

#define GPR_PAPER "<b>\"Fast Edge-based geodesic Poisson Disk Remeshing\"</b>"
#define GPR_FU_AND_ZHOU                                                                \
	"<i>Yan Fu, Bingfeng Zhou:</i> <b>\"Direct sampling on surfaces for high quality " \
	"remeshing\"</b>, "                                                                \
	"ACM Symposium on Solid and Physical Modeling, 2008"

namespace gpr_filter {

namespace {

const FilterText remeshing = {
	"Remeshing: Geodesic Poisson Disk",
	"meshing_geodesic_poisson_disk_remeshing",
	"Remeshes the surface with about-equilateral triangles of equal size and with exactly the "
	"wanted number of vertices. Components, holes, handles and borders are kept; colour, quality, "
	"textures and named attributes are carried over. MeshLab has no undo: put the result into a "
	"new layer to keep the original.<br>"
	"<br>See: " GPR_PAPER " and " GPR_FU_AND_ZHOU,
};

const FilterText sampling = {
	"Sampling: Geodesic Poisson Disk",
	"generate_sampling_geodesic_poisson_disk",
	"Makes a new layer of points on the surface. The points are as dense as possible, but no two "
	"points are nearer than the disk radius, measured along the surface. The number of points is "
	"the wanted number within about a tenth.<br>"
	"The quality of a point is the radius of its disk, the normal is the normal of the surface. "
	"Vertex colour is carried over. \"Remeshing: Retriangulate from Samples\" makes a mesh of the "
	"points.<br>"
	"<br>See: " GPR_PAPER ", section 3, steps 1 to 8, and " GPR_FU_AND_ZHOU,
};

const FilterText retriangulation = {
	"Remeshing: Retriangulate from Samples",
	"meshing_retriangulate_from_samples",
	"Meshes the surface of the current layer with the vertices of another layer, given by its "
	"number. Components, holes and handles are kept. If the topology needs more vertices than the "
	"samples, some of the original vertices stay.<br>"
	"A sample off the surface moves to the nearest point of the surface. The log has the number of "
	"moved samples and the largest move. The transforms of both layers count. Attributes are "
	"carried over from the surface. MeshLab has no undo: put the result into a new layer to keep "
	"the original.<br>"
	"<br>See: " GPR_PAPER ", section 3, last paragraph",
};

const FilterText features = {
	"Feature Detection: Second-Order Difference",
	"compute_features_by_second_order_difference",
	"Detects crease edges and cone apexes and selects their vertices. The strength of an edge is "
	"the angle, in degrees, between the mean normals of the two half-disks on its sides. All "
	"half-disks have the same size. The quality of a vertex becomes the largest strength of its "
	"edges; \"Colorize by vertex Quality\" shows this strength. Selected faces stay selected; "
	"nothing else is changed.<br>"
	"The selected vertices are a feature region, and can be corrected by hand. A later call of "
	"\"Remeshing: Geodesic Poisson Disk\" proposes smaller triangles in this region, by the "
	"feature disk scale.<br>"
	"<br>See: " GPR_PAPER
	", section 3.1, for the method's name and its use. The formula is in the file "
	"features.md of this plugin's documentation.",
};

const FilterText comparison = {
	"Compare: Geodesic Poisson Disk vs Quadric Edge Collapse",
	"generate_geodesic_poisson_disk_vs_quadric_edge_collapse",
	"Makes two new layers with the same number of faces from the current layer: the first by "
	"\"Remeshing: Geodesic Poisson Disk\" with the parameters below, the second by MeshLab's "
	"\"Simplification: Quadric Edge Collapse Decimation\" with the values of its dialog. Colours "
	"show the quality of the triangles or the distance from the input. The log compares both "
	"layers in a table. The current layer is unchanged.<br>"
	"<br>See: " GPR_PAPER " and M. Garland, P. S. Heckbert: \"Surface simplification using quadric "
	"error metrics\", SIGGRAPH 1997",
};

} // namespace

const FilterText& textOf(Filter filter)
{
	switch (filter) {
	case SamplingFilter:
		return sampling;
	case RetriangulateFilter:
		return retriangulation;
	case FeatureFilter:
		return features;
	case CompareFilter:
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
