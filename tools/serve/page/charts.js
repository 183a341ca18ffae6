// The page's plots: what each of them shows of an answer.

import { Plot, area, band, bars, cursor, dots, line, shown } from './plot.js';

const LEAST_LSB = 0.05;
const decibels = (amplitude) => 20 * Math.log10(Math.max(amplitude, LEAST_LSB));
const nepers = (value) => Math.max(-26, value * 8.685889638);
const index = (n) => Array.from({ length: n }, (_, i) => i);

/** The smallest of a few round ranges that holds a value, so that the axis rarely moves. */
function reach(value) {
  return [100, 200, 500, 1000, 2048].find((each) => each >= value) ?? value;
}

export class Charts {
  constructor(parent, facts) {
    this.facts = facts;
    this.learnt = new Map();
    const plot = (title, x, y) => new Plot(parent, { title, x, y });
    this.profile = plot('Range profile', 'range bin', 'amplitude (dB over 1 LSB)');
    this.descriptor = plot('Descriptor: 12 numbers', 'range bin', 'amplitude (dB over 1 LSB)');
    this.tilt = plot('Level over tilt', 'tilt (degrees)', 'dB over an endless mirror');
    this.height = plot('Level over height', 'height (mm)', 'received power (dBm)');
    this.slab = plot('Slab reflection', 'frequency (GHz)', 'dB over a mirror');
    this.adc = plot('ADC samples', 'sample of the chirp', 'code (LSB)');
    this.adc.explain([['f1', 'RX 1'], ['f2', 'RX 2'], ['f3', 'RX 3']]);
    this.profile.explain([['f1', 'bins 6 to 17, the descriptor'], ['f0', 'other bins'], ['ring', 'an endless mirror at this height']]);
  }

  get all() {
    return [this.profile, this.descriptor, this.tilt, this.height, this.slab, this.adc];
  }

  /** @param answer of /api/chirp  @param model the chosen one's facts */
  show(answer, values, model) {
    this.showProfile(answer);
    this.showDescriptor(answer, values, model);
    this.showSlab(answer);
    this.showAdc(answer);
    for (const axis of ['tilt', 'height']) this.showCurve(axis, values);
  }

  showProfile({ profile }) {
    const n = Math.min(32, profile.lsb.length);
    const { first_bin: first, n_bins: count } = this.facts;
    const inside = (bin) => bin >= first && bin < first + count;
    const levels = profile.lsb.slice(0, n).map(decibels);
    const search = levels.map((level, bin) => (bin < 4 ? -99 : level));
    const peak = search.indexOf(Math.max(...search));
    this.profile.draw({
      x: [-0.7, n - 0.3], y: [-20, 66], xTicks: index(n).filter((bin) => bin % 3 === 0),
      marks: [this.window ??= band(first - 0.5, first + count - 0.5, 'window', 'window-edge'),
        bars(index(n), levels, (bin) => (inside(bin) ? 'bar in' : 'bar')),
        dots([profile.height_bin], [decibels(profile.mirror_lsb)], 'ring', 5)],
    });
    const place = ((peak * profile.bin_mm) / 10).toFixed(0);
    this.profile.say(`peak in bin ${peak}, ${place} cm, ${shown(levels[peak])} dB`,
      `Strongest echo in bin ${peak}, at ${place} centimetres, ${inside(peak) ? 'inside' : 'outside'} the window of bins 6 to 17`);
  }

  showDescriptor(answer, values, model) {
    const said = answer.models.find((each) => each.name === model.name);
    const bins = this.descriptorBins;
    const own = said ? said.features : answer.profile.lsb.slice(bins[0], bins[0] + bins.length);
    // ln LSB and LSB on one scale: 20 log10.
    const scale = said && model.is_logarithm ? nepers : decibels;
    this.descriptor.draw({ x: [bins[0] - 0.3, bins.at(-1) + 0.3], y: [-20, 66], xTicks: bins,
      marks: [...(said ? this.bandsOf(model) : []), line(bins, own.map(scale), 'strong'), dots(bins, own.map(scale), 'dot', 4)] });
    this.descriptor.explain([...this.facts.classes.map((name, i) => [`f${i + 1}`, name]), ['ink', 'this chirp']]);
    this.descriptor.say(model.is_logarithm ? 'shifted to its peak, times range' : 'as it stands',
      said ? `Compared with what the model learnt: ${said.is_familiar ? 'familiar' : 'unfamiliar'}` : 'No model knows this chirp');
  }

