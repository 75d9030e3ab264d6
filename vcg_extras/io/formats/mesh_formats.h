// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_MESH_FORMATS_H
#define VCG_EXTRAS_IO_FORMATS_MESH_FORMATS_H

#include <vcg_extras/io/base/output_file.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <string>
#include <string_view>
#include <vector>

// The readers and writers of all formats.
//
// A reader takes a file in memory. Returned indices are in range, and nothing is lost silently.
// Every reader throws AppError (BadInput) on anything malformed or cut off. A writer of text gives
// coordinates the fewest digits from which each double, or each float, can be read. `lost` receives
// words for data that the format does not hold.

namespace gpr::app {

// ---- PLY

/// Reads ASCII and both binary forms, properties of any type in any order, unused elements,
/// polygons, triangle strips. Triangles of the usual layout are read at the speed of copying.
/// Positions are double if x, y or z is stored as double or as a 32-bit whole number. Sizes are
/// checked against the file's length before memory is taken.
InputMesh readPly(std::string_view file);

/// The same, but usable positions and triangles stay in place in the file, as in most scans:
/// InputMesh::inFile. The bytes of the file must then outlive the mesh.
InputMesh lookAtPly(std::string_view file);

/// Reads the wanted attributes of a PLY file into the mesh of readPly. Names are MeshLab's: the
/// vertices' property "quality"; a bit for the selection in "flags" of vertices and faces. A
/// property "selected" other than 0 selects, too. If vertices are wanted and no vertex is selected,
/// the corners of selected faces are selected. All other scalar properties are carried, and the
/// texture coordinates "texcoord" and "texnumber" of faces; other lists, and a selection that is
/// not wanted, are named in `lost`. A second pass over the file, value by value, so that reading
/// stays fast for files without attributes. Throws AppError (BadInput) for a missing required
/// attribute, too.
void readPlyAttributes(std::string_view file, const WantedAttributes& wanted, InputMesh& mesh);

/// Writes a binary little endian file with positions as double or float, triangles, and every
/// attribute with its name and type; texture coordinates of corners as in MeshLab, in a list
/// 'texcoord' of each face.
void writePly(const MeshView& mesh, bool doublePrecision, const MeshAttributes& attributes,
			  OutputFile& out);

// ---- OBJ

/// Reads positions and faces, in pieces by all threads; all else is passed over. Indices count from
/// the begin or from the end. holdsMore: whether there are colours, texture, normals, materials or
/// groups, see readObjAttributes.
InputMesh readObj(std::string_view file, bool& holdsMore);
InputMesh readObj(std::string_view file);

/// Reads all data of an OBJ file beside the mesh of readObj: texture coordinates, materials,
/// groups, objects, and colours after the coordinates of vertices. Normals are passed over and
/// named in `lost`. A second pass over the file. Malformed texture coordinates count as missing.
void readObjAttributes(std::string_view file, InputMesh& mesh);

/// Writes texture coordinates, materials, groups, objects and colours, if any. Labels without names
/// become groups such as label_3. Corners of a vertex with the same coordinates share a vt.
void writeObj(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& attributes,
			  OutputFile& out, std::vector<std::string>& lost);

// ---- OFF

/// Reads ASCII, one vertex and one face a line, in pieces by all threads; text after the
/// coordinates and the corners on a line is passed over.
InputMesh readOff(std::string_view file);

/// Writes positions and triangles.
void writeOff(const TriangleMesh& mesh, bool doublePrecision, OutputFile& out);

// ---- STL

/// Reads ASCII or, by all threads, binary, for any first word; corners at exactly the same position
/// become one vertex, in the order of their first use. ASCII: keywords in any case, names of any
/// words, several solids, which are regions of faces; a note tells of a solid without end.
/// Attribute bytes of a binary file are named in `lost`.
InputMesh readStl(std::string_view file);

/// Writes binary, which holds floats only; ASCII with a solid for each of several regions.
void writeStl(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& attributes,
			  OutputFile& out, std::vector<std::string>& lost);

// ---- glTF

/// Reads the triangles of a binary file's scene as one mesh, each at the place of its node; with
/// attributes if wanted: the first texture coordinates, the first colours, normals, and materials.
/// Coordinates are floats, or doubles if a node has moved the mesh so far that floats would not
/// resolve the mesh. Texture coordinates count from the lower left corner, as in the other formats.
/// Points and lines are left out, with a note. Refuses compression, morph targets, sparse data and
/// data in other files.
InputMesh readGlb(std::string_view file, bool wantsAttributes = true);

/// Writes a binary file of one mesh, with texture coordinates, colours and normals of the vertices,
/// and materials, if any. glTF has one texture coordinate for each vertex, so vertices along seams
/// are written more than once. Materials of a glTF input are written unchanged, with their images;
/// images and materials of other files by their names. The format holds floats only. Throws
/// AppError (Failure) for more than 4 GB.
void writeGlb(const TriangleMesh& mesh, const MeshAttributes& attributes, OutputFile& out);

/// The same as text, with the buffer inside. Needs hasGltfText().
void writeGltf(const TriangleMesh& mesh, const MeshAttributes& attributes, OutputFile& out);

/// Adds words for the values that glTF does not hold.
void tellLostInGltf(const MeshAttributes& attributes, std::vector<std::string>& lost);

/// One level of detail.
struct GlbLevel {
	TriangleMesh   mesh;
	MeshAttributes attributes;
	double         largestError = 0; ///< proven, mesh units
};

/// Writes a binary file whose node has several levels by the extension MSFT_lod, the finest first.
/// Each node tells its largest error in its extras. All levels have the materials of the first
/// level. Throws as writeGlb.
void writeGlbLevels(const std::vector<GlbLevel>& levels, OutputFile& out);

/// Whether this build has TinyGLTF, the library for glTF as text (.gltf). What a mesh is in glTF is
/// told by the readers and writers of binary files.
bool hasGltfText();

/// The binary file with the content of a text file. folder: of the text file, for its buffers in
/// other files.
std::string glbOfGltf(std::string_view file, const std::string& folder);

/// The text file with the content of a binary file, its buffer and its images inside. Throws
/// AppError (Failure).
std::string gltfOfGlb(const std::string& glb);

// ---- 3MF, a format of printers

/// Whether this build has lib3mf, the library for the format.
bool hasThreeMf();

/// Reads the triangles of all objects that the file builds as one mesh, each object at its place.
/// Coordinates are floats, in the unit of the file. Names of objects and materials are named in
/// `lost`.
InputMesh readThreeMf(std::string_view file);

/// Writes a single object with about seven digits; the same mesh gives the same bytes. unit: see
/// MeshAttributes; empty: millimetres. Throws AppError (Failure), also for coordinates of a billion
/// and more, and for coordinates below a millionth only.
void writeThreeMf(const TriangleMesh& mesh, const std::string& unit, OutputFile& out);

} // namespace gpr::app

#endif
