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

/// A call of the engine, made from any bytes.
struct FuzzCase {
	enum class Tool { Remesh, Sample, Retriangulate, Detect };

	TriangleMesh              mesh;
	std::vector<uint8_t>      selected;
	std::vector<std::int32_t> region; ///< labels of the faces, or none
	RemeshOptions             options;
	Tool                      tool = Tool::Remesh;
};

/// The size of a case. Small cases take a tenth of the time in the mean, so a fuzzer gets ten times
/// as far; only the size is smaller.
enum class CaseSize { Any, Small };

/// A case with vertices on a small grid of whole numbers: different bytes give corners in a line,
/// faces at the same place, and equal coordinates.
FuzzCase caseOf(const std::uint8_t* data, std::size_t size, CaseSize caseSize = CaseSize::Any);

/// A small case whose faces have labels, with junctions, matched borders and periods, all from the
/// same bytes.
FuzzCase caseOfParts(const std::uint8_t* data, std::size_t size);

/// Runs a case. Returns the faults of the outcome; empty for a sound result or a sensible refusal.
std::string complaintsAbout(const FuzzCase& fuzzCase);

} // namespace gpr::test

#endif