  get descriptorBins() {
    return index(this.facts.n_bins).map((i) => i + this.facts.first_bin);
  }

  /** What a model learnt, as marks that stay the same. */
  bandsOf(model) {
    const scale = model.is_logarithm ? nepers : decibels;
    const bins = this.descriptorBins;
    if (!this.learnt.has(model.name)) {
      this.learnt.set(model.name, model.bands.flatMap((each, i) => [
        area(bins, each.low.map(scale), each.high.map(scale), `a${i + 1}`),
        line(bins, each.middle.map(scale), `thin s${i + 1}`)]));
    }
    return this.learnt.get(model.name);
  }

  showSlab({ slab }) {
    const key = JSON.stringify(slab);
    if (key === this.shownSlab) return;
    this.shownSlab = key;
    const f = index(slab.over_mirror_db.length).map((i) => slab.first_ghz + i * slab.step_ghz);
    const inBand = slab.over_mirror_db.filter((_, i) => f[i] >= slab.chirp_ghz[0] && f[i] <= slab.chirp_ghz[1]);
    const power = inBand.reduce((sum, db) => sum + 10 ** (db / 10), 0) / inBand.length;
    this.slab.draw({ x: [57, 64], y: [-42, 2],
      marks: [band(slab.chirp_ghz[0], slab.chirp_ghz[1], 'window', 'window-edge'), line(f, slab.over_mirror_db)] });
    const mean = shown(Math.round(1000 * Math.log10(power)) / 100);
    this.slab.say(inBand.length ? `${mean} dB on average` : '');
    this.slab.explain([['fw', 'swept by the chirp']]);
  }

  showAdc({ adc }) {
    const n = adc[0].length;
    const top = reach(Math.max(...adc.flat().map(Math.abs)));
    this.adc.draw({ x: [0, n - 1], y: [-top, top], marks: adc.slice(0, 3).map((codes, rx) => line(index(n), codes, `thin s${rx + 1}`)) });
    this.adc.say(`${n} samples of ${adc.length} receivers`);
  }

  /** @param answer of /api/curve, or null while a new one is on its way */
  takeCurve(axis, answer, values) {
    this[`${axis}Curve`] = answer ?? this[`${axis}Curve`];
    this[axis].figure.classList.toggle('stale', !answer);
    if (!answer) return;
    const off = stretches(answer.x, answer.foot_margin).map(([from, to]) => band(from, to, 'off'));
    this[`${axis}Marks`] = [...off, line(answer.x, answer.level_db)];
    this[axis].explain(off.length ? [['fo', 'the mirror\u2019s foot has left the sample']] : []);
    this.showCurve(axis, values);
  }

  showCurve(axis, values) {
    const curve = this[`${axis}Curve`];
    if (!curve) return;
    const plot = this[axis];
    const at = axis === 'tilt' ? values.tilt_deg : values.height_mm;
    const x = axis === 'tilt' ? [-20, 20] : [250, 650];
    const low = Math.min(...curve.level_db), high = Math.max(...curve.level_db);
    const y = axis === 'tilt' ? [Math.min(-30, Math.floor(low / 10) * 10), Math.max(6, Math.ceil(high / 5) * 5)]
      : [Math.floor((low - 2) / 5) * 5, Math.ceil((high + 1) / 5) * 5];
    const here = interpolate(curve.x, curve.level_db, at);
    const marks = [...this[`${axis}Marks`], cursor(at)];
    if (here !== null) marks.push(dots([at], [here]));
    plot.draw({ x, y, marks });
    plot.say(here === null ? 'beyond the curve' : `${shown(here)} ${axis === 'tilt' ? 'dB' : 'dBm'} at ${shown(at)} ${axis === 'tilt' ? 'degrees' : 'mm'}`);
  }
}

function interpolate(xs, ys, at) {
  const i = xs.findIndex((x) => x >= at);
  if (i < 0 || at < xs[0]) return null;
  if (i === 0) return ys[0];
  const share = (at - xs[i - 1]) / (xs[i] - xs[i - 1]);
  return ys[i - 1] + share * (ys[i] - ys[i - 1]);
}

/** Where the margin is below zero, as [from, to]. */
function stretches(xs, margins) {
  const found = [];
  margins.forEach((margin, i) => {
    if (margin >= 0) return;
    if (i > 0 && margins[i - 1] < 0) found.at(-1)[1] = xs[i];
    else found.push([xs[i], xs[i]]);
  });
  return found.filter(([from, to]) => to > from);
}
