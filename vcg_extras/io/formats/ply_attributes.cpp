// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"
#include "ply_header.h"
#include "ply_source.h"

#include <vcg_extras/io/base/exit_code.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace gpr::app {

namespace {

/// The number of a scalar property, or -1.
int findScalar(const PlyElement& e, const char* name)
{
	const int i = e.find(name);
	return i >= 0 && !e.properties[std::size_t(i)].isList ? i : -1;
}

/// The columns by which an element's records are marked as selected.
class SelectionColumns {
public:
	explicit SelectionColumns(const PlyElement& e) :
			flags_(findScalar(e, "flags")), selected_(findScalar(e, "selected"))
	{
	}

	bool exist() const { return flags_ >= 0 || selected_ >= 0; }
	bool isSelected(const PlyRecord& record) const
	{
		if (selected_ >= 0 && record.scalars[std::size_t(selected_)] != 0) return true;
		if (flags_ < 0) return false;
		const double flags = record.scalars[std::size_t(flags_)];
		return std::abs(flags) < 4294967296.0 && (std::int64_t(flags) & selectedPlyFlag) != 0;
	}

private:
	int flags_, selected_;
};

void checkPresent(const PlyHeader& header, const WantedAttributes& wanted)
{
	const auto areMarked = [&](const char* name) {
		return std::any_of(
			header.elements.begin(), header.elements.end(),
			[&](const PlyElement& e) { return e.name == name && SelectionColumns(e).exist(); });
	};
	if (wanted.selection && !areMarked("vertex") && !areMarked("face"))
		failInput("its vertices and faces have neither the property 'selected' nor 'flags'");
	if (wanted.faceSelection && !areMarked("face"))
		failInput("its faces have neither the property 'selected' nor 'flags'");
}

/// The carried properties of an element, and their columns.
class CarriedColumns {
public:
	CarriedColumns(const PlyElement& e, bool carried)
	{
		for (std::size_t i = 0; carried && i < e.properties.size(); ++i) {
			const PlyProperty& p     = e.properties[i];
			const bool         isOwn = e.name == "vertex" ? isOneOf(p.name, {"x", "y", "z"})
														  : isOneOf(p.name, {"texnumber"});
			if (p.isList || isOwn || isOneOf(p.name, {"flags", "selected"})) continue;
			property_.push_back(i);
			columns.push_back({p.name, p.type, {}, {}});
		}
	}

	std::vector<ValueColumn> columns;

	bool any() const { return !columns.empty(); }
	void take(const PlyRecord& record)
	{
		for (std::size_t c = 0; c < columns.size(); ++c)
			columns[c].values.push_back(record.scalars[property_[c]]);
	}

private:
	std::vector<std::size_t> property_;
};

/// The properties of faces with texture coordinates of their corners.
struct TextureProperties {
	explicit TextureProperties(const PlyElement& e) : image(findScalar(e, "texnumber"))
	{
		const int i = e.find("texcoord");
		if (i >= 0 && e.properties[std::size_t(i)].isList) coordinates = i;
	}
	int coordinates = -1, image;
};

template <class Source>
void readVertices(const PlyElement& e, const WantedAttributes& wanted, Source& source,
				  InputMesh& mesh)
{
	const SelectionColumns selection(e);
	CarriedColumns         carried(e, wanted.carried);
	PlyRecord              record;
	bool                   anySelected = false;
	for (std::uint64_t v = 0; v < e.count; ++v) {
		readRecord(e, {}, source, record);
		const bool isSelected = selection.isSelected(record);
		if (wanted.ofSelectedVertices() && isSelected) mesh.selected[v] = 1;
		anySelected = anySelected || isSelected;
		carried.take(record);
	}
	if (wanted.carried && anySelected && !wanted.ofSelectedVertices())
		mesh.attributes.lost.push_back("the selection of vertices");
	mesh.attributes.ofVertices = std::move(carried.columns);
}

/// The data of the file about its faces, face after face, until polygons are cut.
class FaceReading {
public:
	FaceReading(const PlyElement& e, const WantedAttributes& wanted) :
			wanted_(wanted), selection_(e), texture_(e), carried_(e, wanted.carried)
	{
		kept_.corners = findIndexList(e);
		if (wanted.carried) kept_.texture = texture_.coordinates;
	}

	template <class Source>
	void read(const PlyElement& e, Source& source, InputMesh& mesh)
	{
		const bool cornersToo  = wanted_.selection && !mesh.view().anySelected();
		bool       anySelected = false;
		PlyRecord  record;
		for (std::uint64_t f = 0; f < e.count; ++f) {
			readRecord(e, kept_, source, record);
			order_.add(record.corners.data(), record.corners.size());
			carried_.take(record);
			if (kept_.texture >= 0) takeTexture(record);
			const bool isSelected = selection_.isSelected(record);
			if (wanted_.faceSelection) selected_.push_back(isSelected);
			if (cornersToo && isSelected) selectCorners(record, mesh);
			anySelected = anySelected || isSelected;
		}
		if (wanted_.carried && anySelected && !wanted_.faceSelection && !cornersToo)
			mesh.attributes.lost.push_back("the selection of faces");
	}

