// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_io.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/base/platform.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh/precision.h>
#include <vcg_extras/io/text/text_lines.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>

namespace gpr::app {

namespace {

struct FormatRow {
	const char* extension;
	const char* floatName; ///< of a format that holds floats only; empty: any other format
	const char* library;
	bool (*isThere)(); ///< the library, in this build
};

bool always()
{
	return true;
}

/// By MeshFormat.
constexpr FormatRow formats[] = {
	{".ply", "", "", always},
	{".obj", "", "", always},
	{".off", "", "", always},
	{".stl", "STL", "", always},
	{".glb", "glTF", "", always},
	{".gltf", "glTF", "TinyGLTF (Debian: libtinygltf-dev)", hasGltfText},
	{".3mf", "3MF", "lib3mf (Debian: lib3mf-dev)", hasThreeMf}};
static_assert(std::size(formats) == std::size_t(MeshFormat::ThreeMf) + 1);

/// The row of a path's extension, or the end.
const FormatRow* rowOf(const std::string& path)
{
	const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
	return std::find_if(std::begin(formats), std::end(formats),
						[&](const FormatRow& row) { return row.extension == extension; });
}

std::string folderOf(const std::string& path)
{
	return std::filesystem::absolute(path).parent_path().string();
}

InputMesh readFormat(MeshFormat format, std::string_view content, const std::string& path,
					 const WantedAttributes& wanted, bool& holdsMore)
{
	switch (format) {
	case MeshFormat::Ply:
		return wanted.mayStayInFile ? lookAtPly(content) : readPly(content);
	case MeshFormat::Obj:
		return readObj(content, holdsMore);
	case MeshFormat::Off:
		return readOff(content);
	case MeshFormat::Stl:
		return readStl(content);
	case MeshFormat::Glb:
		return readGlb(content, wanted.carried);
	case MeshFormat::Gltf:
		return readGlb(glbOfGltf(content, folderOf(path)), wanted.carried);
	case MeshFormat::ThreeMf:
		return readThreeMf(content);
	}
	return {};
}

InputMesh readContent(MeshFormat format, const std::string& path, const WantedAttributes& wanted)
{
	const auto content = std::make_shared<const FileContent>(path);
	if (content->view().empty()) failInput("the file is empty");
	bool      holdsMore = false;
	InputMesh mesh      = readFormat(format, content->view(), path, wanted, holdsMore);
	if (format == MeshFormat::Ply) readPlyAttributes(content->view(), wanted, mesh);
	if (format == MeshFormat::Obj && wanted.carried && holdsMore)
		readObjAttributes(content->view(), mesh);
	if (wanted.carried) {
		mesh.regions           = regionsOf(mesh.attributes, wanted.regions);
		mesh.attributes.folder = folderOf(path);
	}
	if (mesh.isInFile()) mesh.file = content;
	return mesh;
}

void checkCarried(MeshFormat format, const std::string& path, const WantedAttributes& wanted)
{
	if (format == MeshFormat::Ply || !wanted.anyRequired()) return;
	failUsage("the selection is read from PLY files only, not from '" + path + "'.");
}

/// Makes named materials of a texture a column of labels with names, as PLY holds names of labels
/// only. Numbers of images stay numbers of images.
void nameMaterials(MeshAttributes& attributes)
{
	std::vector<std::int32_t>& image = attributes.texture.image;
	if (attributes.materials.empty() || image.empty()) return;
	if (columnNamed(attributes.ofFaces, "material") != nullptr) return;
	attributes.ofFaces.push_back(
		{"material", PlyType::Int32, {image.begin(), image.end()}, attributes.materials});
	image.clear();
}

/// Readers take a PLY header of a megabyte at most.
void dropNamesBeyondHeader(MeshAttributes& attributes)
{
	constexpr std::size_t mostBytes = 1 << 19, bytesPerLine = 64;
	std::size_t           bytes = 0;
	for (const ValueColumn& column : attributes.ofFaces) {
		for (const std::string& name : column.names)
			bytes += name.size() + column.name.size() + bytesPerLine;
	}
	if (bytes <= mostBytes) return;
	for (ValueColumn& column : attributes.ofFaces)
		column.names.clear();
	attributes.lost.push_back("the names of regions, which are too many for the header");
}

/// Changes the relative name of a file beside the input to its name seen from another folder. The
/// name stays if no such file is there, with words in `lost`.
void seeFrom(const std::string& folder, std::string& name, MeshAttributes& attributes)
{
	namespace fs = std::filesystem;
	std::error_code error;
	const fs::path  from = attributes.folder, file = from / name;
	if (from.empty() || name.empty() || fs::path(name).is_absolute()) return;
	if (fs::equivalent(from, folder, error)) return;
	if (!fs::exists(file, error))
		attributes.lost.push_back("the place of '" + name + "', which is not beside the input");
	else
		name = fs::proximate(file, folder, error).generic_string();
}

void seeFilesFrom(const std::string& folder, MeshFormat format, MeshAttributes& attributes)
{
	if (format == MeshFormat::Obj) seeFrom(folder, attributes.materialLibrary, attributes);
	if (format != MeshFormat::Ply) return;
	for (std::string& image : attributes.images)
		seeFrom(folder, image, attributes);
}

} // namespace

WantedAttributes neededBy(const RemeshOptions& options)
{
	WantedAttributes wanted;
	wanted.selection     = options.featureRegion == FeatureRegion::Selection;
	wanted.ifSelected    = mayUseSelectedVertices(options);
	wanted.faceSelection = options.selectedOnly;
	return wanted;
}

MeshFormat formatOfPath(const std::string& path)
{
	const FormatRow* const row = rowOf(path);
	if (row == std::end(formats))
		failUsage("'" + path + "' has none of the extensions " + formatNames() + ".");
	if (!row->isThere())
		failUsage("'" + path + "' needs the library " + row->library +
				  ", which this build of gpremesh was made without.");
	return MeshFormat(row - formats);
}

bool isMeshName(const std::string& path)
{
	const FormatRow* const row = rowOf(path);
	return row != std::end(formats) && row->isThere();
}

std::string formatNames()
{
	std::string names = ".ply, .obj, .off, .stl";
	if (hasGltfText()) names += ", .gltf";
	if (hasThreeMf()) names += ", .3mf";
	return names + " or .glb";
}

InputMesh readMesh(const std::string& path, const WantedAttributes& wanted)
{
	const MeshFormat format = formatOfPath(path);
	checkCarried(format, path, wanted);
	InputMesh mesh;
	try {
		mesh = readContent(format, path, wanted);
	}
	catch (const AppError& error) {
		throw AppError(error.code, "cannot read '" + path + "': " + error.what() + ".");
	}
	if (mesh.faceNum() == 0) {
		failInput("'" + path + "' has no faces (" + std::to_string(mesh.vertexNum()) +
				  " vertices).");
	}
	return mesh;
}

void tellLost(MeshFormat format, MeshAttributes& attributes)
{
	const bool isGltf     = format == MeshFormat::Glb || format == MeshFormat::Gltf;
	const bool holdsPlain = format == MeshFormat::Off || format == MeshFormat::ThreeMf;
	if (holdsPlain && attributes.any())
		attributes.lost.push_back("any attribute, which this format does not hold");
	else if (attributes.gltf != nullptr && !isGltf)
		attributes.lost.push_back("images and properties of materials");
	if (isGltf) tellLostInGltf(attributes, attributes.lost);
	if (!attributes.materialLibrary.empty() && format != MeshFormat::Obj && !holdsPlain)
		attributes.lost.push_back("the name of the file of materials");
	if (!attributes.unit.empty() && format != MeshFormat::ThreeMf)
		attributes.lost.push_back("the unit '" + attributes.unit + "'");
}

std::string nameOfFloatFormat(MeshFormat format)
{
	return formats[int(format)].floatName;
}

void requireFaces(const TriangleMesh& mesh, bool doublePrecision, const std::string& path)
{
	const std::string name = nameOfFloatFormat(formatOfPath(path));
	if (!doublePrecision || name.empty()) return;
	const std::size_t num = facesSpoiledByFloat(mesh);
	if (num == 0) return;
	throw AppError(ExitCode::PromiseBroken,
				   name + " holds floats only, which would spoil " + std::to_string(num) + " of " +
					   std::to_string(mesh.faceNum()) + " faces of '" + path +
					   "'; write PLY, OBJ or OFF, which keep the coordinates.");
}

void writeMesh(const TriangleMesh& mesh, bool doublePrecision, MeshAttributes& attributes,
			   OutputFile& out)
{
	requireFaces(mesh, doublePrecision, out.path());
	const MeshFormat format = formatOfPath(out.path());
	doublePrecision         = doublePrecision && nameOfFloatFormat(format).empty();
	tellLost(format, attributes);
	seeFilesFrom(folderOf(out.path()), format, attributes);
	switch (format) {
	case MeshFormat::Ply:
		nameMaterials(attributes);
		dropNamesBeyondHeader(attributes);
		writePly(mesh.view(), doublePrecision, attributes, out);
		break;
	case MeshFormat::Obj:
		writeObj(mesh, doublePrecision, attributes, out, attributes.lost);
		break;
	case MeshFormat::Off:
		writeOff(mesh, doublePrecision, out);
		break;
	case MeshFormat::Stl:
		writeStl(mesh, doublePrecision, attributes, out, attributes.lost);
		break;
	case MeshFormat::Glb:
		writeGlb(mesh, attributes, out);
		break;
	case MeshFormat::Gltf:
		writeGltf(mesh, attributes, out);
		break;
	case MeshFormat::ThreeMf:
		writeThreeMf(mesh, attributes.unit, out);
		break;
	}
	out.finish();
}

void writeMesh(const TriangleMesh& mesh, bool doublePrecision, MeshAttributes& attributes,
			   const std::string& path, const RunLimit& limit)
{
	OutputFile out(path, limit);
	writeMesh(mesh, doublePrecision, attributes, out);
	out.commit();
}

} // namespace gpr::app
