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

/// What a file holds of a mesh beside coordinates and triangles: as the program's readers give it
/// and its writers take it, with a way from and to arrays.
struct FileAttributes {
	app::MeshAttributes values;
	/// What values of faces are called, by the names of these: see ValueColumn::names.
	std::map<std::string, std::vector<std::string>> names = {};

	/// Whole numbers of up to 32 bits and real numbers, one a vertex or face.
	void addVertexValues(const std::string& name, const nb::ndarray<nb::ro>& array);
	void addFaceValues(const std::string& name, const nb::ndarray<nb::ro>& array);
	void setTexture(const CornerCoords& uv, const std::optional<Indices>& image);
	/// The names of images, materials and values of faces, and what a binary glTF file says of
	/// them.
	void takeMaterials(const FileAttributes& other);

	/// Copies: arrays by their names; the texture is None where there is none.
	nb::dict   vertexValues() const;
	nb::dict   faceValues() const;
	nb::object uv() const;
	nb::object image() const;
};

/// Reads a mesh in the format of its extension, with all attributes: a dictionary of arrays and
/// FileAttributes, or of what is wrong with the file. Throws ValueError for an extension that
/// stands for no format.
nb::dict readMeshFile(const std::string& path);

/// Writes a mesh likewise. Returns words for what the format does not hold. Throws ValueError for
/// an unknown extension, OSError where the file cannot be written.
std::vector<std::string> writeMeshFile(const std::string& path, const Positions& positions,
									   const Triangles&      triangles,
									   const FileAttributes& attributes);

} // namespace gpr::python

#endif
