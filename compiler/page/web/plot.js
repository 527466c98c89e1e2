// One panel: its signals over time, with the values at a time beside their names.
import uPlot from "uplot";
import { brief, exact, powerOfTen } from "./numbers.js";
import { nearestRow } from "./result.js";

const mostDecadeMarks = 6;
const clickTravel = 4; // pixels between press and release that still make a click, not a zoom

/** Axis ends around values from `low` to `high`: with some air; what is constant but for rounding stays flat. */
function sensibleRange(plot, low, high) {
  if (low === null || high === null) return [-1, 1];
  const size = Math.max(Math.abs(low), Math.abs(high));
  const flat = high - low <= 1e-12 * size;
  const air = flat ? size / 2 || 1 : 0.06 * (high - low);
  return [low - air, high + air];
}

/** Whole powers of ten around the values. */
function decades(plot, low, high) {
  if (low === null || high === null) return [1e-16, 1];
  const first = Math.floor(Math.log10(low));
  const last = Math.max(Math.ceil(Math.log10(high)), first + 1);
  return [10 ** first, 10 ** last];
}

/** The powers of ten to mark between two others, every second or third one where they are many. */
function decadeMarks(plot, axis, low, high) {
  const [first, last] = [low, high].map((value) => Math.round(Math.log10(value)));
  const step = Math.ceil((last - first) / mostDecadeMarks);
  const marks = [];
  for (let exponent = last; exponent >= first; exponent -= step) marks.unshift(10 ** exponent);
  return marks;
}

/** What can be drawn of a signal, on a logarithmic axis its size; with gaps where there is nothing to draw. */
function drawable(values, logarithmic) {
  const size = (value) => (logarithmic ? Math.abs(value) || null : value);
  return Array.from(values, (value) => (Number.isFinite(value) ? size(value) : null));
}

export class Plot {
  #listeners = { zoom: () => {}, time: () => {} };
  #hovered = null;

