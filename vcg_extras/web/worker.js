// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The engine in a thread of its own, in a browser or in node. Takes first {compiled, threadNum}, then messages {id, call, ...}, and answers
// {id, answer} or {id, error, code}; before the answer it sends {id, share, phrase}. engine.js is the other end.
/* global makeGpremesh */

const isNode = typeof importScripts !== "function";
if (isNode) {
	const { parentPort } = require("node:worker_threads");
	// The parts of a browser that the loader of the module uses.
	globalThis.self = { location: { href: __filename } };
	globalThis.importScripts = () => {};
	globalThis.postMessage = (message, transferred) => parentPort.postMessage(message, transferred);
	parentPort.on("message", (message) => globalThis.onmessage({ data: message }));
	globalThis.makeGpremesh = require("./gpremesh.js");
}

let current = null; // the number of the present message
let loaded = null;
let shared = null; // the memory of modules with threads

// The memory of the module: another thread may have made it larger.
const heapOf = (module) => shared === null ? module.HEAPU8 : new Uint8Array(shared.buffer);

function load(compiled, threadNum) {
	const loader = threadNum > 1 ? "gpremesh_threads.js" : "gpremesh.js";
	if (!isNode) importScripts(loader);
	if (threadNum > 1) shared = new WebAssembly.Memory({ initial: 256, maximum: 65536, shared: true }); // as it was linked
	return makeGpremesh({
		...(shared === null ? {} : { wasmMemory: shared }),
		threadNum,
		mainScriptUrlOrBlob: loader, // for further threads
		instantiateWasm(imports, receive) {
			WebAssembly.instantiate(compiled, imports).then((instance) => receive(instance, compiled));
			return {};
		},
		onProgress(share, phrase) {
			postMessage({ id: current, share, phrase });
		},
		print() {},
		printErr(text) {
			console.warn(text);
		},
	});
}

// Copies a typed array of a request to the memory of the module, until the answer.
function lend(module, values) {
	const at = module._malloc(values.byteLength) >>> 0;
	if (at === 0) throw new RangeError("no memory for the mesh");
	heapOf(module).set(new Uint8Array(values.buffer, values.byteOffset, values.byteLength), at);
	return { at, length: values.byteLength };
}

// Replaces the references of an answer by buffers.
function takeOut(module, value, transferred) {
	if (value === null || typeof value !== "object") return value;
	if (typeof value.at === "number" && typeof value.length === "number" && Object.keys(value).length === 2) {
		const bytes = heapOf(module).slice(value.at, value.at + value.length).buffer;
		transferred.push(bytes);
		return bytes;
	}
	for (const key of Object.keys(value)) value[key] = takeOut(module, value[key], transferred);
	return value;
}

// Files lie in a file system in memory, under a name that cannot be a path. The one that is open stays: other options may need more
// of it.
const pathOf = (name) => "/" + name.replace(/\//g, "_");
let openPath = null;

// The open file stays beside a result with the same name.
const pathOfResult = (name) => pathOf(name) === openPath ? pathOf("/" + name) : pathOf(name);

function keepFile(module, path, bytes) {
	if (openPath !== null && openPath !== path) module.FS.unlink(openPath);
	module.FS.writeFile(path, bytes, { canOwn: true });
	openPath = path;
}

function answer(module, request) {
	const lent = [];
	for (const [key, value] of Object.entries(request)) {
		if (!ArrayBuffer.isView(value) || key === "bytes") continue;
		request[key] = lend(module, value);
		lent.push(request[key].at);
	}
	if (request.name && request.call === "open") {
		request.path = pathOf(request.name);
		keepFile(module, request.path, request.bytes);
		delete request.bytes;
	}
	if (request.call === "save") request.path = pathOfResult(request.name);
	try {
		return JSON.parse(module.ccall("gprCall", "string", ["string"], [JSON.stringify(request)]));
	} finally {
		for (const at of lent) module._free(at);
	}
}

async function reply(message) {
	if (message.compiled) {
		loaded = load(message.compiled, message.threadNum);
		return;
	}
	const module = await loaded;
	current = message.id;
	const transferred = [];
	const answered = takeOut(module, answer(module, message), transferred);
	if (message.call === "save" && answered.error === undefined) {
		answered.bytes = module.FS.readFile(message.path);
		transferred.push(answered.bytes.buffer);
		module.FS.unlink(message.path);
	}
	postMessage({ id: message.id, answer: answered, memory: heapOf(module).length }, transferred);
}

globalThis.onmessage = ({ data }) => {
	reply(data).catch((error) => {
		// No failure of the engine, but of the module, which is unusable from here on.
		postMessage({ fatal: String(error.message || error) });
	});
};
