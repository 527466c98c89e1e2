// The way that each point came: a line that fades into the background.
import { Color, Group } from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";

const piecesOfAll = 3000; // shared by the points
const mostPieces = 600;
const fewestPieces = 24;
const recent = 0.12; // of the whole motion

/** Trails to choose from, with the part of the motion that they show. */
export const trailLengths = { "no trails": 0, "short trails": recent, "whole trails": 1 };

export class Trails {
  #place = [0, 0, 0];

  constructor(motion, clock) {
    Object.assign(this, { motion, clock, group: new Group(), length: recent });
    this.pieces = Math.min(Math.max(Math.round(piecesOfAll / motion.count), fewestPieces), mostPieces);
    this.lines = Array.from({ length: motion.count }, () => this.#addLine());
  }

  #addLine() {
    const geometry = new LineGeometry();
    geometry.setPositions(new Float32Array(3 * (this.pieces + 1)));
    const line = new Line2(geometry, new LineMaterial({ linewidth: 2, vertexColors: true }));
    line.frustumCulled = false;
    this.group.add(line);
    return line;
  }

  paint(theme) {
    const paper = new Color(theme.colour("--stage"));
    const mixed = new Color();
    this.lines.forEach((line, index) => {
      const colour = new Color(theme.point(index, this.motion.count));
      const colours = [];
      for (let piece = 0; piece <= this.pieces; ++piece) {
        const freshness = (piece / this.pieces) ** 1.3;
        colours.push(...mixed.lerpColors(paper, colour, 0.08 + 0.8 * freshness).toArray());
      }
      line.geometry.setColors(colours);
    });
  }

  setLength(length) {
    this.length = length;
    this.group.visible = length > 0;
  }

  place(time) {
    if (!this.group.visible) return;
    const start = Math.max(time - this.length * this.clock.span, this.clock.first);
    this.lines.forEach((line, index) => {
      const ends = line.geometry.attributes.instanceStart.data; // x, y, z of both ends of each piece
      for (let mark = 0; mark <= this.pieces; ++mark) {
        this.motion.positionOf(index, start + ((time - start) * mark) / this.pieces, this.#place, 0);
        if (mark < this.pieces) ends.array.set(this.#place, 6 * mark);
        if (mark > 0) ends.array.set(this.#place, 6 * mark - 3);
      }
      ends.needsUpdate = true;
    });
  }
}
