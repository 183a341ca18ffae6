// Drives the page of `specula serve` in headless Chromium as a visitor would. See browser_test.sh.

import assert from 'node:assert/strict';
import { execFileSync, spawn } from 'node:child_process';
import { mkdtempSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';
import { createInterface } from 'node:readline';

const [program, cache] = process.argv.slice(2).map((path) => resolve(path));
const { chromium } = createRequire(import.meta.url)(join(process.env.SPECULA_MODULES, 'playwright-core'));
const shots = process.env.SPECULA_SHOTS;
const downloads = mkdtempSync(join(tmpdir(), 'specula_browser_'));

async function startServer() {
  const server = spawn(program, ['serve', '--port', '0'], { env: { ...process.env, XDG_CACHE_HOME: cache }, stdio: ['ignore', 'pipe', 'inherit'] });
  for await (const line of createInterface({ input: server.stdout })) {
    const found = line.match(/http:\/\/127\.0\.0\.1:\d+\//);
    if (found) return { server, address: found[0] };
  }
  throw new Error('the server said no address');
}

const complaints = [];

async function openPage(browser, address, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1600, height: 1000 }, acceptDownloads: true, ...options });
  context.setDefaultTimeout(120_000);  // on a machine that has much else to do
  const page = await context.newPage();
  page.on('console', (message) => ['error', 'warning'].includes(message.type()) && !message.text().includes('GPU stall') && complaints.push(message.text()));
  page.on('pageerror', (error) => complaints.push(String(error)));
  // What is on its way when we go to another address ends there, and is no fault.
  page.on('requestfailed', (request) => request.failure()?.errorText === 'net::ERR_ABORTED' || complaints.push(`${request.url()} failed`));
  page.on('request', (request) => request.url().startsWith(address) || request.url().startsWith('blob:') || complaints.push(`asks elsewhere: ${request.url()}`));
  await page.goto(address);
  await settled(page);
  return page;
}

/** Both curves and the latest chirp are drawn. */
async function settled(page) {
  await page.waitForFunction(() => document.querySelectorAll('.plot.stale').length === 0
    && document.querySelectorAll('.plot .marks > g > *').length > 20 && document.getElementById('call').textContent,
  null, { polling: 100 });
  await page.waitForTimeout(250);
}

async function shoot(page, name) {
  if (!shots) return;
  const size = page.viewportSize();
  await page.screenshot({ path: join(shots, `${name}_top.png`) });
  await page.setViewportSize({ width: size.width, height: await page.evaluate(() => document.documentElement.scrollHeight) });
  await page.waitForTimeout(400);  // what comes into view is drawn now
  await page.screenshot({ path: join(shots, `${name}.png`) });
  await page.setViewportSize(size);
}

const call = (page) => page.textContent('#call');
const reading = (page, title) => page.textContent(`.plot:has(b:text-is("${title}")) figcaption span`);

async function testMaterial(page) {
  const before = await call(page);
  await page.click('.chips button:text-is("limestone")');
  await settled(page);
  const after = await call(page);
  assert.notEqual(before, after, 'another material, another answer');
  assert.match(after, /limestone/);
  await page.waitForURL(/material=limestone/);  // the state is in the address
}

/** Drags a slider with the mouse for a while; says how long updates took, and how many there were a second. */
async function testDrag(page) {
  await page.evaluate(() => performance.clearMeasures());
  const slider = page.locator('#field-height_mm');
  const box = await slider.boundingBox();
  const y = box.y + box.height / 2;
  await page.mouse.move(box.x + box.width / 2, y);
  await page.mouse.down();
  // A mouse does not wait for the page: 125 places a second, whatever becomes of them.
  const mouse = await page.context().newCDPSession(page);
  const moves = [];
  const start = Date.now();
  for (let i = 0; Date.now() - start < 4000; i++) {
    const x = box.x + box.width * (0.5 + 0.42 * Math.sin(i / 25));
    moves.push(mouse.send('Input.dispatchMouseEvent', { type: 'mouseMoved', button: 'left', buttons: 1, x, y }));
    await new Promise((wake) => setTimeout(wake, 8));
  }
  await Promise.all(moves);
  const seconds = (Date.now() - start) / 1000;
  await page.mouse.up();
  const times = (await page.evaluate(() => performance.getEntriesByName('update api/chirp').map((each) => each.duration))).sort((a, b) => a - b);
  await settled(page);
  const quantile = (share) => times[Math.floor(share * (times.length - 1))].toFixed(1);
  console.log(`  dragging: ${(times.length / seconds).toFixed(0)} updates/s, median ${quantile(0.5)} ms, 95th percentile ${quantile(0.95)} ms`);
  assert.ok(times.length > 10, 'the page follows the mouse');  // how fast, is for people to read
}

