// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Run by package_test.py in a folder with torus.obj and what the program has made of it.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import test from "node:test";
import { GpremeshError, parameters, remesh, remeshFile } from "gpremesh";

const obj = await readFile("torus.obj");

// The same mesh as arrays: quads are cut as the program's reader cuts them, so only their corners are taken.
function arraysOf(text) {
	const vertices = [], faces = [];
	for (const line of text.split("\n")) {
		const [word, ...rest] = line.split(" ");
		if (word === "v") vertices.push(...rest.map(Number));
		if (word === "f") {
			const [a, b, c, d] = rest.map((corner) => Number(corner) - 1);
			faces.push(a, b, c, a, c, d);
		}
	}
	return { vertices: new Float32Array(vertices), faces: new Uint32Array(faces) };
}

const mesh = arraysOf(obj.toString());

// Coordinates of a binary PLY file of floats.
async function verticesOf(name) {
	const bytes = await readFile(name), text = bytes.toString("latin1");
	const num = Number(/element vertex (\d+)/.exec(text)[1]), from = text.indexOf("end_header\n") + 11;
	return new Float32Array(bytes.buffer.slice(bytes.byteOffset + from, bytes.byteOffset + from + 12 * num));
}

test("files have the bytes of the program's", async () => {
	const plain = await remeshFile("torus.obj", obj, "out.ply");
	assert.deepEqual(Buffer.from(plain.bytes), await readFile("plain.ply"));
	const other = await remeshFile("torus.obj", obj, "out.ply", { vertices: 700, adapt: 1 });
	assert.deepEqual(Buffer.from(other.bytes), await readFile("options.ply"));
	assert.equal(other.report.result.vertices, 700);
});

test("typed arrays in and out", async () => {
	const before = mesh.vertices.slice();
	const shares = [];
	const made = await remesh(mesh, { vertices: 700, adapt: 1 }, { onProgress: (share) => shares.push(share) });
	assert.ok(made.vertices instanceof Float32Array && made.faces instanceof Uint32Array);
	assert.deepEqual(made.vertices, await verticesOf("options.ply"));
	assert.equal(made.faces.length, 3 * 1400);
	assert.ok(Math.max(...made.faces) < 700);
	assert.deepEqual(mesh.vertices, before);
	assert.ok(shares.every((share) => share >= 0 && share <= 1));
	const double = await remesh({ ...mesh, vertices: new Float64Array(mesh.vertices) }, { vertices: 700 });
	assert.ok(double.vertices instanceof Float64Array);
});

test("many calls at a time, each with its own mesh", async () => {
	const made = await Promise.all([300, 400, 500].map((vertices) => remesh(mesh, { vertices })));
	assert.deepEqual(made.map((m) => m.vertices.length / 3), [300, 400, 500]);
});

test("an aborted run ends, and the next one goes", async () => {
	const abort = new AbortController();
	const run = remesh(mesh, {}, { signal: abort.signal, onProgress: () => abort.abort() });
	setTimeout(() => abort.abort(), 20);
	await assert.rejects(run, { name: "AbortError" });
	await assert.rejects(remesh(mesh, {}, { signal: AbortSignal.abort() }), { name: "AbortError" });
	assert.equal((await remesh(mesh, { vertices: 300 })).vertices.length, 900);
});

test("what is wrong is told in a sentence", async () => {
	await assert.rejects(remesh(mesh, { vertices: 3 }), (error) => error instanceof GpremeshError && error.code === 4);
	await assert.rejects(remesh(mesh, { vertices: 60e6 }), { message: /takes about .* GB of memory/ });
	await assert.rejects(remesh(mesh, { adapt: 7 }), { message: /--adapt takes .*not '7'/, code: 2 });
	await assert.rejects(remesh(mesh, { vertexes: 7 }), TypeError);
	await assert.rejects(remesh({ vertices: [0, 0, 0], faces: mesh.faces }), TypeError);
	await assert.rejects(remesh({ ...mesh, faces: new Uint32Array([0, 1, 1e6]) }), GpremeshError);
	await assert.rejects(remeshFile("a.ply", new Uint8Array(10), "b.ply"), { code: 3 });
	await assert.rejects(remeshFile("torus.obj", obj, "b.xyz"), GpremeshError);
});

test("files that were opened are given back", async () => {
	const { Engine } = await import("./node_modules/gpremesh/engine.js");
	const engine = new Engine();
	const large = Buffer.concat([obj, Buffer.from("# nothing\n".repeat(1600000))]); // 16 MB
	const open = (k) => engine.call("open", { name: `mesh${k}.obj`, bytes: new Uint8Array(large) });
	for (let k = 0; k < 4; ++k) await open(k);
	const before = process.memoryUsage().rss;
	for (let k = 4; k < 24; ++k) await open(k);
	const grown = (process.memoryUsage().rss - before) / 1e6;
	engine.end();
	assert.ok(grown < 160, `${grown} MB more after 20 files of 16 MB`);
});

test("options have names, ranges and texts", async () => {
	const rows = await parameters();
	assert.ok(rows.some((row) => row.option === "--adapt" && row.help.length > 20 && row.maximum === 1));
});
