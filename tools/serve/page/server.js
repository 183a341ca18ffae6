// Asks the server. Few at a time: while answers are on their way the newest state waits, and states in
// between are skipped, so that the page never runs behind the hand.

export async function ask(path, request) {
  const response = await fetch(path, request && {
    method: 'POST',
    headers: { 'Content-Type': 'application/json' },
    body: JSON.stringify(request),
  });
  if (response.ok) return response;
  const said = await response.json().catch(() => ({}));
  const { field = '', problem = `the server answered ${response.status}`, remedy = '' } = said.error ?? {};
  throw Object.assign(new Error([problem, remedy].filter(Boolean).join('; ')), { field, status: response.status });
}

const MOST_REFUSALS = 20;  // of a busy server, then it is said
const MOST_MEASURES = 5000;

const pause = (ms) => new Promise((wake) => setTimeout(wake, ms));

/** Keeps one kind of answer up to date. */
export class Follower {
  /**
   * @param path of the API  @param show takes (answer, request)  @param complain takes (Error, request)
   * @param most requests on their way at a time
   */
  constructor(path, show, complain, most = 1) {
    Object.assign(this, { path, show, complain, most, wanted: null, flying: 0, sent: 0, shown: 0, refusals: 0, latest_ms: [], measured: 0 });
  }

  /** @param since when the hand moved, for the measure of what it took */
  want(request, since = performance.now()) {
    this.wanted = { request, since: this.wanted?.since ?? since };
    if (this.flying < this.most) this.send();
  }

  async send() {
    const { request, since } = this.wanted;
    const number = ++this.sent;
    this.wanted = null;
    this.flying++;
    try {
      const answer = await (await ask(this.path, request)).json();
      this.refusals = 0;
      // Of answers that overtake each other the newest stays.
      if (number > this.shown) {
        this.shown = number;
        this.show(answer, request);
        requestAnimationFrame(() => this.measure(since));
      }
    } catch (error) {
      if (error.status === 503 && ++this.refusals < MOST_REFUSALS) {
        await pause(300);
        if (number === this.sent) this.wanted ??= { request, since };
      } else if (number > this.shown) {
        this.shown = number;
        this.complain(error, request);
      }
    }
    this.flying--;
    if (this.wanted) this.send();
  }

  /** How long it took from the hand to the frame that paints the answer; the latest 40 are kept. */
  measure(since) {
    const name = `update ${this.path}`;
    if (++this.measured % MOST_MEASURES === 0) performance.clearMeasures(name);
    const { duration } = performance.measure(name, { start: since, end: performance.now() });
    this.latest_ms = [...this.latest_ms.slice(-39), duration];
  }
}

/** Saves a file that the browser holds. */
export function save(name, blob) {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
