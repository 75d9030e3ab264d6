// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#ifndef VCG_EXTRAS_CORE_RUN_VERDICT_H
#define VCG_EXTRAS_CORE_RUN_VERDICT_H

#include <cstdint>
#include <string>

namespace gpr {

/// What of the options and the input decides whether a mesh is taken.
struct Request {
	bool         exactCount   = true;
	bool         isTargetWish = false; ///< another count may be taken
	std::int64_t keptNum      = 0;     ///< vertices of the caller's that are to stay
};

/// How a mesh gets its count.
enum class Way {
	WithFeatureLines, ///< samples of the right spacing, on feature lines too; then the exact count
	WithoutFeatureLines, ///< the same, but no feature line is followed
	ByTopology           ///< from the fewest samples, splits and collapses whatever the shapes
};

/// One mesh to be made, and what it is made for.
struct Attempt {
	Way          way       = Way::WithFeatureLines;
	std::int64_t vertexNum = 0;
	std::int64_t asked     = 0;     ///< count that sentences for the user compare with
	bool         isRaised  = false; ///< to the smallest count that topology came to
	/// The search for a count with which every triangle has an area: the count that it began with,
	/// and how many counts it has come to, this one included. 0: there is no search.
	std::int64_t searchedFrom      = 0;
	int          searchedNum       = 0;
	bool         keepsRaggedBorder = false; ///< though a smooth one was asked for
	bool         leavesSeamsOpen   = false; ///< though they were to be sewn
};

/// What came of an attempt.
struct Outcome {
	std::int64_t vertexNum       = 0;
	bool         hasFeatureLines = false;
	bool         hasZeroAreas    = false; ///< triangles whose area is nothing but rounding
	bool         hasSmoothBorder = false;
	bool         isSewn          = false; ///< along seams
};

/// What is to be done with the mesh of an attempt.
struct Verdict {
	enum class Kind { Accept, TryNext, Refuse };

	Kind         kind = Kind::Accept;
	std::string  sentence; ///< for the user: why it is refused, else a note; may be empty
	Attempt      next;     ///< with TryNext
	std::int64_t smallestVertexNum = 0; ///< with Refuse: what to ask for instead
};

/// The first attempt at a count.
Attempt firstAttempt(std::int64_t vertexNum);

/// Decides by counts alone; makes nothing. The rules, in their order:
///
/// 1. Feature lines with which the count is missed or triangles have no area are given up. So are a
///    smooth border, and then sewn seams, with which triangles have no area.
/// 2. Vertices to be kept leave no other way to the count: the nearest one is taken where the
///    target is a wish, else it is refused.
/// 3. A count that is missed is reached by topology alone. What even that cannot reach is refused
///    or, where the target was a wish, raised to the smallest possible count, and meshed anew:
///    samples of the right spacing, if they lead there, make better triangles.
/// 4. With very few vertices some triangles may have no way but along a slit or a fold, where they
///    have no area. The next count that does better is looked for. It is taken where the target was
///    a wish; else what was asked for is refused and that count named. Where there is none, the
///    mesh is accepted, and the audit withholds it.
///
/// The attempts that follow from each other always come to an end.
Verdict judge(const Request& request, const Attempt& attempt, const Outcome& outcome);

} // namespace gpr

#endif
