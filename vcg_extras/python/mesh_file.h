// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_PYTHON_MESH_FILE_H
#define VCG_EXTRAS_PYTHON_MESH_FILE_H

#include "arrays.h"

#include <vcg_extras/io/mesh/mesh_attributes.h>

#include <map>
#include <nanobind/nanobind.h>
#include <string>

namespace gpr::python {

/// The values of a mesh file beside coordinates and triangles, in the form of the program's readers
/// and writers, with conversion from and to arrays.
struct FileAttributes {
	app::MeshAttributes values;
	/// Names of the values of faces, by the name of the column: see ValueColumn::names.
	std::map<std::string, std::vector<std::string>> names = {};

	/// Whole numbers of up to 32 bits or real numbers, one per vertex or face.
	void addVertexValues(const std::string& name, const nb::ndarray<nb::ro>& array);
	void addFaceValues(const std::string& name, const nb::ndarray<nb::ro>& array);
	void setTexture(const CornerCoords& uv, const std::optional<Indices>& image);
	/// Takes the names of images, materials and values of faces, and the glTF data of a binary glTF
	/// file.
	void takeMaterials(const FileAttributes& other);

	/// The same as lists of bytes, since names in files may be no UTF-8, for pickle.
	nb::list materialState() const;
	void     setMaterialState(const nb::list& state);

	/// Copies: arrays by name; the texture is None if there is no texture.
	nb::dict   vertexValues() const;
	nb::dict   faceValues() const;
	nb::object uv() const;
	nb::object image() const;
};

/// Reads a mesh with all attributes, in the format of the extension: a dictionary of arrays and
/// FileAttributes, or the fault of the file. Throws ValueError for an unknown extension.
nb::dict readMeshFile(const std::string& path);

/// Writes a mesh in the format of the extension. Returns words for values that the format cannot
/// hold. Throws ValueError for an unknown extension, OSError if the file cannot be written.
std::vector<std::string> writeMeshFile(const std::string& path, const Positions& positions,
									   const Triangles&      triangles,
									   const FileAttributes& attributes);

} // namespace gpr::python

#endif
