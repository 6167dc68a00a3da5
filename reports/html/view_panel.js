// The elements of an interactive view: a canvas, the controls, the legend, and the text that says what is shown.

function make(tag, properties = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name in element && name !== 'role') element[name] = value;
    else element.setAttribute(name, value);
  }
  element.append(...children);
  return element;
}

const button = (text, title, onclick) => make('button', {type: 'button', title, 'aria-label': title, onclick}, text);
const wordButton = (text, name, onclick) => make('button', {type: 'button', className: name, onclick}, text);
const group = (name, ...children) => make('fieldset', {}, make('legend', {}, name), ...children);
const row = (...children) => make('div', {className: 'mesh-view-row'}, ...children);

const SHOWN = [
  ['elements', 'elements', true],
  ['skeleton', 'skeleton in the slice', false],
  ['active', 'active region', true],
  ['nodes', 'active nodes in the slice', true],
  ['allNodes', 'all active nodes', false],
  ['regions', 'perturbed regions in the slice', true],
  ['allRegions', 'all perturbed regions', false],
];

/** Builds the controls of `view` and puts them into its figure, behind the static picture. */
class Panel {
  constructor(view) {
    this.view = view;
    this.mesh = view.mesh;
    this.canvas = make('canvas', {
      tabIndex: 0, role: 'application',
      'aria-label': 'The mesh, cut at the slice. Arrow keys turn it, plus and minus zoom, Home resets the view, ' +
        'page up and page down move the slice, n and p pick the next and the previous node.',
    });
    this.says = make('div', {className: 'mesh-view-says', 'aria-live': 'polite'});
    this.live = make('div', {className: 'mesh-view-live'}, this.canvas, make('div', {className: 'mesh-view-panel'},
      this.sliceControls(), this.turnControls(), this.nodeControls(), this.showControls(), this.legend()), this.says);
    view.figure.prepend(this.live);
    view.figure.classList.add('mesh-view-ready');
  }

  sliceControls() {
    const name = `slice-axis-${Panel.count = (Panel.count ?? 0) + 1}`;
    this.axes = AXES.map((text, axis) => make('input', {
      type: 'radio', name, value: text, onchange: () => this.view.sliceThroughPick(axis),
    }));
    this.slider = make('input', {
      type: 'range', min: 0, step: 1, className: 'mesh-view-slider', 'aria-label': 'place of the slice',
      oninput: () => this.view.slice(this.view.state.axis, Number(this.slider.value)),
    });
    this.sliceText = make('p', {className: 'mesh-view-slice'});
    return group('Slice orthogonal to',
      row(...this.axes.map((input, axis) => make('label', {}, input, AXES[axis]))),
      row(button('◂', 'Move the slice down', () => this.view.moveSlice(-1)), this.slider,
        button('▸', 'Move the slice up', () => this.view.moveSlice(1))),
      this.sliceText);
  }

  turnControls() {
    const turn = (yaw, pitch) => () => this.view.turn(yaw, pitch);
    return group('View',
      row(button('←', 'Turn to the left', turn(-15, 0)), button('→', 'Turn to the right', turn(15, 0)),
        button('↑', 'Turn up', turn(0, 15)), button('↓', 'Turn down', turn(0, -15)),
        button('+', 'Zoom in', () => this.view.zoom(1.25)), button('−', 'Zoom out', () => this.view.zoom(0.8))),
      row(wordButton('Face the slice', 'mesh-view-face', () => this.view.faceSlice()),
        wordButton('Reset', 'mesh-view-reset', () => this.view.reset())));
  }

  nodeControls() {
    const {nodeCount, json} = this.mesh;
    this.number = make('input', {
      type: 'number', min: 1, max: nodeCount, className: 'mesh-view-number',
      onchange: () => this.view.pickNumber(Number(this.number.value)),
    });
    const controls = nodeCount === 0 ? [row('There is none.')] : [
      row(button('‹', 'Previous node', () => this.view.step(-1)), button('›', 'Next node', () => this.view.step(1)),
        make('label', {}, 'number ', this.number, ` of ${nodeCount}`)),
      row(wordButton('Zoom to it', 'mesh-view-near', () => this.view.zoomToPicked()),
        wordButton('None', 'mesh-view-none', () => this.view.pick([]))),
    ];
    const named = json.picked.length + json.marks.boxes.length + json.marks.points.length;
    if (named > 0) {
      controls.push(row(wordButton(this.witnessWords(), 'mesh-view-witness', () => this.view.showWitness())));
    }
    return group('Active node', ...controls);
  }

