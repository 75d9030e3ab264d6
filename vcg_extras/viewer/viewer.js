// SPDX-FileCopyrightText: 2026 the gpremesh authors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several meshes under one camera: for the page written by `gpremesh compare --html`, and for the page that remeshes.
// The root has the elements of viewer.html. All meshes have the frame of the input: its middle is the origin, the
// diagonal of its box is 1. Meshes have the format of mesh_json.h, with arrays as buffers or in base64.
"use strict";
/* exported makeViewer */
function makeViewer(root, page) {

const viewAngleDeg = 30;
const slope = Math.tan(viewAngleDeg * Math.PI / 360);
const farthest = 20;          // of the camera from its target, in diagonals
const barNum = 40;            // of a histogram
const spotWidth = 10;         // width of the view round a spot, in lengths of its triangle
// From good to bad; each colour is darker than the colour before, so that the order is visible in grey, too.
const ramp = [[.93, .95, .97], [.99, .83, .62], [.96, .56, .35], [.80, .20, .14], [.42, 0, .05]];
const plain = [.80, .86, .95];

const find = (selector) => root.querySelector(selector);
const tools = find(".tools").elements;
const meshes = [];

const grouped = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, ",");

function bytesOf(text) {
	if (typeof text !== "string") return text;
	const characters = atob(text);
	const bytes = new Uint8Array(characters.length);
	for (let i = 0; i < bytes.length; ++i) bytes[i] = characters.charCodeAt(i);
	return bytes.buffer;
}

// The measures for colours and histograms: a value for each triangle, and the ends of the colours.
const measures = {
	quality: {
		values: (mesh) => mesh.quality, good: 1, bad: 0,
		from: "2r/R: 1, equilateral", to: "0, degenerate",
	},
	distance: {
		values: (mesh) => mesh.isMeasured ? mesh.distance : [], good: 0,
		get bad() { return page.endOfDistances || 1e-9; },
		from: "0", get to() { return "\u2265 " + page.endOfDistances.toPrecision(2) + " % of the diagonal"; },
	},
};

function takeMesh(given) {
	const mesh = { ...given };
	mesh.positions = new Float32Array(bytesOf(mesh.positions));
	mesh.triangles = new Uint32Array(bytesOf(mesh.triangles));
	mesh.quality = new Float32Array(bytesOf(mesh.quality));
	// The input has distance 0 from itself.
	mesh.isMeasured = mesh.distance !== undefined || mesh.key === "input";
	mesh.distance = mesh.distance ? new Float32Array(bytesOf(mesh.distance)) : new Float32Array(mesh.shown);
	mesh.isDecimated = mesh.shown < mesh.faces && mesh.faces > page.mostShown;
	return mesh;
}

// ---- drawing ----

const vertexShader = `
attribute vec3 corner;
attribute float quality, farness;
uniform float good, bad;
uniform bool byQuality;
varying vec3 vCorner, vView;
varying float vShare;
void main() {
	vec4 view = modelViewMatrix * vec4(position, 1.0);
	vCorner = corner;
	vView = view.xyz;
	vShare = clamp(((byQuality ? quality : farness) - good) / (bad - good), 0.0, 1.0);
	gl_Position = projectionMatrix * view;
}`;

// Light comes from behind the camera and from above. Edges of small triangles are faint: opaque edges would cover the
// surface.
const fragmentShader = `
uniform vec3 ramp[${ramp.length}];
uniform vec3 plain;
uniform bool coloured, edges;
varying vec3 vCorner, vView;
varying float vShare;
void main() {
	vec3 normal = normalize(cross(dFdx(vView), dFdy(vView)));
	vec3 colour = plain;
	if (coloured) {
		colour = ramp[0];
		for (int i = 1; i < ${ramp.length}; ++i)
			colour = mix(colour, ramp[i], clamp(vShare * ${ramp.length - 1}.0 - float(i - 1), 0.0, 1.0));
	}
	float light = 0.32 + 0.45 * abs(normal.z) + 0.28 * max(dot(normal, vec3(0.40, 0.75, 0.53)), 0.0);
	colour *= light * (gl_FrontFacing ? 1.0 : 0.62);
	if (edges) {
		vec3 width = fwidth(vCorner);
		vec3 away = smoothstep(vec3(0.0), 1.3 * width, vCorner);
		float pixels = 1.0 / max(width.x, max(width.y, width.z));
		float line = 1.0 - min(away.x, min(away.y, away.z));
		colour = mix(colour, vec3(0.08), 0.85 * line * clamp((pixels - 1.5) / 4.0, 0.0, 1.0));
	}
	gl_FragColor = vec4(colour, 1.0);
}`;

