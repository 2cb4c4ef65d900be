// The 3-D view without its meaning: canvas, camera, lines and names, drawn when something changes.
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { element } from "../shared/dom.js";
import { besideOutline, paintName } from "./names.js";
import { Spheres } from "./spheres.js";

const LEAST_NAMED = 12; // pixels a diameter: numbers of smaller spheres would hide them
const TURN = Math.PI / 24; // of one arrow key
const NAME_ROOM = 30; // pixels around what is shown, for the names of the axes
const BESIDE = 0.6; // diameters from the centre of a sphere to its number

export class Stage {
  /** most: spheres at once;  isFlat: seen from above, not turned */
  constructor(most, isFlat) {
    this.isFlat = isFlat;
    this.canvas = element("canvas", {
      tabindex: "0",
      role: "img",
      "aria-label": "Spheres of the run. Arrow keys turn, plus and minus zoom, 0 shows everything.",
      onkeydown: (event) => this.key(event),
    });
    this.names = element("div", { class: "names", "aria-hidden": "true" });
    this.box = element("div", { class: "stage" }, this.canvas, this.names);
    this.renderer = new THREE.WebGLRenderer({
      canvas: this.canvas,
      antialias: true,
      preserveDrawingBuffer: true,
    }); // so that it is printed
    this.renderer.setPixelRatio(Math.min(devicePixelRatio, 2));
    this.renderer.setClearColor(0xffffff);
    this.scene = new THREE.Scene();
    this.camera = new THREE.OrthographicCamera();
    this.spheres = new Spheres(most, isFlat);
    this.lines = lineSet(0x5b6773, {});
    this.bonds = tubeSet();
    this.scene.add(this.spheres.mesh, this.lines, this.bonds.mesh);
    this.controls = new OrbitControls(this.camera, this.canvas);
    this.controls.enableRotate = !isFlat;
    if (isFlat) this.controls.mouseButtons.LEFT = THREE.MOUSE.PAN;
    this.controls.addEventListener("change", () => this.draw());
    this.labels = [];
    this.axes = [];
    new ResizeObserver(() => this.resize()).observe(this.box);
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.box;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.frame();
  }

  /**
   * Looks at all of some places, as far as `margin` around them.
   *
   * direction: from where; else from the front, a little from the right and from above
   */
  lookAt(places, margin, direction = [0.45, 0.3, 1]) {
    const centre = [0, 1, 2].map((d) => {
      const column = places.map((at) => at[d]);
      return (
        (column.reduce((a, b) => Math.min(a, b)) + column.reduce((a, b) => Math.max(a, b))) / 2
      );
    });
    const radius =
      margin +
      places.reduce(
        (most, at) => Math.max(most, Math.hypot(...at.map((x, d) => x - centre[d]))),
        0,
      );
    this.home = { places, margin, direction, radius };
    const from = new THREE.Vector3(...(this.isFlat ? [0, 0, 1] : direction)).normalize();
    this.controls.target.set(...centre);
    this.camera.position.copy(this.controls.target).addScaledVector(from, radius * 4);
    this.camera.zoom = 1;
    this.controls.update();
    this.frame();
  }

