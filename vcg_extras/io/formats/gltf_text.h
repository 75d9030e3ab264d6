// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_GLTF_TEXT_H
#define VCG_EXTRAS_IO_FORMATS_GLTF_TEXT_H

#include <string>
#include <string_view>

// glTF as text (.gltf), by the library TinyGLTF. What a mesh is in glTF is told by the readers and
// writers of binary glTF files: see glb_reader.h and glb_writer.h.

namespace gpr::app {

/// Whether this build has the library.
bool hasGltfText();

/// The binary glTF file with the content of a text file. folder: of the text file, for its buffers
/// in other files. Throws AppError (BadInput) on anything malformed.
std::string glbOfGltf(std::string_view file, const std::string& folder);

/// The text file with the content of a binary glTF file, its buffer and its images inside. Throws
/// AppError (Failure).
std::string gltfOfGlb(const std::string& glb);

} // namespace gpr::app

#endif
