// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_io.h"

#include "exit_code.h"
#include "glb_reader.h"
#include "glb_writer.h"
#include "obj_attributes.h"
#include "output_file.h"
#include "platform.h"
#include "ply_attribute_writer.h"
#include "ply_attributes.h"
#include "ply_reader.h"
#include "ply_writer.h"
#include "soup_io.h"
#include "soup_writer.h"

#include <filesystem>
#include <memory>

namespace gpr::app {

namespace {

std::string lowerCase(std::string text)
{
	for (char& c : text) {
		if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
	}
	return text;
}

InputMesh readFormat(MeshFormat format, std::string_view content, const WantedAttributes& wanted,
					 bool& holdsMore)
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
		return readGlb(content, wanted);
	}
	return {};
}

InputMesh readContent(MeshFormat format, const std::string& path, const WantedAttributes& wanted)
{
	const auto content = std::make_shared<const FileContent>(path);
	if (content->view().empty()) throw AppError(ExitCode::BadInput, "the file is empty");
	bool      holdsMore = false;
	InputMesh mesh      = readFormat(format, content->view(), wanted, holdsMore);
	if (format == MeshFormat::Ply) readPlyAttributes(content->view(), wanted, mesh);
	if (format == MeshFormat::Obj && wanted.carried && holdsMore)
		readObjAttributes(content->view(), mesh);
	if (mesh.isInFile()) mesh.file = content;
	return mesh;
}

void checkCarried(MeshFormat format, const std::string& path, const WantedAttributes& wanted)
{
	if (format == MeshFormat::Ply || !wanted.anyRequired()) return;
	throw AppError(ExitCode::Usage,
				   "the selection is read from PLY files only, not from '" + path + "'.");
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
	const std::string extension = lowerCase(std::filesystem::path(path).extension().string());
	if (extension == ".ply") return MeshFormat::Ply;
	if (extension == ".obj") return MeshFormat::Obj;
	if (extension == ".off") return MeshFormat::Off;
	if (extension == ".stl") return MeshFormat::Stl;
	if (extension == ".glb") return MeshFormat::Glb;
	throw AppError(ExitCode::Usage,
				   "'" + path + "' has none of the extensions .ply, .obj, .off, .stl and .glb.");
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
		throw AppError(ExitCode::BadInput, "'" + path + "' has no faces (" +
											   std::to_string(mesh.vertexNum()) + " vertices).");
	}
	return mesh;
}

namespace {

void writePlyFile(const TriangleMesh& mesh, bool doublePrecision, const MeshAttributes& attributes,
				  OutputFile& out)
{
	if (attributes.any())
		writePlyWithAttributes(mesh, doublePrecision, attributes, out);
	else
		writePly(mesh, doublePrecision, out);
}

void writeObjFile(const TriangleMesh& mesh, bool doublePrecision, MeshAttributes& attributes,
				  OutputFile& out)
{
	if (attributes.any())
		writeObjWithAttributes(mesh, doublePrecision, attributes, out, attributes.lost);
	else
		writeObj(mesh, doublePrecision, out);
}

} // namespace

void writeMesh(const TriangleMesh& mesh, bool doublePrecision, MeshAttributes& attributes,
			   const std::string& path, const RunLimit& limit)
{
	const MeshFormat format = formatOfPath(path);
	OutputFile       out(path, limit);
	if (attributes.any() && (format == MeshFormat::Off || format == MeshFormat::Stl))
		attributes.lost.push_back("any attribute, which this format does not hold");
	else if (attributes.gltf != nullptr && format != MeshFormat::Glb)
		attributes.lost.push_back("images and properties of materials");
	switch (format) {
	case MeshFormat::Ply:
		writePlyFile(mesh, doublePrecision, attributes, out);
		break;
	case MeshFormat::Obj:
		writeObjFile(mesh, doublePrecision, attributes, out);
		break;
	case MeshFormat::Off:
		writeOff(mesh, doublePrecision, out);
		break;
	case MeshFormat::Stl:
		writeStl(mesh, out);
		break;
	case MeshFormat::Glb:
		writeGlb(mesh, attributes, out, attributes.lost);
		break;
	}
	out.commit();
}

} // namespace gpr::app
