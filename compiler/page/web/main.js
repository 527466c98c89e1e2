// The page: reads its data, makes its parts and joins them by the clock.
import "./style.css";
import { Clock } from "./clock.js";
import { Controls, listenToKeys } from "./controls.js";
import { Figures } from "./figures.js";
import { Motion } from "./motion.js";
import { readResult } from "./result.js";
import { trailLengths } from "./scene/trails.js";
import { View } from "./scene/view.js";
import { Theme } from "./theme.js";

const element = (id) => document.getElementById(id);

const result = readResult(element("data"));
const theme = new Theme();
const clock = new Clock(result.times[0], result.times.at(-1));
const motion = new Motion(result);
const controls = new Controls(element("controls"), clock, result);
const figures = new Figures(element("figures"), result, clock, theme);
const view = makeView();

/** Nothing where there is nothing to see, or the browser cannot draw it; the figures do without. */
function makeView() {
  const stage = element("stage");
  if (motion.count === 0) {
    stage.remove();
    return null;
  }
  try {
    return new View(stage, result, motion, clock, theme);
  } catch (error) {
    stage.dataset.problem = `This browser cannot draw the scene: ${error.message}`;
    return null;
  }
}

function nextTrails() {
  const select = element("trails");
  select.selectedIndex = (select.selectedIndex + 1) % select.length;
  select.dispatchEvent(new Event("change"));
}

if (view) {
  const names = result.scene.points.map(({ name }) => name);
  const mark = (title) => view.mark(names.indexOf(title));
  figures.onChoice(mark);
  mark(result.figures[figures.chosen].title);
  view.onPick = (point) => figures.chooseTitle(names[point]);
  const trails = element("trails");
  trails.append(...Object.keys(trailLengths).map((text) => new Option(text)));
  trails.selectedIndex = 1;
  trails.addEventListener("change", () => view.setTrails(trailLengths[trails.value]));
  element("squares").textContent = `squares of ${view.spacing}`;
  element("from-start").addEventListener("click", () => view.lookFromStart());
}

element("scheme").addEventListener("click", () => theme.toggle());
element("about-button").addEventListener("click", () => element("about").showModal());
listenToKeys({
  " ": () => clock.toggle(),
  ArrowRight: (event) => controls.step(1, !event.shiftKey),
  ArrowLeft: (event) => controls.step(-1, !event.shiftKey),
  ArrowUp: () => clock.faster(1),
  ArrowDown: () => clock.faster(-1),
  Home: () => clock.seek(clock.first),
  End: () => clock.seek(clock.last),
  t: () => view && nextTrails(),
  r: () => view?.lookFromStart(),
  z: () => figures.zoom(null),
  d: () => theme.toggle(),
  "?": () => element("about").showModal(),
});

function frame(now) {
  clock.advance(now);
  view?.render();
  requestAnimationFrame(frame);
}
requestAnimationFrame(frame);

/** For tests and for curious people: README.md in compiler/page tells what it has. */
window.mbcc = {
  result,
  positions: () => view?.drawnPositions() ?? [],
  onScreen: () => view?.screenPositions() ?? [],
  time: () => clock.time,
  seek: (time) => clock.seek(time),
  playing: () => clock.playing,
  shown: () => figures.range,
};
