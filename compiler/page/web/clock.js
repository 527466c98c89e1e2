// The time that the page shows: the one thing that plots, scene and controls have in common.

const speeds = [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];
const longestAtFirst = 30; // seconds that the whole motion takes at the speed that is set at first
const shortestAtFirst = 3;
const longestFrame = 1; // seconds: where frames are farther apart the page was out of sight, and has rested

export class Clock {
  #listeners = [];
  #last = undefined;

  constructor(first, last) {
    this.first = first;
    this.last = last;
    this.time = first;
    this.playing = false;
    this.speed = this.#comfortableSpeed();
  }

  get span() {
    return this.last - this.first;
  }

  get speeds() {
    return speeds;
  }

  /** Real time if the motion is neither over in a moment nor endless. */
  #comfortableSpeed() {
    if (this.span === 0) return 1;
    if (this.span > longestAtFirst) {
      return speeds.find((speed) => this.span / speed <= longestAtFirst) ?? speeds.at(-1);
    }
    return speeds.findLast((speed) => speed <= 1 && this.span / speed >= shortestAtFirst) ?? speeds[0];
  }

  /** `listener` is called after every change of time, speed or playing. */
  onChange(listener) {
    this.#listeners.push(listener);
  }

  #changed() {
    for (const listener of this.#listeners) listener(this);
  }

  seek(time) {
    this.time = Math.min(Math.max(time, this.first), this.last);
    this.#changed();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.#changed();
  }

  faster(steps) {
    const index = speeds.indexOf(this.speed) + steps;
    this.setSpeed(speeds[Math.min(Math.max(index, 0), speeds.length - 1)]);
  }

  play() {
    if (this.span <= 0) return;
    if (this.time >= this.last) this.time = this.first;
    this.playing = true;
    this.#last = undefined;
    this.#changed();
  }

  pause() {
    this.playing = false;
    this.#changed();
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }

  /** One frame at `now` (milliseconds); the motion starts again at its end. */
  advance(now) {
    if (!this.playing) return;
    if (this.#last !== undefined) {
      const time = this.time + Math.min((now - this.#last) / 1000, longestFrame) * this.speed;
      this.time = time <= this.last ? time : this.first;
    }
    this.#last = now;
    this.#changed();
  }
}
