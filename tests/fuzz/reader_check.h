// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_FUZZ_READER_CHECK_H
#define GPR_TESTS_FUZZ_READER_CHECK_H

#include <vcg_extras/io/base/exit_code.h>
#include <vcg_extras/io/formats/mesh_formats.h>
#include <vcg_extras/io/mesh/mesh_data.h>

#include <string>
#include <string_view>

namespace gpr::test {

using Reader = app::InputMesh (*)(std::string_view);

/// The readers by their formats, for the corpus, the random cases and the fuzz targets.
struct NamedReader {
	std::string_view format;
	Reader           read;
};
constexpr NamedReader readers[] = {
	{"ply", app::readPly},
	{"obj", app::readObj},
	{"off", app::readOff},
	{"stl", app::readStl},
	{"glb", [](std::string_view file) { return app::readGlb(file); }},
};

/// Null for the name of no format.
inline Reader readerOf(std::string_view format)
{
	for (const NamedReader& reader : readers)
		if (reader.format == format) return reader.read;
	return nullptr;
}

/// The faults of reading a file; empty for a mesh with all indices in range, and for a refusal as
/// bad input with a sentence.
inline std::string complaintsAbout(Reader read, std::string_view file)
{
	if (file.empty()) return ""; // told before any reader is called
	try {
		const app::InputMesh mesh = read(file);
		if (mesh.triangles.size() % 3 != 0) return "a part of a triangle";
		if ((mesh.floats.size() + mesh.doubles.size()) % 3 != 0) return "a part of a vertex";
		for (const std::int32_t v : mesh.triangles) {
			if (v < 0 || std::size_t(v) >= mesh.vertexNum()) return "an index out of range";
		}
		return "";
	}
	catch (const app::AppError& error) {
		if (error.code != app::ExitCode::BadInput) return error.what();
		return error.what()[0] == '\0' ? "no sentence" : "";
	}
}

} // namespace gpr::test

#endif
