// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "valence_energy.h"

#include "sectors.h"

namespace gpr {

Buffer<int> correctedValences(const HalfEdgeMesh& m, Workers& workers)
{
	Buffer<int> valence(m.vertexNum);
	workers.forEach(m.vertexNum,
					[&](int v) { valence[v] = m.outgoing[v] < 0 ? 6 : correctedValence(m, v); });
	return valence;
}

int flipEnergy(const HalfEdgeMesh& m, const Buffer<int>& valence, int h)
{
	// A face less changes the energy by (n - 1 - 6)² - (n - 6)² = 13 - 2n, a face more by 2n - 11.
	const int losing  = valence[m.origin[h]] + valence[m.target(h)];
	const int gaining = valence[m.apex(h)] + valence[m.apex(m.opposite[h])];
	return 26 - 2 * losing + 2 * gaining - 22;
}

} // namespace gpr