async function testHeight(page, address) {
  await page.goto(`${address}#material=limestone&height_mm=350`);
  await page.reload();
  await settled(page);
  assert.match(await reading(page, 'Range profile'), /bin (8|9),/, 'at 35 cm the peak is in bin 9');
  assert.equal(await page.getAttribute('#monitors li:last-child', 'class'), 'alarm', 'an unknown height is noticed');
  assert.match(await call(page), /wrong/, "the paper's model fails at 35 cm");
  await page.click('#models button:text-is("Aligned and augmented")');
  assert.match(await call(page), /limestone.*right/, 'the repaired one does not');
  await shoot(page, 'height_350_repaired');
}

async function testLessons(page) {
  for (let i = 1; i <= 6; i++) {
    await page.click(`#lesson-list li:nth-child(${i}) button`);
    await settled(page);
    assert.match(await page.textContent('#lesson h2'), new RegExp(`^${i}\\. `));
    await shoot(page, `lesson_${i}`);
  }
  await page.click('#lesson-list li:nth-child(3) button');
  await page.click('#lesson .tries li:first-child button');
  await settled(page);
  assert.equal(await page.getAttribute('#lesson .tries li:first-child button', 'aria-pressed'), 'true');
  assert.match(await page.textContent('#facts'), /off the sample/, 'the foot has left 15 cm at 10 degrees');
  await shoot(page, 'lesson_3_tried');
  for (const nth of [4, 3]) await page.click(`#lesson .tries li:nth-child(${nth}) button`);
  assert.equal(await page.inputValue('#field-roughness_um'), '52', 'a try begins where the lesson does, not at the try before');
  await page.click('button:text-is("Start over")');
  assert.equal(await page.inputValue('#field-size_mm'), '150', 'a lesson starts over with its own scene');
  await page.focus('.leave');
  await page.keyboard.press('Enter');
  assert.equal(await page.isHidden('#lesson'), true);
  assert.equal(await page.evaluate(() => document.activeElement.matches('#lesson-list li:nth-child(3) button')), true, 'the keyboard is back at its button');
}

/** What stands in an address comes back from it, word for word. */
async function testAddress(page, address) {
  const found = await page.evaluate(async () => {
    const { State } = await import('./state.js');
    const facts = await (await fetch('api/page')).json();
    const [lesson, other] = facts.lessons;
    const changes = [{}, { lesson: lesson.name }, { model: 'aligned', lesson: other.name, height_mm: 350 }, { leakage: false, frame: 7 }];
    const materials = ['aluminium', 'limestone', 'plexiglass', 'wood', 'silicon'].filter((name) => facts.materials.some((each) => each.name === name));
    const differing = [];
    let n = 0;
    for (const begun of changes) for (const radar of facts.radars) for (const material of materials) for (const thickness_mm of [2.95, 3]) for (const slope_mhz_us of [100, 150]) {
      const state = new State(facts), read = new State(facts);
      state.set({ ...begun, radar: radar.name, material, thickness_mm, slope_mhz_us });
      read.readFragment(state.fragment());
      n++;
      if (JSON.stringify(read.request()) !== JSON.stringify(state.request()) || read.values.model !== state.values.model) differing.push(state.fragment());
    }
    const scene = new State(facts);
    scene.readFragment(`lesson=${other.name}`);
    const kept = Object.entries(other.scene).every(([key, value]) => scene.values[key] === value);
    return { n, differing, kept };
  });
  assert.ok(found.n > 100);
  assert.deepEqual(found.differing, [], 'a state read from its own address is the same');
  assert.ok(found.kept, 'the address of a lesson alone is its scene');
  const status = (words) => page.waitForFunction((source) => new RegExp(source).test(document.getElementById('status').textContent), words, { polling: 100 });
  await page.goto(`${address}#session=2.5`);
  await status('Session: 2.5 is not a whole number');
  assert.equal(await page.inputValue('#field-session'), '1');
  const height = page.locator('input[type=number][aria-label^="Height"]');
  await height.fill('5000');
  await height.press('Enter');
  assert.equal(await height.inputValue(), '450', 'a height out of range is put back');
  await status('Height: 5000 is out of range; use 150 to 1000 mm');
  await page.click('.controls summary');
  await page.locator('#field-radar').selectOption('bgt60tr13c');
  await status('height brought from 450 to \\d+ mm');
  assert.equal(await page.isHidden('.problem'), true, 'another board is brought a height that it sees');
  await page.click('#frames');
  await page.waitForURL(/frame=/);  // the address keeps up while frames run
  await page.click('#frames');
  await page.goto(address);
  await page.reload();
  await settled(page);
}

