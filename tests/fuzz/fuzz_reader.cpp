// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer target for the reader that GPR_READER names: any bytes are a mesh with all indices in
// range, or refused as bad input.

#include <cstdio>
#include <cstdlib>
#include <vcg_extras/apps/gpremesh/exit_code.h>
#include <vcg_extras/apps/gpremesh/ply_reader.h>
#include <vcg_extras/apps/gpremesh/soup_io.h>

namespace {

[[noreturn]] void complain(const char* about)
{
	std::fprintf(stderr, "complaint: %s\n", about);
	std::abort();
}

void check(const gpr::app::InputMesh& mesh)
{
	if (mesh.triangles.size() % 3 != 0) complain("a part of a triangle");
	if (mesh.floats.size() % 3 != 0 || mesh.doubles.size() % 3 != 0) complain("a part of a vertex");
	for (const std::int32_t v : mesh.triangles) {
		if (v < 0 || std::size_t(v) >= mesh.vertexNum()) complain("an index out of range");
	}
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
try {
	if (size == 0) return 0; // told before any reader is called
	check(gpr::app::GPR_READER({reinterpret_cast<const char*>(data), size}));
	return 0;
}
catch (const gpr::app::AppError& error) {
	if (error.code != gpr::app::ExitCode::BadInput) complain(error.what());
	if (error.what()[0] == '\0') complain("no sentence");
	return 0;
}
