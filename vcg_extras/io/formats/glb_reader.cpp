// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "glb_container.h"
#include "mesh_formats.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh/mesh_attributes.h>
#include <vcg_extras/io/mesh/precision.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace gpr::app {

namespace {

/// An affine map, row by row.
struct Transform {
	std::array<double, 12> m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

	Vec3d point(const Vec3d& p) const
	{
		return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3],
				m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
				m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
	}

	Vec3d row(std::size_t r) const { return {m[4 * r], m[4 * r + 1], m[4 * r + 2]}; }

	double determinant() const { return dot(row(0), cross(row(1), row(2))); }
	bool   isMirror() const { return determinant() < 0; }
	bool   isNone() const { return m == Transform().m; }

	/// The mapped unit normal of a surface.
	Vec3d normal(const Vec3d& n) const
	{
		const double sign = isMirror() ? -1 : 1;
		const Vec3d a = cross(row(1), row(2)), b = cross(row(2), row(0)), c = cross(row(0), row(1));
		const Vec3d turned(sign * dot(a, n), sign * dot(b, n), sign * dot(c, n));
		const double len = length(turned);
		return len > 0 ? turned * (1 / len) : turned;
	}

	/// This transform after the first transform.
	Transform after(const Transform& first) const
	{
		Transform both;
		for (std::size_t r = 0; r < 3; ++r) {
			for (std::size_t c = 0; c < 4; ++c) {
				double& sum = both.m[4 * r + c];
				sum         = c == 3 ? m[4 * r + 3] : 0;
				for (std::size_t k = 0; k < 3; ++k)
					sum += m[4 * r + k] * first.m[4 * k + c];
			}
		}
		return both;
	}
};

/// The numbers of a list of this length; false for a missing list.
template <std::size_t length>
bool readNumbers(const GltfJson& node, const char* name, std::array<double, length>& numbers)
{
	const GltfJson& list = listOf(node, name);
	if (list.empty()) return false;
	if (list.size() != length) failInput(std::string("a node's '") + name + "' has a wrong length");
	for (std::size_t i = 0; i < length; ++i) {
		if (!list[i].is_number()) failInput(std::string("a node's '") + name + "' has no numbers");
		numbers[i] = list[i].get<double>();
	}
	return true;
}

/// From the matrix of a node, which is given column by column.
Transform transformOf(const std::array<double, 16>& columns)
{
	Transform t;
	for (std::size_t r = 0; r < 3; ++r) {
		for (std::size_t c = 0; c < 4; ++c)
			t.m[4 * r + c] = columns[4 * c + r];
	}
	return t;
}

/// From a turn by a unit quaternion, after a scaling, before a translation.
Transform transformOf(const std::array<double, 3>& move, const std::array<double, 4>& turn,
					  const std::array<double, 3>& scale)
{
	const double x = turn[0], y = turn[1], z = turn[2], w = turn[3];
	Transform    t;
	t.m = {(1 - 2 * (y * y + z * z)) * scale[0], 2 * (x * y - z * w) * scale[1],
		   2 * (x * z + y * w) * scale[2],       move[0],
		   2 * (x * y + z * w) * scale[0],       (1 - 2 * (x * x + z * z)) * scale[1],
		   2 * (y * z - x * w) * scale[2],       move[1],
		   2 * (x * z - y * w) * scale[0],       2 * (y * z + x * w) * scale[1],
		   (1 - 2 * (x * x + y * y)) * scale[2], move[2]};
	return t;
}

Transform transformOf(const GltfJson& node)
{
	std::array<double, 16> columns{};
	if (readNumbers(node, "matrix", columns)) return transformOf(columns);
	std::array<double, 3> move{}, scale{1, 1, 1};
	std::array<double, 4> turn{0, 0, 0, 1};
	const bool            isMoved  = readNumbers(node, "translation", move);
	const bool            isTurned = readNumbers(node, "rotation", turn);
	const bool            isScaled = readNumbers(node, "scale", scale);
	return isMoved || isTurned || isScaled ? transformOf(move, turn, scale) : Transform();
}

/// Extensions that may be required: extensions for materials and images, and kinds of numbers that
/// are read.
bool isHarmless(const std::string& extension)
{
	return extension.rfind("KHR_materials_", 0) == 0 || extension.rfind("KHR_texture_", 0) == 0 ||
		   extension.rfind("EXT_texture_", 0) == 0 || extension == "KHR_mesh_quantization";
}

void checkExtensions(const GltfJson& json)
{
	for (const GltfJson& name : listOf(json, "extensionsRequired")) {
		if (!name.is_string() || !isHarmless(name.get<std::string>()))
			failInput("the file needs the extension " +
					  (name.is_string() ? name.get<std::string>() : "") +
					  " of glTF, which is not read");
	}
}

