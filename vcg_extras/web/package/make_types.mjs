// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Writes options.d.ts and package.json of the npm package, from the engine's parameter table.
//
//   node make_types.mjs FOLDER        FOLDER has index.js and the engine
import { writeFile } from "node:fs/promises";
import { pathToFileURL } from "node:url";

const folder = process.argv[2];
const { Engine } = await import(pathToFileURL(`${folder}/engine.js`));
const { version, parameters } = await new Engine().call("table");

const nameOf = (row) => row.option.slice(2).replace(/-([a-z])/g, (_, c) => c.toUpperCase());

function typeOf(row) {
	if (row.kind === "switch") return "boolean";
	if (row.kind === "choice") return row.choices.map((choice) => JSON.stringify(choice)).join(" | ");
	if (row.option === "--max-error") return "number | `${number}%`";
	return row.default === "auto" ? 'number | "auto"' : "number";
}

const rows = parameters.map((row) => {
	const text = row.help + (row.default ? ` Default: ${row.default}.` : "");
	return `\t/** ${text.replace(/\*\//g, "* /")} */\n\t${nameOf(row)}?: ${typeOf(row)};\n`;
});
await writeFile(`${folder}/options.d.ts`, `/** The options of the program, in JavaScript's way of writing names. */
export interface Options {
${rows.join("")}}
`);
await writeFile(`${folder}/package.json`, JSON.stringify({
	name: "gpremesh",
	version,
	description: "Remeshes a triangle mesh to nearly equilateral triangles with exactly as many vertices as asked for",
	keywords: ["mesh", "remeshing", "simplification", "triangles", "poisson-disk", "wasm"],
	license: "GPL-3.0-or-later",
	type: "module",
	exports: { ".": { types: "./index.d.ts", default: "./index.js" } },
	types: "./index.d.ts",
	engines: { node: ">=20" },
	sideEffects: false,
}, null, 2) + "\n");
