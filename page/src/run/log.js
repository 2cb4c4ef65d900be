// The collision log at any zoom: stretches of bins, from coarse to every row.

/** One stretch of the log, columns as the program wrote them (src/report/log_digest.hpp). */
export class Stretch {
  /**
   * column: name => typed array;  about: {name, width, bins, last, pairs}
   *
   * pairs: [[i, j, collisions], ...], the most frequent ones of a log that is binned
   */
  constructor(about, column) {
    this.width = about.width;
    this.size = about.bins;
    this.last = about.last;
    const read = (name) => column(`${about.name}.${name}`);
    this.k = read("k");
    this.time = read("time");
    this.gapLow = read("gap_low");
    this.speedLow = read("speed_low");
    this.flags = read("flags");
    const single = about.width === 1;
    this.gapHigh = single ? this.gapLow : read("gap_high");
    this.speedHigh = single ? this.speedLow : read("speed_high");
    this.flightLow = single ? null : read("flight_low");
    this.flightHigh = single ? null : read("flight_high");
    this.hits = single ? null : read("hits");
    this.pairMask = about.pairs ? read("pairs") : null;
    this.pairs = about.pairs ?? null;
    this.i = single ? read("i") : null;
    this.j = single ? read("j") : null;
  }

  get first() {
    return this.k[0];
  }
  hitsIn(bin) {
    return this.hits ? this.hits[bin] : this.flags[bin] & 1;
  }

  /** The first bin whose collision number is at least `k`. */
  binFrom(k) {
    let low = 0,
      high = this.size;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.k[middle] < k) low = middle + 1;
      else high = middle;
    }
    return low;
  }
}

const lower = (a, b) => (b < a || Number.isNaN(a) ? b : a);
const higher = (a, b) => (b > a || Number.isNaN(a) ? b : a);

/** Bins `begin` to `end` of a stretch, put together in groups of `group`. */
function merged(stretch, begin, end, group) {
  const size = Math.ceil((end - begin) / group);
  const view = { width: stretch.width * group, stretch, begin, group, size };
  for (const name of [
    "k",
    "time",
    "flightLow",
    "flightHigh",
    "count",
    "gapLow",
    "gapHigh",
    "speedLow",
    "speedHigh",
    "hits",
    "flags",
  ]) {
    view[name] = new Float64Array(size);
  }
  for (let n = 0; n < size; ++n)
    fill(view, n, begin + n * group, Math.min(end, begin + (n + 1) * group));
  return view;
}

/** Shortest and longest time per collision in a bin; NaN where it is not known when it began. */
function flightsOf({ width, time, flightLow, flightHigh }, bin) {
  if (width > 1) return [flightLow[bin], flightHigh[bin]];
  const flight = bin === 0 ? NaN : time[bin] - time[bin - 1];
  return [flight, flight];
}

function fill(view, n, first, end) {
  const { stretch } = view;
  let [gapLow, gapHigh, speedLow, speedHigh, hits, flags] = [NaN, NaN, Infinity, -Infinity, 0, 0];
  let [flightLow, flightHigh] = [NaN, NaN];
  for (let bin = first; bin < end; ++bin) {
    gapLow = lower(gapLow, stretch.gapLow[bin]);
    gapHigh = higher(gapHigh, stretch.gapHigh[bin]);
    speedLow = lower(speedLow, stretch.speedLow[bin]);
    speedHigh = higher(speedHigh, stretch.speedHigh[bin]);
    const [shortest, longest] = flightsOf(stretch, bin);
    flightLow = lower(flightLow, shortest);
    flightHigh = higher(flightHigh, longest);
    hits += stretch.hitsIn(bin);
    flags |= stretch.flags[bin];
  }
  view.k[n] = stretch.k[first];
  view.time[n] = stretch.time[end - 1];
  view.count[n] = (end < stretch.size ? stretch.k[end] : stretch.last + 1) - stretch.k[first];
  [
    view.gapLow[n],
    view.gapHigh[n],
    view.speedLow[n],
    view.speedHigh[n],
    view.flightLow[n],
    view.flightHigh[n],
    view.hits[n],
    view.flags[n],
  ] = [gapLow, gapHigh, speedLow, speedHigh, flightLow, flightHigh, hits, flags];
}

export class Log {
  /** stretches: the first one covers the whole log, the others hold every row of a part */
  constructor(stretches) {
    this.stretches = stretches;
  }

  get isEmpty() {
    return this.stretches.length === 0;
  }
  get first() {
    return this.isEmpty ? 0 : this.stretches[0].first;
  }
  get last() {
    return this.isEmpty ? 1 : this.stretches[0].last;
  }

  /**
   * Collisions `first` to `last` in at most about `most` entries: extremes of gap, speed and time
   * per collision, the time after each entry, its hits and flags.
   */
  view(first, last, most) {
    if (this.isEmpty) return null;
    const covers = (stretch) => stretch.first <= first && stretch.last >= last;
    const stretch = this.stretches.slice(1).find(covers) ?? this.stretches[0];
    const begin = Math.max(0, stretch.binFrom(first + 1) - 1);
    const end = Math.max(begin + 1, stretch.binFrom(last + 1));
    const group = Math.max(1, Math.ceil((end - begin) / most));
    return merged(stretch, begin, Math.min(end, stretch.size), group);
  }
}