/// Collects the scene's triangles.
class GlbReading {
public:
	GlbReading(const GlbChunks& glb, bool wantsAttributes) :
			glb_(glb), wantsAttributes_(wantsAttributes)
	{
	}

	void readScene()
	{
		checkExtensions(glb_.json);
		const GltfJson& nodes  = listOf(glb_.json, "nodes");
		const GltfJson& scenes = listOf(glb_.json, "scenes");
		isVisited_.assign(nodes.size(), 0);
		if (scenes.empty()) failInput("the file has no scene");
		const GltfJson& scene = entryOf(scenes, countOf(glb_.json, "scene", 0), "scene");
		readNodes(listOf(scene, "nodes"), Transform());
		while (!waiting_.empty()) {
			const Waiting next = waiting_.back();
			waiting_.pop_back();
			readNode(entryOf(nodes, next.node, "node"), next.parent);
		}
	}

	InputMesh takeMesh()
	{
		InputMesh mesh;
		mesh.doublePrecision = true;
		mesh.doubles         = std::move(positions_);
		mesh.triangles       = std::move(triangles_);
		if (isMoved_)
			settlePrecision(mesh);
		else
			roundToFloat(mesh);
		if (otherPrimitiveNum_ > 0)
			mesh.notes.push_back("Points and lines of the file were left out.");
		if (wantsAttributes_) giveAttributes(mesh);
		return mesh;
	}

private:
	/// Attributes of vertices, by their names in the file.
	struct Values {
		std::size_t         numEach;   ///< numbers of a vertex
		double              otherwise; ///< number of vertices without the attribute
		std::vector<double> numbers = {};
		bool                isThere = false, isMissingSomewhere = false;
	};
	struct Waiting {
		std::int64_t node;
		Transform    parent;
	};

	const GlbChunks&        glb_;
	const bool              wantsAttributes_;
	CoordinateArray<double> positions_;
	IndexArray              triangles_;
	Values                  normals_{3, 0}, colours_{4, 1}, uv_{2, 0};
	std::vector<double>     material_; ///< per triangle; as many as materials: none
	std::vector<char>       isVisited_;
	std::vector<Waiting>    waiting_;
	std::int64_t            otherPrimitiveNum_ = 0;
	bool                    isMoved_ = false, hasLost_ = false, lacksMaterial_ = false;
	/// The first vertices of a node's primitives with all data in common.
	std::map<std::string, std::size_t> firstVertex_;

	void readNodes(const GltfJson& children, const Transform& parent)
	{
		for (std::size_t i = children.size(); i-- > 0;) {
			if (!children[i].is_number_unsigned()) failInput("a node is named by no number");
			waiting_.push_back({children[i].get<std::int64_t>(), parent});
		}
	}

	void readNode(const GltfJson& node, const Transform& parent)
	{
		const auto number = std::size_t(&node - &listOf(glb_.json, "nodes")[0]);
		if (isVisited_[number]) failInput("a node has two parents");
		isVisited_[number]        = 1;
		const Transform transform = parent.after(transformOf(node));
		readNodes(listOf(node, "children"), transform);
		if (!node.contains("mesh")) return;
		hasLost_ = hasLost_ || node.contains("skin");
		isMoved_ = isMoved_ || !transform.isNone();
		firstVertex_.clear();
		const GltfJson& mesh =
			entryOf(listOf(glb_.json, "meshes"), countOf(node, "mesh", 0), "mesh");
		for (const GltfJson& primitive : listOf(mesh, "primitives"))
			readPrimitive(primitive, transform);
	}

	void readPrimitive(const GltfJson& primitive, const Transform& transform)
	{
		if (!primitive.is_object()) failInput("a primitive is malformed");
		if (!listOf(primitive, "targets").empty())
			failInput("the file has morph targets, which are not read");
		const std::int64_t mode = countOf(primitive, "mode", gltf::Triangles);
		if (mode != gltf::Triangles && mode != gltf::TriangleStrip && mode != gltf::TriangleFan) {
			++otherPrimitiveNum_;
			return;
		}
		const auto attributes = primitive.find("attributes");
		if (attributes == primitive.end() || !attributes->is_object())
			failInput("a primitive has no attributes");
		const auto     known = firstVertex_.emplace(attributes->dump(), positions_.size() / 3);
		const GltfRows places(glb_, countOf(*attributes, "POSITION", -1), 3);
		if (known.second) addVertices(*attributes, places, transform);
		addFaces(primitive, mode, known.first->second, places.rowNum(), transform.isMirror());
		addMaterial(primitive);
	}

