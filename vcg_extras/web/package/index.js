// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The npm package: see index.d.ts.
import { Engine } from "./engine.js";

export { GpremeshError } from "./engine.js";

const idle = []; // engines without work

// Runs `work` with an engine. An aborted engine has ended its thread, and starts a new thread for the next call.
async function withEngine(work) {
	const engine = idle.pop() ?? new Engine();
	try {
		return await work(engine);
	} finally {
		idle.push(engine);
	}
}

let table = null;

/** The options with their ranges and texts. */
export async function parameters() {
	table ??= (await withEngine((engine) => engine.call("table"))).parameters;
	return table;
}

// Options as text: { maxError: "0.1%", check: true } becomes "--max-error 0.1% --check".
async function textOf(options) {
	const rows = await parameters(), words = [];
	for (const [name, value] of Object.entries(options)) {
		if (value === undefined) continue;
		const option = "--" + name.replace(/[A-Z]/g, (c) => "-" + c.toLowerCase());
		const row = rows.find((r) => r.option === option);
		if (row === undefined) throw new TypeError(`there is no option ${name}.`);
		const isBare = row.argument === "";
		if (isBare && value === false) continue;
		const word = value === true ? "on" : value === false ? "off" : String(value).replace(/\s/g, "");
		words.push(isBare ? option : `${option} ${word}`);
	}
	return words.join(" ");
}

function checkMesh({ vertices, faces }) {
	if (!(vertices instanceof Float32Array || vertices instanceof Float64Array) || vertices.length % 3 !== 0)
		throw new TypeError("vertices must be a Float32Array or Float64Array with three numbers a vertex.");
	if (!(faces instanceof Int32Array || faces instanceof Uint32Array) || faces.length % 3 !== 0)
		throw new TypeError("faces must be an Int32Array or Uint32Array with three vertices a triangle.");
}

export async function remesh(mesh, options = {}, { onProgress, signal } = {}) {
	checkMesh(mesh);
	const text = await textOf(options);
	return withEngine(async (engine) => {
		const double = mesh.vertices instanceof Float64Array;
		await engine.call("take", { vertices: mesh.vertices, faces: mesh.faces, double }, { signal });
		const report = await engine.call("remesh", { options: text }, { onProgress, signal });
		const made = await engine.call("arrays", {}, { signal });
		return {
			vertices: double ? new Float64Array(made.vertices) : new Float32Array(made.vertices),
			faces: new Uint32Array(made.faces),
			report,
		};
	});
}

export async function remeshFile(name, bytes, outName, options = {}, { onProgress, signal } = {}) {
	const text = await textOf(options);
	return withEngine(async (engine) => {
		await engine.call("open", { name, bytes }, { signal });
		const report = await engine.call("remesh", { options: text }, { onProgress, signal });
		const saved = await engine.call("save", { name: outName }, { signal });
		return { bytes: saved.bytes, lost: saved.lost, report };
	});
}
