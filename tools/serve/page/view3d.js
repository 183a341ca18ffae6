// The scene in three dimensions: one unit is 100 mm, z points up, the untilted face lies at z = 0.

import * as THREE from './three/build/three.module.js';
import { OrbitControls } from './three/examples/jsm/controls/OrbitControls.js';

const MM = 0.01;
const RAD = Math.PI / 180;
const CLEAR = 0xbfe3f2;
const COLOURS = {  // by group
  metal: 0xaeb6c2, wood: 0xb98a55, plastic: 0xe9ecef, stone: 0xcfc6b4, building: 0xc3bdb3, glass: CLEAR, water: 0x6fa8d6, tissue: 0xd9a08c, soil: 0x8a6a4c,
};
const SPECIAL = { iron: 0x6f7680, plexiglass: CLEAR, polycarbonate: CLEAR };

/** Without a graphics processor every pixel costs: then edges are left jagged. */
function drawsInSoftware() {
  const gl = document.createElement('canvas').getContext('webgl');
  const facts = gl && gl.getExtension('WEBGL_debug_renderer_info');
  return Boolean(facts) && /swiftshader|llvmpipe|software/i.test(gl.getParameter(facts.UNMASKED_RENDERER_WEBGL));
}

export class View3d {
  constructor(canvas, facts) {
    this.canvas = canvas;
    this.facts = facts;
    const slow = drawsInSoftware();
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !slow, alpha: true });
    this.renderer.setPixelRatio(slow ? 1 : Math.min(2, window.devicePixelRatio));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(32, 1, 0.1, 200);
    this.camera.up.set(0, 0, 1);
    this.camera.position.set(8.5, -10.5, 6.2);
    this.orbit = new OrbitControls(this.camera, canvas);
    this.orbit.enablePan = false;
    this.orbit.enableKeys = false;
    this.orbit.enableZoom = false;
    this.orbit.maxPolarAngle = 1.62;
    this.orbit.target.set(0, 0, 2);
    this.orbit.addEventListener('change', () => this.render());
    canvas.addEventListener('keydown', (event) => this.turn(event));
    this.build();
    new ResizeObserver(() => this.resize()).observe(canvas);
  }

  build() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8890a0, 0.85));
    const lamp = new THREE.DirectionalLight(0xffffff, 0.55);
    lamp.position.set(4, -6, 12);
    this.scene.add(lamp);
    this.grid = new THREE.GridHelper(16, 16, 0x8895ab, 0x8895ab);
    this.grid.rotation.x = Math.PI / 2;
    this.grid.position.z = -1.6;
    this.grid.material.transparent = true;
    this.grid.material.opacity = 0.35;
    this.scene.add(this.grid);
    this.sensor = this.makeSensor();
    this.sample = new THREE.Group();
    this.plate = new THREE.Mesh(new THREE.BufferGeometry(), new THREE.MeshLambertMaterial({ side: THREE.DoubleSide }));
    this.rim = new THREE.LineLoop(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x3c4658 }));
    this.zone = new THREE.Mesh(new THREE.RingGeometry(0.9, 1, 64), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, depthTest: false }));
    this.disc = new THREE.Mesh(new THREE.CircleGeometry(1, 64), new THREE.MeshBasicMaterial({ side: THREE.DoubleSide, transparent: true, opacity: 0.28, depthTest: false }));
    this.sample.add(this.plate, this.rim, this.zone, this.disc);
    this.ray = new THREE.Line(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x00845f, depthTest: false }));
    this.tube = new THREE.Mesh(new THREE.ConeGeometry(1, 1, 48, 1, true).translate(0, -0.5, 0).rotateX(-Math.PI / 2),
      new THREE.MeshBasicMaterial({ transparent: true, opacity: 0.2, side: THREE.DoubleSide, depthWrite: false }));
    this.scene.add(this.sensor, this.sample, this.ray, this.tube);
  }

  /** Board, patches, and a beam as wide as the antennas' -6 dB, 60 by 35 degrees to either side. */
  makeSensor() {
    const sensor = new THREE.Group();
    const board = new THREE.Mesh(new THREE.BoxGeometry(0.62, 0.9, 0.06), new THREE.MeshLambertMaterial({ color: 0x9b2335 }));
    board.position.z = 0.05;
    const chip = new THREE.Mesh(new THREE.BoxGeometry(0.2, 0.2, 0.05), new THREE.MeshLambertMaterial({ color: 0x20242c }));
    chip.position.z = 0.1;
    const gold = new THREE.MeshLambertMaterial({ color: 0xe0b252 });
    for (const x of [-0.18, 0.06, 0.13, 0.2]) {
      const patch = new THREE.Mesh(new THREE.BoxGeometry(0.05, 0.07, 0.02), gold);
      patch.position.set(x, 0, 0.01);
      sensor.add(patch);
    }
    this.beam = new THREE.Mesh(new THREE.ConeGeometry(1, 1, 48, 1, true).translate(0, -0.5, 0).rotateX(Math.PI / 2),
      new THREE.MeshBasicMaterial({ color: 0x4a78d0, transparent: true, opacity: 0.09, side: THREE.DoubleSide, depthWrite: false }));
    this.axis = new THREE.Line(new THREE.BufferGeometry().setFromPoints([new THREE.Vector3(), new THREE.Vector3(0, 0, -1)]),
      new THREE.LineBasicMaterial({ color: 0x4a78d0, transparent: true, opacity: 0.8 }));
    sensor.add(board, chip);
    sensor.scale.setScalar(1.6);  // larger than it is, to be seen
    const whole = new THREE.Group();
    whole.add(sensor, this.beam, this.axis);
    return whole;
  }

  /** A bowed face with its thickness below, as one closed surface. */
  shapePlate({ size_mm: size, thickness_mm: thickness, bow_mm: bow }) {
    const key = [size, thickness, bow].join();
    if (key === this.plateKey) return;
    this.plateKey = key;
    const n = 16;
    const box = new THREE.BoxBufferGeometry(size * MM, size * MM, thickness * MM, n, n, 1);
    const at = box.attributes.position;
    const drop = (x, y) => -bow * MM * ((2 * x / (size * MM)) ** 2 + (2 * y / (size * MM)) ** 2);
    for (let i = 0; i < at.count; i++) at.setZ(i, at.getZ(i) - (thickness * MM) / 2 + drop(at.getX(i), at.getY(i)));
    box.computeVertexNormals();
    this.plate.geometry.dispose();
    this.plate.geometry = box;
    const half = (size * MM) / 2;
    const corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => new THREE.Vector3(x * half, y * half, drop(half, half) + 0.004));
    this.rim.geometry.setFromPoints(corners);
  }

  paint(material) {
    const { group } = this.facts.materials.find((each) => each.name === material) ?? {};
    const colour = SPECIAL[material] ?? COLOURS[group] ?? 0xb9b2a6;
    this.plate.material.setValues({ transparent: colour === CLEAR, opacity: colour === CLEAR ? 0.55 : 1 });
    this.plate.material.color.setHex(colour);
  }

  show(values, foot) {
    this.shapePlate(values);
    this.paint(values.material);
    const height = values.height_mm * MM;
    const about = values.tilt_plane === 'azimuth' ? 'y' : 'x';
    for (const part of [this.sensor, this.sample]) part.rotation.set(0, 0, 0);
    this[values.tilted].rotation[about] = values.tilt_deg * RAD;
    this.sensor.position.set(0, 0, height);
    this.beam.scale.set(height * Math.tan(60 * RAD) * 0.55, height * Math.tan(35 * RAD) * 0.55, height * 0.55);
    this.axis.scale.z = height;
    this.showFoot(foot);
    this.orbit.target.z = height * 0.42;
    this.orbit.update();
    this.render();
  }

  showFoot(foot) {
    const isOn = foot.margin >= 0;
    const colour = isOn ? 0x00a376 : 0xd55e00;
    for (const part of [this.zone, this.disc]) {
      part.material.color.setHex(colour);
      part.scale.setScalar(foot.fresnel_mm * MM);
      part.position.set(foot.x_mm * MM, foot.y_mm * MM, 0.02);
    }
    this.sample.updateMatrixWorld();
    const end = this.sample.localToWorld(new THREE.Vector3(foot.x_mm * MM, foot.y_mm * MM, 0.02));
    this.ray.geometry.setFromPoints([this.sensor.position.clone(), end]);
    // What the echo is made of: from the radar to the first Fresnel zone around the foot.
    this.tube.position.copy(this.sensor.position);
    this.tube.lookAt(end);
    this.tube.scale.set(foot.fresnel_mm * MM, foot.fresnel_mm * MM, this.sensor.position.distanceTo(end));
    for (const part of [this.ray, this.tube]) part.material.color.setHex(colour);
  }

  turn(event) {
    const step = { ArrowLeft: [-0.12, 0], ArrowRight: [0.12, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1] }[event.key];
    if (!step) return;
    event.preventDefault();
    const around = new THREE.Vector3().subVectors(this.camera.position, this.orbit.target);
    around.applyAxisAngle(new THREE.Vector3(0, 0, 1), step[0]);
    const side = new THREE.Vector3(-around.y, around.x, 0).normalize();
    const raised = around.clone().applyAxisAngle(side, step[1]);
    if (Math.abs(raised.z) < 0.97 * raised.length()) around.copy(raised);
    this.camera.position.copy(this.orbit.target).add(around);
    this.orbit.update();
  }

  resize() {
    const { clientWidth: width, clientHeight: height } = this.canvas;
    if (!width || !height) return;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    // Wide enough for the plate, be the view ever so narrow.
    this.camera.fov = Math.max(32, (2 / RAD) * Math.atan(Math.tan(17 * RAD) / this.camera.aspect));
    this.camera.updateProjectionMatrix();
    this.render();
  }

  /** Once for each picture of the screen, however often it is called. */
  render() {
    this.frame ??= requestAnimationFrame(() => {
      this.frame = undefined;
      this.renderer.render(this.scene, this.camera);
    });
  }
}
