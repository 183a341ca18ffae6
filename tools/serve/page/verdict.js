// What the chosen model says of the chirp, how sure it is, and whether it has ever seen anything like it.

import { element, put } from './controls.js';
import { shown } from './plot.js';

const percent = (share) => `${Math.round(share * 100)}\u202f%`;

export class Verdict {
  constructor(state) {
    this.state = state;
    this.facts = state.facts;
    const at = (id) => document.getElementById(id);
    Object.assign(this, { models: at('models'), idea: at('idea'), call: at('call'), strip: at('strip') });
    this.makeModels();
    this.makeBars(at('classes'));
    this.makeMonitors(at('monitors'));
    this.makeScores(at('scores'));
  }

  makeModels() {
    this.modelButtons = this.facts.models.map((model, i) => element('button', {
      type: 'button', role: 'radio', onclick: () => this.state.set({ model: model.name }),
      onkeydown: (event) => this.moveAmongModels(event, i),
    }, model.title));
    this.models.append(...this.modelButtons);
    this.state.listen(({ model }) => this.facts.models.forEach((each, i) => {
      const chosen = each.name === model;
      this.modelButtons[i].setAttribute('aria-checked', chosen);
      this.modelButtons[i].tabIndex = chosen ? 0 : -1;
      if (chosen) this.idea.textContent = each.idea;
    }));
  }

  moveAmongModels(event, i) {
    const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[event.key];
    if (!step) return;
    event.preventDefault();
    const n = this.facts.models.length;
    const next = (i + step + n) % n;
    this.state.set({ model: this.facts.models[next].name });
    this.modelButtons[next].focus();
  }

  makeBars(list) {
    this.bars = this.facts.classes.map((name, i) => {
      const fill = element('span', { class: `fill f${i + 1}` });
      const value = element('output');
      const row = element('li', {}, name, element('span', { class: 'track', 'aria-hidden': 'true' }, fill), value);
      list.append(row);
      return { row, fill, value };
    });
  }

  makeMonitors(list) {
    const make = (title, hint) => {
      const fill = element('span', { class: 'fill' });
      const limit = element('span', { class: 'limit', hidden: true });
      const value = element('output');
      const row = element('li', {}, element('span', {}, title), element('span', { class: 'track', 'aria-hidden': 'true' }, fill, limit), value);
      if (hint) row.append(element('small', {}, hint));
      list.append(row);
      return { row, fill, limit, value };
    };
    this.confidence = make('Confidence');
    this.logit = make('Largest logit');
    this.energy = make('Energy');
    this.distance = make('Distance to training', 'Mahalanobis distance of the 12 numbers; the mark is where 99 of 100 training frames end.');
  }

  makeScores(table) {
    const { models } = this.facts;
    const head = element('tr', {}, element('th', { scope: 'col' }, 'Macro-F1'), ...models.map((model) => element('th', { scope: 'col' }, model.title)));
    const body = models[0].scores.map(({ condition }, row) => {
      const values = models.map((model) => model.scores[row].macro_f1);
      return element('tr', {}, element('th', { scope: 'row' }, condition), ...values.map((value) =>
        element('td', value === Math.max(...values) ? { class: 'best' } : {}, value.toFixed(2))));
    });
    table.append(element('thead', {}, head), element('tbody', {}, ...body));
  }

  show(answer, values) {
    const said = answer.models.find((each) => each.name === values.model);
    if (!said) return this.showNone('The models know one board and one chirp only; this is another one', 'No model for this chirp');
    const best = said.probability.indexOf(Math.max(...said.probability));
    const name = this.facts.classes[best];
    const isClass = this.facts.classes.includes(values.material);
    const [kind, word] = !isClass ? ['none', 'no class of its own'] : name === values.material ? ['right', 'right'] : ['wrong', `wrong: it is ${values.material}`];
    const answered = `${name}, ${percent(said.probability[best])}`;
    this.bars.forEach(({ row, fill, value }, i) => {
      row.className = i === best ? 'chosen' : '';
      fill.style.transform = `scaleX(${said.probability[i].toFixed(3)})`;
      put(value, percent(said.probability[i]));
    });
    this.showMonitors(said, said.probability[best]);
    const trust = said.is_familiar ? 'looks familiar' : 'unfamiliar input';
    const all = `${answered}, ${word}, ${trust}`;
    if (all === this.said) return;
    this.said = all;
    this.call.replaceChildren(answered, element('span', { class: `badge ${kind}` }, word));
    this.strip.replaceChildren(element('span', {}, answered), element('small', {}, `${word}, ${trust}`));
  }

  showMonitors(said, confidence) {
    const set = ({ row, fill, value }, share, text, mood = '') => {
      row.className = mood;
      fill.style.transform = `scaleX(${Math.min(1, Math.max(0.004, share)).toFixed(3)})`;
      put(value, text);
    };
    set(this.confidence, confidence, percent(confidence));
    set(this.logit, said.max_logit / 20, shown(said.max_logit));
    set(this.energy, -said.energy / 20, shown(said.energy));
    // The scale ends at four times the limit; beyond, the bar is full and the number goes on.
    const scale = 4 * said.familiar_distance;
    set(this.distance, said.distance / scale, said.distance < 100 ? shown(said.distance) : said.distance.toFixed(0), said.is_familiar ? 'calm' : 'alarm');
    this.distance.limit.hidden = false;
    this.distance.limit.style.left = `${(100 * said.familiar_distance) / scale}%`;
  }

  /** Another chirp than the one the models were trained on, or none at all. */
  showNone(reason, brief) {
    this.call.replaceChildren(element('span', { class: 'badge none' }, reason));
    for (const { row, fill, value } of [...this.bars, this.confidence, this.logit, this.energy, this.distance]) {
      row.className = '';
      fill.style.transform = 'scaleX(0)';
      value.textContent = '';
    }
    this.distance.limit.hidden = true;
    this.strip.replaceChildren(brief);
    this.said = brief;
  }
}
