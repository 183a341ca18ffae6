// The dialog: the address, files, figures, and the command of a sweep.

import { ask, save } from './server.js';
import { shape } from './plot.js';

const WIDTH = 1280;
const COLUMNS = 2;
const HEAD = 96;

/** The plot's legend as a row of patches and texts. */
function legend(plot, y) {
  let x = 60;
  return [...plot.legend.children].flatMap((entry) => {
    const patch = entry.firstChild.className;
    const parts = patch === 'ring' ? [shape('circle', { class: 'ring', cx: x + 5, cy: y - 4, r: 4 })]
      : [shape('rect', { class: patch, x, y: y - 9, width: 10, height: 10, rx: 2 })];
    parts.push(shape('text', { class: 'tick', x: x + 15, y }, entry.textContent));
    x += 30 + 6.6 * entry.textContent.length;
    return parts;
  });
}

/** All plots as one figure that stands alone, in the light colours. */
async function figureSvg(charts, subtitle) {
  const css = await (await fetch('chart.css')).text();
  const theme = await (await fetch('theme.css')).text();
  const light = theme.match(/:root \{[^}]*\}/)[0];
  const cell = WIDTH / COLUMNS;
  const tall = 322;
  const rows = Math.ceil(charts.length / COLUMNS);
  const svg = shape('svg', { xmlns: 'http://www.w3.org/2000/svg', width: WIDTH, height: HEAD + rows * tall, viewBox: `0 0 ${WIDTH} ${HEAD + rows * tall}` });
  svg.append(shape('style', {}, `${light} text { font-family: Helvetica, Arial, sans-serif; } ${css}`),
    shape('title', {}, subtitle), shape('rect', { width: '100%', height: '100%', fill: '#ffffff' }),
    shape('text', { x: 24, y: 40, 'font-size': 24, 'font-weight': 700 }, 'Specula: one chirp'),
    shape('text', { x: 24, y: 68, 'font-size': 15, fill: '#4d4d4d' }, subtitle));
  charts.forEach((plot, i) => {
    const place = shape('g', { transform: `translate(${(i % COLUMNS) * cell + 12} ${HEAD + Math.floor(i / COLUMNS) * tall})` });
    place.append(shape('text', { x: 40, y: 16, 'font-size': 15, 'font-weight': 700 }, plot.words.title),
      shape('text', { x: cell - 36, y: 16, 'font-size': 13, fill: '#4d4d4d', 'text-anchor': 'end' }, plot.reading.textContent));
    plot.drawNow();
    const drawn = plot.svg.cloneNode(true);
    for (const [key, value] of Object.entries({ y: 24, width: cell - 24, height: tall - 66, preserveAspectRatio: 'xMidYMid meet' })) drawn.setAttribute(key, value);
    place.append(drawn, ...legend(plot, tall - 24));
    svg.append(place);
  });
  return new XMLSerializer().serializeToString(svg);
}

/** The same as pixels, twice as fine. */
async function figurePng(svg) {
  const picture = new Image();
  picture.src = URL.createObjectURL(new Blob([svg], { type: 'image/svg+xml' }));
  await picture.decode();
  const canvas = document.createElement('canvas');
  canvas.width = picture.naturalWidth * 2;
  canvas.height = picture.naturalHeight * 2;
  canvas.getContext('2d').drawImage(picture, 0, 0, canvas.width, canvas.height);
  URL.revokeObjectURL(picture.src);
  return new Promise((done) => canvas.toBlob(done, 'image/png'));
}

export class Sharing {
  /** @param describe the scene in a line  @param complain takes a text */
  constructor(state, charts, describe, complain) {
    Object.assign(this, { state, charts, describe, complain });
    this.dialog = document.getElementById('sharing');
    document.getElementById('share').addEventListener('click', () => this.open());
    document.getElementById('close-sharing').addEventListener('click', () => this.dialog.close());
    this.dialog.addEventListener('click', (event) => this.press(event.target.closest('button')));
  }

  open() {
    document.getElementById('link').value = [location.href.split('#')[0], this.state.fragment()].filter(Boolean).join('#');
    for (const axis of ['tilt', 'height']) {
      document.getElementById(`sweep-${axis}`).value = this.charts[`${axis}Curve`]?.command ?? '';
    }
    this.dialog.showModal();
  }

  async press(button) {
    if (!button) return;
    const { copy, file, figure } = button.dataset;
    try {
      if (copy) await this.copy(button, document.getElementById(copy));
      if (file) await this.download(file);
      if (figure) await this.draw(figure);
    } catch (error) {
      this.complain(error.message);
    }
  }

  async copy(button, field) {
    field.select();
    // Off the loopback there is no clipboard but the old one.
    if (navigator.clipboard) await navigator.clipboard.writeText(field.value);
    else document.execCommand('copy');
    button.textContent = 'Copied';
    setTimeout(() => { button.textContent = 'Copy'; }, 1500);
  }

  async download(file) {
    const response = await ask(`api/${file}`, this.state.request());
    const name = response.headers.get('Content-Disposition').match(/filename="([^"]+)"/)[1];
    save(name, await response.blob());
  }

  async draw(kind) {
    const svg = await figureSvg(this.charts.all, this.describe());
    save(`specula_chirp.${kind}`, kind === 'svg' ? new Blob([svg], { type: 'image/svg+xml' }) : await figurePng(svg));
  }
}