	void addVertices(const GltfJson& attributes, const GltfRows& places, const Transform& transform)
	{
		if (positions_.size() / 3 + places.rowNum() > std::size_t(INT32_MAX))
			failInput("the file has too many vertices");
		for (std::size_t v = 0; v < places.rowNum(); ++v) {
			const Vec3d p =
				transform.point({places.number(v, 0), places.number(v, 1), places.number(v, 2)});
			positions_.insert(positions_.end(), {p.x, p.y, p.z});
		}
		if (!wantsAttributes_) return;
		addNormals(attributes, transform);
		addColours(attributes);
		addTexture(attributes);
		for (const auto& [name, accessor] : attributes.items()) {
			const bool isRead = name == "POSITION" || name == "NORMAL" || name == "COLOR_0" ||
								name == "TEXCOORD_0" || name == "TANGENT";
			hasLost_ = hasLost_ || !isRead;
		}
	}

	std::size_t vertexNum() const { return positions_.size() / 3; }

	/// Adds the numbers that put(rows, v) appends for each row of an attribute; the rows must be as
	/// many as the vertices.
	template <class Put>
	void addValues(const GltfJson& attributes, const char* name, int componentNum, Values& values,
				   const Put& put)
	{
		if (attributes.contains(name)) {
			const GltfRows places(glb_, countOf(attributes, "POSITION", -1), 3);
			const GltfRows rows(glb_, countOf(attributes, name, -1), componentNum);
			if (rows.rowNum() != places.rowNum())
				failInput("a primitive's attributes are not equally many");
			values.isThere = true;
			for (std::size_t v = 0; v < rows.rowNum(); ++v)
				put(rows, v);
		}
		else {
			values.isMissingSomewhere = true;
		}
		values.numbers.resize(values.numEach * vertexNum(), values.otherwise);
	}

	void addNormals(const GltfJson& attributes, const Transform& transform)
	{
		addValues(attributes, "NORMAL", 3, normals_, [&](const GltfRows& rows, std::size_t v) {
			const Vec3d n =
				transform.normal({rows.number(v, 0), rows.number(v, 1), rows.number(v, 2)});
			normals_.numbers.insert(normals_.numbers.end(), {n.x, n.y, n.z});
		});
	}

	void addColours(const GltfJson& attributes)
	{
		addValues(attributes, "COLOR_0", 0, colours_, [&](const GltfRows& rows, std::size_t v) {
			if (rows.componentNum() < 3) failInput("its colours have too few components");
			for (int k = 0; k < 4; ++k)
				colours_.numbers.push_back(k < rows.componentNum() ? rows.number(v, k) : 1);
		});
	}

	void addTexture(const GltfJson& attributes)
	{
		addValues(attributes, "TEXCOORD_0", 2, uv_, [&](const GltfRows& rows, std::size_t v) {
			uv_.numbers.insert(uv_.numbers.end(), {rows.number(v, 0), 1 - rows.number(v, 1)});
		});
	}

	void addFaces(const GltfJson& primitive, std::int64_t mode, std::size_t first,
				  std::size_t placeNum, bool isMirror)
	{
		std::vector<std::int32_t> corners;
		if (primitive.contains("indices")) {
			const GltfRows rows(glb_, countOf(primitive, "indices", -1), 1);
			corners.reserve(rows.rowNum());
			for (std::size_t i = 0; i < rows.rowNum(); ++i) {
				const std::int64_t corner = rows.index(i);
				if (corner >= std::int64_t(placeNum))
					failInput("a face names a vertex that does not exist");
				corners.push_back(std::int32_t(first + std::size_t(corner)));
			}
		}
		else {
			for (std::size_t i = 0; i < placeNum; ++i)
				corners.push_back(std::int32_t(first + i));
		}
		if (mode == gltf::Triangles && corners.size() % 3 != 0)
			failInput("the last triangle of a primitive is cut off");
		const std::size_t step = mode == gltf::Triangles ? 3 : 1;
		for (std::size_t i = 0; i + 2 < corners.size(); i += step)
			addFace(corners, mode, i, isMirror);
	}

	void addFace(const std::vector<std::int32_t>& corners, std::int64_t mode, std::size_t i,
				 bool isMirror)
	{
		std::int32_t a = corners[mode == gltf::TriangleFan ? 0 : i], b = corners[i + 1],
					 c      = corners[i + 2];
		const bool isStrip  = mode == gltf::TriangleStrip;
		const bool isTurned = isMirror != (isStrip && i % 2 == 1);
		if (isStrip && (a == b || b == c || c == a)) return; // the face only steers the strip
		if (isTurned) std::swap(b, c);
		if (triangles_.size() / 3 >= std::size_t(INT32_MAX))
			failInput("the file has too many faces");
		for (const std::int32_t corner : {a, b, c})
			triangles_.push_back(corner);
	}

