// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef FILTER_GEODESIC_POISSON_RECIPE_H
#define FILTER_GEODESIC_POISSON_RECIPE_H

#include <vcg_extras/core/parameters.h>

#include <QString>
#include <map>
#include <string>

namespace gpr_filter {

/// Three ways to the same mesh.
struct Recipe {
	QString script;  ///< the whole text of an .mlx file
	QString command; ///< a line for the shell
	QString python;  ///< a line for PyMeshLab

	/// All three, each with a line about its purpose.
	QString text() const;
};

/// The recipe for the remeshing of a mesh of these facts with these values; a missing value means
/// the default. file: of the layer.
Recipe recipeFor(const std::map<std::string, gpr::ParameterValue>& values,
				 const gpr::MeshFacts& facts, const QString& file);

} // namespace gpr_filter

#endif
