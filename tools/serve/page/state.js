// What the page shows is made from this alone: a request's fields, and which model answers. It lives in
// the URL's fragment, which never leaves the browser; what comes from there is checked like anything else.

const CHOICES = { tilted: ['sensor', 'sample'], tilt_plane: ['azimuth', 'elevation'] };

/** @param facts of GET /api/page */
export class State {
  constructor(facts) {
    this.facts = facts;
    this.listeners = [];
    this.values = this.usual();
  }

  usual() {
    const values = { material: 'aluminium', radar: 'iwrl6432boost', tilted: 'sensor', tilt_plane: 'azimuth', leakage: true, model: 'paper', lesson: '' };
    for (const field of this.facts.fields) values[field.key] = field.usual;
    return { ...values, ...this.pieceOf(values.material) };
  }

  /** Thickness, bow and roughness of the piece that the models learnt from; nothing for other materials. */
  pieceOf(material) {
    const piece = this.facts.pieces.find((each) => each.name === material);
    if (!piece) return {};
    const { name, ...values } = piece;
    return values;
  }

  allowed(key, value) {
    if (key === 'leakage') return value === true || value === false;
    if (key in CHOICES) return CHOICES[key].includes(value);
    const names = (list) => list.some((each) => each.name === value);
    if (key === 'material') return names(this.facts.materials);
    if (key === 'radar') return names(this.facts.radars);
    if (key === 'model') return names(this.facts.models);
    if (key === 'lesson') return value === '' || names(this.facts.lessons);
    const field = this.facts.fields.find((each) => each.key === key);
    return Boolean(field) && Number.isFinite(value) && value >= field.min && value <= field.max;
  }

  /** Takes what is allowed of it, and tells the listeners. A radar brings its own chirp and noise. */
  set(changes) {
    if (changes.radar && changes.radar !== this.values.radar) {
      const radar = this.facts.radars.find((each) => each.name === changes.radar);
      if (radar) changes = { slope_mhz_us: radar.slope_mhz_us, noise_figure_db: radar.noise_figure_db, ...changes };
    }
    for (const [key, value] of Object.entries(changes)) {
      if (this.allowed(key, value)) this.values[key] = value;
    }
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

  /** Only what differs from the usual. */
  fragment() {
    const usual = this.usual();
    const words = new URLSearchParams();
    for (const [key, value] of Object.entries(this.values)) if (value !== usual[key]) words.set(key, value);
    return words.toString();
  }

  readFragment(text) {
    const changes = {};
    for (const [key, word] of new URLSearchParams(text)) {
      const isNumber = this.facts.fields.some((each) => each.key === key);
      changes[key] = isNumber ? Number(word) : key === 'leakage' ? word === 'true' : word;
    }
    // A material and nothing else means the piece the models know.
    this.values = this.usual();
    if (this.allowed('material', changes.material)) Object.assign(this.values, this.pieceOf(changes.material));
    this.set(changes);
  }
}
