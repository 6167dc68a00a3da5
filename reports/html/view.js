// Turns every figure.mesh-view of the page into an interactive view. What is shown stands on the figure as data
// attributes too: data-slice-axis, -index (the half rank: 2*line on a line), -position, -elements (that the plane meets
// with area), -through, -nodes; data-picked-node (numbers); data-yaw, -pitch, -zoom; data-units, data-origin (pixels of
// each axis's unit, and of the index domain's origin, on the canvas); data-drawn (faces), data-frame-ms.

const TURN = 5;        // degrees an arrow key
const CLICK = 14;      // pixels around a node that pick it
const DRAG = 4;        // pixels before a press becomes a drag
const DEGREES = 0.4;   // a pixel

class MeshView {
  constructor(figure) {
    this.figure = figure;
    this.mesh = new MeshData(JSON.parse(figure.querySelector('.mesh-data').textContent));
    this.camera = new Camera(this.mesh.domain);
    this.state = {picked: [], witness: false, show: {}};
    this.panel = new Panel(this);
    this.scene = new Scene(this.mesh, this.panel.canvas);
    this.sliceAtWitness();
    this.pick([]);
    this.listen();
  }

  // ---- the slice ---------------------------------------------------------------------------------------------------

  slice(axis, half) {
    const {mesh, state} = this;
    const place = Math.max(0, Math.min(2 * mesh.lastLine(axis), half));
    Object.assign(state, {axis, half: place, cut: mesh.cut(axis, place), nodes: mesh.nodesIn(axis, place),
      regions: mesh.regionsIn(axis, place)});
    this.panel.showSlice(state);
    this.draw();
  }

  moveSlice(step) { this.slice(this.state.axis, this.state.half + step); }

  /** Through what is picked, else in the middle. */
  sliceThroughPick(axis) {
    const [pick] = this.state.picked;
    this.slice(axis, pick ? 2 * this.mesh.nodeLine(pick.node, axis) : this.middle(axis));
  }

  middle(axis) { return this.mesh.halfOf(axis, rationalText([BigInt(this.mesh.domain[axis]), 2n])); }

  /** Through the witness's point, a plane that all its nodes lie in, or its first node or box; else in the middle. */
  sliceAtWitness() {
    const {picked, marks: {points, boxes}} = this.mesh.json;
    const line = (node, axis) => this.mesh.nodeLine(node, axis);
    if (points.length > 0) return this.slice(2, this.mesh.halfOf(2, points[0].at[2]));
    if (picked.length > 0) {
      const common = [2, 1, 0].find((axis) => picked.every((node) => line(node, axis) === line(picked[0], axis))) ?? 2;
      return this.slice(common, 2 * line(picked[0], common));
    }
    if (boxes.length > 0) return this.slice(2, this.mesh.halfOf(2, middleText(boxes[0].lower[2], boxes[0].upper[2])));
    return this.slice(2, this.middle(2));
  }

  // ---- picking -----------------------------------------------------------------------------------------------------

  pick(picked, witness = false) {
    Object.assign(this.state, {picked, witness});
    this.panel.showPicked(this.state);
    this.draw();
  }

  /** One node, and the slice through it. */
  pickNode(node) {
    this.pick([{node, name: 'v'}]);
    this.slice(this.state.axis, 2 * this.mesh.nodeLine(node, this.state.axis));
  }

  pickNumber(number) {
    if (Number.isInteger(number) && number >= 1 && number <= this.mesh.nodeCount) this.pickNode(number - 1);
  }

  step(by) {
    if (this.mesh.nodeCount === 0) return;
    const [pick] = this.state.picked;
    const from = pick ? pick.node + by : (by > 0 ? 0 : -1);
    this.pickNode((from + this.mesh.nodeCount) % this.mesh.nodeCount);
  }

  showWitness() {
    this.pick(this.mesh.json.marks.nodes.map(({name, node}) => ({name, node})), true);
    this.sliceAtWitness();
  }

  pickAt(x, y) {
    const {show, nodes} = this.state;
    const candidates = show.allNodes ? Array.from({length: this.mesh.nodeCount}, (_, n) => n) : show.nodes ? nodes : [];
    let [nearest, least] = [null, CLICK];
    for (const node of candidates) {
      const [px, py] = this.scene.project(this.mesh.nodeNear(node));
      const distance = Math.hypot(px - x, py - y);
      if (distance < least) [nearest, least] = [node, distance];
    }
    if (nearest !== null) this.pickNode(nearest);
  }

  // ---- the view ----------------------------------------------------------------------------------------------------

  turn(yaw, pitch) {
    this.camera.turn(yaw, pitch);
    this.draw();
  }

  zoom(factor) {
    this.camera.zoom = Math.max(0.2, Math.min(1e9, this.camera.zoom * factor));
    this.draw();
  }

  faceSlice() {
    this.camera.face(this.state.axis);
    this.draw();
  }

  reset() {
    this.camera.reset();
    this.draw();
  }

