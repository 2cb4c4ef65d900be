// The spheres of the snapshots in their sheared cell, and the controls of the view.
import { bonds, Cell, length, NEAR } from "./cell.js";
import { BLUE, rgb, VERMILION } from "../shared/colours.js";
import { button, element } from "../shared/dom.js";
import { grouped, short } from "../shared/format.js";
import { acrossThe, captionOf, groupsOf, unwrapped } from "./groups.js";
import { Player } from "./player.js";
import { fileStem, saveMenu } from "../shared/save.js";
import { Stage } from "./stage.js";
import { colouringsOf, tintsOf } from "./tints.js";

const DOT = [0.25, 0.25, 0.12],
  FULL = 0.5; // radii, diameters; dots in one to three dimensions
const MOST_NAMES = 60,
  MOST_NAMED_PAIRS = 4;
const AXES = { shear: ["x: flow", "y: gradient", "z: vorticity"], none: ["x", "y", "z"] };

export class SphereView {
  /** frames: {positions, speeds, collisions};  snapshot: Choice of a number in run.snapshots.shown */
  constructor(run, frames, snapshot) {
    Object.assign(this, { run, frames, snapshot, groups: groupsOf(run) });
    this.colourings = colouringsOf(run, frames);
    this.stage = new Stage(run.spheres, run.dimension < 3);
    this.state = {
      colour: "speed",
      group: this.groups[0]?.id ?? "",
      show: this.groups.length ? "dots" : "all",
      isNamed: true,
    };
    this.box = element("div", { class: "sphere-view" }, this.stage.box, this.controls());
    snapshot.listen(() => this.update());
    this.lookAtCell();
    this.update();
  }

  get shown() {
    return this.run.snapshots.shown;
  }
  get group() {
    return this.groups.find(({ id }) => id === this.state.group);
  }

  cell(frame) {
    const D = this.run.dimension;
    const edges = this.run.snapshots.box_edges.slice(frame * D * D, (frame + 1) * D * D);
    return new Cell(edges, D, this.run.values.walls);
  }

  /** Position of a sphere in a frame, in the slanted cell. */
  place(cell, frame, n) {
    const { dimension: D, spheres: N } = this.run;
    const at = (frame * N + n) * D;
    return cell.slant([0, 1, 2].map((d) => (d < D ? this.frames.positions[at + d] : 0)));
  }

  controls() {
    this.slider = element("input", {
      type: "range",
      min: 0,
      max: this.shown.length - 1,
      value: 0,
      id: "snapshot",
      oninput: () => this.snapshot.set(Number(this.slider.value)),
    });
    const player = new Player(this.snapshot, this.shown.length);
    this.moment = element("output", { for: "snapshot" });
    this.legend = element("div", { class: "legend" });
    this.caption = element("p", { class: "caption", role: "status" });
    const colours = Object.entries(this.colourings).map(([id, { name }]) => [id, name]);
    return element(
      "div",
      { class: "controls" },
      element(
        "div",
        { class: "row" },
        player.button,
        element("label", { for: "snapshot" }, "Snapshot"),
        this.slider,
        this.moment,
        this.saveMenu(),
      ),
      element("div", { class: "row" }, this.select("colour", "Colour", colours), this.legend),
      this.groupControls(),
      this.caption,
    );
  }

  saveMenu() {
    const stem = () => fileStem(this.run.name, "snapshot", this.shown[this.snapshot.value] + 1);
    return saveMenu("this view", stem, { png: () => this.stage.picture() });
  }

  select(key, label, options) {
    const made = element(
      "select",
      { id: `spheres-${key}`, onchange: () => this.change(key, made.value) },
      ...options.map(([value, text]) =>
        element("option", { value, selected: value === this.state[key] }, text),
      ),
    );
    return element("span", {}, element("label", { for: `spheres-${key}` }, label), made);
  }

  groupControls() {
    if (!this.groups.length) return "";
    const ways = [
      ["all", "in its place"],
      ["dots", "others as dots"],
      ["alone", "alone"],
      ["moment", "alone, exactly as found"],
    ];
    const radios = ways.map(([value, text]) =>
      element(
        "label",
        {},
        element("input", {
          type: "radio",
          name: "show",
          value,
          checked: value === this.state.show,
          onchange: () => this.change("show", value),
        }),
        text,
      ),
    );
    const named = element("input", {
      type: "checkbox",
      checked: true,
      onchange: () => this.change("isNamed", named.checked),
    });
    return element(
      "fieldset",
      {},
      element("legend", {}, "Single out"),
      element(
        "div",
        { class: "row" },
        this.select(
          "group",
          "",
          this.groups.map(({ id, name }) => [id, name]),
        ),
      ),
      element(
        "div",
        { class: "row" },
        ...radios,
        element("label", {}, named, "numbers"),
        button("Reset view", () => this.reset()),
      ),
    );
  }

  change(key, value) {
    this.state[key] = value;
    if (key === "show" || key === "group") this.reset();
    this.update();
  }

  /** Looks at what is shown, as at the beginning. */
  reset() {
    const { show } = this.state;
    if (show === "alone" || show === "moment") this.lookAtGroup();
    else this.lookAtCell();
  }

