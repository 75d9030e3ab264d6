// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page. Two engines have the mesh: the first makes drafts and is never stopped, the second makes the results.
/* global makeViewer */
import { Engine, threadNum } from "./engine.js";
import { examples } from "./examples.js";

const restAfter = 500;            // ms after the last change, until the default begins
const mostFacesOfDrafts = 3000000; // two engines need the memory twice
const mostBytes = 1.5e9;          // of a file: it lies in memory beside the mesh
const ownRows = ["--threads", "--time-limit", "--selected"]; // as many threads as may be; the page selects nothing

const $ = (id) => document.getElementById(id);
const drafts = new Engine(), results = new Engine();
const viewer = makeViewer($("viewer"), {
	endOfDistances: 0, mostShown: 300000, meshes: [], panels: ["input", "result", "quadricEdgeCollapse"],
});
let table = [];
let mesh = null;       // the open mesh: { name, bytes, facts }
let change = 0;        // number of changes of the options or the mesh
let waiting = null;    // the timer of the default
let running = null;    // AbortController of the present call of the results' engine
let draftWanted = null, isDrafting = false;
let finished = 0;      // drafts up to this change are not shown any more

// ---- words ----

const grouped = (number) => Math.round(number).toString().replace(/\B(?=(\d{3})+$)/g, ",");
const seconds = (from) => ((performance.now() - from) / 1000).toFixed(2) + " s";

function tell(words, isFailure = false) {
	$("words").textContent = words;
	$("status").classList.toggle("failed", isFailure);
}

function tellFailure(error) {
	if (error.name !== "AbortError") tell(error.message.replace(/^./, (c) => c.toUpperCase()), true);
}

// The number of working threads, and the memory of the engines.
function tellEngines() {
	const megabytes = Math.round((drafts.memory + results.memory) / 1e6);
	$("engine").textContent = `${threadNum > 1 ? threadNum + " threads work" : "One thread works"}, with ${megabytes} MB of memory.`;
}

// For scripts/measure/page_times: one entry of this name in the browser's own record of times.
function record(name, start) {
	performance.clearMeasures(name);
	performance.measure(name, { start });
}

function showProgress(share, phrase) {
	$("progress").hidden = $("cancel").hidden = share === null;
	if (share === null) return;
	$("progress").value = share;
	tell(phrase);
}

// ---- the options of the page, as options of the command line ----

const rowOf = (option) => table.find((row) => row.option === option);

function makeWidget(row) {
	const widget = document.createElement(row.kind === "choice" ? "select" : "input");
	if (row.kind === "choice") {
		for (const choice of row.choices) widget.add(new Option(choice));
	} else if (row.kind === "switch") {
		widget.type = "checkbox";
		widget.defaultChecked = row.default === "on";
	} else {
		widget.placeholder = row.default;
		widget.inputMode = "decimal";
	}
	if (row.kind === "choice" && row.default) widget.value = row.default;
	widget.dataset.option = row.option;
	widget.title = row.help;
	return widget;
}

function makeRows() {
	for (const row of table.filter((r) => !r.isSize && !ownRows.includes(r.option))) {
		const label = document.createElement("label");
		label.append(row.label, makeWidget(row));
		label.title = row.help;
		$(row.isExpert ? "experts" : "more").append(label);
	}
	for (const row of table.filter((r) => r.isSize)) $("size").add(new Option(row.label, row.option));
}

function chooseSize() {
	const row = rowOf($("size").value), hasSlider = row.kind === "count";
	$("number").replaceChildren(makeWidget(row));
	$("slider").hidden = !hasSlider;
	if (hasSlider) setNumber(mostOf(row) / 20);
	else if (row.kind === "choice") numberWidget().value = "normal";
	else if (row.option === "--percent") numberWidget().value = "10";
	else if (row.option === "--max-error") numberWidget().value = "0.1%";
	else numberWidget().value = (mesh.facts.diagonal / 100).toPrecision(2);
}

const numberWidget = () => $("number").firstElementChild;
const mostOf = (row) => row.option === "--faces" ? mesh.facts.faces : mesh.facts.vertices;

// The slider goes from 10 to twice the number of the input, in steps of equal ratio.
const range = () => Math.log(2 * mostOf(rowOf($("size").value)) / 10);

function setNumber(number) {
	numberWidget().value = Math.max(4, Math.round(number));
	$("slider").value = 1000 * Math.log(Math.max(number, 10) / 10) / range();
}

function wordOf(widget) {
	const row = rowOf(widget.dataset.option);
	if (row.kind === "switch") return widget.checked === (row.default === "on") ? "" : widget.checked ? "on" : "off";
	const word = widget.value.trim().replace(/\s+/g, "");
	return word === row.default ? "" : word;
}

// Pairs of an option and its value, as text for the program.
function wishes() {
	const widgets = [numberWidget(), ...document.querySelectorAll("#more [data-option], #experts [data-option]")];
	return widgets.map((widget) => [rowOf(widget.dataset.option), wordOf(widget)]).filter(([, word]) => word !== "");
}