  /** So that the supports of what is picked fill the canvas. */
  zoomToPicked() {
    const supports = this.state.picked.map(({node}) => this.mesh.support(node)).filter(Boolean);
    if (supports.length === 0) return;
    const ranges = AXES.map((_, axis) => [
      Math.min(...supports.map((support) => this.mesh.near[axis][support[axis][0]])),
      Math.max(...supports.map((support) => this.mesh.near[axis][support[axis][1]])),
    ]);
    this.camera.centre = ranges.map(([low, high]) => (low + high) / 2);
    const size = Math.hypot(...ranges.map(([low, high]) => high - low));
    this.camera.zoom = Math.hypot(...this.mesh.domain) / size;
    this.draw();
  }

  toggle(key, on) {
    this.state.show[key] = on;
    this.draw();
  }

  // ---- drawing -----------------------------------------------------------------------------------------------------

  draw() {
    if (this.waiting || !this.scene) return;
    this.waiting = true;
    requestAnimationFrame(() => {
      this.waiting = false;
      this.frame();
    });
  }

  frame() {
    if (this.panel.canvas.clientWidth === 0) return;  // not on the page now, for example in print
    const begin = performance.now();
    const style = getComputedStyle(this.panel.live);
    const colours = Object.fromEntries(['ink', 'ground', 'edge', 'faint'].map(
      (name) => [name, style.getPropertyValue(`--mesh-view-${name}`).trim()]));
    const drawn = this.scene.draw(this.state, this.camera, colours);
    this.publish(drawn, performance.now() - begin);
  }

  publish(drawn, milliseconds) {
    const {axis, half, cut, nodes, picked} = this.state;
    Object.assign(this.figure.dataset, {
      sliceAxis: AXES[axis], sliceIndex: half, slicePosition: this.mesh.positionText(axis, half),
      sliceElements: cut.through.length + cut.below.length + cut.above.length, sliceThrough: cut.through.length,
      sliceNodes: nodes.length, pickedNode: picked.map(({node}) => node).join(' '),
      yaw: this.camera.yaw, pitch: this.camera.pitch, zoom: this.camera.zoom, drawn, frameMs: milliseconds.toFixed(1),
      units: this.scene.units.flat().join(' '), origin: this.scene.origin.join(' '),
    });
  }

  // ---- keyboard, mouse, touch --------------------------------------------------------------------------------------

  listen() {
    const {canvas} = this.panel;
    canvas.addEventListener('keydown', (event) => this.onKey(event));
    canvas.addEventListener('wheel', (event) => this.onWheel(event), {passive: false});
    const pointers = new Map();
    canvas.addEventListener('pointerdown', (event) => this.onDown(event, pointers));
    canvas.addEventListener('pointermove', (event) => this.onMove(event, pointers));
    canvas.addEventListener('pointerup', (event) => this.onUp(event, pointers));
    canvas.addEventListener('pointercancel', (event) => pointers.delete(event.pointerId));
    new ResizeObserver(() => this.draw()).observe(canvas);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.draw());
  }

  onKey(event) {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const actions = {
      ArrowLeft: () => this.turn(-TURN, 0), ArrowRight: () => this.turn(TURN, 0),
      ArrowUp: () => this.turn(0, TURN), ArrowDown: () => this.turn(0, -TURN),
      '+': () => this.zoom(1.25), '=': () => this.zoom(1.25), '-': () => this.zoom(0.8), Home: () => this.reset(),
      PageUp: () => this.moveSlice(1), PageDown: () => this.moveSlice(-1),
      n: () => this.step(1), p: () => this.step(-1),
    };
    if (!actions[event.key]) return;
    event.preventDefault();
    actions[event.key]();
  }

  /** Without the canvas's focus the wheel scrolls the page. */
  onWheel(event) {
    if (!event.ctrlKey && document.activeElement !== this.panel.canvas) return;
    event.preventDefault();
    this.zoom(Math.exp(-event.deltaY / 500));
  }

  onDown(event, pointers) {
    this.panel.canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, {x: event.offsetX, y: event.offsetY, moved: 0});
  }

  onMove(event, pointers) {
    const pointer = pointers.get(event.pointerId);
    if (!pointer) return;
    const [dx, dy] = [event.offsetX - pointer.x, event.offsetY - pointer.y];
    const before = spread(pointers);
    Object.assign(pointer, {x: event.offsetX, y: event.offsetY, moved: pointer.moved + Math.hypot(dx, dy)});
    if (pointers.size === 2) this.zoom(spread(pointers) / before || 1);
    else if (pointer.moved > DRAG) this.turn(-dx * DEGREES, dy * DEGREES);
  }

  onUp(event, pointers) {
    const pointer = pointers.get(event.pointerId);
    pointers.delete(event.pointerId);
    if (pointer && pointer.moved <= DRAG) this.pickAt(event.offsetX, event.offsetY);
  }
}

/** The distance between two fingers. */
function spread(pointers) {
  const [one, other] = pointers.values();
  return other ? Math.hypot(one.x - other.x, one.y - other.y) : 0;
}

for (const figure of document.querySelectorAll('figure.mesh-view')) {
  try {
    new MeshView(figure);
  } catch (error) {
    console.error(error);  // the static picture stays
  }
}