	void addMaterial(const GltfJson& primitive)
	{
		const GltfJson&    materials = listOf(glb_.json, "materials");
		const std::int64_t number = countOf(primitive, "material", std::int64_t(materials.size()));
		lacksMaterial_            = lacksMaterial_ || !primitive.contains("material");
		if (primitive.contains("material")) entryOf(materials, number, "material");
		material_.resize(triangles_.size() / 3, double(number));
	}

	/// What the scene has and the mesh has not.
	void nameLost(MeshAttributes& a) const
	{
		if (hasLost_) a.lost.push_back("skins and further sets of attributes");
		if (listOf(glb_.json, "meshes").size() > 1) a.lost.push_back("names of nodes and meshes");
		for (const char* name : {"cameras", "animations"}) {
			if (!listOf(glb_.json, name).empty()) a.lost.push_back(name);
		}
		const GltfJson& used = listOf(glb_.json, "extensionsUsed");
		if (std::find(used.begin(), used.end(), "KHR_lights_punctual") != used.end())
			a.lost.push_back("lights");
	}

	void giveAttributes(InputMesh& mesh)
	{
		MeshAttributes& a = mesh.attributes;
		nameLost(a);
		if (normals_.isThere && !normals_.isMissingSomewhere)
			giveColumns(normals_, {"nx", "ny", "nz"}, PlyType::Float32, 1, a);
		if (colours_.isThere)
			giveColumns(colours_, {"red", "green", "blue", "alpha"}, PlyType::UInt8, 255, a);
		if (uv_.isThere) giveTexture(mesh);
		giveMaterials(mesh);
	}

	static void giveColumns(const Values& values, const std::vector<std::string>& names,
							PlyType type, double largest, MeshAttributes& a)
	{
		for (std::size_t k = 0; k < names.size(); ++k) {
			ValueColumn column{names[k], type, {}, {}};
			for (std::size_t i = k; i < values.numbers.size(); i += names.size()) {
				const double value = largest * values.numbers[i];
				column.values.push_back(
					largest == 1 ? value : std::floor(std::clamp(value, 0.0, largest) + 0.5));
			}
			a.ofVertices.push_back(std::move(column));
		}
	}

	void giveTexture(InputMesh& mesh) const
	{
		for (const std::int32_t v : mesh.triangles) {
			mesh.attributes.texture.uv.push_back(float(uv_.numbers[2 * std::size_t(v)]));
			mesh.attributes.texture.uv.push_back(float(uv_.numbers[2 * std::size_t(v) + 1]));
		}
	}

	void giveMaterials(InputMesh& mesh) const
	{
		MeshAttributes& a         = mesh.attributes;
		const GltfJson& materials = listOf(glb_.json, "materials");
		if (materials.empty()) return;
		for (const GltfJson& material : materials) {
			const auto name = material.find("name");
			const bool has  = name != material.end() && name->is_string();
			a.materials.push_back(has ? name->get<std::string>() : "");
		}
		if (lacksMaterial_) a.materials.push_back("");
		if (a.hasTexture())
			a.texture.image.assign(material_.begin(), material_.end());
		else
			a.ofFaces.push_back({"material", PlyType::Int32, material_, a.materials});
		a.gltf = materialsOf();
	}

	std::shared_ptr<const GltfMaterials> materialsOf() const
	{
		auto     kept = std::make_shared<GltfMaterials>();
		GltfJson json;
		for (const char* name : {"materials", "textures", "images", "samplers"}) {
			if (!listOf(glb_.json, name).empty()) json[name] = listOf(glb_.json, name);
		}
		for (const char* name : {"extensionsUsed", "extensionsRequired"}) {
			for (const GltfJson& extension : listOf(glb_.json, name)) {
				if (!extension.is_string()) continue;
				const auto text = extension.get<std::string>();
				if (isHarmless(text) && text != "KHR_mesh_quantization" &&
					text != "KHR_materials_variants")
					json[name].push_back(text);
			}
		}
		for (const GltfJson& image : listOf(glb_.json, "images")) {
			if (!image.is_object()) failInput("an image is malformed");
			const bool isInside = image.contains("bufferView");
			kept->imageBytes.emplace_back(isInside
											  ? bufferViewOf(glb_, countOf(image, "bufferView", -1))
											  : std::string_view());
		}
		kept->json = json.dump();
		return kept;
	}
};

} // namespace

InputMesh readGlb(std::string_view file, bool wantsAttributes)
{
	const GlbChunks glb = glbChunksOf(file);
	GlbReading      reading(glb, wantsAttributes);
	reading.readScene();
	return reading.takeMesh();
}

} // namespace gpr::app
