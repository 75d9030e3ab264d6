// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "byte_order.h"
#include "glb_container.h"
#include "mesh_formats.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh/face_regions.h>
#include <vcg_extras/io/mesh/mesh_attributes.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

namespace gpr::app {

namespace {

using Columns = std::vector<const ValueColumn*>;

/// The columns with these names; none if a column is missing.
Columns columnsOf(const MeshAttributes& a, const std::vector<const char*>& names)
{
	Columns columns;
	for (const char* name : names) {
		columns.push_back(a.ofVertex(name));
		if (columns.back() == nullptr) return {};
	}
	return columns;
}

/// The vertices of the file: each vertex of the mesh, once for each of its texture coordinates.
struct FileVertices {
	std::vector<std::int32_t>         vertex; ///< of the mesh
	std::vector<std::array<float, 2>> uv;     ///< empty without a texture
	std::vector<std::uint32_t>        corner; ///< of the faces
};

FileVertices verticesWithoutTexture(const TriangleMesh& mesh)
{
	FileVertices out;
	for (std::size_t v = 0; v < mesh.vertexNum(); ++v)
		out.vertex.push_back(std::int32_t(v));
	out.corner.assign(mesh.triangles.begin(), mesh.triangles.end());
	return out;
}

FileVertices verticesWithTexture(const TriangleMesh& mesh, const std::vector<float>& uv)
{
	using Key = std::tuple<std::int32_t, float, float>;
	std::map<Key, std::uint32_t> known;
	FileVertices                 out;
	for (std::size_t c = 0; c < mesh.triangles.size(); ++c) {
		const Key  key(mesh.triangles[c], uv[2 * c], uv[2 * c + 1]);
		const auto at = known.emplace(key, std::uint32_t(out.vertex.size()));
		out.corner.push_back(at.first->second);
		if (!at.second) continue;
		out.vertex.push_back(mesh.triangles[c]);
		out.uv.push_back({uv[2 * c], 1 - uv[2 * c + 1]}); // from the upper left corner
	}
	return out;
}

/// The JSON part and the binary part, while they grow.
class GlbParts {
public:
	GltfJson    json;
	std::string binary;

	template <class T>
	void put(T value)
	{
		appendLittleEndian(value, binary);
	}

