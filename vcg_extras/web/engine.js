// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The engine in a worker, as promises. Page and npm package use this module.

const isNode = typeof process === "object" && Boolean(process.versions && process.versions.node);

/** A failure of the engine, with its sentence and the exit code of the program for the same failure. */
export class GpremeshError extends Error {
	constructor(sentence, code) {
		super(sentence);
		this.name = "GpremeshError";
		this.code = code;
	}
}

const mostThreads = 16;

/** How many threads an engine has. Threads share memory, which browsers allow to pages that are isolated from others: the server
 * sends the headers Cross-Origin-Opener-Policy: same-origin and Cross-Origin-Embedder-Policy: require-corp. */
export const threadNum = !isNode && globalThis.crossOriginIsolated ? Math.min(navigator.hardwareConcurrency, mostThreads) : 1;

let compiled = null;

// Compiles the module once for all workers.
function compile() {
	compiled ??= (async () => {
		const url = new URL(threadNum > 1 ? "./worker/gpremesh_threads.wasm" : "./worker/gpremesh.wasm", import.meta.url);
		if (!isNode) {
			const response = await fetch(url);
			if (!response.ok) throw new GpremeshError("gpremesh.wasm cannot be loaded.", 1);
			return WebAssembly.compile(await response.arrayBuffer());
		}
		const { readFile } = await import("node:fs/promises");
		return WebAssembly.compile(await readFile(url));
	})();
	return compiled;
}

// The first message has the module.
async function startWorker(compiled, listen, fail) {
	const url = new URL("./worker/worker.js", import.meta.url);
	if (isNode) {
		const { Worker } = await import("node:worker_threads");
		const worker = new Worker(url);
		worker.on("message", listen);
		worker.on("error", fail);
		worker.unref();
		worker.postMessage({ compiled, threadNum });
		return { post: (message, moved) => { worker.ref(); worker.postMessage(message, moved); }, rest: () => worker.unref(), end: () => worker.terminate() };
	}
	const worker = new Worker(url);
	worker.onmessage = ({ data }) => listen(data);
	worker.onerror = (event) => fail(new Error(event.message || "The worker cannot be started."));
	worker.postMessage({ compiled, threadNum });
	return { post: (message, moved) => worker.postMessage(message, moved), rest() {}, end: () => worker.terminate() };
}

/** A thread with a mesh. An aborted call ends the thread; the next call starts a new thread without a mesh. */
export class Engine {
	#worker = null;
	#waiting = new Map();
	#lastId = 0;
	/** Memory of the thread with its last answer, bytes. */
	memory = 0;

	/** Calls the engine. Calls are answered in sequence.
	 * @param call name of a call in calls.cpp, @param request the arguments of the call */
	async call(call, request = {}, { onProgress, signal, move = [] } = {}) {
		signal?.throwIfAborted();
		const module = await compile();
		this.#worker ??= startWorker(module, (message) => this.#hear(message), (error) => this.#fail(error));
		const mine = this.#worker;
		const worker = await mine;
		signal?.throwIfAborted();
		if (mine !== this.#worker) throw new GpremeshError("The engine was stopped.", 5);
		const id = ++this.#lastId;
		const answered = new Promise((resolve, reject) => this.#waiting.set(id, { resolve, reject, onProgress }));
		const stop = () => this.#fail(signal.reason);
		signal?.addEventListener("abort", stop);
		worker.post({ ...request, id, call }, move);
		try {
			return await answered;
		} finally {
			signal?.removeEventListener("abort", stop);
			if (this.#waiting.size === 0) worker.rest();
		}
	}

	/** Ends the thread. */
	end() {
		this.#fail(new GpremeshError("The engine was stopped.", 5));
	}

	/** Whether there is a thread, with its mesh. */
	get isRunning() {
		return this.#worker !== null;
	}

	#hear({ id, answer, memory, share, phrase, fatal }) {
		if (fatal !== undefined) {
			this.#fail(new GpremeshError(`the engine failed, mostly for want of memory (${fatal}).`, 1));
			return;
		}
		const waiting = this.#waiting.get(id);
		if (waiting === undefined) return;
		if (answer === undefined) {
			waiting.onProgress?.(share, phrase);
			return;
		}
		this.#waiting.delete(id);
		this.memory = memory;
		if (answer.error === undefined) waiting.resolve(answer);
		else waiting.reject(new GpremeshError(answer.error, answer.code));
	}

	#fail(error) {
		this.#worker?.then((worker) => worker.end());
		this.#worker = null;
		this.memory = 0;
		for (const { reject } of this.#waiting.values()) reject(error);
		this.#waiting.clear();
	}
}
