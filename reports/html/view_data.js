// What a mesh's JSON says (reports/html/mesh_view.hpp), decoded once. Lines are compared as integers; a position across
// an axis is a half rank, as in lib/spline/index_sets.hpp: 2*line on a line, 2*line+1 in the middle between it and the
// next one. Floating-point numbers only place pixels; every text is exact.

const AXES = ['x', 'y', 'z'];
const NO_LEVEL = -2147483648;
const ELEMENT = 7;  // numbers an element: x0, x1, y0, y1, z0, z1, level
const NODE = 6;     // numbers a node: x, y, z, its index vectors

const otherAxes = (axis) => [0, 1, 2].filter((other) => other !== axis);

// ---- exact numbers -------------------------------------------------------------------------------------------------

/** "5/2" as [5n, 2n]. */
function rational(text) {
  const [numerator, denominator] = text.split('/');
  return [BigInt(numerator), BigInt(denominator ?? 1)];
}

function rationalText([numerator, denominator]) {
  let [a, b] = [numerator < 0n ? -numerator : numerator, denominator];
  while (b !== 0n) [a, b] = [b, a % b];
  const [n, d] = [numerator / (a || 1n), denominator / (a || 1n)];
  return d === 1n ? `${n}` : `${n}/${d}`;
}

/** The nearest pixel's worth; numerators and denominators may be far beyond what a double holds. */
function nearNumber(text) {
  const [numerator, denominator] = rational(text);
  return Number((numerator << 64n) / denominator) / 2 ** 64;
}

function middleText(one, other) {
  const [[a, b], [c, d]] = [rational(one), rational(other)];
  return rationalText([a * d + c * b, 2n * b * d]);
}

const pointText = (texts) => `(${texts.join(', ')})`;

// ---- the mesh ------------------------------------------------------------------------------------------------------

function decodeTable({data}) {
  const binary = atob(data);
  const bytes = new DataView(new ArrayBuffer(binary.length));
  for (let i = 0; i < binary.length; ++i) bytes.setUint8(i, binary.charCodeAt(i));
  const table = new Int32Array(binary.length / 4);
  for (let i = 0; i < table.length; ++i) table[i] = bytes.getInt32(4 * i, true);
  return table;
}

class MeshData {
  constructor(json) {
    this.json = json;
    this.domain = json.domain;
    this.lines = json.lines;
    this.near = json.lines.map((lines) => Float64Array.from(lines, nearNumber));
    this.elements = decodeTable(json.elements);
    this.elementCount = json.elements.count;
    this.nodes = decodeTable(json.nodes);
    this.nodeCount = json.nodes.count;
    this.levels = this.countLevels();
    const integers = this.levels.map(({level}) => level).filter((level) => level !== NO_LEVEL);
    this.levelRange = [integers[0] ?? 0, integers[integers.length - 1] ?? 0];
    this.sides = this.findSides();
  }

  countLevels() {
    const counts = new Map();
    for (let i = 6; i < this.elements.length; i += ELEMENT) {
      counts.set(this.elements[i], (counts.get(this.elements[i]) ?? 0) + 1);
    }
    return [...counts].sort((one, other) => one[0] - other[0]).map(([level, count]) => ({level, count}));
  }

  /** For each axis the elements at the domain's lower and at its upper side. */
  findSides() {
    const sides = AXES.map(() => [[], []]);
    for (let e = 0; e < this.elementCount; ++e) {
      for (let axis = 0; axis < 3; ++axis) {
        if (this.lower(e, axis) === 0) sides[axis][0].push(e);
        if (this.upper(e, axis) === this.lastLine(axis)) sides[axis][1].push(e);
      }
    }
    return sides;
  }

  lastLine(axis) { return this.lines[axis].length - 1; }
  lower(element, axis) { return this.elements[ELEMENT * element + 2 * axis]; }
  upper(element, axis) { return this.elements[ELEMENT * element + 2 * axis + 1]; }
  level(element) { return this.elements[ELEMENT * element + 6]; }

