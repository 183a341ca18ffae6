// What the page shows is made from this alone: a request's fields, and which model answers. It lives in
// the URL's fragment, which never leaves the browser; what comes from there is checked like anything else.

const CHOICES = { tilted: ['sensor', 'sample'], tilt_plane: ['azimuth', 'elevation'] };

const START = { material: 'aluminium', radar: 'iwrl6432boost', tilted: 'sensor', tilt_plane: 'azimuth', leakage: true, model: 'paper', lesson: '' };

/** @param facts of GET /api/page */
export class State {
  constructor(facts) {
    this.facts = facts;
    this.listeners = [];
    this.note = '';
    this.values = this.start();
  }

  named(list, name) {
    return this.facts[list].find((each) => each.name === name);
  }

  /** Where a lesson begins, or the page without one. */
  start(lesson = '') {
    const values = { ...START };
    for (const field of this.facts.fields) values[field.key] = field.usual;
    return { ...values, ...this.pieceOf(values.material), ...this.named('lessons', lesson)?.scene, lesson };
  }

  /** What all else is, unless said otherwise, under a lesson, a board and a material. */
  usual({ lesson = '', radar, material }) {
    const values = this.start(lesson);
    if (material && material !== values.material) Object.assign(values, this.pieceOf(material), { material });
    if (radar && radar !== values.radar) Object.assign(values, this.boardOf(radar, values.height_mm), { radar });
    return values;
  }

  /** Thickness, bow and roughness of the piece that the models learnt from; nothing for other materials. */
  pieceOf(material) {
    const { name, ...values } = this.named('pieces', material) ?? {};
    return values;
  }

  /** A board's own chirp and noise, and the height that it sees nearest to the one that is. */
  boardOf(radar, height_mm) {
    const { slope_mhz_us, noise_figure_db, heights_mm: [least, most] } = this.named('radars', radar);
    return { slope_mhz_us, noise_figure_db, height_mm: Math.min(most, Math.max(least, height_mm)) };
  }

  /** What is wrong with a value, as a sentence that names the field; nothing where it is allowed. */
  problem(key, value) {
    const is = (good) => (good ? '' : `${key}: ${String(value).slice(0, 40)} is no known choice`);
    const names = (list) => is(Boolean(this.named(list, value)));
    if (key === 'leakage') return is(value === true || value === false);
    if (key in CHOICES) return is(CHOICES[key].includes(value));
    if (key === 'lesson' && value === '') return '';
    if (['material', 'radar', 'model', 'lesson'].includes(key)) return names(`${key}s`);
    const field = this.facts.fields.find((each) => each.key === key);
    if (!field) return `${key.slice(0, 40)}: no such field`;
    const { title, unit, min, max, whole } = field;
    const fault = !Number.isFinite(value) ? 'that is no number' : value < min || value > max ? `${value} is out of range`
      : whole && !Number.isInteger(value) ? `${value} is not a whole number` : '';
    return fault && `${title}: ${fault}; use ${whole ? 'a whole number from ' : ''}${min} to ${max} ${unit}`.trim();
  }

  allowed(key, value) {
    return !this.problem(key, value);
  }

  /** Takes what is allowed of it, notes what is not, and tells the listeners. A radar brings its own chirp and noise. */
  set(changes) {
    const notes = [];
    const board = changes.radar && changes.radar !== this.values.radar && this.named('radars', changes.radar);
    if (board) {
      const brought = this.boardOf(board.name, this.values.height_mm);
      if (!('height_mm' in changes)) notes.push(...this.moved(board, this.values.height_mm, brought.height_mm));
      changes = { ...brought, ...changes };
    }
    this.take(changes, notes);
  }

  moved({ name, heights_mm: [least, most] }, from, to) {
    return from === to ? [] : [`height brought from ${from} to ${to} mm, since ${name} sees ${least} to ${most} mm`];
  }

  take(changes, notes) {
    for (const [key, value] of Object.entries(changes)) {
      const problem = this.problem(key, value);
      if (problem) notes.push(problem);
      else this.values[key] = value;
    }
    this.note = notes.join('. ');
    for (const listener of this.listeners) listener(this.values);
  }

  listen(listener) {
    this.listeners.push(listener);
  }

  /** The fields that the server knows. */
  request() {
    const { model, lesson, ...request } = this.values;
    return request;
  }

  /** What readFragment() makes the same state of: only what differs from what it would take anyway. */
  fragment() {
    const { lesson, radar, material } = this.values;
    const usual = { ...this.usual(this.values), lesson: '' };
    const begun = this.start(lesson);
    if (radar !== begun.radar) usual.radar = '';
    if (material !== begun.material) usual.material = '';
    const words = new URLSearchParams();
    for (const [key, value] of Object.entries(this.values)) if (value !== usual[key]) words.set(key, value);
    return words.toString();
  }

  readFragment(text) {
    const changes = {};
    for (const [key, word] of new URLSearchParams(text)) {
      const isNumber = this.facts.fields.some((each) => each.key === key);
      changes[key] = isNumber ? (word.trim() ? Number(word) : NaN) : key === 'leakage' ? { true: true, false: false }[word] ?? word : word;
    }
    // A material, a board or a lesson and nothing else means its own piece, chirp or scene.
    const chosen = Object.fromEntries(['lesson', 'radar', 'material'].filter((key) => key in changes && this.allowed(key, changes[key])).map((key) => [key, changes[key]]));
    const from = this.start(chosen.lesson).height_mm;
    this.values = this.usual(chosen);
    const board = this.named('radars', this.values.radar);
    this.take(changes, 'height_mm' in changes ? [] : this.moved(board, from, this.values.height_mm));
  }
}