  witnessWords() {
    if (this.mesh.json.picked.length === 2) return 'Show the violated pair';
    return this.mesh.json.picked.length > 0 ? 'Show the nodes that violate it' : 'Show what violates it';
  }

  showControls() {
    const known = SHOWN.filter(([key]) => this.mesh.json.regions || !/regions/i.test(key));
    return group('Show', ...known.map(([key, text, initially]) => {
      this.view.state.show[key] = initially;
      const box = make('input', {
        type: 'checkbox', name: key, checked: initially,
        onchange: () => this.view.toggle(key, box.checked),
      });
      return make('label', {}, box, text);
    }));
  }

  legend() {
    const swatch = (colour) => make('span', {className: 'mesh-view-swatch', style: `background:${colour}`});
    const levels = this.mesh.levels.map(({level, count}) => make('li', {'data-level': levelText(level)},
      swatch(levelColour(level, this.mesh.levelRange)),
      `level ${levelText(level)}: ${count} element${count === 1 ? '' : 's'}`));
    const regions = !this.mesh.json.regions ? [] : AXES.map((name, axis) => make('li', {},
      swatch(REGION_COLOURS[axis]),
      `perturbed region R${name}, ${this.mesh.json.regions[axis].length === 0 ? 'empty' : 'not empty'}`));
    return group('Legend', make('ul', {className: 'mesh-view-legend', tabIndex: 0}, ...levels, ...regions));
  }

  // ---- what changes ------------------------------------------------------------------------------------------------

  showSlice({axis, half, cut, nodes}) {
    this.axes[axis].checked = true;
    this.slider.max = 2 * this.mesh.lastLine(axis);
    this.slider.value = half;
    const place = `${AXES[axis]} = ${this.mesh.positionText(axis, half)}`;
    const ends = half % 2 === 0 ? `, that end there: ${cut.below.length}, that begin there: ${cut.above.length}` : '';
    const counts = `Elements that it goes through: ${cut.through.length}${ends}. Active nodes in it: ${nodes.length}.`;
    this.slider.setAttribute('aria-valuetext', `${place}. ${counts}`);
    this.sliceText.textContent = `${place}. ${counts}`;
  }

  showPicked({picked, witness}) {
    if (picked.length > 0) this.number.value = picked[0].node + 1;
    const parts = picked.map(({node, name}, index) => this.nodeText(node, name, index));
    if (witness && this.mesh.json.says) parts.unshift(make('p', {}, `${this.mesh.json.says}.`));
    if (witness) parts.push(...this.markTexts());
    if (parts.length === 0 && this.mesh.nodeCount > 0) {
      parts.push(make('p', {}, 'No node is picked: click one in the slice, or choose it by its number.'));
    }
    this.says.replaceChildren(...parts);
  }

  nodeText(node, name, index) {
    const colour = NODE_COLOURS[index % NODE_COLOURS.length];
    const swatch = make('span', {
      className: 'mesh-view-swatch', style: `background:${colour === 'ink' ? 'currentColor' : colour}`,
    });
    const vectors = AXES.map((axis, k) => make('li', {'data-vector': axis},
      `index vector along ${axis}: ${this.mesh.vectorText(node, k)}`));
    return make('div', {className: 'mesh-view-node', 'data-node': node},
      make('p', {}, swatch, make('strong', {}, name), ` = ${this.mesh.nodeText(node)}, active node ${node + 1} of ` +
        `${this.mesh.nodeCount}`),
      make('ul', {}, ...vectors, make('li', {'data-support': ''}, `support: ${this.mesh.supportText(node)}, which ` +
        `${this.mesh.elementsInSupport(node)} elements share volume with`)));
  }

  markTexts() {
    const {points, boxes} = this.mesh.json.marks;
    return [
      ...points.map(({name, at}) => make('p', {}, `${name}: the point ${pointText(at)}`)),
      ...boxes.map(({name, lower, upper}) => make('p', {}, `${name}: the box ` +
        lower.map((text, axis) => `[${text}, ${upper[axis]}]`).join(' × '))),
    ];
  }
}
