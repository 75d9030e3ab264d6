// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_FACE_REGIONS_H
#define VCG_EXTRAS_IO_MESH_FACE_REGIONS_H

#include "mesh_attributes.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace gpr::app {

/// Regions that nobody wants.
constexpr const char* noRegions = "off";

/// Names that a file gives to its faces, each to those that follow: numbered as they come. Faces
/// before the first one have a name without letters.
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

/// The regions of a mesh: labels of its triangles, as gpr::MeshView has them.
struct FaceRegions {
	std::vector<std::int32_t> label;       ///< one a triangle; empty: there are none
	std::vector<std::string>  names;       ///< by label, or empty
	std::string               prefix = {}; ///< of names that are made of labels

	std::string nameOf(std::int32_t labelOfOne) const;
};

/// Whether all values of a column are whole numbers.
bool areLabels(const ValueColumn& column);
/// The regions that such a column tells. Where it has no names, names are made of its own and the
/// labels: "label_3".
FaceRegions regionsIn(const ValueColumn& column);

/// Whether a column of faces with this name tells regions: label, material, group and their like.
bool tellsRegions(const std::string& columnName);

/// The regions that the values of faces tell. wanted: the name of one of them; empty: all that
/// tellsRegions() and materials, combined; "off": none. Throws AppError (BadInput) where the named
/// one is not there, or holds other than whole numbers; without a name, such a one is none.
FaceRegions regionsOf(const MeshAttributes& attributes, const std::string& wanted = {});

} // namespace gpr::app

#endif
