// Asks the server. One chirp at a time: while an answer is on its way the newest state waits, and states
// in between are skipped, so that the page never runs behind the hand.

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

const pause = (ms) => new Promise((wake) => setTimeout(wake, ms));

/** Keeps one kind of answer up to date. */
export class Follower {
  /** @param path of the API  @param show takes (answer, request)  @param complain takes an Error */
  constructor(path, show, complain) {
    Object.assign(this, { path, show, complain, wanted: null, running: false });
  }

  /** @param since when the hand moved, for the measure of what it took */
  want(request, since = performance.now()) {
    this.wanted = { request, since: this.wanted?.since ?? since };
    if (!this.running) this.run();
  }

  async run() {
    this.running = true;
    let refused = 0;
    while (this.wanted) {
      const { request, since } = this.wanted;
      this.wanted = null;
      try {
        const answer = await (await ask(this.path, request)).json();
        this.show(answer, request);
        performance.measure(`update ${this.path}`, { start: since, end: performance.now() });
      } catch (error) {
        if (error.status === 503 && ++refused < MOST_REFUSALS) {
          await pause(300);
          this.wanted ??= { request, since };
        } else {
          this.complain(error);
        }
      }
    }
    this.running = false;
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
