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
	"Makes a new layer of points on the surface. They are as dense as possible while no two of "
	"them are nearer than the disk radius, measured along the surface. Their number is within "
	"about a tenth of the wanted one.<br>"
	"The quality of a point is the radius of its disk. Its normal is that of the surface. Vertex "
	"colour is carried over. \"Remeshing: Retriangulate from Samples\" makes a mesh of the "
	"points.<br>"
	"<br>See: " GPR_PAPER ", section 3, steps 1 to 8, and " GPR_FU_AND_ZHOU,
};

const FilterText retriangulation = {
	"Remeshing: Retriangulate from Samples",
	"meshing_retriangulate_from_samples",
	"Gives the surface of the current layer new vertices: those of another layer, which is named "
	"by its number. Components, holes and handles are kept. Where they need more vertices than "
	"there are samples, some of the original vertices stay.<br>"
	"A sample off the surface is put on the nearest point of the surface. The log tells how many "
	"were, and how far off. The transforms of both layers are taken into account. Attributes are "
	"carried over from the surface. MeshLab has no undo: put the result into a new layer to keep "
	"the original.<br>"
	"<br>See: " GPR_PAPER ", section 3, last paragraph",
};

const FilterText features = {
	"Feature Detection: Second-Order Difference",
	"compute_features_by_second_order_difference",
	"Finds creases and cone apexes and selects their vertices. The strength of an edge is the "
	"angle, in degrees, between the mean normals of the two half-disks on its sides. All "
	"half-disks have one size. The quality of a vertex becomes the largest strength of its edges; "
	"\"Colorize by vertex Quality\" shows it. Selected faces stay selected; nothing else is "
	"changed.<br>"
	"The selected vertices are a feature region. They can be corrected by hand. \"Remeshing: "
	"Geodesic Poisson Disk\", called afterwards, proposes smaller triangles there: see its "
	"feature disk scale.<br>"
	"<br>See: " GPR_PAPER
	", section 3.1, for the method's name and its use. The formula is in the file "
	"features.md of this plugin's documentation.",
};

const FilterText comparison = {
	"Compare: Geodesic Poisson Disk vs Quadric Edge Collapse",
	"generate_geodesic_poisson_disk_vs_quadric_edge_collapse",
	"Makes two new layers of the current one, with the same number of faces. One is made by "
	"\"Remeshing: Geodesic Poisson Disk\" with the parameters below, the other by MeshLab's "
	"\"Simplification: Quadric Edge Collapse Decimation\" with what its dialog proposes. They are "
	"coloured by the quality of their triangles or by the distance from the input. The log has a "
	"table of both. The current layer stays as it is.<br>"
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
