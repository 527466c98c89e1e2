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

function segments(points, colour) {
  const geometry = new BufferGeometry().setAttribute("position", new Float32BufferAttribute(points, 3));
  const lines = new LineSegments(geometry, new LineBasicMaterial());
  lines.colour = colour;
  return lines;
}

export class Ground {
  constructor(extent, dimension) {
    this.extent = extent;
    this.group = new Group();
    this.spacing = extent.spacing(extent.flat ? squaresInPlane : squaresInSpace);
    this.lines = [];
    if (extent.flat) {
      this.#addPaper(dimension);
      this.#addPaperAxes(dimension);
    } else {
      this.#addFloor();
      this.#addSpaceAxes();
    }
  }

  /** A square grid of `reach` squares to each side of (x, y), in multiples of the spacing; z = 0. */
  #grid(x, y, reach) {
    const step = this.spacing;
    const [left, low] = [Math.round(x / step) - reach, Math.round(y / step) - reach];
    const points = [];
    for (let i = 0; i <= 2 * reach; ++i) {
      points.push((left + i) * step, low * step, 0, (left + i) * step, (low + 2 * reach) * step, 0);
      points.push(left * step, (low + i) * step, 0, (left + 2 * reach) * step, (low + i) * step, 0);
    }
    return this.#add(segments(points, "--grid-line"));
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
    floor.add(this.#grid(middle.x, middle.y, reach));
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
    const paper = this.#grid(extent.middle.x, extent.middle.y, reach);
    paper.position.z = -extent.radius;
    this.group.add(paper);
    for (let axis = 0; axis < dimension; ++axis) {
      const first = Math.round(extent.middle.getComponent(axis) / spacing) - reach;
      for (let mark = first; mark <= first + 2 * reach; ++mark) {
        if (mark !== 0 || dimension === 1) this.#addMark(axis, mark * spacing);
      }
    }
  }

  #addMark(axis, value) {
    const mark = label(brief(value, this.spacing), axis === 0 ? "mark below" : "mark beside");
    mark.position.setComponent(axis, value);
    this.group.add(mark);
  }

  /** Through the whole paper and under what moves, named at the edge of the first view. */
  #addPaperAxes(dimension) {
    const { middle, radius } = this.extent;
    for (let axis = 0; axis < dimension; ++axis) {
      const tip = new Vector3().setComponent(axis, middle.length() + 5 * radius);
      const name = new Vector3().setComponent(axis, middle.getComponent(axis) + 1.12 * radius);
      this.#addAxis(axis, tip.clone().negate(), tip, name, "--axis").position.z = -radius / 2;
    }
  }

  /** From the origin where that is near the scene, else from the scene's corner. */
  #addSpaceAxes() {
    const { middle, radius, low } = this.extent;
    const origin = middle.length() < 2.5 * radius ? new Vector3() : low;
    for (let axis = 0; axis < 3; ++axis) {
      const tip = origin.clone().setComponent(axis, origin.getComponent(axis) + axisOfScene * radius);
      this.#addAxis(axis, origin, tip, tip.clone().lerp(origin, -0.08), axis);
    }
  }

  /** `colour` is a variable of style.css, or the number of a signal's colour. */
  #addAxis(axis, tail, tip, nameAt, colour) {
    const name = label("xyz"[axis], "axis");
    name.position.copy(nameAt);
    const line = this.#add(segments([...tail.toArray(), ...tip.toArray()], colour));
    this.group.add(line, name);
    return line;
  }

  paint(theme) {
    for (const { material, colour } of this.lines) {
      material.color.set(typeof colour === "number" ? theme.signal(colour) : theme.colour(colour));
    }
    if (this.shadow) this.shadow.material.opacity = theme.scheme === "dark" ? 0.45 : 0.16;
  }
}
