// How large the scene is, and where its middle and its ground are: computed once, so that nothing jumps while playing.
import { Vector3 } from "three";

const leastRelativeRadius = 1e-9; // of the distance from the origin, for scenes in which nothing moves

export class Extent {
  /** `scene` is the page's: dimension, up, points, rods, spheres. */
  constructor(motion, scene) {
    const anchors = scene.rods.filter((rod) => rod.anchor).map((rod) => rod.anchor);
    const ends = scene.spheres.flatMap(({ centre, radius }) => [-radius, radius].map((r) => centre.map((c) => c + r)));
    const { low, high } = motion.bounds([...anchors, ...ends]);
    this.flat = scene.dimension < 3;
    this.low = new Vector3(...low);
    this.high = new Vector3(...high);
    this.middle = this.low.clone().add(this.high).divideScalar(2);
    this.radius = this.high.distanceTo(this.low) / 2;
    if (!(this.radius > leastRelativeRadius * this.middle.length())) this.radius = this.middle.length() || 1;
    this.up = this.flat ? new Vector3(0, 0, 1) : new Vector3(...scene.up);
  }

  /** Height above the origin of the lowest point ever. */
  get floor() {
    return Math.min(this.low.dot(this.up), this.high.dot(this.up));
  }

  /** A way across `up`: so far along the two other axes. */
  across(first, second) {
    const one = new Vector3(this.up.y, this.up.z, this.up.x);
    const other = new Vector3().crossVectors(this.up, one);
    return one.multiplyScalar(first).addScaledVector(other, second);
  }

  /** 1, 2 or 5 times a power of ten: about `parts` of them make the scene. */
  spacing(parts) {
    const wish = (2 * this.radius) / parts;
    const power = 10 ** Math.floor(Math.log10(wish));
    return [1, 2, 5, 10].map((step) => step * power).find((step) => step >= wish);
  }
}
