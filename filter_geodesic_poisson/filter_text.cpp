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
		"Gives the surface a new mesh of about-equilateral triangles of equal size, with as many "
		"vertices as asked for. Samples are placed one by one on the surface, each at the border "
		"of "
		"the geodesic disks of those before it, so that no two are nearer than the disk radius and "
		"no gap stays; the original vertices are then removed and the new ones relaxed on the "
		"surface. Number of components, holes and handles stay as they are, and open borders are "
		"kept.<br>"
		"Works on scans of millions of triangles within seconds. What is not a 2-manifold is "
		"repaired or cut first, and the log tells what. Vertex colour and vertex quality are "
		"carried "
		"over; texture coordinates and what belongs to single faces are dropped. MeshLab has no "
		"undo: let the result go into a new layer to keep the original.<br>"
		"<br>See:<br>"
		"<b>\"Fast Edge-based geodesic Poisson Disk Remeshing\"</b><br>"
		"and<br>"
		"<i>Yan Fu, Bingfeng Zhou</i>,<br>"
		"<b>\"Direct sampling on surfaces for high quality remeshing\"</b><br>"
		"ACM Symposium on Solid and Physical Modeling, 2008");
}

} // namespace gpr_filter
