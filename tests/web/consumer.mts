// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A program in TypeScript that uses the npm package; package_test.py has its types checked. The lines after
// the expected errors below must be mistakes.
import { GpremeshError, parameters, remesh, remeshFile } from "gpremesh";
import type { Mesh, Options, Report, Run } from "gpremesh";

const mesh: Mesh<Float32Array> = { vertices: new Float32Array(9), faces: new Uint32Array([0, 1, 2]) };
const options: Options = { vertices: 700, adapt: "auto", preset: "fast", maxError: "0.1%", check: true };
const abort = new AbortController();
const run: Run = { signal: abort.signal, onProgress: (share: number, phrase: string) => console.log(phrase, share) };

async function use(): Promise<number> {
	const made = await remesh(mesh, options, run);
	const vertices: Float32Array = made.vertices;
	const faces: Uint32Array = made.faces;
	const report: Report = made.report;
	const doubles: Float64Array = (await remesh({ ...mesh, vertices: new Float64Array(9) })).vertices;
	const { bytes, lost }: { bytes: Uint8Array; lost: string[] } = await remeshFile("a.ply", new Uint8Array(9), "b.glb");
	return vertices.length + faces.length + doubles.length + bytes.length + lost.length + report.seconds.total + (await parameters()).length;
}

use().catch((error: unknown) => {
	if (error instanceof GpremeshError) console.error(error.message, error.code.toFixed());
});

// @ts-expect-error: no option of this name
remesh(mesh, { vertexes: 7 });
// @ts-expect-error: a choice that is none
remesh(mesh, { preset: "slow" });
// @ts-expect-error: a number is wanted
remesh(mesh, { vertices: "many" });
// @ts-expect-error: arrays of numbers are no typed arrays
remesh({ vertices: [0, 0, 0], faces: [0, 1, 2] });
