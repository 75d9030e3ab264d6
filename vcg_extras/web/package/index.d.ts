// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Options } from "./options.js";

export type { Options };

/** A triangle mesh. Coordinates are in any unit, three a vertex; faces have three vertices each. */
export interface Mesh<Coordinates = Float32Array | Float64Array> {
	vertices: Coordinates;
	faces: Int32Array | Uint32Array;
}

/** What was done, and how well: the report of the program. */
export type Report = Record<string, any>;

export interface Run {
	/** Called about every 50 ms with the share of the work done, from 0 to 1, and a short text. */
	onProgress?: (share: number, phrase: string) => void;
	/** Ends the run: the promise is rejected with the signal's reason. */
	signal?: AbortSignal;
}

/** A failure that the engine tells in a sentence. */
export class GpremeshError extends Error {
	/** The exit code that the program would have: 2 for options, 3 for the input, 4 for a number of vertices that
	 * the surface cannot be meshed with. */
	code: number;
}

/** Remeshes a surface to nearly equilateral triangles, in a worker, which has threads in pages that are isolated from
 * others (crossOriginIsolated), else one thread. The input is copied and stays as it is; the result has its precision.
 * 10 % of the vertices are made where no size is given. The result has the bytes of the program's. */
export function remesh<Coordinates extends Float32Array | Float64Array>(
	mesh: Mesh<Coordinates>, options?: Options, run?: Run,
): Promise<{ vertices: Coordinates; faces: Uint32Array; report: Report }>;

/** The same from file to file, with all that the file holds beside the mesh. The extensions of the names tell the
 * formats: ply, obj, stl, off, glb. `lost` has words for what the format does not hold. */
export function remeshFile(
	name: string, bytes: Uint8Array, outName: string, options?: Options, run?: Run,
): Promise<{ bytes: Uint8Array; lost: string[]; report: Report }>;

/** The options with their ranges and texts. */
export function parameters(): Promise<Record<string, any>[]>;
