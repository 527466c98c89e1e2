// Points as balls, rods between them, what they hang from, and the spheres that they are kept on.
import {
  BackSide, BoxGeometry, Color, CylinderGeometry, DynamicDrawUsage, Group, InstancedMesh, Matrix4, Mesh,
  MeshBasicMaterial, MeshStandardMaterial, Quaternion, RingGeometry, SphereGeometry, Vector3,
} from "three";

const ballOfScene = 0.034; // radius of a ball, by that of the scene
const ballOfRod = 0.16; // and at most, by the length of the shortest rod
const rodOfBall = 0.27;
const ballOfCrowd = 0.3; // and at most, over the root of the number of balls

const alongRod = new Vector3(0, 0, 1);

function material(flat, settings) {
  return flat ? new MeshBasicMaterial(settings) : new MeshStandardMaterial({ roughness: 0.45, ...settings });
}

export class Bodies {
  #matrix = new Matrix4();
  #from = new Vector3();
  #to = new Vector3();
  #turn = new Quaternion();
  #size = new Vector3();

  constructor(result, motion, extent) {
    this.rods = result.scene.rods;
    this.motion = motion;
    this.group = new Group();
    this.radius = this.#ballRadius(extent);

    this.balls = this.#instances(new SphereGeometry(this.radius, 32, 20), extent.flat, motion.count);
    const thickness = rodOfBall * this.radius;
    const rod = new CylinderGeometry(thickness, thickness, 1, 14).rotateX(Math.PI / 2);
    this.bars = this.#instances(rod, extent.flat, this.rods.length);
    this.pins = this.#pins(extent);
    this.spheres = result.scene.spheres.map((sphere) => this.#sphere(sphere, extent.flat));
    // Only its far side: it stands around the ball, not before it.
    this.halo = new Mesh(
      new SphereGeometry(1.5 * this.radius, 32, 20),
      new MeshBasicMaterial({ transparent: true, opacity: 0.3, depthWrite: false, side: BackSide }),
    );
    this.halo.visible = false;
    this.group.add(this.halo);
  }

  #ballRadius(extent) {
    const lengths = this.rods.map(({ length }) => length);
    return Math.min(
      ballOfScene * extent.radius,
      ballOfRod * Math.min(...lengths, Infinity),
      (ballOfCrowd * extent.radius) / Math.sqrt(this.motion.count || 1),
    );
  }

  #instances(geometry, flat, count) {
    const mesh = new InstancedMesh(geometry, material(flat, {}), count);
    mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    mesh.frustumCulled = false;
    mesh.castShadow = true;
    this.group.add(mesh);
    return mesh;
  }

  /** One small block for each place that rods hang from. */
  #pins(extent) {
    const places = new Map(this.rods.filter((rod) => rod.anchor).map((rod) => [String(rod.anchor), rod.anchor]));
    const size = 1.5 * this.radius;
    return [...places.values()].map((place) => {
      const pin = new Mesh(new BoxGeometry(size, size, extent.flat ? 0 : size), material(extent.flat, {}));
      pin.position.set(...place);
      pin.castShadow = true;
      this.group.add(pin);
      return pin;
    });
  }

  #sphere({ centre, radius }, flat) {
    const geometry = flat
      ? new RingGeometry(radius - 0.1 * this.radius, radius + 0.1 * this.radius, 128)
      : new SphereGeometry(radius, 64, 40);
    const glass = { transparent: true, opacity: flat ? 0.6 : 0.13, depthWrite: false };
    const mesh = new Mesh(geometry, material(flat, glass));
    mesh.position.set(...centre);
    this.group.add(mesh);
    return mesh;
  }

  paint(theme) {
    for (let index = 0; index < this.motion.count; ++index) {
      this.balls.setColorAt(index, new Color(theme.point(index, this.motion.count)));
    }
    if (this.balls.instanceColor) this.balls.instanceColor.needsUpdate = true;
    const metal = theme.colour("--rod");
    for (const mesh of [this.bars, ...this.pins, ...this.spheres]) mesh.material.color.set(metal);
    this.halo.material.color.set(theme.colour("--accent"));
  }

  /** The point that is marked; none for -1. */
  mark(index) {
    this.marked = index;
    this.halo.visible = index >= 0 && this.motion.count > 1;
  }

  /** Moves everything to the positions x, y, z of all points. */
  place(positions) {
    for (let index = 0; index < this.motion.count; ++index) {
      this.balls.setMatrixAt(index, this.#matrix.makeTranslation(...positions.subarray(3 * index, 3 * index + 3)));
    }
    this.rods.forEach((rod, index) => {
      this.#from.fromArray(positions, 3 * rod.point);
      if (rod.anchor) this.#to.set(...rod.anchor);
      else this.#to.fromArray(positions, 3 * rod.other);
      this.bars.setMatrixAt(index, this.#between());
    });
    this.balls.instanceMatrix.needsUpdate = true;
    this.bars.instanceMatrix.needsUpdate = true;
    this.balls.boundingSphere = null; // picking asks for it again
    if (this.halo.visible) this.halo.position.fromArray(positions, 3 * this.marked);
  }

  /** The transformation that lays a rod of length 1 between #from and #to. */
  #between() {
    const length = this.#size.subVectors(this.#to, this.#from).length();
    this.#turn.setFromUnitVectors(alongRod, this.#size.divideScalar(length || 1));
    const middle = this.#from.add(this.#to).divideScalar(2);
    return this.#matrix.compose(middle, this.#turn, this.#size.set(1, 1, length));
  }
}
