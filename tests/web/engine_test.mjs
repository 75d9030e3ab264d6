// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thread round the engine, in node and without emscripten: the module is a stand-in that copies files.
import assert from "node:assert/strict";
import { cp, mkdir, mkdtemp, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import test from "node:test";
import { fileURLToPath } from "node:url";

// As made by emscripten: a file system in memory, and calls with JSON.
const standIn = `
module.exports = async () => {
	const files = new Map();
	let opened = null;
	const FS = {
		writeFile(path, bytes) { files.set(path, bytes); },
		readFile(path) { return files.get(path); },
		unlink(path) { if (!files.delete(path)) throw new Error("no file " + path); },
	};
	const calls = {
		table: () => ({ parameters: [] }),
		open({ path }) { opened = path; return {}; },
		remesh() { return files.has(opened) ? {} : { error: "cannot read " + opened, code: 3 }; },
		save({ path }) { FS.writeFile(path, new Uint8Array([7])); return { lost: [] }; },
	};
	return { FS, HEAPU8: new Uint8Array(8), ccall(name, type, types, [text]) {
		const request = JSON.parse(text);
		return JSON.stringify(calls[request.call](request));
	} };
};`;

const web = fileURLToPath(new URL("../../vcg_extras/web", import.meta.url));
const folder = await mkdtemp(join(tmpdir(), "gpremesh-web-"));
test.after(() => rm(folder, { recursive: true }));
await mkdir(join(folder, "worker"));
await cp(join(web, "package/index.js"), join(folder, "index.js"));
await cp(join(web, "engine.js"), join(folder, "engine.js"));
await cp(join(web, "worker.js"), join(folder, "worker/worker.js"));
await writeFile(join(folder, "package.json"), '{ "type": "module" }');
await writeFile(join(folder, "worker/package.json"), '{ "type": "commonjs" }');
await writeFile(join(folder, "worker/gpremesh.js"), standIn);
await writeFile(join(folder, "worker/gpremesh.wasm"), new Uint8Array([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0])); // an empty module
const { remeshFile } = await import(join(folder, "index.js"));
const { Engine } = await import(join(folder, "engine.js"));

test("the result may have the name of the input", async () => {
	for (const name of ["a.ply", "a.ply", "b.ply"])
		assert.deepEqual((await remeshFile(name, new Uint8Array(3), name)).bytes, new Uint8Array([7]));
	const engine = new Engine();
	await engine.call("open", { name: "a.ply", bytes: new Uint8Array(3) });
	await engine.call("save", { name: "a.ply" });
	await engine.call("remesh"); // other options may read the input again
});

test("a call that is aborted while the thread starts leaves an engine that works", async () => {
	const engine = new Engine(), abort = new AbortController();
	const call = engine.call("table", {}, { signal: abort.signal });
	abort.abort();
	await assert.rejects(call, { name: "AbortError" });
	assert.deepEqual((await engine.call("table")).parameters, []);
	const both = [engine.call("table"), new Engine().call("table")];
	await Promise.all(both);
});
