// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_text.h"

namespace gpr_filter {

QString remeshName()
{
	return QStringLiteral("Remeshing: Geodesic Poisson Disk");
}

QString remeshPythonName()
{
	return QStringLiteral("meshing_geodesic_poisson_disk_remeshing");
}

QString remeshInfo()
{
	return QStringLiteral(
		"Remeshes the surface with about-equilateral triangles of equal size and exactly as many "
		"vertices as asked for. Samples are placed one by one at the border of the geodesic disks "
		"of "
		"those before them, so that no two are nearer than the disk radius and no gap stays; the "
		"original vertices are removed, and the new ones relaxed on the surface. Components, holes "
		"and handles are kept.<br>"
		"What is not a 2-manifold is repaired or cut first, and the log tells what. Vertex colour "
		"and vertex quality are carried over; texture coordinates and face attributes are not. "
		"MeshLab has no undo: put the result into a new layer to keep the original.<br>"
		"<br>See:<br>"
		"<b>\"Fast Edge-based geodesic Poisson Disk Remeshing\"</b><br>"
		"and<br>"
		"<i>Yan Fu, Bingfeng Zhou</i>,<br>"
		"<b>\"Direct sampling on surfaces for high quality remeshing\"</b><br>"
		"ACM Symposium on Solid and Physical Modeling, 2008");
}

} // namespace gpr_filter
