// What is drawn over the mesh: skeleton, active region, nodes, perturbed regions, and what is picked.

const axisRange = (box, axis) => [box[2 * axis], box[2 * axis + 1]];
const colourOf = (scene, index) => {
  const colour = NODE_COLOURS[index % NODE_COLOURS.length];
  return colour === 'ink' ? scene.colours.ink : colour;
};

function drawOverlays(scene) {
  const {show} = scene.state;
  if (show.skeleton) drawSkeleton(scene);
  if (show.active && scene.mesh.json.active) drawActiveRegion(scene);
  if (show.regions) drawRegions(scene, scene.state.regions, 0.5);
  if (show.allRegions) drawRegions(scene, scene.mesh.allRegions(), 0.22);
  drawNodes(scene);
  drawMarks(scene);
  scene.state.picked.forEach((pick, index) => drawPick(scene, pick, index));
  drawAxes(scene);
}

/**
 * The slice's part of the skeleton (Definition 4.2): lines of Xi_u and Xi_v, and hatched where it lies in Xi_axis. Line
 * by line: stroking one path of thousands of lines takes seconds.
 */
function drawSkeleton(scene) {
  const {axis, half, cut} = scene.state;
  const position = scene.mesh.position(axis, half);
  scene.setPen(REGION_COLOURS[axis], 0.7);
  for (const element of cut.below.concat(cut.above)) hatch(scene, element, position);
  for (const side of otherAxes(axis)) {
    scene.setPen(REGION_COLOURS[side], 1.6);
    for (const element of cut.through.concat(cut.below, cut.above)) traceFaces(scene, element, side, position);
  }
}

/** Where the two faces of an element that are orthogonal to `side` meet the slice. */
function traceFaces(scene, element, side, position) {
  const {axis} = scene.state;
  const along = otherAxes(axis).find((other) => other !== side);
  const range = scene.nearRange(element, along);
  for (const end of scene.nearRange(element, side)) {
    const from = [];
    [from[axis], from[side], from[along]] = [position, end, range[0]];
    const to = from.slice();
    to[along] = range[1];
    scene.strokeLine(from, to);
  }
}

/** A face in the slice: its two diagonals. */
function hatch(scene, element, position) {
  const {axis} = scene.state;
  const [u, v] = otherAxes(axis);
  const [[u0, u1], [v0, v1]] = [scene.nearRange(element, u), scene.nearRange(element, v)];
  for (const [a, b] of [[v0, v1], [v1, v0]]) {
    const from = [];
    const to = [];
    [from[axis], from[u], from[v]] = [position, u0, a];
    [to[axis], to[u], to[v]] = [position, u1, b];
    scene.strokeLine(from, to);
  }
}

function drawActiveRegion(scene) {
  const {mesh, state: {axis, half}} = scene;
  const box = mesh.json.active.map((range, k) => range.map((place) => mesh.placeNear(k, place)));
  scene.strokeBox(box, scene.colours.ink, 1.2, [7, 4]);
  const position = mesh.position(axis, half);
  if (position < box[axis][0] || position > box[axis][1]) return;
  const inSlice = box.slice();
  inSlice[axis] = [position, position];
  scene.strokeBox(inSlice, scene.colours.ink, 2, [7, 4]);
}

/** Rectangles orthogonal to the region's axis; those that the slice meets across are segments or points. */
function drawRegions(scene, parts, opacity) {
  const position = scene.mesh.position(scene.state.axis, scene.state.half);
  for (const {region, ends} of parts) {
    const [u, v] = otherAxes(region);
    const path = new Path2D();
    scene.addRectangle(path, region, ends[2 * region], ...axisRange(ends, u), ...axisRange(ends, v));
    scene.context.globalAlpha = opacity;
    scene.context.fillStyle = REGION_COLOURS[region];
    scene.context.fill(path);
    scene.context.globalAlpha = 1;
    scene.stroke(path, REGION_COLOURS[region], 1);
    if (opacity > 0.4) drawRegionInSlice(scene, region, ends, position);
  }
}

