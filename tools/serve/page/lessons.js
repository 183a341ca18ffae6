// The side panel: six lessons, each a scene and what to look for in it.

import { element } from './controls.js';

export class Lessons {
  constructor(state) {
    this.state = state;
    this.lessons = state.facts.lessons;
    this.panel = document.getElementById('lesson');
    this.buttons = this.lessons.map((lesson, i) => element('button', { type: 'button', onclick: () => this.begin(i) },
      element('b', { 'aria-hidden': 'true' }, String(i + 1)), lesson.title));
    document.getElementById('lesson-list').append(...this.buttons.map((button) => element('li', {}, button)));
    this.shown = null;
    state.listen((values) => this.show(values));
  }

  begin(i) {
    const lesson = this.lessons[i];
    this.state.set(this.state.start(lesson.name));
    this.panel.querySelector('h2').focus({ preventScroll: true });
  }

  show(values) {
    if (values.lesson !== this.shown) this.open(values.lesson);
    const lesson = this.lessons.find((each) => each.name === values.lesson);
    lesson?.tries.forEach((each, i) => {
      const tried = { ...this.state.start(lesson.name), ...each.set };
      const done = Object.entries(tried).every(([key, value]) => values[key] === value);
      this.tries[i].setAttribute('aria-pressed', done);
    });
  }

  open(name) {
    this.shown = name;
    const at = this.lessons.findIndex((each) => each.name === name);
    this.buttons.forEach((button, i) => button.setAttribute('aria-current', i === at));
    this.panel.hidden = at < 0;
    document.querySelector('main').classList.toggle('taught', at >= 0);
    if (at < 0) return;
    const lesson = this.lessons[at];
    this.tries = lesson.tries.map((each) => element('button', { type: 'button', onclick: () => this.state.set({ ...this.state.start(name), ...each.set }) }, element('span', {}, each.text)));
    const words = element('div', { class: 'words' }, ...lesson.text.map((text) => element('p', {}, text)));
    const deeds = element('div', { class: 'deeds' }, element('p', { class: 'look' }, element('b', {}, 'Look for: '), lesson.look_for),
      element('ul', { class: 'tries' }, ...this.tries.map((button) => element('li', {}, button))), this.steps(at));
    this.panel.replaceChildren(element('h2', { tabindex: -1 }, `${at + 1}. ${lesson.title}`), words, deeds);
  }

  leave(at) {
    this.state.set({ lesson: '' });
    this.buttons[at].focus();  // the pressed button is gone, and the keyboard's place with it
  }

  steps(at) {
    const step = (title, to) => element('button', { type: 'button', onclick: () => this.begin(to) }, title);
    const row = element('p', { class: 'steps' });
    if (at > 0) row.append(step('Back', at - 1));
    if (at + 1 < this.lessons.length) row.append(step('Next lesson', at + 1));
    row.append(element('button', { type: 'button', class: 'leave', 'aria-label': 'Close the lesson', onclick: () => this.leave(at) }, 'Close'));
    return row;
  }
}