	void giveTo(InputMesh& mesh)
	{
		order_.finish(mesh.view());
		if (order_.face().size() != mesh.faceNum()) { // triangle strips beside the faces
			if (wanted_.faceSelection)
				failInput("the selection is for faces and for triangle strips");
			mesh.attributes.lost.push_back("attributes of faces beside triangle strips");
			return;
		}
		for (ValueColumn& column : carried_.columns) {
			column.values = perTriangle(column.values, order_);
			mesh.attributes.ofFaces.push_back(std::move(column));
		}
		if (wanted_.faceSelection) {
			for (const double s : perTriangle(selected_, order_))
				mesh.selectedFaces.push_back(s != 0);
		}
		if (kept_.texture < 0) return;
		mesh.attributes.texture.uv   = cornersOfTriangles(uv_, order_);
		const std::vector<double> at = perTriangle(image_, order_);
		if (texture_.image >= 0) mesh.attributes.texture.image.assign(at.begin(), at.end());
	}

private:
	WantedAttributes    wanted_;
	SelectionColumns    selection_;
	TextureProperties   texture_;
	CarriedColumns      carried_;
	KeptLists           kept_;
	TriangleOrder       order_;
	std::vector<float>  uv_; ///< two a corner of the file
	std::vector<double> image_, selected_;

	void takeTexture(const PlyRecord& record)
	{
		std::vector<float> uv = record.texture;
		uv.resize(2 * record.corners.size(), 0.0f);
		uv_.insert(uv_.end(), uv.begin(), uv.end());
		const int i = texture_.image;
		image_.push_back(i >= 0 ? record.scalars[std::size_t(i)] : 0);
	}

	static void selectCorners(const PlyRecord& record, InputMesh& mesh)
	{
		for (const std::int64_t v : record.corners) {
			if (v >= 0 && std::uint64_t(v) < mesh.vertexNum()) mesh.selected[std::size_t(v)] = 1;
		}
	}
};

bool wantsFaces(const PlyElement& e, const WantedAttributes& wanted)
{
	if (wanted.selection || wanted.faceSelection) return true;
	if (wanted.carried && SelectionColumns(e).exist()) return true; // to tell a loss
	return CarriedColumns(e, wanted.carried).any() ||
		   (wanted.carried && TextureProperties(e).coordinates >= 0);
}

bool wantsElement(const PlyElement& e, const WantedAttributes& wanted)
{
	if (e.name == "vertex") {
		const bool selection = wanted.selection || ((wanted.ifSelected || wanted.carried) &&
													SelectionColumns(e).exist());
		return selection || CarriedColumns(e, wanted.carried).any();
	}
	return e.name == "face" && wantsFaces(e, wanted);
}

/// Elements after the last wanted element are not read.
template <class Source>
void readElements(const PlyHeader& header, const WantedAttributes& wanted, Source source,
				  InputMesh& mesh)
{
	std::size_t num = usefulElementNum(header);
	while (num > 0 && !wantsElement(header.elements[num - 1], wanted))
		--num;
	for (std::size_t i = 0; i < num; ++i) {
		const PlyElement& e = header.elements[i];
		if (!wantsElement(e, wanted)) {
			skipElement(e, source);
		}
		else if (e.name == "vertex") {
			readVertices(e, wanted, source, mesh);
		}
		else {
			FaceReading faces(e, wanted);
			faces.read(e, source, mesh);
			faces.giveTo(mesh);
		}
	}
}

/// Notes the lists that are lost.
void noteLostLists(const PlyHeader& header, MeshAttributes& attributes)
{
	for (const PlyElement& e : header.elements) {
		if (e.name != "vertex" && e.name != "face") continue;
		for (const PlyProperty& p : e.properties) {
			const bool isKnown = isOneOf(p.name, {"vertex_indices", "vertex_index", "texcoord"});
			if (p.isList && !(e.name == "face" && isKnown))
				attributes.lost.push_back("the list '" + p.name + "'");
		}
	}
}

/// The text after the keyword in each line of the header with this keyword.
std::vector<std::string> findLines(std::string_view header, std::string_view keyword)
{
	std::vector<std::string> lines;
	for (std::size_t at = header.find(keyword); at != header.npos; at = header.find(keyword, at)) {
		const bool isBegin = at == 0 || header[at - 1] == '\n' || header[at - 1] == '\r';
		at += keyword.size();
		const std::size_t end = std::min(header.find_first_of("\r\n", at), header.size());
		if (isBegin) lines.emplace_back(header.substr(at, end - at));
	}
	return lines;
}

/// The names of the values of faces in comments of this program: in order, "0 inlet", "1 wall".
void findNames(std::string_view header, std::vector<ValueColumn>& columns)
{
	for (ValueColumn& column : columns) {
		for (const std::string& line : findLines(header, nameComment(column.name))) {
			const std::string number = std::to_string(column.names.size()) + " ";
			if (line.compare(0, number.size(), number) != 0) break;
			column.names.push_back(line.substr(number.size()));
		}
	}
}

} // namespace

void readPlyAttributes(std::string_view file, const WantedAttributes& wanted, InputMesh& mesh)
{
	const PlyHeader header = readPlyHeader(file);
	checkPresent(header, wanted);
	if (wanted.ofSelectedVertices()) mesh.selected.assign(mesh.vertexNum(), 0);
	if (wanted.carried) {
		noteLostLists(header, mesh.attributes);
		mesh.attributes.images = findLines(file.substr(0, header.byteNum), "comment TextureFile ");
	}
	withSource(header, file, [&](auto source) { readElements(header, wanted, source, mesh); });
	findNames(file.substr(0, header.byteNum), mesh.attributes.ofFaces);
}

} // namespace gpr::app
