// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_GLTF_MATERIALS_H
#define VCG_EXTRAS_IO_FORMATS_GLTF_MATERIALS_H

#include <string>
#include <vector>

namespace gpr::app {

/// The materials of a binary glTF file, to be written unchanged: the parts of the JSON text for the
/// materials, and the bytes of the images in the file.
struct GltfMaterials {
	std::string json; ///< an object: materials, textures, images, samplers, names of extensions
	std::vector<std::string> imageBytes; ///< by the number of the image; empty for another file
	std::size_t              materialNum = 0;
};

} // namespace gpr::app

#endif
