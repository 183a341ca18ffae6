// Puts the page together: state, controls, answers, pictures.

import { Charts } from './charts.js';
import { Controls, element, put } from './controls.js';
import { Lessons } from './lessons.js';
import { shown } from './plot.js';
import { Follower, ask } from './server.js';
import { Sharing } from './sharing.js';
import { State } from './state.js';
import { Verdict } from './verdict.js';
import { View3d } from './view3d.js';

const at = (id) => document.getElementById(id);
const CURVE_REST_MS = 140;  // a curve is asked for when the hand rests
const SAID_REST_MS = 700;
const LIVE_MS = 40;
const URL_MS = 350;  // browsers refuse more than a hundred changes in 30 s
const PATIENCE_MS = 300;  // an answer before that needs no word of waiting
const MOST_CHIRPS = 2;  // one is drawn while the next is computed

/** What of the state a curve depends on. */
function curveKey(axis, request) {
  const { session, frame, noise_figure_db, leakage, leakage_db, [axis === 'tilt' ? 'tilt_deg' : 'height_mm']: own, ...rest } = request;
  return JSON.stringify(rest);
}

function themes() {
  const dark = matchMedia('(prefers-color-scheme: dark)');
  const wear = (name) => document.documentElement.setAttribute('data-theme', name);
  const now = () => document.documentElement.dataset.theme;
  wear(localStorage.getItem('theme') ?? (dark.matches ? 'dark' : 'light'));
  dark.addEventListener('change', () => localStorage.getItem('theme') ?? wear(dark.matches ? 'dark' : 'light'));
  at('theme').addEventListener('click', () => {
    wear(now() === 'dark' ? 'light' : 'dark');
    localStorage.setItem('theme', now());
  });
}

/** The scene in a line, for figures and for those who listen. */
function described(values) {
  const tilt = values.tilt_deg ? `, ${values.tilted} tilted by ${shown(values.tilt_deg)} degrees in ${values.tilt_plane}` : '';
  return `${values.material.replaceAll('_', ' ')}, ${shown(values.size_mm)} mm wide, ${shown(values.thickness_mm)} mm thick, at ${shown(values.height_mm)} mm${tilt}, session ${values.session}`;
}

function showFacts(values, { foot, placement }) {
  const rows = [['Echo path', `${shown(foot.range_mm)} mm`],
    ['Mirror\u2019s foot', foot.margin < 0 ? 'off the sample' : `${shown(Math.hypot(foot.x_mm, foot.y_mm))} mm off centre`],
    ['Smallest plate', foot.critical_mm < 1 ? 'any' : `${shown(foot.critical_mm)} mm`]];
  if (values.session > 0) rows.push(['Mounted', `${placement.height_mm >= 0 ? '+' : '\u2212'}${Math.abs(placement.height_mm).toFixed(1)} mm, ${shown(Math.hypot(placement.tilt_x_deg, placement.tilt_y_deg), 2)}\u00b0 off`]);
  const list = at('facts');
  if (list.childNodes.length !== 2 * rows.length) list.replaceChildren(...rows.flatMap(() => [element('dt'), element('dd')]));
  rows.flat().forEach((text, i) => put(list.childNodes[i], text));
}

function makeView(facts) {
  try {
    return new View3d(at('view'), facts);
  } catch {
    at('view').hidden = true;
    at('view-hint').textContent = 'This browser has no WebGL; everything else works';
    return null;
  }
}

