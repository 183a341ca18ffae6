// A plot of our own in SVG: axes, and marks in the plot's own coordinates. An update changes the attributes
// that differ and makes no new elements: styling those took longer than all else.

const NS = 'http://www.w3.org/2000/svg';
const REST_MS = 250;
const MARGIN = { left: 52, right: 12, top: 10, bottom: 38 };

/** An SVG element with attributes, and text if any. */
export function shape(name, attributes = {}, text = undefined) {
  const element = document.createElementNS(NS, name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  if (text !== undefined) element.textContent = text;
  return element;
}

/** Makes the group's children what the drafts say; touches only what differs from what is drawn. */
function redraw(group, drafts) {
  drafts.forEach(({ name, attributes, text }, i) => {
    let element = group.childNodes[i];
    if (element?.localName !== name) {
      const made = shape(name);
      if (element) element.replaceWith(made);
      else group.append(made);
      element = made;
    }
    const before = element.drawn ?? {};
    for (const key of Object.keys(before)) if (!(key in attributes)) element.removeAttribute(key);
    for (const [key, value] of Object.entries(attributes)) if (before[key] !== value) element.setAttribute(key, value);
    if (text !== undefined && element.textContent !== text) element.textContent = text;
    element.drawn = attributes;
  });
  while (group.childNodes.length > drafts.length) group.lastChild.remove();
}

/** Round numbers from low to high, about n of them. */
export function ticks(low, high, n) {
  const raw = (high - low) / Math.max(1, n);
  const power = 10 ** Math.floor(Math.log10(raw));
  const step = [1, 2, 5, 10].map((m) => m * power).find((s) => s >= raw * 0.999);
  const found = [];
  for (let i = Math.ceil(low / step - 1e-9); i * step <= high + 1e-9 * step; i++) found.push(i * step);
  return found;
}

/** A number without noise behind it; a true minus sign. */
export function shown(value, digits = 3) {
  const text = Math.abs(value) < 1e-9 ? '0' : String(Number(value.toPrecision(digits)));
  return text.replace('-', '\u2212');
}

export class Plot {
  /** @param parent where the figure goes  @param words title, x, y: names of the axes */
  constructor(parent, words) {
    this.words = words;
    this.figure = document.createElement('figure');
    this.figure.className = 'plot';
    const caption = document.createElement('figcaption');
    const title = document.createElement('b');
    title.textContent = words.title;
    this.reading = document.createElement('span');
    caption.append(title, this.reading);
    this.svg = shape('svg', { role: 'img', 'aria-label': words.title });
    this.axes = shape('g', { class: 'axes' });
    this.marks = shape('g', { class: 'marks' });
    this.svg.append(this.axes, this.marks);
    this.legend = document.createElement('div');
    this.legend.className = 'legend';
    this.figure.append(caption, this.svg, this.legend);
    parent.append(this.figure);
    this.width = 0;
    this.isSeen = false;
    new IntersectionObserver(([entry]) => {
      this.isSeen = entry.isIntersecting;
      if (this.isSeen && this.last) this.drawNow();
    }, { rootMargin: '100px' }).observe(this.figure);
    new ResizeObserver(([entry]) => {
      this.width = Math.round(entry.contentRect.width);
      this.height = Math.round(entry.contentRect.height);
      this.svg.setAttribute('viewBox', `0 0 ${this.width} ${this.height}`);
      if (this.last) this.drawNow();
    }).observe(this.svg);
  }

  /** Says what there is to read, to those who see and to those who listen. */
  say(reading, description = reading) {
    const spoken = `${this.words.title}. ${description}`;
    if (this.reading.textContent !== reading) this.reading.textContent = reading;
    if (this.svg.getAttribute('aria-label') !== spoken) this.svg.setAttribute('aria-label', spoken);
  }

  /** @param entries [class of the patch, text] */
  explain(entries) {
    const key = entries.join();
    if (key === this.explained) return;
    this.explained = key;
    this.legend.replaceChildren(...entries.map(([patch, text]) => {
      const entry = document.createElement('span');
      const sign = document.createElement('i');
      sign.className = patch;
      entry.append(sign, text);
      return entry;
    }));
  }

  x(value) {
    const [low, high] = this.last.x;
    return MARGIN.left + ((value - low) / (high - low)) * (this.width - MARGIN.left - MARGIN.right);
  }

  y(value) {
    const [low, high] = this.last.y;
    const share = Math.min(1.02, Math.max(-0.02, (value - low) / (high - low)));
    return this.height - MARGIN.bottom - share * (this.height - MARGIN.top - MARGIN.bottom);
  }

  /**
   * Draws where somebody sees it, else when the hand rests.
   * @param picture x, y: ranges; marks: functions of the plot that each return drafts of SVG elements.
   *   A mark that is the very one of the last picture is not asked again.
   */
  draw(picture) {
    this.last = picture;
    clearTimeout(this.timer);
    if (this.isSeen) this.drawNow();
    else this.timer = setTimeout(() => this.drawNow(), REST_MS);
  }

  drawNow() {
    if (!this.width) return;
    this.drawAxes();
    const { marks } = this.last;
    const groups = this.marks.childNodes;
    while (groups.length > marks.length) this.marks.lastChild.remove();
    while (groups.length < marks.length) this.marks.append(shape('g'));
    marks.forEach((mark, i) => {
      const group = groups[i];
      if (group.mark === mark && group.axes === this.drawnAxes) return;
      redraw(group, mark(this));
      Object.assign(group, { mark, axes: this.drawnAxes });
    });
  }

  drawAxes() {
    const { x, y, xTicks } = this.last;
    const key = [x, y, this.width, this.height, this.words.y].join();
    if (key === this.drawnAxes) return;
    this.drawnAxes = key;
    const parts = [];
    const bottom = this.height - MARGIN.bottom;
    for (const value of ticks(y[0], y[1], this.height / 46)) {
      const at = this.y(value);
      parts.push(shape('path', { class: 'axis', d: `M${MARGIN.left} ${at}H${this.width - MARGIN.right}` }),
        shape('text', { class: 'tick', x: MARGIN.left - 7, y: at + 4, 'text-anchor': 'end' }, shown(value)));
    }
    for (const value of xTicks ?? ticks(x[0], x[1], this.width / 75)) {
      parts.push(shape('text', { class: 'tick', x: this.x(value), y: bottom + 17, 'text-anchor': 'middle' }, shown(value, 4)));
    }
    const middle = MARGIN.left + (this.width - MARGIN.left - MARGIN.right) / 2;
    parts.push(shape('text', { class: 'name', x: middle, y: this.height - 4, 'text-anchor': 'middle' }, this.words.x),
      shape('text', { class: 'name', transform: `translate(12 ${(MARGIN.top + bottom) / 2}) rotate(-90)`, 'text-anchor': 'middle' }, this.words.y));
    this.axes.replaceChildren(...parts);
  }
}

// --- marks: each takes its data and returns a function of the plot -------------------------------

const draft = (name, attributes, text = undefined) => ({ name, attributes, text });

const path = (plot, xs, ys) => ys.map((v, i) => `${i ? 'L' : 'M'}${plot.x(xs[i]).toFixed(1)} ${plot.y(v).toFixed(1)}`).join('');

export const line = (xs, ys, style = '') => (plot) => [draft('path', { class: `line ${style}`, d: path(plot, xs, ys) })];

export const area = (xs, lows, highs, style) => (plot) => [draft('path', {
  class: style,
  d: `${path(plot, xs, highs)}${path(plot, [...xs].reverse(), [...lows].reverse()).replace('M', 'L')}Z`,
})];

/** A band over the whole height, from one x to another. */
export const band = (from, to, style, edge = '') => (plot) => {
  const [left, right] = [plot.x(from), plot.x(to)];
  const box = { x: left, y: MARGIN.top, width: Math.max(0, right - left), height: plot.height - MARGIN.top - MARGIN.bottom };
  const drawn = [draft('rect', { class: style, ...box })];
  if (edge) drawn.push(draft('path', { class: edge, d: `M${left} ${box.y}v${box.height}M${right} ${box.y}v${box.height}` }));
  return drawn;
};

/** Bars from the floor; those of one style are one path. */
export const bars = (xs, ys, style) => (plot) => {
  const width = Math.max(1.5, (plot.x(1) - plot.x(0)) * 0.72);
  const floor = plot.height - MARGIN.bottom;
  const paths = {};
  ys.forEach((v, i) => {
    const name = style(xs[i]);
    const left = (plot.x(xs[i]) - width / 2).toFixed(1);
    paths[name] = `${paths[name] ?? ''}M${left} ${floor}V${Math.min(floor, plot.y(v)).toFixed(1)}h${width.toFixed(1)}V${floor}z`;
  });
  return Object.entries(paths).map(([name, d]) => draft('path', { class: name, d }));
};

export const dots = (xs, ys, style = 'dot', radius = 4.5) => (plot) =>
  ys.map((v, i) => draft('circle', { class: style, cx: plot.x(xs[i]).toFixed(1), cy: plot.y(v).toFixed(1), r: radius }));

export const cursor = (x) => (plot) => [draft('path', {
  class: 'cursor', d: `M${plot.x(x).toFixed(1)} ${MARGIN.top}V${plot.height - MARGIN.bottom}`,
})];
