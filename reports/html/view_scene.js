// What is drawn, on a 2D canvas, from a camera without perspective. Of the mesh only the half behind the slice is
// shown: it is a box, so that its sides towards the reader, the slice among them, hide one another nowhere and need no
// sorting, and elements inside it are never looked at.

const REGION_COLOURS = ['#d55e00', '#0072b2', '#009e73'];
const NODE_COLOURS = ['#cc79a7', '#e69f00', '#56b4e9', 'ink'];

/** From the lowest to the highest level: pale yellow, grey green, violet; none is the colour of a region or a node. */
const LEVEL_STOPS = [[255, 248, 214], [164, 198, 178], [122, 108, 160]];

function levelColour(level, [lowest, highest]) {
  if (level === NO_LEVEL) return 'rgb(255 255 255)';
  const t = (level - lowest) / Math.max(1, highest - lowest) * (LEVEL_STOPS.length - 1);
  const first = Math.min(LEVEL_STOPS.length - 2, Math.floor(t));
  const [from, to] = [LEVEL_STOPS[first], LEVEL_STOPS[first + 1]];
  const channel = (k) => Math.round(from[k] + (to[k] - from[k]) * (t - first));
  return `rgb(${channel(0)} ${channel(1)} ${channel(2)})`;
}

class Camera {
  constructor(domain) {
    this.domain = domain;
    this.reset();
  }

  reset() {
    Object.assign(this, {yaw: -60, pitch: 25, zoom: 1, centre: this.domain.map((length) => length / 2)});
  }

  turn(yaw, pitch) {
    this.yaw = ((this.yaw + yaw + 540) % 360 + 360) % 360 - 180;
    this.pitch = Math.max(-90, Math.min(90, this.pitch + pitch));
  }

  /** Straight at slices of an axis: the other two axes to the right and up, as in the pictures of slices. */
  face(axis) { Object.assign(this, {yaw: axis === 0 ? 0 : -90, pitch: axis === 2 ? 90 : 0}); }

  /** The direction towards the reader. */
  get towards() {
    const [y, p] = [this.yaw * Math.PI / 180, this.pitch * Math.PI / 180];
    return [Math.cos(p) * Math.cos(y), Math.cos(p) * Math.sin(y), Math.sin(p)];
  }

  /** Pixels for each axis's unit, and where the index domain's origin is, on a canvas of this size. */
  projection(width, height) {
    const [y, p] = [this.yaw * Math.PI / 180, this.pitch * Math.PI / 180];
    const right = [-Math.sin(y), Math.cos(y), 0];
    const up = [-Math.sin(p) * Math.cos(y), -Math.sin(p) * Math.sin(y), Math.cos(p)];
    const scale = this.zoom * 0.86 * Math.min(width, height) / Math.hypot(...this.domain);
    const units = AXES.map((_, axis) => [scale * right[axis], -scale * up[axis]]);
    const origin = [width / 2, height / 2];
    for (const k of [0, 1]) {
      for (let axis = 0; axis < 3; ++axis) origin[k] -= this.centre[axis] * units[axis][k];
    }
    return {units, origin, scale};
  }
}

class Scene {
  constructor(mesh, canvas) {
    this.mesh = mesh;
    this.canvas = canvas;
    this.context = canvas.getContext('2d');
  }

  /** Draws everything that `state` says; returns how many element faces were drawn. */
  draw(state, camera, colours) {
    const ratio = window.devicePixelRatio || 1;
    const [width, height] = [this.canvas.clientWidth, this.canvas.clientHeight];
    const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (this.canvas.width !== w || this.canvas.height !== h) Object.assign(this.canvas, {width: w, height: h});
    Object.assign(this, {state, colours, size: [width, height], ...camera.projection(width, height), drawn: 0});
    this.context.setTransform(ratio, 0, 0, ratio, 0, 0);
    this.context.clearRect(0, 0, width, height);
    this.context.lineJoin = 'round';
    this.drawBody(camera.towards);
    drawOverlays(this);
    return this.drawn;
  }

  project([x, y, z]) {
    const {origin, units: [ux, uy, uz]} = this;
    return [origin[0] + x * ux[0] + y * uy[0] + z * uz[0], origin[1] + x * ux[1] + y * uy[1] + z * uz[1]];
  }

  // ---- the half of the mesh behind the slice -----------------------------------------------------------------------

  drawBody(towards) {
    const {axis, half, cut} = this.state;
    const below = towards[axis] >= 0;  // the half that the slice hides nothing of
    this.kept = this.mesh.domain.map((length) => [0, length]);
    this.kept[axis][below ? 1 : 0] = this.mesh.position(axis, half);
    this.strokeBox(this.mesh.domain.map((length) => [0, length]), this.colours.faint, 1);
    if (!this.state.show.elements) return;
    for (let side = 0; side < 3; ++side) {
      const facing = towards[side];
      if (side === axis || Math.abs(facing) < 1e-9) continue;
      const upper = facing > 0 ? 1 : 0;
      this.drawFaces(side, upper * this.mesh.domain[side], this.mesh.sides[side][upper], side === 2 ? 0.1 : 0.2);
    }
    if (Math.abs(towards[axis]) < 1e-9) return;
    this.drawFaces(axis, this.mesh.position(axis, half), this.faces(cut, below), 0);
  }

