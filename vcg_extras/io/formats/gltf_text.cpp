// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_formats.h"

#include <vcg_extras/io/base/exit_code.h>

#include <sstream>
#include <tiny_gltf.h>

namespace gpr::app {

namespace {

/// Keeps the bytes of an image as they are: nothing here needs its pixels.
bool keepBytes(tinygltf::Image*     image, int, std::string*, std::string*, int, int,
			   const unsigned char* bytes, int size, void*)
{
	image->image.assign(bytes, bytes + size);
	return true;
}

/// A reader and writer that leaves images alone.
tinygltf::TinyGLTF plainLoader()
{
	tinygltf::TinyGLTF loader;
	loader.SetImageLoader(keepBytes, nullptr);
	loader.SetImageWriter(nullptr, nullptr);
	return loader;
}

void append(const std::vector<unsigned char>& bytes, std::vector<unsigned char>& all)
{
	all.insert(all.end(), bytes.begin(), bytes.end());
	all.resize((all.size() + 3) / 4 * 4);
}

/// Binary glTF has one buffer.
void joinBuffers(tinygltf::Model& model)
{
	if (model.buffers.empty()) model.buffers.emplace_back();
	std::vector<std::size_t>   begin;
	std::vector<unsigned char> all;
	for (const tinygltf::Buffer& buffer : model.buffers) {
		begin.push_back(all.size());
		append(buffer.data, all);
	}
	for (tinygltf::BufferView& view : model.bufferViews) {
		if (view.buffer < 0 || std::size_t(view.buffer) >= begin.size())
			throw AppError(ExitCode::BadInput, "a buffer view has no buffer");
		view.byteOffset += begin[std::size_t(view.buffer)];
		view.buffer = 0;
	}
	model.buffers.resize(1);
	model.buffers[0].uri.clear();
	model.buffers[0].data = std::move(all);
}

/// Images that were written into the text come into the buffer.
void takeImages(tinygltf::Model& model)
{
	for (tinygltf::Image& image : model.images) {
		if (image.bufferView >= 0 || !image.uri.empty() || image.image.empty()) continue;
		tinygltf::BufferView view;
		view.buffer     = 0;
		view.byteOffset = model.buffers[0].data.size();
		view.byteLength = image.image.size();
		append(image.image, model.buffers[0].data);
		image.bufferView = int(model.bufferViews.size());
		model.bufferViews.push_back(view);
	}
}

std::string written(const tinygltf::Model& model, bool isBinary)
{
	std::ostringstream out;
	tinygltf::TinyGLTF loader = plainLoader();
	if (!loader.WriteGltfSceneToStream(&model, out, true, isBinary))
		throw AppError(ExitCode::Failure, "TinyGLTF could not write the mesh.");
	return out.str();
}

/// The library's complaint, in one line without a full stop.
std::string complaint(std::string text)
{
	while (!text.empty() && (text.back() == '\n' || text.back() == '.'))
		text.pop_back();
	return text.empty() ? "the file is no glTF" : text.substr(0, text.find('\n'));
}

} // namespace

bool hasGltfText()
{
	return true;
}

std::string glbOfGltf(std::string_view file, const std::string& folder)
{
	tinygltf::TinyGLTF loader = plainLoader();
	tinygltf::Model    model;
	std::string        error, warning;
	if (!loader.LoadASCIIFromString(&model, &error, &warning, file.data(),
									static_cast<unsigned int>(file.size()), folder))
		throw AppError(ExitCode::BadInput, complaint(error));
	joinBuffers(model);
	takeImages(model);
	return written(model, true);
}

std::string gltfOfGlb(const std::string& glb)
{
	tinygltf::TinyGLTF loader = plainLoader();
	tinygltf::Model    model;
	std::string        error, warning;
	if (!loader.LoadBinaryFromMemory(&model, &error, &warning,
									 reinterpret_cast<const unsigned char*>(glb.data()),
									 static_cast<unsigned int>(glb.size())))
		throw AppError(ExitCode::Failure, complaint(error) + ".");
	return written(model, false);
}

} // namespace gpr::app
