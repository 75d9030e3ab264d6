// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"
#include "obj_lines.h"

#include <vcg_extras/io/text/number_text.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <string>
#include <tuple>

namespace gpr::app {

namespace {

/// Collects the attributes of the lines; the mesh itself has been read and checked before.
class ObjReading {
public:
	void readLine(std::string_view line)
	{
		Words                  words(withoutComment(line));
		const std::string_view keyword = words.next();
		if (keyword == "v") {
			addVertex(words);
		}
		else if (keyword == "vt") {
			addTexturePoint(words);
		}
		else if (keyword == "f") {
			addFace(words);
		}
		else if (keyword == "usemtl") {
			materials_.begin(std::string(words.rest()));
		}
		else if (keyword == "g") {
			groups_.begin(std::string(words.rest()));
		}
		else if (keyword == "o") {
			objects_.begin(std::string(words.rest()));
		}
		else if (keyword == "mtllib" && library_.empty()) {
			library_ = words.rest();
		}
		else if (keyword == "vn") {
			hasNormals_ = true;
		}
	}

	void giveTo(InputMesh& mesh)
	{
		order_.finish(mesh.view());
		MeshAttributes& a = mesh.attributes;
		if (hasNormals_) a.lost.push_back("normals");
		if (order_.face().size() != mesh.faceNum() || vertexNum_ != mesh.vertexNum()) {
			a.lost.push_back("the attributes of this OBJ file, which is read in another way");
			return;
		}
		giveColours(a);
		const bool isTextured = texturedCorners_ > 0 && malformed_ == 0;
		if (isTextured) a.texture.uv = cornersOfTriangles(uv_, order_);
		if (malformed_ > 0) a.lost.push_back("malformed texture coordinates");
		giveNames("object", objects_, a);
		giveNames("group", groups_, a);
		if (!materials_.any()) return;
		a.materials       = materials_.names();
		a.materialLibrary = library_;
		if (!isTextured) return giveNames("material", materials_, a);
		const std::vector<double> number = perTriangle(materials_.numbers(), order_);
		a.texture.image.assign(number.begin(), number.end());
	}

private:
	std::size_t                              vertexNum_ = 0;
	std::vector<std::array<std::uint8_t, 3>> colour_; ///< as many as vertices, or useless
	std::vector<std::array<float, 2>>        texturePoint_;
	TriangleOrder                            order_;
	std::vector<float>                       uv_; ///< two a corner of the file
	NamesOfFaces                             materials_, groups_, objects_;
	std::string                              library_;
	std::int64_t                             texturedCorners_ = 0, malformed_ = 0;
	bool                                     hasNormals_ = false;
	std::vector<std::int64_t>                corners_;

	void giveNames(const char* column, const NamesOfFaces& named, MeshAttributes& a) const
	{
		if (!named.any()) return;
		a.ofFaces.push_back(
			{column, PlyType::Int32, perTriangle(named.numbers(), order_), named.names()});
	}

	void addVertex(Words& words)
	{
		++vertexNum_;
		for (int k = 0; k < 3; ++k)
			words.next();
		std::array<std::uint8_t, 3> colour{};
		if (readObjColour(words, colour)) colour_.push_back(colour);
	}

	void addTexturePoint(Words& words)
	{
		double     u = 0, v = 0;
		const bool good = parseNumber(words.next(), u);
		parseNumber(words.next(), v);
		if (!good) ++malformed_;
		texturePoint_.push_back({float(u), float(v)});
	}

	/// An index of the file, from the begin or from the end, as an index from 0; -1 for a malformed
	/// index.
	static std::int64_t resolved(std::string_view word, std::size_t num)
	{
		std::int64_t index = 0;
		if (!parseInteger(word, index) || index == 0) return -1;
		index = index > 0 ? index - 1 : index + std::int64_t(num);
		return index >= 0 && index < std::int64_t(num) ? index : -1;
	}

	void addFace(Words& words)
	{
		corners_.clear();
		for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
			const std::size_t slash = std::min(word.find('/'), word.size());
			corners_.push_back(resolved(word.substr(0, slash), vertexNum_));
			std::string_view rest = word.substr(std::min(slash + 1, word.size()));
			rest                  = rest.substr(0, std::min(rest.find('/'), rest.size()));
			const std::int64_t t  = rest.empty() ? -1 : resolved(rest, texturePoint_.size());
			if (!rest.empty() && t < 0) ++malformed_;
			texturedCorners_ += t >= 0;
			for (std::size_t i = 0; i < 2; ++i)
				uv_.push_back(t >= 0 ? texturePoint_[std::size_t(t)][i] : 0);
		}
		order_.add(corners_.data(), corners_.size());
		for (NamesOfFaces* named : {&materials_, &groups_, &objects_})
			named->addFace();
	}

	void giveColours(MeshAttributes& a) const
	{
		if (colour_.empty() || colour_.size() != vertexNum_) return;
		const char* names[] = {"red", "green", "blue"};
		for (std::size_t k = 0; k < 3; ++k) {
			ValueColumn column{names[k], PlyType::UInt8, {}, {}};
			for (const auto& c : colour_)
				column.values.push_back(c[k]);
			a.ofVertices.push_back(std::move(column));
		}
	}
};

} // namespace

void readObjAttributes(std::string_view file, InputMesh& mesh)
{
	ObjReading reading;
	while (!file.empty())
		reading.readLine(takeLine(file));
	reading.giveTo(mesh);
}

// ---- writing

