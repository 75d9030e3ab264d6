// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef GPR_TESTS_FUZZ_PIPELINE_H
#define GPR_TESTS_FUZZ_PIPELINE_H

#include <vcg_extras/core/mesh_view.h>
#include <vcg_extras/core/options.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace gpr::test {

/// One call of the engine, made of any bytes at all.
struct FuzzCase {
	enum class Tool { Remesh, Sample, Retriangulate, Detect };

	TriangleMesh              mesh;
	std::vector<uint8_t>      selected;
	std::vector<std::int32_t> region; ///< labels of the faces, or none
	RemeshOptions             options;
	Tool                      tool = Tool::Remesh;
};

/// How large what is made of bytes may be. Small cases take a tenth of the time in the mean, so
/// that a fuzzer gets ten times as far; all that they leave out is size.
enum class CaseSize { Any, Small };

/// Vertices on a small whole-numbered grid, so that bytes that differ give corners in a line, faces
/// one on the other, and coordinates that are equal.
FuzzCase caseOf(const std::uint8_t* data, std::size_t size, CaseSize caseSize = CaseSize::Any);

/// A small case whose faces have labels, with junctions, matched borders and periods, all from the
/// same bytes.
FuzzCase caseOfParts(const std::uint8_t* data, std::size_t size);

/// Runs it: what is wrong with the outcome, in words; empty where it is a sound result or a refusal
/// that makes sense.
std::string complaintsAbout(const FuzzCase& fuzzCase);

} // namespace gpr::test

#endif
