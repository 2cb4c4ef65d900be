// Goes through the snapshots, one after another.
import { button } from "../shared/dom.js";

const FRAMES_PER_SECOND = 4;

export class Player {
  /** snapshot: Choice of a number below `count` */
  constructor(snapshot, count) {
    Object.assign(this, { snapshot, count, isPlaying: false });
    this.button = button("Play", () => this.toggle(), { "aria-pressed": "false", id: "play" });
  }

  toggle() {
    this.isPlaying = !this.isPlaying;
    clearTimeout(this.timer);
    this.button.textContent = this.isPlaying ? "Pause" : "Play";
    this.button.setAttribute("aria-pressed", String(this.isPlaying));
    if (!this.isPlaying) return;
    if (this.snapshot.value === this.count - 1) this.snapshot.set(0);
    this.awaitNext();
  }

  /** Counts from the picture of the last one, so that a slow machine shows them all. */
  awaitNext() {
    requestAnimationFrame(() => {
      clearTimeout(this.timer);
      if (this.isPlaying) this.timer = setTimeout(() => this.advance(), 1000 / FRAMES_PER_SECOND);
    });
  }

  advance() {
    if (this.snapshot.value + 1 < this.count) this.snapshot.set(this.snapshot.value + 1);
    if (this.snapshot.value + 1 >= this.count) this.toggle();
    else this.awaitNext();
  }
}