async function start() {
  themes();
  const facts = await (await ask('api/page')).json();
  const state = new State(facts);
  const view = makeView(facts);
  const controls = new Controls(at('controls'), state);
  const charts = new Charts(at('plots'), facts);
  const verdict = new Verdict(state);
  new Lessons(state);
  let latest = null, asked = '', paceTimer = 0, busyTimer = 0, saidTimer = 0;
  const main = document.querySelector('main');

  const complain = (error) => {
    const title = facts.fields.find((each) => each.key === error.field)?.title;
    const text = title && !error.message.startsWith(error.field) ? `${title}: ${error.message}` : error.message;
    controls.complain(text);
    at('status').textContent = text;
    return text;
  };
  const redraw = () => {
    if (!latest) return;
    const { answer, request } = latest;
    const { values } = state;
    const model = facts.models.find((each) => each.name === values.model);
    charts.show(answer, values, model);
    verdict.show(answer, { ...request, model: values.model });
    showFacts(request, answer);
  };
  const isAnswered = () => latest && JSON.stringify(latest.request) === asked;
  const say = () => put(at('status'), [state.note, ...latest.answer.warnings].filter(Boolean).map((text, i) => (i ? text : `Note: ${text}`)).join('; ') || 'Ready');
  const wait = () => {
    main.setAttribute('aria-busy', 'true');
    busyTimer ||= setTimeout(() => put(at('status'), 'Computing'), PATIENCE_MS);
  };
  const rest = () => {
    main.setAttribute('aria-busy', 'false');
    clearTimeout(busyTimer);
    busyTimer = 0;
  };
  const announce = () => {
    clearTimeout(saidTimer);
    saidTimer = setTimeout(() => { at('said').textContent = `${described(state.values)}: ${verdict.said ?? ''}`; }, SAID_REST_MS);
  };
  /** What was drawn belongs to another state: it shall not pass for this one's. */
  const refuse = (error, request) => {
    latest = null;
    main.classList.add('refused');
    verdict.showNone(`No answer. ${complain(error)}`, 'No answer');
    if (JSON.stringify(request) !== asked) return;
    asked = '';  // the next change asks again
    rest();
    announce();
  };
  const chirps = new Follower('api/chirp', (answer, request) => {
    latest = { answer, request };
    main.classList.remove('refused');
    controls.complain('');
    redraw();
    view?.show(request, answer.foot);
    rest();
    if (isAnswered()) {
      say();
      announce();
    } else {
      wait();
    }
    clearTimeout(paceTimer);
    paceTimer = setTimeout(() => showPace(chirps.latest_ms), CURVE_REST_MS);
  }, refuse, MOST_CHIRPS);
  const curves = ['tilt', 'height'].map((axis) => {
    const curve = { axis, key: '', timer: 0 };
    curve.follower = new Follower(`api/curve/${axis}`, (answer) => charts.takeCurve(axis, answer, state.values), (error) => {
      curve.key = '';  // the same curve may do at another height
      complain(error);
    });
    return curve;
  });

  const wantCurve = (curve) => {
    const key = curveKey(curve.axis, state.request());
    if (key === curve.key) return;
    curve.key = key;
    charts.takeCurve(curve.axis, null, state.values);
    clearTimeout(curve.timer);
    curve.timer = setTimeout(() => curve.follower.want(state.request()), CURVE_REST_MS);
  };
  let urlTimer = 0;
  state.listen(() => {
    const request = state.request();
    const text = JSON.stringify(request);
    clearTimeout(saidTimer);
    if (text !== asked) {
      asked = text;
      wait();
      chirps.want(request);
    } else {
      redraw();
      if (isAnswered()) {
        say();
        announce();
      }
    }
    curves.forEach(wantCurve);
    urlTimer ||= setTimeout(() => {
      urlTimer = 0;
      history.replaceState(null, '', `#${state.fragment()}`);
    }, URL_MS);
  });

  let live = 0;
  at('frames').addEventListener('click', () => {
    clearInterval(live);
    live = live ? 0 : setInterval(() => state.set({ frame: (state.values.frame + 1) % 60 }), LIVE_MS);
    at('frames').setAttribute('aria-pressed', Boolean(live));
  });
  new Sharing(state, charts, () => described(state.values), (text) => complain(new Error(text)));
  const isPlace = () => Boolean(at(location.hash.slice(1)));  // as that of the skip link
  addEventListener('hashchange', () => isPlace() || state.readFragment(location.hash.slice(1)));
  state.readFragment(isPlace() ? '' : location.hash.slice(1));
}

/** How long updates took lately, from the hand to the picture. */
function showPace(latest_ms) {
  const took = [...latest_ms].sort((a, b) => a - b);
  if (took.length) at('pace').textContent = `Last updates: ${took[Math.floor(took.length / 2)].toFixed(0)} ms.`;
}

start().catch((error) => { at('status').textContent = `The page cannot start: ${error.message}`; });