const optionsText = (given) => given.map(([row, word]) => row.argument ? row.option + " " + word : row.option).join(" ");

function pythonValue(row, word) {
	if (row.kind === "switch") return word === "on" ? "True" : "False";
	return row.kind === "choice" || !Number.isFinite(Number(word)) ? JSON.stringify(word) : word;
}

const outName = () => mesh.name.replace(/\.[^.]*$/, "") + "_remeshed." + $("format").value;
const quoted = (name) => /^[\w.+-]+$/.test(name) ? name : "'" + name.replace(/'/g, "'\\''") + "'";

function showCommands() {
	const given = wishes(), called = given.map(([row, word]) => row.python + "=" + pythonValue(row, word)).join(", ");
	$("command").textContent = `gpremesh remesh ${quoted(mesh.name)} ${quoted(outName())} ${optionsText(given)}`;
	$("python").textContent = `import gpremesh\nresult = gpremesh.read(${JSON.stringify(mesh.name)}).remesh(${called})\n` +
		`gpremesh.write(${JSON.stringify(outName())}, result)`;
}

// ---- figures ----

const shownFigures = new Map();

function showFigures(key, name, figures) {
	shownFigures.set(key, { ...shownFigures.get(key), name, ...figures });
	const body = $("figures").tBodies[0];
	body.textContent = "";
	for (const rowKey of ["input", "result", "quadricEdgeCollapse"]) {
		const f = shownFigures.get(rowKey);
		if (f === undefined) continue;
		const row = body.insertRow(), cell = (text) => { row.insertCell().textContent = text; };
		const percent = (value) => value === undefined ? "" : value.toPrecision(3) + " %";
		cell(f.name);
		cell(grouped(f.faces));
		cell(grouped(f.vertices));
		cell(f.quality.radiusRatio.mean.toFixed(3));
		cell(f.quality.angles.min.toFixed(1) + "°");
		cell(f.quality.angles.below30Percent.toPrecision(3) + " %");
		cell(percent(f.distance?.rmsPercent));
		cell(percent(f.distance?.p999Percent));
		row.append(largestCell(rowKey, f));
		cell(f.seconds ?? "");
	}
}

function largestCell(key, figures) {
	const cell = document.createElement("td");
	if (figures.proven) cell.textContent = "≤ " + figures.proven.upperPercent.toPrecision(3) + " %";
	if (!figures.distance || figures.proven) return cell;
	const button = document.createElement("button");
	button.type = "button";
	button.textContent = "prove";
	button.onclick = () => prove(key, figures.name);
	cell.append(button);
	return cell;
}

async function prove(key, name) {
	const of = change;
	tell("Computing a proven bound of the largest distance ...");
	try {
		const bounds = await results.call("proven", { key });
		if (of !== change) return;
		showFigures(key, name, { proven: bounds.hausdorff });
		tell("No point of either surface is farther from the other surface. This is proven.");
	} catch (error) {
		tellFailure(error);
	}
}

function showNotes(notes) {
	$("notes").replaceChildren(...notes.map((note) => Object.assign(document.createElement("li"), { textContent: note })));
}

// ---- drafts, during changes ----

async function draft() {
	if (isDrafting || draftWanted === null || !mesh.hasDrafts) return;
	const { text, of, since } = draftWanted;
	draftWanted = null;
	isDrafting = true;
	try {
		if (!drafts.isRunning) await drafts.call("open", { name: mesh.name, bytes: mesh.bytes.slice() });
		await drafts.call("remesh", { options: text + " --preset fast" });
		const shown = await drafts.call("shown", { key: "result", name: "gpremesh, draft" });
		if (finished < of && of <= change) {
			viewer.put(shown);
			record("draft", since);
			if (running === null) tell(`Draft of ${grouped(shown.faces)} faces after ${seconds(since)}.`);
		}
	} catch (error) {
		if (of === change) tellFailure(error);
	}
	isDrafting = false;
	tellEngines();
	draft();
}

// ---- results ----

async function showMeasured(key, name, of, more) {
	const shown = await results.call("measured", { key, name }, { signal: running.signal });
	if (of !== change) return;
	if (key === "result") viewer.setEndOfDistances(shown.figures.distance.p999Percent);
	viewer.put(shown);
	showFigures(key, name, { ...shown.figures, ...more });
}

async function makeResult(text, of) {
	const start = performance.now(), signal = running.signal;
	const report = await results.call("remesh", { options: text }, { signal, onProgress: showProgress });
	const took = seconds(start);
	record("result", start);
	const shown = await results.call("shown", { key: "result", name: "gpremesh" }, { signal });
	finished = of;
	viewer.put(shown);
	showNotes(report.notes);
	$("download").disabled = false;
	showProgress(0.9, "measuring");
	shownFigures.delete("result");
	shownFigures.delete("quadricEdgeCollapse");
	await showMeasured("result", "gpremesh", of, { seconds: took.replace(" s", "") });
	if ($("quadric").checked) {
		const quadric = "quadricEdgeCollapse", name = "Quadric Edge Collapse";
		const made = await results.call("collapse", { faces: shown.faces }, { signal, onProgress: (_, phrase) => showProgress(0.95, phrase) });
		await showMeasured(quadric, name, of, { seconds: made.seconds.toFixed(2) });
	}
	tell(`${grouped(shown.faces)} faces after ${took}.`);
}

async function finish(of) {
	stop();
	const mine = running = new AbortController();
	try {
		if (!results.isRunning) reopen();
		await reopened;
		await makeResult(optionsText(wishes()), of);
	} catch (error) {
		tellFailure(error);
	}
	tellEngines();
	if (running !== mine) return;
	running = null;
	showProgress(null);
}

// The call under way ends with its thread; a new thread opens the mesh again.
let reopened = null;

function stop() {
	clearTimeout(waiting);
	if (running === null) return;
	running.abort();
	running = null;
	showProgress(null);
	reopen();
}

function reopen() {
	reopened = results.call("open", { name: mesh.name, bytes: mesh.bytes.slice() });
	reopened.catch(() => {}); // the waiting caller reports the failure
}

function changed() {
	if (mesh === null) return;
	const of = ++change, given = wishes();
	stop();
	showCommands();
	$("download").disabled = true;
	// A search for an error bound takes many runs.
	if (!given.some(([row]) => row.option === "--max-error")) {
		draftWanted = { text: optionsText(given), of, since: performance.now() };
		draft();
	}
	waiting = setTimeout(() => finish(of), restAfter);
}

// ---- the mesh ----

async function open(name, bytes) {
	stop();
	draftWanted = null;
	const of = ++change;
	tell(`Opening ${name} ...`);
	try {
		reopened = null;
		const facts = await results.call("open", { name, bytes: bytes.slice() });
		if (of !== change) return;
		mesh = { name, bytes, facts, hasDrafts: facts.faces <= mostFacesOfDrafts };
		const input = await results.call("shownInput");
		if (of !== change) return;
		$("results").hidden = $("wishes").hidden = false;
		viewer.begin(input);
		shownFigures.clear();
		showFigures("input", name, input.figures);
		showNotes(facts.notes);
		$("format").value = /\.(ply|obj|stl|off|glb)$/i.exec(name)[1].toLowerCase();
		drafts.end(); // the next draft opens this mesh
		chooseSize();
		changed();
	} catch (error) {
		tellFailure(error);
		if (mesh !== null && of === change) { // reopens the mesh on the page
			reopen();
			$("download").disabled = true;
		}
	}
}

async function openFile(file) {
	if (!/\.(ply|obj|stl|off|glb)$/i.test(file.name)) return tell("The page reads PLY, OBJ, STL, OFF and GLB, and no other format.", true);
	if (file.size > mostBytes) return tell("Files above 1.5 GB are too large for the browser. Use the program gpremesh for this file.", true);
	return open(file.name, new Uint8Array(await file.arrayBuffer()));
}

// ---- saving ----

function offer(name, bytes) {
	const link = document.createElement("a");
	link.href = URL.createObjectURL(new Blob([bytes]));
	link.download = name;
	link.click();
	setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

async function save() {
	try {
		const { bytes, lost } = await results.call("save", { name: outName() });
		if (lost.length > 0) showNotes(["Not carried over: " + lost.join(", ") + "."]);
		offer(outName(), bytes);
	} catch (error) {
		tellFailure(error);
	}
}

// ---- start ----

function listen() {
	$("file").addEventListener("change", () => {
		if ($("file").files.length > 0) openFile($("file").files[0]);
		$("file").value = "";
	});
	for (const name of Object.keys(examples)) {
		const button = Object.assign(document.createElement("button"), { type: "button", textContent: name });
		button.addEventListener("click", () => open(name + ".ply", examples[name]()));
		$("examples").append(button, " ");
	}
	for (const event of ["dragover", "dragleave", "drop"]) {
		document.addEventListener(event, (e) => {
			e.preventDefault();
			document.body.classList.toggle("over", event === "dragover");
			if (event === "drop" && e.dataTransfer.files.length > 0) openFile(e.dataTransfer.files[0]);
		});
	}
	$("slider").addEventListener("input", () => {
		setNumber(10 * Math.exp($("slider").value / 1000 * range()));
		changed();
	});
	$("size").addEventListener("change", chooseSize);
	$("wishes").addEventListener("change", (event) => {
		if (event.target !== $("slider")) changed();
	});
	$("wishes").addEventListener("submit", (event) => event.preventDefault());
	$("cancel").addEventListener("click", () => {
		stop();
		draftWanted = null;
		finished = change; // nor is a draft shown
		tell("Cancelled.");
	});
	$("download").addEventListener("click", save);
	$("downloadInput").addEventListener("click", () => offer(mesh.name, mesh.bytes));
	$("format").addEventListener("change", showCommands);
}

try {
	const { version, parameters } = await results.call("table");
	table = parameters;
	$("version").textContent = version;
	tellEngines();
	makeRows();
	listen();
	tell("Drop a mesh here, open a file, or try an example.");
} catch (error) {
	tellFailure(error);
}