namespace {

/// With which keywords columns of faces are written.
constexpr std::pair<const char*, const char*> objNames[] = {
	{"object", "o"}, {"solid", "o"},         {"group", "g"},         {"region", "g"},
	{"label", "g"},  {"CellEntityIds", "g"}, {"material", "usemtl"}, {"material_index", "usemtl"}};

bool isWritten(const ValueColumn& column)
{
	return areLabels(column) &&
		   std::any_of(std::begin(objNames), std::end(objNames),
					   [&](const auto& name) { return column.name == name.first; });
}

/// Whether numbers of images tell the materials, of which an OBJ file has a single name for a face.
bool imagesAreMaterials(const MeshAttributes& a)
{
	if (a.texture.image.empty()) return false;
	return !a.materials.empty() || columnNamed(a.ofFaces, "material") == nullptr;
}

class ObjWriting {
public:
	ObjWriting(const TriangleMesh& mesh, const MeshAttributes& a, OutputFile& out) :
			mesh_(mesh), a_(a),
			out_(out), rgb_{a.ofVertex("red"), a.ofVertex("green"), a.ofVertex("blue")}
	{
	}

	void write(bool doublePrecision)
	{
		if (a_.any()) out_.text("# written by gpremesh\n");
		if (!a_.materialLibrary.empty()) out_.text("mtllib " + a_.materialLibrary + "\n");
		for (std::size_t v = 0; v < mesh_.vertexNum(); ++v) {
			out_.text("v");
			out_.position(mesh_.positions[v], doublePrecision);
			writeColour(v);
			out_.text("\n");
		}
		if (a_.hasTexture()) numberTexturePoints();
		writeFaces();
	}

private:
	const TriangleMesh&       mesh_;
	const MeshAttributes&     a_;
	OutputFile&               out_;
	const ValueColumn*        rgb_[3];
	std::vector<std::int64_t> point_; ///< per corner: its vt, from 1

	void number(double value)
	{
		char       text[40];
		const auto end = toChars(text, text + sizeof text, float(value));
		out_.text(" ");
		out_.text(std::string_view(text, std::size_t(end - text)));
	}

	void writeColour(std::size_t v)
	{
		if (!rgb_[0] || !rgb_[1] || !rgb_[2]) return;
		for (const ValueColumn* c : rgb_)
			number(c->type == PlyType::UInt8 ? c->values[v] / 255 : c->values[v]);
	}

	/// One vt for all corners of a vertex with the same coordinates.
	void numberTexturePoints()
	{
		using Key = std::tuple<std::int32_t, float, float>;
		std::map<Key, std::int64_t> known;
		point_.resize(mesh_.triangles.size());
		for (std::size_t c = 0; c < point_.size(); ++c) {
			const float u = a_.texture.uv[2 * c], v = a_.texture.uv[2 * c + 1];
			const auto  at = known.emplace(Key(mesh_.triangles[c], u, v), known.size() + 1);
			point_[c]      = at.first->second;
			if (!at.second) continue;
			out_.text("vt");
			number(u);
			number(v);
			out_.text("\n");
		}
	}

	/// The names of the faces, of one kind.
	struct Names {
		const char*  keyword;
		FaceRegions  of;
		std::int32_t last = -1; ///< label written last
	};
	std::vector<Names> names_;

	/// By these faces are sorted: by objects, then groups, then materials.
	void collectNames()
	{
		for (const auto& [name, keyword] : objNames) {
			for (const ValueColumn& column : a_.ofFaces) {
				if (column.name == name && areLabels(column))
					names_.push_back({keyword, regionsIn(column)});
			}
		}
		if (imagesAreMaterials(a_))
			names_.push_back({"usemtl", {a_.texture.image, a_.materials, "image_"}});
	}

	void writeNames(std::size_t f)
	{
		for (Names& names : names_) {
			const std::int32_t label = names.of.label[f];
			if (label == names.last) continue;
			const std::string name = names.of.nameOf(label);
			if (!name.empty() || names.last >= 0) out_.text(names.keyword + (" " + name) + "\n");
			names.last = label;
		}
	}

	void writeFaces()
	{
		collectNames();
		for (std::size_t f : facesByName()) {
			writeNames(f);
			out_.text("f");
			for (std::size_t c = 3 * f; c < 3 * f + 3; ++c) {
				out_.text(" ");
				out_.integer(mesh_.triangles[c] + 1);
				if (point_.empty()) continue;
				out_.text("/");
				out_.integer(point_[c]);
			}
			out_.text("\n");
		}
	}

	/// So each name is written once, or once in each object; otherwise in the order of the faces.
	std::vector<std::size_t> facesByName() const
	{
		std::vector<std::size_t> order(mesh_.faceNum());
		std::iota(order.begin(), order.end(), std::size_t(0));
		for (std::size_t i = names_.size(); i-- > 0;) {
			const std::vector<std::int32_t>& label = names_[i].of.label;
			std::stable_sort(order.begin(), order.end(),
							 [&](std::size_t f, std::size_t g) { return label[f] < label[g]; });
		}
		return order;
	}
};

} // namespace

void writeObj(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& attributes,
			  OutputFile& out, std::vector<std::string>& lost)
{
	for (const ValueColumn& column : attributes.ofVertices) {
		if (!isOneOf(column.name, {"red", "green", "blue"}))
			lost.push_back("'" + column.name + "' of vertices");
	}
	for (const ValueColumn& column : attributes.ofFaces) {
		if (!isWritten(column)) lost.push_back("'" + column.name + "' of faces");
	}
	if (!attributes.texture.image.empty() && !imagesAreMaterials(attributes))
		lost.push_back("numbers of images");
	if (!attributes.images.empty()) lost.push_back("names of images");
	ObjWriting(mesh, attributes, out).write(doublePrecision);
}

} // namespace gpr::app
