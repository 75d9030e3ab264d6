// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_IO_FORMATS_GLTF_MATERIALS_H
#define VCG_EXTRAS_IO_FORMATS_GLTF_MATERIALS_H

#include <string>
#include <vector>

namespace gpr::app {

/// What a binary glTF file says of its materials, to be written as it was read: the parts of the
/// JSON text that they need, and the bytes of the images that lie in the file.
struct GltfMaterials {
	std::string json; ///< an object: materials, textures, images, samplers, names of extensions
	std::vector<std::string> imageBytes; ///< by the number of the image; empty for one elsewhere
	std::size_t              materialNum = 0;
};

} // namespace gpr::app

#endif