  /** Of a half rank: exactly, and nearly. */
  positionText(axis, half) {
    const lines = this.lines[axis];
    const line = half >> 1;
    return half % 2 === 0 ? lines[line] : middleText(lines[line], lines[line + 1]);
  }
  position(axis, half) {
    const line = half >> 1;
    const near = this.near[axis];
    return half % 2 === 0 ? near[line] : (near[line] + near[line + 1]) / 2;
  }

  /** A place: a line's number, or an exact coordinate where there is no line. */
  placeText(axis, place) { return typeof place === 'number' ? this.lines[axis][place] : place; }
  placeNear(axis, place) { return typeof place === 'number' ? this.near[axis][place] : nearNumber(place); }

  /** The half rank of an exact coordinate; between lines that of the middle. */
  halfOf(axis, text) {
    const [n, d] = rational(text);
    let [low, high] = [0, this.lastLine(axis)];
    while (low < high) {  // the last line that is not above it
      const middle = (low + high + 1) >> 1;
      const [a, b] = rational(this.lines[axis][middle]);
      if (a * d <= n * b) low = middle; else high = middle - 1;
    }
    const [a, b] = rational(this.lines[axis][low]);
    return a * d === n * b || low === this.lastLine(axis) ? 2 * low : 2 * low + 1;
  }

  /** The closed elements that a plane meets with area: those that it goes through, those that end or begin at it. */
  cut(axis, half) {
    const result = {through: [], below: [], above: []};
    for (let e = 0, i = 2 * axis; e < this.elementCount; ++e, i += ELEMENT) {
      const lower = 2 * this.elements[i];
      const upper = 2 * this.elements[i + 1];
      if (lower < half && half < upper) result.through.push(e);
      else if (upper === half) result.below.push(e);
      else if (lower === half) result.above.push(e);
    }
    return result;
  }

  nodesIn(axis, half) {
    const result = [];
    for (let n = 0; n < this.nodeCount; ++n) {
      if (2 * this.nodeLine(n, axis) === half) result.push(n);
    }
    return result;
  }

  nodeLine(node, axis) { return this.nodes[NODE * node + axis]; }
  nodeNear(node) { return AXES.map((_, axis) => this.near[axis][this.nodeLine(node, axis)]); }
  nodeText(node) { return pointText(AXES.map((_, axis) => this.lines[axis][this.nodeLine(node, axis)])); }
  /** The lines of an index vector (Definition 4.4); nothing when it does not exist. */
  vector(node, axis) { return this.json.vectors[axis][this.nodes[NODE * node + 3 + axis]] ?? null; }
  vectorText(node, axis) {
    const vector = this.vector(node, axis);
    return vector ? pointText(vector.map((line) => this.lines[axis][line])) : 'not known';
  }
  /** For each axis the first and the last line of the index vector: supp B_v. */
  support(node) {
    const vectors = AXES.map((_, axis) => this.vector(node, axis));
    return vectors.every(Boolean) ? vectors.map((vector) => [vector[0], vector[vector.length - 1]]) : null;
  }
  supportText(node) {
    const support = this.support(node);
    if (!support) return 'not known';
    return support.map((range, axis) => `[${range.map((line) => this.lines[axis][line]).join(', ')}]`).join(' × ');
  }

  /** The number of elements that have volume in common with a node's support. */
  elementsInSupport(node) {
    const support = this.support(node);
    let count = 0;
    for (let e = 0; support && e < this.elementCount; ++e) {
      if (support.every(([low, high], axis) => this.lower(e, axis) < high && low < this.upper(e, axis))) ++count;
    }
    return count;
  }

  /** The parts of the perturbed regions that a plane meets, each with its region's axis and its ends as numbers. */
  regionsIn(axis, half) {
    const position = this.position(axis, half);
    return this.allRegions().filter(({ends}) => ends[2 * axis] <= position && position <= ends[2 * axis + 1]);
  }
  allRegions() {
    this.regionParts ??= (this.json.regions ?? []).flatMap((boxes, region) => boxes.map((box) => (
      {region, ends: box.map((place, i) => this.placeNear(i >> 1, place))})));
    return this.regionParts;
  }
}

const levelText = (level) => (level === NO_LEVEL ? 'none' : `${level}`);
