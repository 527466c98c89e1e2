// Buttons, slider and keys.
import { clockText } from "./numbers.js";
import { nearestRow } from "./result.js";

const keyStep = 0.01; // of the whole motion, for an arrow key

export class Controls {
  constructor(root, clock, result) {
    Object.assign(this, { clock, times: result.times });
    this.playButton = root.querySelector("#play");
    this.slider = root.querySelector("#time");
    this.text = root.querySelector("#time-text");
    this.speed = root.querySelector("#speed");
    this.speed.append(...clock.speeds.map((speed) => new Option(`${speed}×`, speed)));

    this.playButton.addEventListener("click", () => clock.toggle());
    this.slider.addEventListener("input", () => clock.seek(clock.first + clock.span * this.slider.valueAsNumber));
    this.speed.addEventListener("change", () => clock.setSpeed(Number(this.speed.value)));
    clock.onChange(() => this.#show());
    this.#show();
  }

  #show() {
    const { clock } = this;
    this.playButton.dataset.playing = clock.playing;
    this.playButton.ariaLabel = clock.playing ? "pause" : "play";
    this.slider.value = clock.span > 0 ? (clock.time - clock.first) / clock.span : 0;
    this.slider.style.setProperty("--done", `${100 * this.slider.valueAsNumber}%`);
    this.text.value = clockText(clock.time, clock.span);
    this.speed.value = clock.speed;
  }

  /** One row on or back, or with `far` a hundredth of the motion. */
  step(direction, far) {
    const { clock, times } = this;
    clock.pause();
    if (far) {
      clock.seek(clock.time + direction * keyStep * clock.span);
    } else {
      const row = nearestRow(times, clock.time) + direction;
      clock.seek(times[Math.min(Math.max(row, 0), times.length - 1)]);
    }
  }
}

/** `actions` maps the key of a KeyboardEvent to what it does. Lists and the dialog keep their own keys. */
export function listenToKeys(actions) {
  const actionOf = (event) => {
    const isOthers = event.ctrlKey || event.metaKey || event.altKey || event.target.closest("select, dialog");
    return isOthers ? undefined : actions[event.key];
  };
  document.addEventListener("keydown", (event) => {
    const action = actionOf(event);
    if (!action) return;
    event.preventDefault();
    action(event);
  });
  // Firefox presses a focused button when the space bar is let go.
  document.addEventListener("keyup", (event) => actionOf(event) && event.preventDefault());
  // A list gives the keys back once something is chosen.
  document.addEventListener("change", (event) => event.target.closest("select")?.blur());
}