// Three vertices for each triangle: the vertices have the triangle's values, and tell the places of its edges.
function geometryOf(mesh) {
	const num = mesh.triangles.length;
	const positions = new Float32Array(3 * num), corners = new Uint8Array(3 * num);
	const quality = new Float32Array(num), distance = new Float32Array(num);
	for (let i = 0; i < num; ++i) {
		for (let k = 0; k < 3; ++k) positions[3 * i + k] = mesh.positions[3 * mesh.triangles[i] + k];
		corners[3 * i + i % 3] = 255;
		quality[i] = mesh.quality[Math.floor(i / 3)];
		distance[i] = mesh.distance[Math.floor(i / 3)];
	}
	const geometry = new THREE.BufferGeometry();
	geometry.setAttribute("position", new THREE.BufferAttribute(positions, 3));
	geometry.setAttribute("corner", new THREE.BufferAttribute(corners, 3, true));
	geometry.setAttribute("quality", new THREE.BufferAttribute(quality, 1));
	geometry.setAttribute("farness", new THREE.BufferAttribute(distance, 1));
	return geometry;
}

const camera = new THREE.PerspectiveCamera(viewAngleDeg, 1, .01, 10);
const target = new THREE.Vector3();
const material = new THREE.ShaderMaterial({
	vertexShader, fragmentShader, side: THREE.DoubleSide, extensions: { derivatives: true },
	uniforms: {
		ramp: { value: ramp.map((c) => new THREE.Vector3(...c)) }, plain: { value: new THREE.Vector3(...plain) },
		good: { value: 1 }, bad: { value: 0 }, byQuality: { value: true },
		coloured: { value: true }, edges: { value: true },
	},
});
let spot = null;              // the place marked in all views
let isDrawWanted = false;
const panels = [];

function wantDraw() {
	if (isDrawWanted) return;
	isDrawWanted = true;
	requestAnimationFrame(() => {
		isDrawWanted = false;
		drawAll();
	});
}

function drawAll() {
	const distance = camera.position.distanceTo(target);
	camera.near = Math.max(distance - 2, distance * .02);
	camera.far = distance + 2;
	camera.lookAt(target);
	camera.updateProjectionMatrix();
	camera.updateMatrixWorld();
	for (const panel of panels) drawPanel(panel);
}

function drawPanel(panel) {
	const size = Math.round(panel.canvas.clientWidth);
	if (size === 0) return; // not shown
	const ratio = Math.min(window.devicePixelRatio || 1, 2);
	if (panel.size !== size * ratio) {
		panel.size = size * ratio;
		panel.renderer.setPixelRatio(ratio);
		panel.renderer.setSize(size, size, false);
	}
	const isWiped = tools.wipe.checked && panel === panels[0] && panels.length > 1;
	const share = isWiped ? tools.line.value / 100 : 1;
	drawPart(panel.renderer, panel.scene, size, 0, share);
	if (isWiped) drawPart(panel.renderer, panels[1].scene, size, share, 1);
	panel.mark.hidden = spot === null;
	if (spot === null) return;
	const at = spot.clone().project(camera);
	panel.mark.style.left = 50 * (1 + at.x) + "%";
	panel.mark.style.top = 50 * (1 - at.y) + "%";
}

