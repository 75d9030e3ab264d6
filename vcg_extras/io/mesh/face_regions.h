// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_FACE_REGIONS_H
#define VCG_EXTRAS_IO_MESH_FACE_REGIONS_H

#include "mesh_attributes.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gpr::app {

/// The name for unwanted regions.
constexpr const char* noRegions = "off";

/// The names of faces in a file; a name holds for all faces up to the next name. Labels are
/// numbered in the order of appearance. Faces before the first name have an empty name.
class NamesOfFaces {
public:
	void begin(const std::string& name);
	/// The same, but never the name of faces before.
	void beginAnother(const std::string& name);
	void addFace() { of_.push_back(current_); }

	bool                            any() const { return !names_.empty(); }
	const std::vector<std::string>& names() const { return names_; }
	/// Per face of the file: the number of its name.
	const std::vector<double>& numbers() const { return of_; }

private:
	std::vector<std::string>                names_;
	std::map<std::string, int, std::less<>> number_;
	std::vector<double>                     of_;
	double                                  current_ = 0;
};

/// The regions of a mesh: labels of its triangles, as in gpr::MeshView.
struct FaceRegions {
	std::vector<std::int32_t> label;       ///< one a triangle; empty without regions
	std::vector<std::string>  names;       ///< by label, or empty
	std::string               prefix = {}; ///< of names made of labels

	std::string nameOf(std::int32_t labelOfOne) const;
};

/// Whether all values of a column are whole numbers.
bool areLabels(const ValueColumn& column);
/// The regions in such a column. Without names, names are made of the column name and the labels:
/// "label_3".
FaceRegions regionsIn(const ValueColumn& column);

/// Whether a column of faces with this name tells regions: label, material, group and their like.
bool tellsRegions(const std::string& columnName);

/// The regions in the values of faces. wanted: the name of a column; empty: all columns of
/// tellsRegions() and materials, combined; "off": none. Throws AppError (BadInput) if the named
/// column is missing, or holds other than whole numbers; without a name, such a column is ignored.
FaceRegions regionsOf(const MeshAttributes& attributes, const std::string& wanted = {});

} // namespace gpr::app

#endif
