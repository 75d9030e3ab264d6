// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <vcg_extras/io/base/checksum.h>
#include <vcg_extras/io/base/exit_code.h>

#include <Model/COM/NMR_DLLInterfaces.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
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

// ---- reading

/// The units of the format, by their number in the library.
constexpr const char* unitNames[] = {"micron", "millimeter", "centimeter", "inch", "foot", "meter"};

std::string unitOf(Instance model)
{
	DWORD unit = NMR::MODELUNIT_MILLIMETER;
	requireRead(NMR::lib3mf_model_getunit(model, &unit));
	return unit < std::size(unitNames) ? unitNames[unit] : "";
}

/// Calls use(object) for each mesh of a model.
template <class Use>
void forEachMesh(Instance model, Use use)
{
	Handle objects;
	requireRead(NMR::lib3mf_model_getmeshobjects(model, objects.put()));
	for (;;) {
		BOOL hasNext = 0;
		requireRead(NMR::lib3mf_resourceiterator_movenext(objects, &hasNext));
		if (!hasNext) return;
		Handle object;
		requireRead(NMR::lib3mf_resourceiterator_getcurrent(objects, object.put()));
		use(object);
	}
}

bool hasName(Instance object)
{
	ULONG size = 0; // with a zero at the end
	requireRead(NMR::lib3mf_object_getnameutf8(object, nullptr, 0, &size));
	return size > 1;
}

/// Whether the whole object or one of its triangles has a material, a colour or an image.
bool hasMaterials(Instance object)
{
	using NMR::eModelPropertyType;
	Handle             ofObject, ofTriangles;
	eModelPropertyType type = NMR::MODELPROPERTYTYPE_NONE;
	requireRead(NMR::lib3mf_object_createdefaultpropertyhandler(object, ofObject.put()));
	requireRead(NMR::lib3mf_defaultpropertyhandler_getpropertytype(ofObject, &type));
	if (type != NMR::MODELPROPERTYTYPE_NONE) return true;
	DWORD faceNum = 0;
	requireRead(NMR::lib3mf_meshobject_gettrianglecount(object, &faceNum));
	requireRead(NMR::lib3mf_meshobject_createpropertyhandler(object, ofTriangles.put()));
	for (DWORD f = 0; f < faceNum; ++f) {
		requireRead(NMR::lib3mf_propertyhandler_getpropertytype(ofTriangles, f, &type));
		if (type != NMR::MODELPROPERTYTYPE_NONE) return true;
	}
	return false;
}

void tellLost(Instance model, std::vector<std::string>& lost)
{
	bool named = false, material = false;
	forEachMesh(model, [&](Instance object) {
		named    = named || hasName(object);
		material = material || hasMaterials(object);
	});
	if (named) lost.push_back("names of objects");
	if (material) lost.push_back("materials");
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

// ---- writing

/// The library writes six digits behind the point. Coordinates of small meshes are written times
/// this power of ten, and the place where the object is built divides by it.
double scaleFor(const TriangleMesh& mesh)
{
	constexpr double enough = 100, largestScale = 1e6;
	constexpr double tooLarge = 1e9; // for the library, which refuses such vertices
	double           largest  = 0;
	for (const Vec3d& p : mesh.positions)
		largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
	if (largest >= tooLarge)
		throw AppError(ExitCode::Failure, "the coordinates are too large for 3MF, which lib3mf "
										  "writes below 1,000,000,000.");
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

/// The unit of a mesh, or the unit of the format without another.
NMR::eModelUnit unitNamed(const std::string& name)
{
	for (std::size_t i = 0; i < std::size(unitNames); ++i) {
		if (name == unitNames[i]) return NMR::eModelUnit(i);
	}
	return NMR::MODELUNIT_MILLIMETER;
}

/// Numbers for the parts of a file. The library's own are random, but the same mesh gives the same
/// bytes in every run.
class PartNumbers {
public:
	PartNumbers(const std::vector<NMR::MODELMESHVERTEX>&   vertices,
				const std::vector<NMR::MODELMESHTRIANGLE>& faces)
	{
		add(vertices);
		add(faces);
	}

	/// A UUID of version 8, whose bits are free: two sums over the mesh and the part.
	std::string of(const std::string& part) const
	{
		const auto high = sumWith(part + " 1"), low = sumWith(part + " 2");
		char       text[40];
		std::snprintf(text, sizeof text, "%08llx-%04llx-8%03llx-9%03llx-%012llx", high >> 32,
					  high >> 16 & 0xffff, high & 0xfff, low >> 52, low & 0xffffffffffff);
		return text;
	}

private:
	Checksum sum_;

	template <class T>
	void add(const std::vector<T>& values)
	{
		sum_.add(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
	}
	unsigned long long sumWith(const std::string& text) const
	{
		Checksum sum = sum_;
		sum.add(text.data(), text.size());
		return sum.value();
	}
};

} // namespace

bool hasThreeMf()
{
	return true;
}

InputMesh readThreeMf(std::string_view file)
{
	Handle model, reader, merged;
	requireRead(NMR::lib3mf_createmodel(model.put()));
	requireRead(NMR::lib3mf_model_queryreader(model, "3mf", reader.put()));
	std::vector<BYTE> bytes(file.begin(), file.end());
	requireRead(NMR::lib3mf_reader_readfrombuffer(reader, bytes.data(), bytes.size()));
	requireRead(NMR::lib3mf_model_mergetomodel(model, merged.put()));
	InputMesh mesh;
	forEachMesh(merged, [&](Instance object) { addObject(object, mesh); });
	mesh.attributes.unit = unitOf(model);
	tellLost(model, mesh.attributes.lost);
	return mesh;
}

void writeThreeMf(const TriangleMesh& mesh, const std::string& unit, OutputFile& out)
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
	requireWritten(NMR::lib3mf_model_setunit(model, unitNamed(unit)));
	requireWritten(NMR::lib3mf_model_addmeshobject(model, object.put()));
	requireWritten(NMR::lib3mf_meshobject_setgeometry(
		object, vertices.data(), DWORD(vertices.size()), faces.data(), DWORD(faces.size())));
	NMR::MODELTRANSFORM place = dividedBy(scale);
	requireWritten(
		NMR::lib3mf_model_addbuilditem(model, object, scale > 1 ? &place : nullptr, item.put()));
	const PartNumbers number(vertices, faces);
	requireWritten(NMR::lib3mf_model_setbuilduuidutf8(model, number.of("build").c_str()));
	requireWritten(NMR::lib3mf_object_setuuidutf8(object, number.of("object").c_str()));
	requireWritten(NMR::lib3mf_builditem_setuuidutf8(item, number.of("item").c_str()));
	requireWritten(NMR::lib3mf_model_querywriter(model, "3mf", writer.put()));
	ULONG64 size = 0;
	requireWritten(NMR::lib3mf_writer_getstreamsize(writer, &size));
	std::vector<BYTE> bytes(size);
	requireWritten(NMR::lib3mf_writer_writetobuffer(writer, bytes.data(), size));
	out.bytes(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

} // namespace gpr::app