async function testDownloads(page) {
  await page.click('#share');
  await shoot(page, 'share');
  const take = async (selector) => {
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
    const file = join(downloads, download.suggestedFilename());
    await download.saveAs(file);
    return file;
  };
  const scene = await take('[data-file="scene.toml"]');
  const csv = readFileSync(await take('[data-file="chirp.csv"]'), 'utf8');
  assert.equal(csv.trim().split('\n').length, 129, 'a row per sample under the heading');
  assert.equal(readFileSync(await take('[data-file="chirp.h5"]')).subarray(1, 4).toString(), 'HDF');
  const figure = readFileSync(await take('[data-figure="svg"]'), 'utf8');
  assert.match(figure, /^<svg .*Range profile.*<\/svg>$/s);
  const png = readFileSync(await take('[data-figure="png"]'));
  assert.equal(png.subarray(1, 4).toString(), 'PNG');
  assert.ok(png.length > 50_000, 'the figure is not empty');
  if (shots) writeFileSync(join(shots, 'figure.png'), png);
  const command = await page.inputValue('#sweep-tilt');
  assert.match(command, /^specula sweep specula_scene\.toml --tilt /);
  const words = command.replace('-20:20:0.5', '-20:20:20').split(' ').slice(1);
  const said = execFileSync(program, [...words, '--out', join(downloads, 'sweep')], { cwd: downloads, encoding: 'utf8' });
  assert.match(said, /3 rows/, 'the command runs beside the downloaded scene');
  execFileSync(program, ['simulate', scene, '--out', join(downloads, 'frame.h5')]);
  await page.keyboard.press('Escape');
}

/** Every control has a name, and the keyboard reaches and moves it. */
async function testKeyboard(page) {
  const unnamed = await page.evaluate(() => [...document.querySelectorAll('button, input, select, canvas, svg[role=img], a')]
    .filter((each) => !each.closest('dialog:not([open])') && !(each.ariaLabel || each.labels?.length || each.textContent.trim() || each.getAttribute('aria-label'))).map((each) => each.outerHTML.slice(0, 80)));
  assert.deepEqual(unnamed, [], 'everything has a name');
  await page.focus('#field-tilt_deg');
  const before = Number(await page.inputValue('#field-tilt_deg'));
  for (let i = 0; i < 5; i++) await page.keyboard.press('ArrowRight');
  await page.waitForFunction(() => /tilted by .* degrees/.test(document.getElementById('said').textContent), null, { polling: 100 });  // changes are spoken
  assert.ok(Number(await page.inputValue('#field-tilt_deg')) > before);
  await page.focus('#models [aria-checked="true"]');
  await page.keyboard.press('ArrowRight');
  assert.equal(await page.evaluate(() => document.activeElement.getAttribute('aria-checked')), 'true');
  await page.focus('#view');
  const picture = () => page.locator('#view').screenshot();
  const still = await picture();
  for (let i = 0; i < 4; i++) await page.keyboard.press('ArrowLeft');
  assert.notDeepEqual(await picture(), still, 'arrow keys orbit the view');
}

async function testRefusal(page, address) {
  await page.goto(`${address}#material=unobtainium&height_mm=1e9&model=%3Cscript%3E`);
  await page.reload();
  await settled(page);
  assert.equal(await page.inputValue('#field-height_mm'), '450', 'nonsense in the address is left out');
  await page.goto(`${address}#slope_mhz_us=390`);
  await page.reload();
  await page.waitForSelector('.problem:not([hidden])');
  assert.match(await page.textContent('.problem'), /slope/i, 'what the chip cannot do is said');
  assert.match(await call(page), /No answer.*slope/i, 'the answer before is gone');
  await page.evaluate(() => { location.hash = ''; });
  await page.waitForSelector('.problem', { state: 'hidden' });
}

async function testSizes(browser, address) {
  const views = [['desktop_light', 1440, 900, 'light'], ['desktop_dark', 1920, 1080, 'dark'], ['projector', 1280, 720, 'light'], ['tablet', 820, 1180, 'dark'], ['phone', 390, 844, 'light']];
  for (const [name, width, height, colorScheme] of views) {
    const page = await openPage(browser, address, { viewport: { width, height }, colorScheme });
    const wide = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
    assert.ok(wide <= 0, `${name}: nothing sticks out to the side, but by ${wide} px`);
    await shoot(page, name);
    await page.context().close();
  }
}

const { server, address } = await startServer();
const browser = await chromium.launch({ executablePath: '/usr/bin/chromium', args: ['--no-sandbox', '--enable-unsafe-swiftshader', '--disable-gpu-rasterization'] });
try {
  const page = await openPage(browser, address);
  await shoot(page, 'start');
  for (const test of [testMaterial, testDrag, testHeight, testLessons, testAddress, testDownloads, testKeyboard]) {
    console.log(test.name);
    await test(page, address);
  }
  assert.deepEqual(complaints, [], 'the console is clean');
  await testRefusal(page, address);  // the console names what the server refused
  complaints.length = 0;
  await page.context().close();
  await testSizes(browser, address);
  assert.deepEqual(complaints, [], 'the console is clean in every size');
  console.log('all well');
} finally {
  await browser.close();
  server.kill('SIGINT');
}
