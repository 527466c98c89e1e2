// Where the points of the scene are at any time.
import { rowBefore } from "./result.js";

/** Position at the fraction s of a step h, from values and rates at both ends: cubic Hermite. */
function hermite(s, h, p0, v0, p1, v1) {
  const r = 1 - s;
  return r * r * (1 + 2 * s) * p0 + s * s * (1 + 2 * r) * p1 + h * s * r * (r * v0 - s * v1);
}

export class Motion {
  constructor(result) {
    this.times = result.times;
    this.points = result.scene.points.map(({ position, velocity }) => ({
      position: position.map((column) => result.columns[column].values),
      velocity: velocity.map((column) => result.columns[column].values),
    }));
  }

  get count() {
    return this.points.length;
  }

  /** Writes x, y, z of point `index` at `time` to `target` from `offset`; axes that the model lacks stay zero. */
  positionOf(index, time, target, offset) {
    const row = Math.min(rowBefore(this.times, time), this.times.length - 2);
    const { position, velocity } = this.points[index];
    for (let axis = 0; axis < position.length; ++axis) {
      target[offset + axis] = this.#between(position[axis], velocity[axis], Math.max(row, 0), time);
    }
  }

  #between(values, rates, row, time) {
    const h = this.times[row + 1] - this.times[row];
    if (!(h > 0)) return values[row]; // a result of one row
    const s = Math.min(Math.max((time - this.times[row]) / h, 0), 1);
    if (s === 0 || s === 1) return values[row + s];
    return rates
      ? hermite(s, h, values[row], rates[row], values[row + 1], rates[row + 1])
      : (1 - s) * values[row] + s * values[row + 1];
  }

  /** x, y, z of all points one after the other. */
  positionsAt(time, target = new Float64Array(3 * this.count)) {
    for (let index = 0; index < this.count; ++index) this.positionOf(index, time, target, 3 * index);
    return target;
  }

  /** Smallest and largest x, y, z over the whole motion and the given further places. */
  bounds(places) {
    const low = [0, 1, 2].map(() => Infinity);
    const high = [0, 1, 2].map(() => -Infinity);
    const include = (axis, value) => {
      if (!Number.isFinite(value)) return;
      low[axis] = Math.min(low[axis], value);
      high[axis] = Math.max(high[axis], value);
    };
    for (const { position } of this.points) {
      for (let axis = 0; axis < 3; ++axis) {
        for (const value of position[axis] ?? [0]) include(axis, value);
      }
    }
    for (const place of places) place.forEach((value, axis) => include(axis, value));
    return { low, high };
  }
}
