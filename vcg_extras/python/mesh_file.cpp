// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_file.h"

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/mesh_io.h>

#include <nanobind/stl/string.h>

namespace gpr::python {

namespace {

using app::PlyType;
using app::ValueColumn;

constexpr PlyType allTypes[] = {PlyType::Int8,    PlyType::UInt8,  PlyType::Int16,
								PlyType::UInt16,  PlyType::Int32,  PlyType::UInt32,
								PlyType::Float32, PlyType::Float64};

PlyType typeOf(const nb::ndarray<nb::ro>& array)
{
	for (const PlyType type : allTypes) {
		bool isIt = false;
		withType(type, [&](auto zero) { isIt = array.dtype() == nb::dtype<decltype(zero)>(); });
		if (isIt) return type;
	}
	throw nb::type_error("Values must be whole numbers of up to 32 bits or real numbers.");
}

ValueColumn columnOf(const std::string& name, const nb::ndarray<nb::ro>& array)
{
	if (array.ndim() != 1 || (array.shape(0) > 1 && array.stride(0) != 1))
		throw nb::type_error("Values must be an array of one dimension in C order.");
	ValueColumn column{name, typeOf(array), {}};
	withType(column.type, [&](auto zero) {
		const auto* const values = static_cast<const decltype(zero)*>(array.data());
		column.values.assign(values, values + array.shape(0));
	});
	return column;
}

nb::dict arraysOf(const std::vector<ValueColumn>& columns)
{
	nb::dict arrays;
	for (const ValueColumn& column : columns) {
		withType(column.type, [&](auto zero) {
			using T = decltype(zero);
			std::vector<T> values;
			for (const double value : column.values)
				values.push_back(T(value));
			arrays[column.name.c_str()] = toNumpy(std::move(values));
		});
	}
	return arrays;
}

template <class Array>
auto copyOf(const Array& values)
{
	using T = typename Array::value_type;
	return std::vector<T>(values.begin(), values.end());
}

nb::dict failed(const app::AppError& error)
{
	nb::dict out;
	out["status"]  = "unusable input";
	out["message"] = std::string(error.what());
	return out;
}

[[noreturn]] void raise(const app::AppError& error)
{
	if (error.code == app::ExitCode::Usage) throw nb::value_error(error.what());
	PyErr_SetString(PyExc_OSError, error.what());
	throw nb::python_error();
}

app::InputMesh readWithoutLock(const std::string& path)
{
	const nb::gil_scoped_release noLock;
	app::WantedAttributes        wanted;
	wanted.carried    = true;
	wanted.ifSelected = true;
	return app::readMesh(path, wanted);
}

nb::object coordinatesOf(const app::InputMesh& mesh)
{
	if (mesh.doublePrecision) return toNumpy<double>(copyOf(mesh.doubles), {mesh.vertexNum(), 3});
	return toNumpy<float>(copyOf(mesh.floats), {mesh.vertexNum(), 3});
}

/// The selected vertices, as bools; None if no vertex is selected.
nb::object selectionOf(const app::InputMesh& mesh)
{
	if (!mesh.view().anySelected()) return nb::none();
	return toNumpy<bool>(copyOf(mesh.selected), {mesh.vertexNum()});
}

} // namespace

void FileAttributes::addVertexValues(const std::string& name, const nb::ndarray<nb::ro>& array)
{
	values.ofVertices.push_back(columnOf(name, array));
}

void FileAttributes::addFaceValues(const std::string& name, const nb::ndarray<nb::ro>& array)
{
	values.ofFaces.push_back(columnOf(name, array));
	const auto known = names.find(name);
	if (known != names.end()) values.ofFaces.back().names = known->second;
}

void FileAttributes::setTexture(const CornerCoords& uv, const std::optional<Indices>& image)
{
	const std::size_t         faceNum = uv.shape(0);
	const std::int32_t* const images  = dataOf(image, faceNum);
	values.texture.uv.assign(uv.data(), uv.data() + 6 * faceNum);
	values.texture.image.clear();
	if (images != nullptr) values.texture.image.assign(images, images + faceNum);
}

void FileAttributes::takeMaterials(const FileAttributes& other)
{
	values.images          = other.values.images;
	values.materials       = other.values.materials;
	values.materialLibrary = other.values.materialLibrary;
	values.gltf            = other.values.gltf;
	values.folder          = other.values.folder;
	values.unit            = other.values.unit;
	names                  = other.names;
	for (const app::ValueColumn& column : other.values.ofFaces) {
		if (!column.names.empty()) names[column.name] = column.names;
	}
}

namespace {

using Texts = std::vector<std::string>;

nb::list bytesOf(const Texts& texts)
{
	nb::list all;
	for (const std::string& text : texts)
		all.append(nb::bytes(text.data(), text.size()));
	return all;
}

Texts textsOf(nb::handle all)
{
	Texts texts;
	for (const nb::handle text : nb::cast<nb::list>(all)) {
		const auto bytes = nb::cast<nb::bytes>(text);
		texts.emplace_back(bytes.c_str(), bytes.size());
	}
	return texts;
}

} // namespace

nb::list FileAttributes::materialState() const
{
	nb::list state;
	for (const Texts& texts : {values.images, values.materials,
							   Texts{values.materialLibrary, values.folder, values.unit},
							   values.gltf == nullptr ? Texts() : Texts{values.gltf->json},
							   values.gltf == nullptr ? Texts() : values.gltf->imageBytes})
		state.append(bytesOf(texts));
	for (const auto& [column, ofColumn] : names) {
		Texts texts = ofColumn;
		texts.push_back(column);
		state.append(bytesOf(texts));
	}
	return state;
}

void FileAttributes::setMaterialState(const nb::list& state)
{
	values.images          = textsOf(state[0]);
	values.materials       = textsOf(state[1]);
	const Texts plain      = textsOf(state[2]);
	values.materialLibrary = plain.at(0);
	values.folder          = plain.at(1);
	values.unit            = plain.at(2);
	const Texts json       = textsOf(state[3]);
	if (!json.empty())
		values.gltf =
			std::make_shared<app::GltfMaterials>(app::GltfMaterials{json[0], textsOf(state[4])});
	for (std::size_t i = 5; i < state.size(); ++i) {
		Texts             texts  = textsOf(state[i]);
		const std::string column = texts.back();
		texts.pop_back();
		names[column] = texts;
	}
}

nb::dict FileAttributes::vertexValues() const
{
	return arraysOf(values.ofVertices);
}

nb::dict FileAttributes::faceValues() const
{
	return arraysOf(values.ofFaces);
}

nb::object FileAttributes::uv() const
{
	if (!values.hasTexture()) return nb::none();
	return toNumpy<float>(copyOf(values.texture.uv), {values.texture.uv.size() / 6, 3, 2});
}

nb::object FileAttributes::image() const
{
	if (values.texture.image.empty()) return nb::none();
	return toNumpy(copyOf(values.texture.image));
}

nb::dict readMeshFile(const std::string& path)
{
	app::InputMesh mesh;
	try {
		mesh = readWithoutLock(path);
	}
	catch (const app::AppError& error) {
		if (error.code == app::ExitCode::BadInput) return failed(error);
		raise(error);
	}
	nb::dict out;
	out["status"]   = "ok";
	out["vertices"] = coordinatesOf(mesh);
	out["faces"]    = toNumpy<std::int32_t>(copyOf(mesh.triangles), {mesh.faceNum(), 3});
	out["selected"] = selectionOf(mesh);
	out["notes"]    = nb::list();
	for (const std::string& note : mesh.notes)
		nb::cast<nb::list>(out["notes"]).append(note);
	out["attributes"] = FileAttributes{std::move(mesh.attributes)};
	return out;
}

std::vector<std::string> writeMeshFile(const std::string& path, const Positions& positions,
									   const Triangles& triangles, const FileAttributes& attributes)
{
	try {
		const nb::gil_scoped_release noLock;
		const MeshView               view   = viewOf(positions, triangles);
		app::MeshAttributes          values = attributes.values;
		app::writeMesh(triangleMeshOf(view), view.doublePrecision, values, path, app::RunLimit());
		return values.lost;
	}
	catch (const app::AppError& error) {
		raise(error);
	}
}

} // namespace gpr::python