// The part of a view between two shares of its width.
function drawPart(renderer, scene, size, from, to) {
	renderer.setScissorTest(true);
	renderer.setScissor(from * size, 0, (to - from) * size, size);
	renderer.render(scene, camera);
}

// ---- the camera ----

const axes = () => {
	const right = new THREE.Vector3(), up = new THREE.Vector3(), back = new THREE.Vector3();
	camera.matrixWorld.extractBasis(right, up, back);
	return { right, up, back };
};

// Shows the whole first mesh, by the same rule as in the still pictures.
function showWhole() {
	const back = new THREE.Vector3(.35, .25, 1).normalize();
	const right = new THREE.Vector3(0, 1, 0).cross(back).normalize();
	const up = back.clone().cross(right);
	const p = new THREE.Vector3(), positions = meshes[0].positions;
	let away = 0;
	for (let i = 0; i < positions.length; i += 3) {
		p.set(positions[i], positions[i + 1], positions[i + 2]);
		if (p.length() > 1) continue; // unused by faces
		away = Math.max(away, p.dot(back) + Math.max(Math.abs(p.dot(right)), Math.abs(p.dot(up))) / slope);
	}
	spot = null;
	target.set(0, 0, 0);
	camera.up.copy(up);
	camera.position.copy(back).multiplyScalar(1.04 * away);
	wantDraw();
}

function turn(across, down) {
	const { right, up } = axes();
	const turned = new THREE.Quaternion().setFromAxisAngle(up, -across)
		.multiply(new THREE.Quaternion().setFromAxisAngle(right, -down));
	camera.position.sub(target).applyQuaternion(turned).add(target);
	camera.up.copy(up).applyQuaternion(turned);
	wantDraw();
}

// Moves the view by shares of its height.
function move(across, down) {
	const { right, up } = axes();
	const height = 2 * slope * camera.position.distanceTo(target);
	const way = right.multiplyScalar(-across * height).add(up.multiplyScalar(down * height));
	camera.position.add(way);
	target.add(way);
	wantDraw();
}

function comeNearer(factor) {
	const offset = camera.position.clone().sub(target);
	offset.setLength(Math.min(Math.max(offset.length() / factor, 1e-4), farthest));
	camera.position.copy(target).add(offset);
	wantDraw();
}

const isPlace = (place) => place && place.at.every((x) => Number.isFinite(x));

// Looks at a place from outside, near enough to show its triangle.
function lookAt(place) {
	const normal = new THREE.Vector3(...place.normal);
	const back = normal.length() > .5 ? normal : camera.position.clone().sub(target).normalize();
	const away = Math.max(spotWidth * place.size, 1e-3) / (2 * slope);
	target.set(...place.at);
	spot = target.clone();
	if (Math.abs(back.dot(camera.up)) > .99) camera.up.copy(axes().back);
	camera.position.copy(target).addScaledVector(back, away);
	wantDraw();
}

function listenToPointers(canvas) {
	const pointers = new Map();
	const middle = () => {
		const [a, b] = [...pointers.values()];
		return b ? { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2, apart: Math.hypot(a.x - b.x, a.y - b.y) } : { ...a, apart: 0 };
	};
	canvas.addEventListener("pointerdown", (event) => {
		canvas.setPointerCapture(event.pointerId);
		pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
	});
	canvas.addEventListener("pointermove", (event) => {
		if (!pointers.has(event.pointerId)) return;
		const before = middle();
		pointers.set(event.pointerId, { x: event.clientX, y: event.clientY });
		const now = middle(), size = canvas.clientWidth;
		const across = (now.x - before.x) / size, down = (now.y - before.y) / size;
		if (pointers.size > 1 || event.shiftKey || (event.buttons & 6)) move(across, down);
		else turn(across * Math.PI, down * Math.PI);
		if (before.apart > 0 && now.apart > 0) comeNearer(now.apart / before.apart);
	});
	for (const end of ["pointerup", "pointercancel"])
		canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
	canvas.addEventListener("contextmenu", (event) => event.preventDefault());
	canvas.addEventListener("wheel", (event) => {
		event.preventDefault();
		comeNearer(Math.exp(-.002 * (event.deltaMode === 1 ? 16 * event.deltaY : event.deltaY)));
	}, { passive: false });
}