  /** The elements seen in the slice: of the half that is kept, or, at the domain's side, of the other one. */
  faces({through, below, above}, keepBelow) {
    const kept = keepBelow ? below : above;
    const behind = through.concat(kept);
    return behind.length > 0 ? behind : (keepBelow ? above : below);
  }

  /**
   * Faces of elements in a plane, cut off at the slice. The side is painted in the colour of edges, and each face on it
   * as a rectangle that is half an edge smaller all around: stroking a path of thousands of faces takes seconds.
   */
  drawFaces(side, position, elements, shade) {
    const {context} = this;
    const [u, v] = otherAxes(side);
    const [[ux, uy], [vx, vy], [sx, sy]] = [this.units[u], this.units[v], this.units[side]];
    context.save();
    context.transform(ux, uy, vx, vy, this.origin[0] + position * sx, this.origin[1] + position * sy);
    this.fillRange(u, v, this.colours.edge);
    const half = (elements.length > 4000 ? 0.2 : 0.4) / Math.abs(ux * vy - uy * vx);
    const inset = [half * Math.hypot(vx, vy), half * Math.hypot(ux, uy)];
    for (const [level, faces] of this.byLevel(elements)) {
      context.fillStyle = levelColour(level, this.mesh.levelRange);
      for (const element of faces) this.fillFace(element, u, v, inset);
    }
    if (shade > 0) this.fillRange(u, v, `rgb(0 0 0 / ${shade})`);
    context.restore();
  }

  byLevel(elements) {
    const result = new Map();
    for (const element of elements) {
      const level = this.mesh.level(element);
      if (!result.has(level)) result.set(level, []);
      result.get(level).push(element);
    }
    return result;
  }

  /** A whole side of what is kept of the domain. */
  fillRange(u, v, colour) {
    const [[u0, u1], [v0, v1]] = [this.kept[u], this.kept[v]];
    this.context.fillStyle = colour;
    this.context.fillRect(u0, v0, u1 - u0, v1 - v0);
  }

  fillFace(element, u, v, inset) {
    const [u0, u1] = this.clipped(element, u);
    const [v0, v1] = this.clipped(element, v);
    if (u0 >= u1 || v0 >= v1) return;
    const du = Math.min(inset[0], 0.2 * (u1 - u0));
    const dv = Math.min(inset[1], 0.2 * (v1 - v0));
    this.context.fillRect(u0 + du, v0 + dv, u1 - u0 - 2 * du, v1 - v0 - 2 * dv);
    ++this.drawn;
  }

  nearRange(element, axis) {
    const near = this.mesh.near[axis];
    return [near[this.mesh.lower(element, axis)], near[this.mesh.upper(element, axis)]];
  }

  clipped(element, axis) {
    const [low, high] = this.nearRange(element, axis);
    return [Math.max(this.kept[axis][0], low), Math.min(this.kept[axis][1], high)];
  }

  addRectangle(path, side, position, u0, u1, v0, v1) {
    const [u, v] = otherAxes(side);
    const [s, p, q] = [this.units[side], this.units[u], this.units[v]];
    const x = this.origin[0] + position * s[0];
    const y = this.origin[1] + position * s[1];
    path.moveTo(x + u0 * p[0] + v0 * q[0], y + u0 * p[1] + v0 * q[1]);
    path.lineTo(x + u1 * p[0] + v0 * q[0], y + u1 * p[1] + v0 * q[1]);
    path.lineTo(x + u1 * p[0] + v1 * q[0], y + u1 * p[1] + v1 * q[1]);
    path.lineTo(x + u0 * p[0] + v1 * q[0], y + u0 * p[1] + v1 * q[1]);
    path.closePath();
  }

  // ---- lines and signs ---------------------------------------------------------------------------------------------

  stroke(path, colour, width, dash = []) {
    this.setPen(colour, width);
    this.context.setLineDash(dash);
    this.context.stroke(path);
    this.context.setLineDash([]);
  }

  setPen(colour, width) { Object.assign(this.context, {strokeStyle: colour, lineWidth: width}); }

  strokeLine(from, to) {
    this.context.beginPath();
    this.line(this.context, from, to);
    this.context.stroke();
  }

  line(path, from, to) {
    path.moveTo(...this.project(from));
    path.lineTo(...this.project(to));
  }

  /** The twelve edges of a box, given by its range along each axis. */
  strokeBox(box, colour, width, dash) {
    const path = new Path2D();
    for (let axis = 0; axis < 3; ++axis) {
      const [u, v] = otherAxes(axis);
      for (const corner of [[0, 0], [0, 1], [1, 0], [1, 1]]) {
        const from = [];
        [from[axis], from[u], from[v]] = [box[axis][0], box[u][corner[0]], box[v][corner[1]]];
        const to = from.slice();
        to[axis] = box[axis][1];
        this.line(path, from, to);
      }
    }
    this.stroke(path, colour, width, dash);
  }

  label(text, point, right = 8, down = -8) {
    const [x, y] = this.project(point);
    Object.assign(this.context, {font: '12px sans-serif', strokeStyle: this.colours.ground, lineWidth: 3});
    this.context.strokeText(text, x + right, y + down);
    this.context.fillStyle = this.colours.ink;
    this.context.fillText(text, x + right, y + down);
  }

  dots(points, radius, colour) {
    this.context.fillStyle = colour;
    for (const point of points) {
      const [x, y] = this.project(point);
      this.context.fillRect(x - radius, y - radius, 2 * radius, 2 * radius);
    }
  }
}