	/// Makes the bytes since `begin` a buffer view; returns the number of the view.
	std::size_t endView(std::size_t begin)
	{
		json["bufferViews"].push_back(
			{{"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary.size() - begin}});
		binary.append((4 - binary.size() % 4) % 4, '\0');
		return json["bufferViews"].size() - 1;
	}

	/// The same as an accessor.
	std::size_t endAccessor(std::size_t begin, const char* type, PlyType component,
							std::size_t count)
	{
		const std::size_t view = endView(begin);
		json["accessors"].push_back({{"bufferView", view},
									 {"componentType", gltf::firstComponentType + int(component)},
									 {"count", count},
									 {"type", type}});
		return json["accessors"].size() - 1;
	}
};

/// Whether neither materials nor files of images tell the materials, so that labels of faces do.
bool materialsAreRegions(const MeshAttributes& a)
{
	return a.gltf == nullptr && a.materials.empty() && a.images.empty();
}

/// A column of materials goes before numbers of images, and these before other regions.
FaceRegions regionsForMaterials(const MeshAttributes& a)
{
	const ValueColumn* const column = columnNamed(a.ofFaces, "material");
	if (column != nullptr && areLabels(*column)) return regionsIn(*column);
	return a.texture.image.empty() ? regionsOf(a) : FaceRegions{a.texture.image, {}, "image_"};
}

class GlbWriting {
public:
	/// All levels share the parts, and the materials of the first.
	GlbWriting(const TriangleMesh& mesh, const MeshAttributes& a, GlbParts& parts) :
			mesh_(mesh), a_(a), parts_(parts)
	{
	}

	void put()
	{
		const FileVertices vertices = a_.hasTexture() ? verticesWithTexture(mesh_, a_.texture.uv)
													  : verticesWithoutTexture(mesh_);
		putVertices(vertices);
		if (materialsAreRegions(a_))
			putRegions();
		else if (!parts_.json.contains("materials"))
			putMaterials();
		if (parts_.json.contains("materials")) materialNum_ = parts_.json["materials"].size();
		putFaces(vertices);
	}

private:
	const TriangleMesh&       mesh_;
	const MeshAttributes&     a_;
	GlbParts&                 parts_;
	GltfJson                  attributes_  = GltfJson::object();
	std::size_t               materialNum_ = 0;
	std::vector<std::int64_t> region_; ///< per face: the material of its region; empty without

	void putVertices(const FileVertices& vertices)
	{
		putPositions(vertices);
		const Columns normal = columnsOf(a_, {"nx", "ny", "nz"});
		if (!normal.empty()) putNormals(vertices, normal);
		Columns colour = columnsOf(a_, {"red", "green", "blue", "alpha"});
		if (colour.empty()) colour = columnsOf(a_, {"red", "green", "blue"});
		if (!colour.empty()) putColours(vertices, colour);
		if (!vertices.uv.empty()) putTexture(vertices);
	}

	void putPositions(const FileVertices& vertices)
	{
		const std::size_t    begin = parts_.binary.size();
		std::array<float, 3> least{INFINITY, INFINITY, INFINITY},
			most{-INFINITY, -INFINITY, -INFINITY};
		for (const std::int32_t v : vertices.vertex) {
			const Vec3d&               p     = mesh_.positions[std::size_t(v)];
			const std::array<float, 3> place = {float(p.x), float(p.y), float(p.z)};
			for (std::size_t k = 0; k < 3; ++k) {
				least[k] = std::min(least[k], place[k]);
				most[k]  = std::max(most[k], place[k]);
				parts_.put(place[k]);
			}
		}
		const std::size_t accessor =
			parts_.endAccessor(begin, "VEC3", PlyType::Float32, vertices.vertex.size());
		parts_.json["accessors"][accessor]["min"] = least;
		parts_.json["accessors"][accessor]["max"] = most;
		attributes_["POSITION"]                   = accessor;
	}

	/// glTF wants unit vectors; a vector without direction points upwards.
	void putNormals(const FileVertices& vertices, const Columns& columns)
	{
		const std::size_t begin = parts_.binary.size();
		for (const std::int32_t v : vertices.vertex) {
			const auto   i = std::size_t(v);
			Vec3d        n(columns[0]->values[i], columns[1]->values[i], columns[2]->values[i]);
			const double len = length(n);
			n                = len > 0 && std::isfinite(len) ? n * (1 / len) : Vec3d(0, 0, 1);
			for (const double value : {n.x, n.y, n.z})
				parts_.put(float(value));
		}
		attributes_["NORMAL"] =
			parts_.endAccessor(begin, "VEC3", PlyType::Float32, vertices.vertex.size());
	}

	/// Four bytes a vertex, since rows must begin at multiples of four.
	void putColours(const FileVertices& vertices, const Columns& columns)
	{
		const std::size_t begin = parts_.binary.size();
		for (const std::int32_t v : vertices.vertex) {
			for (std::size_t k = 0; k < 4; ++k) {
				double value = 255;
				if (k < columns.size()) {
					const bool isByte = columns[k]->type == PlyType::UInt8;
					value             = columns[k]->values[std::size_t(v)] * (isByte ? 1 : 255);
				}
				parts_.put(std::uint8_t(value > 0 ? std::min(value + 0.5, 255.0) : 0));
			}
		}
		const std::size_t accessor =
			parts_.endAccessor(begin, "VEC4", PlyType::UInt8, vertices.vertex.size());
		parts_.json["accessors"][accessor]["normalized"] = true;
		attributes_["COLOR_0"]                           = accessor;
	}

	void putTexture(const FileVertices& vertices)
	{
		const std::size_t begin = parts_.binary.size();
		for (const std::array<float, 2>& uv : vertices.uv) {
			parts_.put(uv[0]);
			parts_.put(uv[1]);
		}
		attributes_["TEXCOORD_0"] =
			parts_.endAccessor(begin, "VEC2", PlyType::Float32, vertices.uv.size());
	}

	// ---- materials

	void putMaterials()
	{
		if (a_.gltf != nullptr)
			putGltfMaterials(*a_.gltf);
		else if (!a_.materials.empty())
			for (const std::string& name : a_.materials)
				putMaterial(name);
		else
			putImages();
	}

	void putGltfMaterials(const GltfMaterials& kept)
	{
		parts_.json.update(GltfJson::parse(kept.json));
		for (std::size_t i = 0; i < kept.imageBytes.size(); ++i) {
			GltfJson& image = parts_.json["images"][i];
			if (!image.contains("bufferView")) continue;
			const std::size_t begin = parts_.binary.size();
			parts_.binary += kept.imageBytes[i];
			image["bufferView"] = parts_.endView(begin);
		}
	}

	void putMaterial(const std::string& name)
	{
		parts_.json["materials"].push_back(
			{{"name", name}, {"pbrMetallicRoughness", {{"metallicFactor", 0}}}});
	}

	/// A material for each region. Levels have the same names, and share the materials.
	void putRegions()
	{
		const FaceRegions                    regions = regionsForMaterials(a_);
		std::map<std::int32_t, std::int64_t> number;
		for (const std::int32_t label : regions.label)
			number.emplace(label, 0);
		for (auto& [label, material] : number) {
			const std::string name = regions.nameOf(label);
			material = materialNamed(name.empty() ? regions.prefix + std::to_string(label) : name);
		}
		for (const std::int32_t label : regions.label)
			region_.push_back(number[label]);
	}

	/// The number of the material with this name, a new one if there is none.
	std::int64_t materialNamed(const std::string& name)
	{
		GltfJson&    materials = parts_.json["materials"];
		std::int64_t number    = 0;
		for (const GltfJson& material : materials) {
			if (material["name"] == name) return number;
			++number;
		}
		putMaterial(name);
		return number;
	}

	/// A material for each file of an image.
	void putImages()
	{
		for (std::size_t i = 0; i < a_.images.size(); ++i) {
			parts_.json["images"].push_back({{"uri", a_.images[i]}});
			parts_.json["textures"].push_back({{"source", i}});
			parts_.json["materials"].push_back(
				{{"pbrMetallicRoughness",
				  {{"baseColorTexture", {{"index", i}}}, {"metallicFactor", 0}}}});
		}
	}

	// ---- faces

	std::int64_t materialOf(std::size_t f) const
	{
		if (!region_.empty()) return region_[f];
		if (!a_.texture.image.empty()) return a_.texture.image[f];
		const ValueColumn* const column = columnNamed(a_.ofFaces, "material");
		return column != nullptr ? std::int64_t(column->values[f]) : 0;
	}

	/// A primitive for each material.
	void putFaces(const FileVertices& vertices)
	{
		std::map<std::int64_t, std::vector<std::size_t>> faces;
		for (std::size_t f = 0; f < mesh_.faceNum(); ++f)
			faces[materialOf(f)].push_back(f);
		GltfJson primitives = GltfJson::array();
		for (const auto& [material, ofMaterial] : faces) {
			const std::size_t begin = parts_.binary.size();
			for (const std::size_t f : ofMaterial) {
				for (std::size_t c = 3 * f; c < 3 * f + 3; ++c)
					parts_.put(vertices.corner[c]);
			}
			GltfJson primitive = {{"attributes", attributes_},
								  {"indices", parts_.endAccessor(begin, "SCALAR", PlyType::UInt32,
																 3 * ofMaterial.size())}};
			if (material >= 0 && std::size_t(material) < materialNum_)
				primitive["material"] = material;
			primitives.push_back(std::move(primitive));
		}
		parts_.json["meshes"].push_back({{"primitives", std::move(primitives)}});
	}
};

// ---- the file

GlbParts partsOfOneMesh()
{
	GlbParts parts;
	parts.json = {{"asset", {{"version", "2.0"}, {"generator", "gpremesh"}}},
				  {"scene", 0},
				  {"scenes", {{{"nodes", {0}}}}},
				  {"nodes", {{{"mesh", 0}}}}};
	return parts;
}

/// All but the binary part, which follows. Completes the JSON.
std::string headOf(GlbParts& parts)
{
	parts.json["buffers"].push_back({{"byteLength", parts.binary.size()}});
	std::string text = parts.json.dump(-1, ' ', false, GltfJson::error_handler_t::replace);
	text.append((4 - text.size() % 4) % 4, ' ');
	const std::size_t length =
		gltf::headerBytes + 2 * gltf::chunkHeaderBytes + text.size() + parts.binary.size();
	if (length > UINT32_MAX)
		throw AppError(ExitCode::Failure, "a binary glTF file holds at most 4 GB.");
	std::string head;
	for (const std::size_t word : {std::size_t(gltf::magic), std::size_t(gltf::version), length,
								   text.size(), std::size_t(gltf::jsonChunk)})
		appendLittleEndian(std::uint32_t(word), head);
	head += text;
	appendLittleEndian(std::uint32_t(parts.binary.size()), head);
	appendLittleEndian(gltf::binaryChunk, head);
	return head;
}

void write(GlbParts& parts, OutputFile& out)
{
	out.text(headOf(parts));
	out.bytes(parts.binary.data(), parts.binary.size());
}

GlbParts partsOf(const TriangleMesh& mesh, const MeshAttributes& attributes)
{
	GlbParts parts = partsOfOneMesh();
	GlbWriting(mesh, attributes, parts).put();
	return parts;
}

} // namespace

void tellLostInGltf(const MeshAttributes& attributes, std::vector<std::string>& lost)
{
	for (const ValueColumn& column : attributes.ofVertices) {
		if (!isOneOf(column.name, {"red", "green", "blue", "alpha", "nx", "ny", "nz"}))
			lost.push_back("'" + column.name + "' of vertices");
	}
	const bool hasMaterial = columnNamed(attributes.ofFaces, "material") != nullptr;
	const bool hasImage    = !attributes.texture.image.empty();
	const bool regionsToo  = materialsAreRegions(attributes) && !hasMaterial && !hasImage;
	if (hasMaterial && hasImage)
		lost.push_back(materialsAreRegions(attributes) ? "numbers of images"
													   : "'material' of faces");
	for (const ValueColumn& column : attributes.ofFaces) {
		const bool isRegion = regionsToo && tellsRegions(column.name) && areLabels(column);
		if (column.name != "material" && !isRegion)
			lost.push_back("'" + column.name + "' of faces");
	}
}

void writeGlb(const TriangleMesh& mesh, const MeshAttributes& attributes, OutputFile& out)
{
	GlbParts parts = partsOf(mesh, attributes);
	write(parts, out);
}

void writeGltf(const TriangleMesh& mesh, const MeshAttributes& attributes, OutputFile& out)
{
	GlbParts          parts = partsOf(mesh, attributes);
	const std::string head  = headOf(parts);
	out.text(gltfOfGlb(head + parts.binary));
}

void writeGlbLevels(const std::vector<GlbLevel>& levels, OutputFile& out)
{
	GlbParts parts      = partsOfOneMesh();
	GltfJson coarser    = GltfJson::array();
	parts.json["nodes"] = GltfJson::array();
	for (std::size_t i = 0; i < levels.size(); ++i) {
		const GlbLevel& level = levels[i];
		GlbWriting(level.mesh, level.attributes, parts).put();
		parts.json["nodes"].push_back(
			{{"mesh", i}, {"extras", {{"largestError", level.largestError}}}});
		if (i > 0) coarser.push_back(i);
	}
	if (!coarser.empty()) {
		parts.json["extensionsUsed"].push_back("MSFT_lod");
		parts.json["nodes"][0]["extensions"]["MSFT_lod"]["ids"] = std::move(coarser);
	}
	write(parts, out);
}

} // namespace gpr::app
