// Light and dark. Colours of the page are CSS variables (style.css); those of signals and points are here, because
// plots and scene need them as values. Both sets stay apart for colour-blind eyes (after Okabe and Ito).

const signals = {
  light: ["#0072b2", "#d55e00", "#009e73", "#b0408a", "#a87400", "#2f9fd8", "#6b6b1f", "#5b5b5b"],
  dark: ["#56b4f0", "#ff8c4a", "#38c99b", "#e79ad0", "#efb93f", "#9bdcff", "#cfcb62", "#bdbdbd"],
};

export class Theme {
  #listeners = [];
  #probe = document.head.appendChild(document.createElement("meta"));
  #system = matchMedia("(prefers-color-scheme: dark)");

  constructor() {
    this.#system.addEventListener("change", () => this.#changed());
  }

  get scheme() {
    return document.documentElement.dataset.scheme ?? (this.#system.matches ? "dark" : "light");
  }

  toggle() {
    document.documentElement.dataset.scheme = this.scheme === "dark" ? "light" : "dark";
    this.#changed();
  }

  onChange(listener) {
    this.#listeners.push(listener);
  }

  #changed() {
    for (const listener of this.#listeners) listener(this);
  }

  /** A colour of style.css, such as "--ink", as the scheme in force makes it. */
  colour(name) {
    this.#probe.style.color = `var(${name})`;
    return getComputedStyle(this.#probe).color;
  }

  signal(index) {
    const colours = signals[this.scheme];
    return colours[index % colours.length];
  }

  /** Few points get colours that are told apart by name, many a gradient along their order. */
  point(index, count) {
    if (count <= signals.light.length) return this.signal(index);
    const hue = 250 - 215 * (index / (count - 1));
    return `hsl(${hue.toFixed(1)}, 62%, ${this.scheme === "dark" ? 64 : 45}%)`;
  }
}
