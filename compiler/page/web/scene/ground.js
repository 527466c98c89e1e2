// The ground in space or the squared paper of the plane, the axes, and their names.
import {
  BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Mesh, PlaneGeometry, ShadowMaterial,
  Vector3,
} from "three";
import { CSS2DObject } from "three/addons/renderers/CSS2DRenderer.js";
import { brief } from "../numbers.js";

const squaresInSpace = 14; // about so many across the scene
const squaresInPlane = 6;
const axisOfScene = 0.32; // length of an axis, by the radius of the scene

export function label(text, kind) {
  const element = Object.assign(document.createElement("span"), { textContent: text, className: `label ${kind}` });
  return new CSS2DObject(element);
}

function segments(points, variable) {
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial());
  lines.variable = variable;
  return lines;
}

export class Ground {
  constructor(extent, dimension) {
    this.extent = extent;
    this.group = new Group();
    this.spacing = extent.spacing(extent.flat ? squaresInPlane : squaresInSpace);
    this.lines = [];
    if (extent.flat) this.#addPaper(dimension);
    else this.#addFloor();
    this.#addAxes(dimension);
  }

  /** A square grid of `reach` squares to each side of (x, y), in multiples of the spacing; z = 0. */
  #grid(x, y, reach, variable) {
    const step = this.spacing;
    const [left, low] = [Math.round(x / step) - reach, Math.round(y / step) - reach];
    const points = [];
    for (let i = 0; i <= 2 * reach; ++i) {
      points.push((left + i) * step, low * step, 0, (left + i) * step, (low + 2 * reach) * step, 0);
      points.push(left * step, (low + i) * step, 0, (left + 2 * reach) * step, (low + i) * step, 0);
    }
    return this.#add(segments(points, variable));
  }

  #add(lines) {
    this.lines.push(lines);
    return lines;
  }

  /** In space: a grid under the lowest point, on which shadows fall. */
  #addFloor() {
    const { extent } = this;
    const floor = new Group();
    floor.quaternion.setFromUnitVectors(new Vector3(0, 0, 1), extent.up);
    const middle = extent.middle.clone().applyQuaternion(floor.quaternion.clone().invert());
    const reach = Math.ceil((1.5 * extent.radius) / this.spacing);
    floor.add(this.#grid(middle.x, middle.y, reach, "--grid-line"));
    this.shadow = new Mesh(new PlaneGeometry(8 * extent.radius, 8 * extent.radius), new ShadowMaterial());
    this.shadow.position.set(middle.x, middle.y, 0);
    this.shadow.receiveShadow = true;
    floor.add(this.shadow);
    floor.position.copy(extent.up).multiplyScalar(extent.floor - 0.08 * extent.radius);
    this.group.add(floor);
  }

  /** In the plane: squares as far as one pans, with their coordinates along the axes. */
  #addPaper(dimension) {
    const { extent, spacing } = this;
    const reach = Math.ceil((4 * extent.radius) / spacing);
    const paper = this.#grid(extent.middle.x, extent.middle.y, reach, "--grid-line");
    paper.position.z = -extent.radius;
    this.group.add(paper);
    for (let axis = 0; axis < dimension; ++axis) {
      const first = Math.round(extent.middle.getComponent(axis) / spacing) - reach;
      for (let mark = first; mark <= first + 2 * reach; ++mark) {
        if (mark !== 0) this.#addMark(axis, mark * spacing);
      }
    }
  }

  #addMark(axis, value) {
    const mark = label(brief(value), axis === 0 ? "mark below" : "mark beside");
    mark.position.setComponent(axis, value);
    this.group.add(mark);
  }

  /** From the origin where that is in the scene, else from its corner; in the plane through the whole paper. */
  #addAxes(dimension) {
    const { extent } = this;
    const near = extent.middle.length() < 2.5 * extent.radius;
    const origin = near || extent.flat ? new Vector3() : extent.low;
    for (let axis = 0; axis < Math.max(dimension, extent.flat ? 1 : 3); ++axis) {
      const length = (extent.flat ? 5 : axisOfScene) * extent.radius + (extent.flat ? extent.middle.length() : 0);
      const tip = origin.clone().setComponent(axis, origin.getComponent(axis) + length);
      const tail = extent.flat ? tip.clone().negate() : origin;
      this.group.add(this.#add(segments([...tail.toArray(), ...tip.toArray()], extent.flat ? "--axis" : axis)));
      const name = label("xyz"[axis], "axis");
      const end = extent.flat ? this.#visibleEnd(axis) : tip.clone().lerp(origin, -0.08);
      name.position.copy(end);
      this.group.add(name);
    }
  }

  #visibleEnd(axis) {
    const { extent } = this;
    return new Vector3().setComponent(axis, extent.middle.getComponent(axis) + 1.12 * extent.radius);
  }

  paint(theme) {
    for (const { material, variable } of this.lines) {
      material.color.set(typeof variable === "number" ? theme.signal(variable) : theme.colour(variable));
    }
    if (this.shadow) this.shadow.material.opacity = theme.scheme === "dark" ? 0.45 : 0.16;
  }
}
