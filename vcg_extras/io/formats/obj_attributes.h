// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_OBJ_ATTRIBUTES_H
#define VCG_EXTRAS_IO_FORMATS_OBJ_ATTRIBUTES_H

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <string_view>

namespace gpr::app {

/// Reads all data of an OBJ file in memory beside the mesh of readObj: texture coordinates,
/// materials, groups, objects, and colours after the coordinates of vertices. Normals are passed
/// over and named in `lost`. A second pass over the file. Malformed texture coordinates count as
/// missing.
void readObjAttributes(std::string_view file, InputMesh& mesh);

/// Writes an OBJ file with texture coordinates, materials, groups, objects and colours, if any;
/// names the lost rest. Labels without names become groups such as label_3. Corners of a vertex
/// with the same coordinates share a vt. Coordinates have the fewest digits from which the same
/// double, or float, can be read.
void writeObj(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& attributes,
			  OutputFile& out, std::vector<std::string>& lost);

} // namespace gpr::app

#endif
