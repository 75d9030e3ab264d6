// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Example meshes, as files in memory.

// A grid of m by n places, closed in the directions of `wraps`, as binary PLY.
function gridPly(m, n, wraps, place) {
	const rows = wraps[0] ? m : m - 1, columns = wraps[1] ? n : n - 1;
	const head = new TextEncoder().encode("ply\nformat binary_little_endian 1.0\n" +
		`element vertex ${m * n}\nproperty float x\nproperty float y\nproperty float z\n` +
		`element face ${2 * rows * columns}\nproperty list uchar int vertex_indices\nend_header\n`);
	const bytes = new Uint8Array(head.length + 12 * m * n + 26 * rows * columns), view = new DataView(bytes.buffer);
	bytes.set(head);
	let at = head.length;
	for (let i = 0; i < m; ++i)
		for (let j = 0; j < n; ++j)
			for (const x of place(i / (wraps[0] ? m : m - 1), j / (wraps[1] ? n : n - 1))) {
				view.setFloat32(at, x, true);
				at += 4;
			}
	const triangle = (...corners) => {
		view.setUint8(at++, 3);
		for (const corner of corners) {
			view.setInt32(at, corner, true);
			at += 4;
		}
	};
	for (let i = 0; i < rows; ++i)
		for (let j = 0; j < columns; ++j) {
			const k = (i + 1) % m, l = (j + 1) % n;
			triangle(i * n + j, k * n + j, k * n + l);
			triangle(i * n + j, k * n + l, i * n + l);
		}
	return bytes;
}

// A ring with bumps, like the scan of a plant.
function ring(u, v) {
	const a = 2 * Math.PI * u, b = 2 * Math.PI * v;
	const bump = .12 * Math.sin(7 * a + 2 * b) * Math.sin(5 * b) + .05 * Math.sin(23 * a) * Math.cos(11 * b - 4 * a);
	const r = 3 + (1 + bump) * Math.cos(b);
	return [r * Math.cos(a), r * Math.sin(a), (1 + bump) * Math.sin(b)];
}

// A gear: the outline of a tooth wheel, a hole, and flat sides with crease edges between the parts.
function gear(u, v) {
	const a = 2 * Math.PI * u, tooth = Math.max(-1, Math.min(1, 2.5 * Math.sin(16 * a)));
	const outer = 3 + .35 * tooth, inner = 1.2, half = .5, side = 4 * v, share = side % 1;
	const [r, z] = [
		[outer, -half + 2 * half * share], [outer + (inner - outer) * share, half],
		[inner, half - 2 * half * share], [inner + (outer - inner) * share, -half],
	][Math.floor(side) % 4];
	return [r * Math.cos(a), r * Math.sin(a), z];
}

// Hills with a border.
function hills(u, v) {
	let z = 0;
	for (let k = 1; k < 60; k *= 2) z += Math.sin(k * (5 * u + 1.3 * v) + k) * Math.sin(k * (4 * v - .7 * u) + 2 * k) / k;
	return [4 * u - 2, 4 * v - 2, .35 * z];
}

export const examples = {
	ring: () => gridPly(400, 160, [true, true], ring),
	gear: () => gridPly(640, 80, [true, true], gear),
	hills: () => gridPly(250, 250, [false, false], hills),
};
