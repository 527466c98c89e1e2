// A sun that throws shadows and a bright sky. Flat scenes have their plain colours.
import { DirectionalLight, HemisphereLight } from "three";

/** What is to be added to a scene of that extent. */
export function lights(extent) {
  if (extent.flat) return [];
  const { middle, radius, up } = extent;
  const sun = new DirectionalLight(0xffffff, 2.4);
  sun.target.position.copy(middle);
  sun.position.copy(extent.across(0.9, 0.5)).addScaledVector(up, 4).multiplyScalar(radius).add(middle);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.radius = 4;
  const reach = 1.6 * radius;
  const box = { left: -reach, right: reach, top: reach, bottom: -reach, near: 0.1 * radius, far: 12 * radius };
  Object.assign(sun.shadow.camera, box);
  const sky = new HemisphereLight(0xffffff, 0xb4b8c0, 2);
  sky.position.copy(up);
  return [sun, sun.target, sky];
}