function drawRegionInSlice(scene, region, ends, position) {
  const box = AXES.map((_, axis) => (axis === scene.state.axis ? [position, position] : axisRange(ends, axis)));
  scene.strokeBox(box, REGION_COLOURS[region], 4, [[], [9, 5], [3, 3]][region]);
}

function drawNodes(scene) {
  const {mesh, state: {show, nodes}} = scene;
  if (show.allNodes) drawAllNodes(scene);
  if (show.nodes) scene.dots(nodes.map((node) => mesh.nodeNear(node)), nodes.length > 200 ? 1 : 2.5, scene.colours.ink);
}

/** Without an object a node: there may be 10^5 of them. */
function drawAllNodes({mesh: {nodes, near: [x, y, z]}, context, colours, origin, units: [ux, uy, uz]}) {
  context.fillStyle = colours.ink;
  for (let i = 0; i < nodes.length; i += NODE) {
    const [a, b, c] = [x[nodes[i]], y[nodes[i + 1]], z[nodes[i + 2]]];
    const right = origin[0] + a * ux[0] + b * uy[0] + c * uz[0];
    const down = origin[1] + a * ux[1] + b * uy[1] + c * uz[1];
    context.fillRect(right - 1, down - 1, 2, 2);
  }
}

/** A node with its support and, along each axis, its index vector: a line with a tick at each entry. */
function drawPick(scene, {node, name}, index) {
  const {mesh} = scene;
  const colour = colourOf(scene, index);
  const at = mesh.nodeNear(node);
  const support = mesh.support(node);
  if (support) {
    const box = support.map((range, axis) => range.map((line) => mesh.near[axis][line]));
    scene.strokeBox(box, scene.colours.ground, 4);
    scene.strokeBox(box, colour, 2.2, [[], [12, 4], [8, 3, 2, 3], [4, 4]][index % 4]);
    AXES.forEach((_, axis) => drawVector(scene, node, axis, at, colour));
  }
  scene.dots([at], 6, scene.colours.ground);
  scene.dots([at], 4.5, colour);
  scene.label(name, at, index % 2 === 0 ? 9 : -9 - scene.context.measureText(name).width, index % 4 < 2 ? -9 : 17);
}

function drawVector(scene, node, axis, at, colour) {
  const entries = scene.mesh.vector(node, axis).map((line) => {
    const point = at.slice();
    point[axis] = scene.mesh.near[axis][line];
    return point;
  });
  const path = new Path2D();
  scene.line(path, entries[0], entries[entries.length - 1]);
  scene.stroke(path, scene.colours.ground, 4);
  scene.stroke(path, colour, 1.6);
  scene.dots(entries, 3.4, scene.colours.ink);
  scene.dots(entries, 2.4, colour);
}

/** What a witness names besides nodes, while it is shown. */
function drawMarks(scene) {
  if (!scene.state.witness) return;
  const {points, boxes} = scene.mesh.json.marks;
  for (const {name, lower, upper} of boxes) {
    const box = lower.map((text, axis) => [nearNumber(text), nearNumber(upper[axis])]);
    scene.strokeBox(box, scene.colours.ground, 4.5);
    scene.strokeBox(box, scene.colours.ink, 2.4, [2, 2]);
    scene.label(name, box.map((range) => range[1]));
  }
  for (const {name, at} of points) {
    const point = at.map(nearNumber);
    const [x, y] = scene.project(point);
    const circle = new Path2D();
    circle.arc(x, y, 11, 0, 2 * Math.PI);
    scene.stroke(circle, scene.colours.ground, 4);
    scene.stroke(circle, scene.colours.ink, 2);
    scene.label(name, point, 14, -8);
  }
}

/** The axes' names at the far ends of the domain's edges from the origin. */
function drawAxes(scene) {
  AXES.forEach((name, axis) => {
    const end = [0, 0, 0];
    end[axis] = scene.mesh.domain[axis];
    if (Math.hypot(...scene.units[axis]) > 0.2 * scene.scale) scene.label(name, end, 4, 12);
  });
}