const keys = {
	ArrowLeft: () => turn(-.1, 0), ArrowRight: () => turn(.1, 0), ArrowUp: () => turn(0, -.1),
	ArrowDown: () => turn(0, .1), "+": () => comeNearer(1.2), "-": () => comeNearer(1 / 1.2),
};

function listenToKeys(canvas) {
	canvas.addEventListener("keydown", (event) => {
		if (!keys[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
		event.preventDefault();
		keys[event.key]();
	});
}

// ---- the panels ----

function element(name, className, parent, text) {
	const made = document.createElement(name);
	made.className = className;
	if (text !== undefined) made.textContent = text;
	parent.appendChild(made);
	return made;
}

function listMeshes(panel) {
	panel.chooser.textContent = "";
	for (const mesh of meshes) {
		const option = element("option", "", panel.chooser, mesh.name);
		option.value = mesh.key;
	}
	panel.chooser.value = panel.key;
}

function makePanel(key) {
	const box = element("div", "panel", find(".panels"));
	const panel = { box, chooser: element("select", "", box), scene: new THREE.Scene() };
	panel.chooser.setAttribute("aria-label", "mesh of this view");
	panel.key = key;
	listMeshes(panel);
	panel.count = element("div", "count", box);
	const frame = element("div", "frame", box);
	panel.canvas = element("canvas", "", frame);
	panel.canvas.tabIndex = 0;
	panel.mark = element("div", "mark", frame);
	panel.histogram = element("div", "histogram", box);
	panel.spots = element("div", "spots", box);
	// The drawing is kept, so that the browser can save the drawing as a picture.
	panel.renderer = new THREE.WebGLRenderer({ canvas: panel.canvas, antialias: true, preserveDrawingBuffer: true });
	panel.renderer.setClearColor(0xffffff);
	panel.chooser.addEventListener("change", () => {
		panel.key = panel.chooser.value;
		fillPanel(panel);
		showValues();
	});
	listenToPointers(panel.canvas);
	listenToKeys(panel.canvas);
	panels.push(panel);
	fillPanel(panel);
}

function spotButton(panel, label, place) {
	if (!isPlace(place)) return;
	const button = element("button", "", panel.spots, label);
	button.type = "button";
	button.addEventListener("click", () => lookAt(place));
}

function fillPanel(panel) {
	for (const old of panel.scene.children) old.geometry.dispose();
	panel.scene.children.length = 0;
	const mesh = panel.mesh = meshes.find((m) => m.key === panel.key);
	panel.box.hidden = mesh === undefined;
	if (mesh === undefined) return;
	const drawn = new THREE.Mesh(geometryOf(mesh), material);
	drawn.frustumCulled = false;
	panel.scene.add(drawn);
	panel.count.textContent = grouped(mesh.faces) + " triangles" +
		(mesh.isDecimated ? ", drawn with " + grouped(mesh.shown) : "") +
		(mesh.isMeasured ? "" : ", distances not measured yet");
	panel.canvas.setAttribute("aria-label", mesh.name);
	panel.spots.textContent = "";
	if (mesh.worst) spotButton(panel, "worst triangle: 2r/R " + mesh.worst.value.toFixed(3), mesh.worst);
	if (mesh.farthest) {
		spotButton(panel, "largest distance: " + mesh.farthest.value.toPrecision(3) + " %", mesh.farthest);
	}
}

// Shares of the triangles, from good to bad.
function sharesOf(mesh, measure) {
	const shares = new Array(barNum).fill(0), values = measure.values(mesh);
	for (const value of values) {
		const share = (value - measure.good) / (measure.bad - measure.good);
		++shares[Math.min(Math.max(Math.floor(share * barNum), 0), barNum - 1)];
	}
	return shares.map((num) => num / Math.max(values.length, 1));
}

function colourAt(share) {
	const at = share * (ramp.length - 1), i = Math.min(Math.floor(at), ramp.length - 2);
	const mixed = ramp[i].map((c, k) => Math.round(255 * (c + (at - i) * (ramp[i + 1][k] - c))));
	return "rgb(" + mixed.join(",") + ")";
}

function drawHistogram(panel, measure) {
	const shares = panel.mesh === undefined ? [] : sharesOf(panel.mesh, measure), highest = Math.max(...shares, 1e-9);
	const bars = shares.map((share, i) => {
		const height = 60 * share / highest, colour = colourAt((i + .5) / barNum);
		return `<rect x="${i}" y="${60 - height}" width=".9" height="${height}" fill="${colour}"
			stroke="#777" stroke-width=".5" vector-effect="non-scaling-stroke"/>`;
	});
	const svg = panel.mesh === undefined ? "" : `<svg viewBox="0 0 ${barNum} 60" preserveAspectRatio="none" role="img"
		aria-label="histogram from ${measure.from} to ${measure.to}">${bars.join("")}</svg>`;
	panel.histogram.innerHTML = svg;
}

// Colours, legend and histograms, as chosen in the tools.
function showValues() {
	const measure = measures[tools.colour.value], uniforms = material.uniforms;
	uniforms.coloured.value = measure !== undefined;
	uniforms.edges.value = tools.edges.checked;
	find(".legend").style.visibility = measure ? "visible" : "hidden";
	if (measure) {
		uniforms.byQuality.value = measure === measures.quality;
		uniforms.good.value = measure.good;
		uniforms.bad.value = measure.bad;
		find(".legend .from").textContent = measure.from;
		find(".legend .to").textContent = measure.to;
		for (const panel of panels) drawHistogram(panel, measure);
	}
	for (const panel of panels) panel.histogram.hidden = !measure;
	find(".decimated").hidden = !meshes.some((mesh) => mesh.isDecimated);
	find(".panels").classList.toggle("wiped", tools.wipe.checked && panels.length > 1);
	tools.line.hidden = !tools.wipe.checked;
	find(".panels").style.setProperty("--line", tools.line.value + "%");
	wantDraw();
}

// Adds a mesh, or replaces the mesh with the same key.
function put(given) {
	const mesh = takeMesh(given), at = meshes.findIndex((m) => m.key === mesh.key);
	if (at < 0) meshes.push(mesh);
	else meshes[at] = mesh;
	for (const panel of panels) {
		listMeshes(panel);
		if (panel.key === mesh.key) fillPanel(panel);
	}
	showValues();
}

// Removes all meshes but the input.
function begin(input) {
	meshes.length = 0;
	for (const panel of panels) fillPanel(panel);
	put(input);
	showWhole();
}

function setEndOfDistances(percent) {
	page.endOfDistances = percent;
	showValues();
}

function start() {
	meshes.push(...page.meshes.map(takeMesh));
	find(".legend .ramp").style.background =
		"linear-gradient(to right," + ramp.map((_, i) => colourAt(i / (ramp.length - 1))).join(",") + ")";
	page.panels.forEach(makePanel);
	find(".most").textContent = grouped(page.mostShown);
	for (const tool of [tools.colour, tools.edges, tools.wipe]) tool.addEventListener("change", showValues);
	tools.line.addEventListener("input", showValues);
	tools.reset.addEventListener("click", showWhole);
	new ResizeObserver(wantDraw).observe(find(".panels"));
	showValues();
	if (meshes.length > 0) showWhole();
}

function complain(error) {
	find(".complaint").textContent = "The views cannot be drawn: " + error.message;
	find(".complaint").hidden = false;
	find(".tools").hidden = find(".panels").hidden = find(".help").hidden = true;
}

try {
	start();
	return { put, begin, setEndOfDistances };
} catch (error) {
	complain(error); // no WebGL, as a rule
	return { put() {}, begin() {}, setEndOfDistances() {} };
}

}
