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
const LIVE_MS = 60;
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
  let latest = null, paceTimer = 0;

  const complain = (error) => {
    controls.complain(error.message);
    at('status').textContent = error.message;
  };
  const redraw = () => {
    if (!latest) return;
    const { values } = state;
    const model = facts.models.find((each) => each.name === values.model);
    charts.show(latest, values, model);
    verdict.show(latest, values);
    showFacts(values, latest);
  };
  const chirps = new Follower('api/chirp', (answer, request) => {
    latest = answer;
    controls.complain('');
    redraw();
    view?.show(request, answer.foot);
    put(at('status'), answer.warnings.length ? `Note: ${answer.warnings.join('; ')}` : 'Ready');
    clearTimeout(paceTimer);
    paceTimer = setTimeout(() => showPace(chirps.latest_ms), CURVE_REST_MS);
  }, complain, MOST_CHIRPS);
  const curves = ['tilt', 'height'].map((axis) => ({
    axis, key: '', timer: 0,
    follower: new Follower(`api/curve/${axis}`, (answer) => charts.takeCurve(axis, answer, state.values), complain),
  }));

  const wantCurve = (curve) => {
    const key = curveKey(curve.axis, state.request());
    if (key === curve.key) return;
    curve.key = key;
    charts.takeCurve(curve.axis, null, state.values);
    clearTimeout(curve.timer);
    curve.timer = setTimeout(() => curve.follower.want(state.request()), CURVE_REST_MS);
  };
  let asked = '', urlTimer = 0, saidTimer = 0;
  state.listen((values) => {
    const request = state.request();
    const text = JSON.stringify(request);
    if (text === asked) redraw();
    else chirps.want(request);
    asked = text;
    curves.forEach(wantCurve);
    clearTimeout(urlTimer);
    urlTimer = setTimeout(() => history.replaceState(null, '', `#${state.fragment()}`), 250);
    clearTimeout(saidTimer);
    saidTimer = setTimeout(() => { at('said').textContent = `${described(values)}: ${verdict.said ?? ''}`; }, SAID_REST_MS);
  });

  let live = 0;
  at('frames').addEventListener('click', () => {
    clearInterval(live);
    live = live ? 0 : setInterval(() => state.set({ frame: (state.values.frame + 1) % 60 }), LIVE_MS);
    at('frames').setAttribute('aria-pressed', Boolean(live));
  });
  new Sharing(state, charts, () => described(state.values), (text) => complain(new Error(text)));
  addEventListener('hashchange', () => state.readFragment(location.hash.slice(1)));
  state.readFragment(location.hash.slice(1));
}

/** How long updates took lately, from the hand to the picture. */
function showPace(latest_ms) {
  const took = [...latest_ms].sort((a, b) => a - b);
  if (took.length) at('pace').textContent = `Last updates: ${took[Math.floor(took.length / 2)].toFixed(0)} ms.`;
}

start().catch((error) => { at('status').textContent = `The page cannot start: ${error.message}`; });
