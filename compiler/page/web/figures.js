// The figures: a row of buttons, and the panels of the chosen one, which share their range of time.
import { Plot } from "./plot.js";

const fewestRowsShown = 4; // how far one can zoom in

export class Figures {
  #plots = [];
  #listeners = [];

  constructor(root, result, clock, theme) {
    Object.assign(this, { result, clock, theme });
    const rests = clock.span > 0 ? 0 : 0.5; // a result of one row is shown with some time around it
    this.whole = [clock.first - rests, clock.last + rests];
    this.range = this.whole;
    this.buttons = this.#addButtons(root.querySelector("nav"));
    this.panels = root.querySelector(".panels");
    clock.onChange(() => this.#showTime());
    theme.onChange(() => this.choose(this.chosen));
    this.choose(0);
  }

  /** `listener` gets the title of the figure that was chosen. */
  onChoice(listener) {
    this.#listeners.push(listener);
  }

  #addButtons(nav) {
    return this.result.figures.map(({ title }, index) => {
      const button = nav.appendChild(document.createElement("button"));
      button.textContent = title;
      button.addEventListener("click", () => this.choose(index));
      return button;
    });
  }

  chooseTitle(title) {
    const index = this.result.figures.findIndex((figure) => figure.title === title);
    if (index >= 0) this.choose(index);
  }

  choose(index) {
    this.chosen = index;
    this.#plots.forEach((plot) => plot.remove());
    const figure = this.result.figures[index];
    this.buttons.forEach((button, other) => button.setAttribute("aria-pressed", other === index));
    this.buttons[index].scrollIntoView({ block: "nearest", inline: "nearest" });
    this.#plots = figure.panels.map((panel) => this.#addPlot(panel));
    this.#showTime();
    for (const listener of this.#listeners) listener(figure.title);
  }

  #addPlot(panel) {
    const plot = new Plot(this.panels, panel, this.result, this.theme, this.range);
    plot.on("zoom", (range) => this.zoom(range));
    plot.on("time", (time) => this.clock.seek(time));
    return plot;
  }

  /** Shows [from, to] of time in all panels, all of it for null. */
  zoom(range) {
    const [first, last] = this.whole;
    const [from, to] = range ? [Math.max(range[0], first), Math.min(range[1], last)] : this.whole;
    const least = ((last - first) / this.result.times.length) * fewestRowsShown;
    if (to - from < Math.min(least, last - first)) return;
    this.range = [from, to];
    this.#plots.forEach((plot) => plot.zoom(this.range));
    this.#showTime();
  }

  #showTime() {
    this.#plots.forEach((plot) => plot.showTime(this.clock.time));
  }
}