  frame() {
    if (!this.home) return;
    const [width, height] = [this.box.clientWidth, this.box.clientHeight].map((side) =>
      Math.max(side, 4 * NAME_ROOM),
    );
    const aspect = width / height;
    this.camera.updateMatrixWorld();
    const seen = this.home.places.map((at) =>
      new THREE.Vector3(...at).applyMatrix4(this.camera.matrixWorldInverse),
    );
    const reach = (axis) =>
      this.home.margin + seen.reduce((most, at) => Math.max(most, Math.abs(at[axis])), 0);
    const part = (side) => 1 - (2 * NAME_ROOM) / side;
    const size = Math.max(reach("y") / part(height), reach("x") / aspect / part(width)),
      wide = size * aspect;
    Object.assign(this.camera, {
      left: -wide,
      right: wide,
      top: size,
      bottom: -size,
      near: 0.01 * this.home.radius,
      far: 8 * this.home.radius,
    });
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** Draws with the next picture of the screen. */
  draw() {
    if (this.isWaiting) return;
    this.isWaiting = true;
    requestAnimationFrame(() => {
      this.isWaiting = false;
      this.camera.updateMatrixWorld();
      this.spheres.follow(this.camera);
      this.renderer.render(this.scene, this.camera);
      this.placeNames();
    });
  }

  /**
   * names: [{text, at, kind}] of spheres
   * axes: [{text, edges: [[from, to], ...], centre}], one of the edges gets the name
   */
  setNames(names, axes) {
    const made = (text, kind) => element("span", { class: kind }, text);
    this.labels = names.map(({ text, at, kind }) => ({ at, made: made(text, kind) }));
    this.axes = axes.map((axis) => ({ ...axis, made: made(axis.text, "axis") }));
    this.names.replaceChildren(...[...this.labels, ...this.axes].map(({ made: name }) => name));
  }

  get pixelsPerLength() {
    return (this.box.clientHeight / 2 / this.camera.top) * this.camera.zoom;
  }

  /** Where a place is seen, pixels from the upper left corner. */
  seen(at) {
    const { x, y } = new THREE.Vector3(...at).project(this.camera);
    return [((x + 1) / 2) * this.box.clientWidth, ((1 - y) / 2) * this.box.clientHeight];
  }

  placeNames() {
    const { pixelsPerLength } = this;
    for (const { at, made } of this.labels) {
      const [x, y] = this.seen(at);
      made.hidden = made.className === "sphere" && pixelsPerLength < LEAST_NAMED;
      made.style.left = `${x + BESIDE * pixelsPerLength}px`;
      made.style.top = `${y}px`;
    }
    for (const axis of this.axes) {
      const place = besideOutline(
        axis.edges.map((edge) => edge.map((end) => this.seen(end))),
        this.seen(axis.centre),
        pixelsPerLength / 2 + axis.made.offsetHeight / 2 + 3,
      );
      axis.made.hidden = place === null;
      if (!place) continue;
      axis.made.style.left = `${place.x}px`;
      axis.made.style.top = `${place.y}px`;
      axis.made.style.rotate = `${place.angle}rad`;
    }
  }

  /** What is seen, with its names, on a canvas of at least two pixels for each of the screen's. */
  picture() {
    const { clientWidth: width, clientHeight: height } = this.box;
    const before = this.renderer.getPixelRatio(),
      scale = Math.max(2, before);
    this.renderer.setPixelRatio(scale);
    this.renderer.setSize(width, height, false);
    this.renderer.render(this.scene, this.camera);
    const canvas = element("canvas", { width: width * scale, height: height * scale });
    const ctx = canvas.getContext("2d");
    ctx.drawImage(this.canvas, 0, 0);
    ctx.scale(scale, scale);
    const shown = [...this.axes, ...this.labels].filter(({ made }) => !made.hidden);
    for (const { made } of shown) paintName(ctx, made);
    this.renderer.setPixelRatio(before);
    this.renderer.setSize(width, height, false);
    this.draw();
    return canvas;
  }

  key(event) {
    const turn = (x, y) => () => this.turn(x * TURN, y * TURN);
    const actions = {
      ArrowLeft: turn(-1, 0),
      ArrowRight: turn(1, 0),
      ArrowUp: turn(0, 1),
      ArrowDown: turn(0, -1),
      "+": () => this.zoom(1.25),
      "=": () => this.zoom(1.25),
      "-": () => this.zoom(0.8),
      0: () => this.lookAt(this.home.places, this.home.margin, this.home.direction),
    };
    if (!actions[event.key] || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    actions[event.key]();
  }

  turn(around, up) {
    if (this.isFlat) return;
    const { target } = this.controls;
    const seen = new THREE.Spherical().setFromVector3(this.camera.position.clone().sub(target));
    seen.theta += around;
    seen.phi = Math.min(Math.max(seen.phi - up, 0.01), Math.PI - 0.01);
    this.camera.position.setFromSpherical(seen).add(target);
    this.controls.update();
    this.draw();
  }

  zoom(factor) {
    this.camera.zoom *= factor;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  /** pairs: [[from, to], ...], thin lines */
  setLines(pairs) {
    this.lines.geometry.dispose();
    this.lines.geometry = new THREE.BufferGeometry();
    this.lines.geometry.setAttribute(
      "position",
      new THREE.Float32BufferAttribute(pairs.flat(2), 3),
    );
  }
}

function lineSet(colour) {
  return new THREE.LineSegments(
    new THREE.BufferGeometry(),
    new THREE.LineBasicMaterial({ color: colour }),
  );
}

const MOST_TUBES = 4096;

/** Tubes between places, drawn over everything, so that a network inside spheres is seen. */
function tubeSet() {
  const shape = new THREE.CylinderGeometry(1, 1, 1, 8).rotateX(Math.PI / 2);
  const material = new THREE.MeshBasicMaterial({ depthTest: false, transparent: true });
  const mesh = new THREE.InstancedMesh(shape, material, MOST_TUBES);
  mesh.renderOrder = 1;
  mesh.frustumCulled = false;
  mesh.count = 0;
  const tube = new THREE.Object3D(),
    colour = new THREE.Color();
  /** tubes: [{line: [from, to], radius, colour}] */
  const set = (tubes) => {
    mesh.count = Math.min(tubes.length, MOST_TUBES);
    tubes.slice(0, MOST_TUBES).forEach(({ line: [from, to], radius, colour: tint }, n) => {
      const [a, b] = [new THREE.Vector3(...from), new THREE.Vector3(...to)];
      tube.position.copy(a).add(b).multiplyScalar(0.5);
      tube.lookAt(b);
      tube.scale.set(radius, radius, a.distanceTo(b));
      tube.updateMatrix();
      mesh.setMatrixAt(n, tube.matrix);
      mesh.setColorAt(n, colour.set(tint));
    });
    mesh.instanceMatrix.needsUpdate = true;
    if (mesh.instanceColor) mesh.instanceColor.needsUpdate = true;
  };
  return { mesh, set };
}