  lookAtCell() {
    const cell = this.cell(this.snapshot.value);
    this.stage.lookAt(cell.corners(), 1);
  }

  lookAtGroup() {
    const places = [...this.placesOfGroup().values()];
    this.stage.lookAt(places, 1, acrossThe(places));
  }

  get isMoment() {
    return this.state.show === "moment" && this.group?.places !== undefined;
  }

  /** sphere => place: exact at the moment it was found, else unwrapped from this snapshot. */
  placesOfGroup() {
    if (this.isMoment) return this.group.places(this.run.dimension);
    const frame = this.snapshot.value;
    const cell = this.cell(frame);
    const at = (sphere) => this.place(cell, frame, sphere);
    return unwrapped(this.group, cell, at, this.run.spheres);
  }

  update() {
    const frame = this.snapshot.value,
      cell = this.cell(frame);
    const isCellShown = this.state.show === "all" || this.state.show === "dots";
    if (isCellShown) this.showCell(cell, frame);
    else this.showGroup(cell);
    this.slider.value = String(frame);
    const at = this.shown[frame],
      { step, time } = this.run.snapshots;
    this.moment.textContent = `${at + 1} of ${step.length}: collision ${grouped(step[at])}, time ${short(time[at], 5)}`;
    this.slider.setAttribute("aria-valuetext", this.moment.textContent);
    this.caption.textContent = captionOf(this.run, this.group, isCellShown, this.isMoment);
    this.stage.draw();
  }

  showCell(cell, frame) {
    const { spheres } = this.stage,
      { state, group, run } = this;
    const members = new Set(group?.spheres),
      inPair = new Set(group?.pairs.flat());
    const tint = this.tints(frame);
    for (let n = 0; n < run.spheres; ++n) {
      const isMember = members.has(n);
      spheres.centre.set(cell.drawn(this.place(cell, frame, n)), 3 * n);
      spheres.radius[n] = isMember || state.show === "all" ? this.radius(n) : DOT[run.dimension - 1];
      spheres.ring[n] = inPair.has(n) ? 1 : 0;
      spheres.tint.set(isMember ? rgb(inPair.has(n) ? VERMILION : BLUE) : tint(n), 3 * n);
    }
    spheres.show(run.spheres);
    const at = (sphere) => this.place(cell, frame, sphere);
    this.stage.setLines(cell.edges());
    this.showNetwork(cell, at);
    this.nameAll((sphere) => cell.drawn(at(sphere)), cell);
  }

  /** True radius of a sphere. */
  radius(n) {
    return this.run.grains?.radii[n] ?? FULL;
  }

  showGroup(cell) {
    const { spheres } = this.stage,
      { group } = this;
    const inPair = new Set(group.pairs.flat());
    const places = this.placesOfGroup();
    [...places].forEach(([sphere, at], n) => {
      spheres.centre.set(at, 3 * n);
      spheres.radius[n] = this.radius(sphere);
      spheres.ring[n] = inPair.has(sphere) ? 1 : 0;
      spheres.tint.set(rgb(inPair.has(sphere) ? VERMILION : BLUE), 3 * n);
    });
    spheres.show(places.size);
    this.stage.setLines([]);
    this.showNetwork(null, (sphere) => places.get(sphere) ?? [NaN, NaN, NaN]);
    this.nameAll((sphere) => places.get(sphere), null);
  }

  showNetwork(cell, at) {
    if (!this.group) return this.stage.bonds.set([]);
    const isRepeating = ([i, j]) => this.group.pairs.some(([a, b]) => a === i && b === j);
    const drawn = (line) => (cell ? line.map((end) => cell.drawn(end)) : line);
    const tubes = (contacts, radius, colour) =>
      bonds(cell, at, contacts, this.run.spheres)
        .map(drawn)
        .filter(([a, b]) => length(a.map((x, n) => b[n] - x)) < NEAR)
        .map((line) => ({ line, radius, colour }));
    const [pairs, others] = [[], []];
    for (const contact of this.group.contacts)
      (isRepeating(contact) ? pairs : others).push(contact);
    this.stage.bonds.set([...tubes(others, 0.06, "#ffffff"), ...tubes(pairs, 0.11, "#f0e442")]);
  }

  /** Numbers of the group's spheres, and names of the axes. */
  nameAll(at, cell) {
    const names = [];
    if (this.state.isNamed && this.group) {
      const inPair = new Set(
        this.group.pairs.length <= MOST_NAMED_PAIRS ? this.group.pairs.flat() : [],
      );
      for (const sphere of this.group.spheres.slice(0, MOST_NAMES)) {
        names.push({
          text: String(sphere),
          at: at(sphere),
          kind: inPair.has(sphere) ? "pair" : "sphere",
        });
      }
    }
    const axes = AXES[this.run.values.drive] ?? AXES.none;
    const edges = cell ? cell.edgesByAxis() : [];
    this.stage.setNames(
      names,
      edges.map((parallel, d) => ({ text: axes[d], edges: parallel, centre: cell.centre() })),
    );
  }

  /** The colour of each sphere in a frame; the legend tells it. */
  tints(frame) {
    const { tint, parts } = tintsOf(this.colourings[this.state.colour], frame, this.run.spheres);
    this.legend.replaceChildren(...parts);
    return tint;
  }
}