  /** `panel` is {title, logarithmic, columns: [index]}; `range` the [from, to] of time that is shown. */
  constructor(container, panel, result, theme, range) {
    this.times = result.times;
    this.columns = panel.columns.map((column) => result.columns[column]);
    this.logarithmic = panel.logarithmic;
    this.root = document.createElement("section");
    this.root.className = "panel";
    this.root.append(this.#heading(panel.title, theme));
    this.canvas = this.root.appendChild(document.createElement("div"));
    this.canvas.className = "plot";
    container.append(this.root);

    const data = [this.times, ...this.columns.map(({ values }) => drawable(values, this.logarithmic))];
    this.plot = new uPlot(this.#options(theme, range), data, this.canvas);
    this.line = this.plot.over.appendChild(document.createElement("div"));
    this.line.className = "time-line";
    this.#listenToPointer();
    this.observer = new ResizeObserver(() => this.#resize());
    this.observer.observe(this.canvas);
  }

  /** `listener` of "zoom" gets [from, to] or null for all, that of "time" the time that was pointed to. */
  on(event, listener) {
    this.#listeners[event] = listener;
  }

  #heading(title, theme) {
    const heading = document.createElement("header");
    heading.append(Object.assign(document.createElement("h3"), { textContent: title }));
    this.values = this.columns.map(({ name }, index) => {
      const entry = heading.appendChild(document.createElement("span"));
      entry.className = "signal";
      entry.style.setProperty("--signal", theme.signal(index));
      entry.append(Object.assign(document.createElement("b"), { textContent: name }));
      return entry.appendChild(document.createElement("output"));
    });
    return heading;
  }

  #options(theme, [from, to]) {
    const axis = {
      stroke: theme.colour("--quiet"),
      grid: { stroke: theme.colour("--grid"), width: 1 },
      ticks: { stroke: theme.colour("--grid"), width: 1, size: 4 },
      font: "11px system-ui, sans-serif",
    };
    const values = (plot, marks, axis, space, step) => marks.map((mark) => brief(mark, step));
    const size = 64;
    const upright = this.logarithmic
      ? {
          ...axis,
          size,
          splits: decadeMarks,
          filter: (plot, marks) => marks,
          values: (plot, marks) => marks.map(powerOfTen),
        }
      : { ...axis, size, values };
    return {
      width: 400,
      height: 120,
      legend: { show: false },
      padding: [8, 12, 0, 0],
      cursor: { sync: { key: "mbcc" }, drag: { x: true, y: false, setScale: false }, points: { size: 6 } },
      scales: {
        x: { time: false, min: from, max: to },
        y: this.logarithmic ? { distr: 3, range: decades } : { range: sensibleRange },
      },
      axes: [{ ...axis, size: 26, values }, upright],
      series: [
        {},
        ...this.columns.map(({ name }, index) => ({
          label: name,
          stroke: theme.signal(index),
          width: 1.6,
          pxAlign: 0, // of curves, unlike of lines of the grid, rounding to pixels makes stairs
          points: { show: this.times.length === 1 },
        })),
      ],
      hooks: {
        setSelect: [(plot) => this.#selected(plot)],
        setCursor: [(plot) => this.#hover(plot)],
        draw: [() => this.#placeLine()],
      },
    };
  }

  #listenToPointer() {
    const { over } = this.plot;
    let pressedAt = 0;
    over.addEventListener("mousedown", (event) => (pressedAt = event.clientX));
    over.addEventListener("click", (event) => {
      if (Math.abs(event.clientX - pressedAt) <= clickTravel) this.#listeners.time(this.#timeUnder(event));
    });
    over.addEventListener("dblclick", () => this.#listeners.zoom(null));
    over.addEventListener("wheel", (event) => this.#wheel(event), { passive: false });

    const axis = this.plot.root.querySelector(".u-axis"); // the first one is that of time: it can be dragged along
    const follow = (event) => axis.hasPointerCapture(event.pointerId) && this.#listeners.time(this.#timeUnder(event));
    axis.classList.add("time-axis");
    axis.addEventListener("pointerdown", (event) => {
      axis.setPointerCapture(event.pointerId);
      follow(event);
    });
    axis.addEventListener("pointermove", follow);
  }

  #timeUnder(event) {
    return this.plot.posToVal(event.clientX - this.plot.over.getBoundingClientRect().left, "x");
  }

  /** Zooms around the pointer; sideways it moves what is shown. */
  #wheel(event) {
    event.preventDefault();
    const { min, max } = this.plot.scales.x;
    const sideways = ((max - min) * event.deltaX) / this.plot.over.clientWidth;
    const factor = Math.exp(event.deltaY / 500);
    const centre = this.#timeUnder(event);
    this.#listeners.zoom([
      centre - (centre - min) * factor + sideways,
      centre + (max - centre) * factor + sideways,
    ]);
  }

  #selected(plot) {
    const { left, width } = plot.select;
    if (width > clickTravel) this.#listeners.zoom([plot.posToVal(left, "x"), plot.posToVal(left + width, "x")]);
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  }

  /** The row under the pointer, over this panel or a neighbour's; else the values are those at the page's time. */
  #hover(plot) {
    this.#hovered = plot.cursor.left >= 0 ? plot.cursor.idx : null;
    this.#showValues();
  }

  #showValues() {
    const row = this.#hovered ?? nearestRow(this.times, this.time ?? this.times[0]);
    this.values.forEach((output, index) => (output.value = exact(this.columns[index].values[row])));
  }

  #placeLine() {
    if (this.time === undefined || !this.line) return;
    const { min, max } = this.plot.scales.x;
    this.line.hidden = this.time < min || this.time > max;
    this.line.style.transform = `translateX(${this.plot.valToPos(this.time, "x")}px)`;
  }

  showTime(time) {
    this.time = time;
    this.#placeLine();
    if (this.#hovered === null) this.#showValues();
  }

  zoom([min, max]) {
    this.plot.setScale("x", { min, max });
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (width > 0 && height > 0) this.plot.setSize({ width, height });
  }

  remove() {
    this.observer.disconnect();
    this.plot.destroy();
    this.root.remove();
  }
}
