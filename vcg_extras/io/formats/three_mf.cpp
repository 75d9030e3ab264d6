// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <vcg_extras/io/base/exit_code.h>

#include <Model/COM/NMR_DLLInterfaces.h>
#include <algorithm>
#include <cmath>
#include <vector>

namespace gpr::app {

namespace {

using Instance = NMR::PLib3MFBase*;

/// Something of the library's, given back at the end.
class Handle {
public:
	Handle() = default;
	~Handle()
	{
		if (handle_ != nullptr) NMR::lib3mf_release(handle_);
	}
	Handle(const Handle&)            = delete;
	Handle& operator=(const Handle&) = delete;

	Instance* put() { return &handle_; }
			  operator Instance() const { return handle_; }

private:
	Instance handle_ = nullptr;
};

void require(LIB3MFRESULT result, ExitCode code, const char* sentence)
{
	if (result != LIB3MF_OK) throw AppError(code, sentence);
}

void requireRead(LIB3MFRESULT result)
{
	require(result, ExitCode::BadInput, "lib3mf cannot read the file as 3MF");
}

void requireWritten(LIB3MFRESULT result)
{
	require(result, ExitCode::Failure, "lib3mf could not write the mesh.");
}

void addObject(Instance object, InputMesh& mesh)
{
	DWORD vertexNum = 0, faceNum = 0;
	requireRead(NMR::lib3mf_meshobject_getvertexcount(object, &vertexNum));
	requireRead(NMR::lib3mf_meshobject_gettrianglecount(object, &faceNum));
	std::vector<NMR::MODELMESHVERTEX>   vertices(vertexNum);
	std::vector<NMR::MODELMESHTRIANGLE> faces(faceNum);
	requireRead(NMR::lib3mf_meshobject_getvertices(object, vertices.data(), vertexNum, &vertexNum));
	requireRead(NMR::lib3mf_meshobject_gettriangleindices(object, faces.data(), faceNum, &faceNum));
	const std::size_t first = mesh.floats.size() / 3;
	for (const NMR::MODELMESHVERTEX& v : vertices)
		mesh.floats.insert(mesh.floats.end(), v.m_fPosition, v.m_fPosition + 3);
	for (const NMR::MODELMESHTRIANGLE& face : faces) {
		for (const DWORD corner : face.m_nIndices) {
			if (corner >= vertexNum)
				throw AppError(ExitCode::BadInput, "a triangle has no such vertex");
			mesh.triangles.push_back(std::int32_t(first + corner));
		}
	}
}

/// The library writes six digits behind the point. Coordinates of small meshes are written times
/// this power of ten, and the place where the object is built divides by it.
double scaleFor(const TriangleMesh& mesh)
{
	constexpr double enough = 100, largestScale = 1e6;
	double           largest = 0;
	for (const Vec3d& p : mesh.positions)
		largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
	double scale = 1;
	while (scale * largest < enough && scale < largestScale)
		scale *= 10;
	if (largest > 0 && scale * largest < 1)
		throw AppError(ExitCode::Failure, "the coordinates are too small for 3MF, which lib3mf "
										  "writes with six digits behind the point.");
	return scale;
}

NMR::MODELTRANSFORM dividedBy(double scale)
{
	NMR::MODELTRANSFORM transform = {};
	for (int k = 0; k < 3; ++k)
		transform.m_fFields[k][k] = float(1 / scale);
	return transform;
}

} // namespace

bool hasThreeMf()
{
	return true;
}

InputMesh readThreeMf(std::string_view file)
{
	Handle model, reader, merged, objects;
	requireRead(NMR::lib3mf_createmodel(model.put()));
	requireRead(NMR::lib3mf_model_queryreader(model, "3mf", reader.put()));
	std::vector<BYTE> bytes(file.begin(), file.end());
	requireRead(NMR::lib3mf_reader_readfrombuffer(reader, bytes.data(), bytes.size()));
	requireRead(NMR::lib3mf_model_mergetomodel(model, merged.put()));
	requireRead(NMR::lib3mf_model_getmeshobjects(merged, objects.put()));
	InputMesh mesh;
	for (;;) {
		BOOL hasNext = 0;
		requireRead(NMR::lib3mf_resourceiterator_movenext(objects, &hasNext));
		if (!hasNext) break;
		Handle object;
		requireRead(NMR::lib3mf_resourceiterator_getcurrent(objects, object.put()));
		addObject(object, mesh);
	}
	return mesh;
}

void writeThreeMf(const TriangleMesh& mesh, OutputFile& out)
{
	std::vector<NMR::MODELMESHVERTEX> vertices;
	const double                      scale = scaleFor(mesh);
	for (const Vec3d& p : mesh.positions)
		vertices.push_back({{float(scale * p.x), float(scale * p.y), float(scale * p.z)}});
	std::vector<NMR::MODELMESHTRIANGLE> faces;
	for (std::size_t c = 0; c < mesh.triangles.size(); c += 3) {
		faces.push_back({{DWORD(mesh.triangles[c]), DWORD(mesh.triangles[c + 1]),
						  DWORD(mesh.triangles[c + 2])}});
	}
	Handle model, object, item, writer;
	requireWritten(NMR::lib3mf_createmodel(model.put()));
	requireWritten(NMR::lib3mf_model_addmeshobject(model, object.put()));
	requireWritten(NMR::lib3mf_meshobject_setgeometry(
		object, vertices.data(), DWORD(vertices.size()), faces.data(), DWORD(faces.size())));
	NMR::MODELTRANSFORM place = dividedBy(scale);
	requireWritten(
		NMR::lib3mf_model_addbuilditem(model, object, scale > 1 ? &place : nullptr, item.put()));
	requireWritten(NMR::lib3mf_model_querywriter(model, "3mf", writer.put()));
	ULONG64 size = 0;
	requireWritten(NMR::lib3mf_writer_getstreamsize(writer, &size));
	std::vector<BYTE> bytes(size);
	requireWritten(NMR::lib3mf_writer_writetobuffer(writer, bytes.data(), size));
	out.bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

} // namespace gpr::app
