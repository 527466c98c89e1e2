// The scene on the screen: the camera, and what the pointer does.
import {
  MOUSE, OrthographicCamera, PCFShadowMap, PerspectiveCamera, Raycaster, Scene, TOUCH, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { CSS2DRenderer } from "three/addons/renderers/CSS2DRenderer.js";
import { Bodies } from "./bodies.js";
import { Extent } from "./extent.js";
import { Ground, label } from "./ground.js";
import { lights } from "./lights.js";
import { Trails } from "./trails.js";

const fieldOfView = 32; // degrees
const margin = 1.02; // of the scene's radius, around it
const clickTravel = 4; // pixels

export class View {
  #stale = true;
  #pointer = null;

  /** Throws where the browser has no WebGL. */
  constructor(root, result, motion, clock, theme) {
    Object.assign(this, { root, result, motion, clock, theme });
    this.renderer = new WebGLRenderer({ antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.labels = new CSS2DRenderer();
    this.labels.domElement.className = "labels";
    root.prepend(this.renderer.domElement, this.labels.domElement);

    this.extent = new Extent(motion, result.scene);
    this.bodies = new Bodies(result, motion, this.extent);
    this.trails = new Trails(motion, clock);
    this.ground = new Ground(this.extent, result.scene.dimension);
    this.scene = new Scene();
    this.scene.add(this.ground.group, this.trails.group, this.bodies.group, ...lights(this.extent));
    this.name = label("", "name");
    this.scene.add(this.name);

    this.positions = motion.positionsAt(clock.time);
    this.#addCamera();
    this.#listen();
    this.#paint();
  }

  get spacing() {
    return this.ground.spacing;
  }

  #addCamera() {
    const { extent } = this;
    this.camera = extent.flat ? new OrthographicCamera() : new PerspectiveCamera(fieldOfView, 1, 0.01, 1000);
    this.controls = new OrbitControls(this.camera, this.renderer.domElement);
    if (extent.flat) {
      this.controls.enableRotate = false;
      this.controls.mouseButtons.LEFT = MOUSE.PAN;
      this.controls.touches.ONE = TOUCH.PAN;
    }
    this.controls.zoomToCursor = true;
    this.controls.addEventListener("change", () => this.refresh());
    this.#resize();
    this.lookFromStart();
  }

  /** The view that the page starts with. */
  lookFromStart() {
    const { extent, camera } = this;
    const spread = Math.sin(((fieldOfView / 2) * Math.PI) / 180) * Math.min(1, this.aspect);
    const distance = (margin * extent.radius) / spread;
    camera.up.copy(extent.flat ? new Vector3(0, 1, 0) : extent.up);
    camera.zoom = 1;
    camera.position.copy(extent.middle);
    if (extent.flat) {
      camera.position.z += 4 * extent.radius;
    } else {
      const way = extent.across(-0.55, -1).addScaledVector(extent.up, 0.42).normalize();
      camera.position.addScaledVector(way, distance);
    }
    camera.near = distance / 1000;
    camera.far = 100 * distance;
    camera.updateProjectionMatrix();
    this.controls.target.copy(extent.middle);
    this.controls.update();
  }

  #listen() {
    new ResizeObserver(() => this.#resize()).observe(this.root);
    this.clock.onChange(() => this.refresh());
    this.theme.onChange(() => this.#paint());
    const canvas = this.renderer.domElement;
    let pressed = new Vector2();
    canvas.addEventListener("pointermove", (event) => this.#hover(event));
    canvas.addEventListener("pointerleave", () => this.#hover(null));
    canvas.addEventListener("pointerdown", (event) => (pressed = new Vector2(event.clientX, event.clientY)));
    canvas.addEventListener("click", (event) => {
      const travel = pressed.distanceTo(new Vector2(event.clientX, event.clientY));
      const point = this.#pointUnder(event);
      if (travel <= clickTravel && point >= 0) this.onPick?.(point);
    });
  }

  #pointUnder(event) {
    const box = this.renderer.domElement.getBoundingClientRect();
    const place = new Vector2(
      (2 * (event.clientX - box.left)) / box.width - 1,
      1 - (2 * (event.clientY - box.top)) / box.height,
    );
    const ray = new Raycaster();
    ray.setFromCamera(place, this.camera);
    return ray.intersectObject(this.bodies.balls)[0]?.instanceId ?? -1;
  }

  #hover(event) {
    this.#pointer = event;
    this.refresh();
  }

  #paint() {
    this.renderer.setClearColor(this.theme.colour("--stage"));
    for (const part of [this.bodies, this.trails, this.ground]) part.paint(this.theme);
    this.refresh();
  }

  #resize() {
    const { clientWidth: width, clientHeight: height } = this.root;
    if (width === 0 || height === 0) return;
    this.aspect = width / height;
    this.renderer.setPixelRatio(devicePixelRatio);
    this.renderer.setSize(width, height);
    this.labels.setSize(width, height);
    if (this.extent.flat) this.#frameFlat();
    else this.camera.aspect = this.aspect;
    this.camera.updateProjectionMatrix();
    this.refresh();
  }

  /** The whole box of the motion, with some air, in the shape of the window. */
  #frameFlat() {
    const { low, high, radius } = this.extent;
    const air = 0.28 * radius;
    const [x, y] = [high.x - low.x, high.y - low.y].map((size) => Math.max(size, radius) / 2 + air);
    const halfHeight = Math.max(y, x / this.aspect);
    const halfWidth = halfHeight * this.aspect;
    Object.assign(this.camera, { left: -halfWidth, right: halfWidth, top: halfHeight, bottom: -halfHeight });
  }

  refresh() {
    this.#stale = true;
  }

  mark(point) {
    this.bodies.mark(point);
    this.refresh();
  }

  setTrails(length) {
    this.trails.setLength(length);
    this.refresh();
  }

  /** Draws, if anything changed since the last time. */
  render() {
    if (!this.#stale) return;
    this.#stale = false;
    this.motion.positionsAt(this.clock.time, this.positions);
    this.bodies.place(this.positions);
    this.trails.place(this.clock.time);
    this.#placeName();
    this.renderer.render(this.scene, this.camera);
    this.labels.render(this.scene, this.camera);
  }

  #placeName() {
    const point = this.#pointer ? this.#pointUnder(this.#pointer) : -1;
    this.name.visible = point >= 0;
    this.renderer.domElement.style.cursor = point >= 0 ? "pointer" : "grab";
    if (point < 0) return;
    this.name.element.textContent = this.result.scene.points[point].name;
    this.name.position.fromArray(this.positions, 3 * point);
  }

  /** Where the points are drawn, read back from what the graphics card was given. */
  drawnPositions() {
    const { array } = this.bodies.balls.instanceMatrix;
    return this.result.scene.points.map((point, index) => Array.from(array.slice(16 * index + 12, 16 * index + 15)));
  }

  /** The same in pixels of the window. */
  screenPositions() {
    const box = this.renderer.domElement.getBoundingClientRect();
    return this.drawnPositions().map((place) => {
      const { x, y } = new Vector3(...place).project(this.camera);
      return [box.left + ((1 + x) / 2) * box.width, box.top + ((1 - y) / 2) * box.height];
    });
  }
}
