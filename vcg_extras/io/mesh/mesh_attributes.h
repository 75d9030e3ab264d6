// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_MESH_MESH_ATTRIBUTES_H
#define VCG_EXTRAS_IO_MESH_MESH_ATTRIBUTES_H

#include <vcg_extras/core/texture_transfer.h>
#include <vcg_extras/io/formats/ply_header.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <vector>

namespace gpr::app {

/// The materials of a binary glTF file, to be written unchanged: the parts of the JSON text for the
/// materials, and the bytes of the images in the file.
struct GltfMaterials {
	std::string json; ///< an object: materials, textures, images, samplers, names of extensions
	std::vector<std::string> imageBytes; ///< by the number of the image; empty for another file
};

/// One value for every vertex, or for every face, by its name and type in a PLY file.
struct ValueColumn {
	std::string         name;
	PlyType             type = PlyType::Float32;
	std::vector<double> values;
	/// Names of the values 0, 1, ... if the values are numbers of names; else empty.
	std::vector<std::string> names = {};
};

/// The column with this name, or null.
template <class Columns>
auto* columnNamed(Columns& columns, const std::string& name)
{
	const auto found = std::find_if(columns.begin(), columns.end(),
									[&](const ValueColumn& column) { return column.name == name; });
	return found != columns.end() ? &*found : nullptr;
}

/// Whether a name of a column is one of these names.
bool isOneOf(const std::string& name, std::initializer_list<const char*> names);

/// All data of a mesh file beside positions and triangles.
struct MeshAttributes {
	std::vector<ValueColumn> ofVertices;
	std::vector<ValueColumn> ofFaces; ///< one value a triangle
	CornerTexture            texture; ///< of the triangles; uv is empty without texture coordinates
	std::vector<std::string> images;  ///< files of the texture's images, by their number
	std::vector<std::string> materials;        ///< OBJ: names; the texture's images are materials
	std::string              materialLibrary;  ///< OBJ: the file of the materials
	std::shared_ptr<const GltfMaterials> gltf; ///< binary glTF: the materials, or null
	std::string folder; ///< of the file, for relative names of images and materials; empty: unknown
	std::string unit;   ///< 3MF: of the coordinates, as the file names it; empty: not told
	std::vector<std::string> lost; ///< words for data of the file that this struct has not

	bool hasTexture() const { return !texture.uv.empty(); }
	bool any() const { return !ofVertices.empty() || !ofFaces.empty() || hasTexture(); }
	/// Whether the faces of a result need their places on the input.
	bool ofFacesToo() const { return !ofFaces.empty() || hasTexture(); }
	/// The column of the vertices with this name, or null.
	const ValueColumn* ofVertex(const std::string& name) const
	{
		return columnNamed(ofVertices, name);
	}
};

/// The words of a list, with commas between.
std::string withCommas(const std::vector<std::string>& words);

/// The sentence of a run about lost data; empty if nothing is lost.
std::string noteOfLost(const std::vector<std::string>& lost);

/// The texture coordinates of vertices, as coordinates of the corners of the triangles; empty
/// without texture coordinates.
CornerTexture textureOfVertices(const MeshAttributes& attributes, const MeshView& mesh);
/// Drops the columns of these coordinates.
void dropTextureOfVertices(MeshAttributes& attributes);

/// The triangles that FaceList makes of a file's faces: first the triangles of the file, in their
/// order, then the cut polygons.
class TriangleOrder {
public:
	/// The corners of each face, face after face.
	void add(const std::int64_t* corners, std::size_t cornerNum);
	/// Cuts the polygons; every index must be in range.
	void finish(const MeshView& positions);

	/// Per triangle: the number of the file's face.
	const std::vector<std::int64_t>& face() const { return face_; }
	/// Three a triangle: the corner's number, counted through all faces of the file.
	const std::vector<std::int64_t>& corner() const { return corner_; }

private:
	struct Polygon {
		std::int64_t              face, firstCorner;
		std::vector<std::int64_t> vertices;
	};
	std::int64_t              faceNum_ = 0, cornerNum_ = 0;
	std::vector<std::int64_t> face_, corner_;
	std::vector<Polygon>      polygons_;
};

/// Reads the attributes of faces, with values per face of the file or per corner.
std::vector<double> perTriangle(const std::vector<double>& perFace, const TriangleOrder& order);
std::vector<float>  cornersOfTriangles(const std::vector<float>& uvPerCorner,
									   const TriangleOrder&      order);

} // namespace gpr::app

#endif
