// Sliders and choices. Every number can be dragged and typed; ranges and units are the server's.

const GROUPS = [
  ['Sample', ['material', 'size_mm', 'thickness_mm', 'roughness_um', 'bow_mm']],
  ['Geometry', ['height_mm', 'tilt_deg', 'tilted', 'tilt_plane']],
  ['Recording', ['session', 'frame']],
];
const RADAR = ['radar', 'slope_mhz_us', 'noise_figure_db', 'leakage', 'leakage_db', 'correlation_mm'];
const SLIDER = { height_mm: [250, 650], roughness_um: [0, 600], bow_mm: [-3, 3], tilt_deg: [-20, 20], thickness_mm: [0.5, 30] };
const CHOICES = {
  tilted: [['sensor', 'Tilt the sensor'], ['sample', 'Tilt the sample']],
  tilt_plane: [['azimuth', 'in azimuth'], ['elevation', 'in elevation']],
};

export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (key === 'class') made.className = value;
    else if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (value === true) made.setAttribute(key, '');
    else if (value !== false) made.setAttribute(key, value);
  }
  made.append(...children);
  return made;
}

/** Changes an element's text where it differs. */
export function put(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

const decimals = (step) => (step >= 1 ? 0 : step >= 0.1 ? 1 : 2);

export class Controls {
  constructor(form, state) {
    Object.assign(this, { form, state, showers: [] });
    form.addEventListener('submit', (event) => event.preventDefault());
    this.problem = element('p', { class: 'problem', role: 'alert', hidden: true });
    const groups = GROUPS.map(([title, keys]) =>
      element('fieldset', {}, element('legend', {}, title), ...keys.map((key) => this.field(key))));
    const radar = element('details', {}, element('summary', {}, 'Radar: chirp, noise, leakage'), ...RADAR.map((key) => this.field(key)));
    form.append(this.problem, ...groups, radar, this.home());
    state.listen((values) => this.show(values));
  }

  show(values) {
    for (const shower of this.showers) shower(values);
  }

  /** What is wrong with the request, or nothing. */
  complain(text) {
    this.problem.textContent = text;
    this.problem.hidden = !text;
  }

  home() {
    return element('p', {}, element('button', { type: 'button', onclick: () => this.state.set(this.state.start(this.state.values.lesson)) }, 'Start over'));
  }

  field(key) {
    if (key === 'material') return this.materials();
    if (key === 'radar') return this.radars();
    if (key === 'leakage') return this.leakage();
    if (key in CHOICES) return this.choice(key);
    return this.number(this.state.facts.fields.find((each) => each.key === key));
  }

  number(field) {
    const [min, max] = SLIDER[field.key] ?? [field.min, field.max];
    const id = `field-${field.key}`;
    let drawn = null;
    const text = (value) => value.toFixed(decimals(field.step)).replace(/(\.\d*?)0+$/, '$1').replace(/\.$/, '');
    const change = ({ target }) => {
      this.state.set({ [field.key]: target.valueAsNumber });
      if (target === typed && !this.state.allowed(field.key, target.valueAsNumber)) typed.value = text(this.state.values[field.key]);
    };
    const slider = element('input', { type: 'range', id, min, max, step: field.step, oninput: change, 'aria-label': field.title });
    const typed = element('input', { type: 'number', min: field.min, max: field.max, step: 'any', onchange: change, onblur: () => { drawn = null; this.show(this.state.values); }, 'aria-label': `${field.title}${field.unit && `, ${field.unit}`}, ${field.min} to ${field.max}` });
    this.showers.push((values) => {
      const value = values[field.key];
      if (value === drawn && document.activeElement !== typed) return;
      drawn = value;
      slider.value = value;
      slider.setAttribute('aria-valuetext', `${value} ${field.unit}`);
      if (document.activeElement !== typed) typed.value = text(value);
    });
    const parts = [element('label', { for: id }, field.title), element('span', { class: 'value' }, typed, element('span', { class: 'unit' }, field.unit)), slider];
    if (field.key === 'session') parts.push(this.sessionNote());
    return element('div', { class: 'field' }, ...parts);
  }

  sessionNote() {
    const note = element('small', { class: 'note' });
    this.showers.push(({ session }) => {
      const known = this.state.facts.training_sessions;
      const text = session === 0 ? 'The bench drawing: no room, nothing misplaced'
        : session <= known ? 'One of the recordings the models learnt from' : 'A recording no model has seen';
      put(note, text);
    });
    return note;
  }

  choice(key) {
    const buttons = CHOICES[key].map(([value, title]) =>
      element('button', { type: 'button', onclick: () => this.state.set({ [key]: value }) }, title));
    let drawn = '';
    this.showers.push((values) => {
      if (values[key] === drawn) return;
      drawn = values[key];
      buttons.forEach((button, i) => button.setAttribute('aria-pressed', drawn === CHOICES[key][i][0]));
    });
    return element('div', { class: 'pair', role: 'group', 'aria-label': key === 'tilted' ? 'What is tilted' : 'Plane of the tilt' }, ...buttons);
  }

  materials() {
    const { facts } = this.state;
    const pick = (name) => this.state.set({ material: name, ...this.state.pieceOf(name) });
    const chips = facts.classes.map((name) => element('button', { type: 'button', onclick: () => pick(name) }, name));
    const select = element('select', { id: 'field-material', onchange: (event) => pick(event.target.value) });
    for (const group of [...new Set(facts.materials.map((each) => each.group))]) {
      select.append(element('optgroup', { label: group }, ...facts.materials.filter((each) => each.group === group)
        .map((each) => element('option', { value: each.name }, each.name.replaceAll('_', ' ')))));
    }
    let drawn = '';
    this.showers.push(({ material }) => {
      if (material === drawn) return;
      drawn = material;
      select.value = material;
      chips.forEach((chip, i) => chip.setAttribute('aria-pressed', facts.classes[i] === material));
    });
    return element('div', { class: 'field' }, element('label', { for: 'field-material' }, 'Material'), element('span'), select,
      element('div', { class: 'chips', role: 'group', 'aria-label': 'The five classes' }, ...chips));
  }

  radars() {
    const select = element('select', { id: 'field-radar', onchange: (event) => this.state.set({ radar: event.target.value }) },
      ...this.state.facts.radars.map((each) => element('option', { value: each.name }, each.name)));
    this.showers.push(({ radar }) => { select.value = radar; });
    return element('div', { class: 'field' }, element('label', { for: 'field-radar' }, 'Board and chirp'), element('span'), select);
  }

  leakage() {
    const box = element('input', { type: 'checkbox', id: 'field-leakage', onchange: (event) => this.state.set({ leakage: event.target.checked }) });
    this.showers.push(({ leakage }) => { box.checked = leakage; });
    return element('div', { class: 'field switch' }, box, element('label', { for: 'field-leakage' }, 'Leakage from TX to RX'));
  }
}
