// The studio in a real browser: node tests/browser/run.mjs [part of a name]

import { readFile, readdir } from 'node:fs/promises';
import { fileURLToPath } from 'node:url';
import { STATE, check, joint, main, open, ready, until } from './harness.mjs';

const AXE = fileURLToPath(new URL('../../node_modules/axe-core/axe.min.js', import.meta.url));

const set = async (page, index, text) => {
  const field = page.getByLabel(`J${index} value`);
  await field.fill(text);
  await field.press('Enter');
};

const pose = async (page, values) => {
  for (const [index, text] of Object.entries(values)) await set(page, index, text);
  await until(page, () => window.pieperViewer.statistics.pictures, (n) => n > 0, 'a picture');
};

/** Where a place of a link is in the window: seen from its frame. */
const place = (page, link, offset = [0, 0, 0]) => page.evaluate(([index, at]) => {
  const view = window.pieperViewer;
  const e = view.arm.links[index].matrix.elements;
  return view.project([0, 1, 2].map((k) => e[12 + k] + e[k] * at[0] + e[4 + k] * at[1] + e[8 + k] * at[2]));
}, [link, offset]);

const hover = async (page, [x, y]) => {
  await page.mouse.move(x - 2, y - 2);
  await page.mouse.move(x, y);
  await page.waitForTimeout(250);
};

const pixels = (page) => page.evaluate(() => {
  const { canvas } = window.pieperViewer;
  const gl = canvas.getContext('webgl2');
  const [w, h] = [canvas.width, canvas.height];
  const data = new Uint8Array(4 * w * h);
  gl.readPixels(0, 0, w, h, gl.RGBA, gl.UNSIGNED_BYTE, data);
  const box = [w, h, 0, 0];
  const tones = new Set();
  for (let y = 0; y < h; y++) for (let x = 0; x < w; x++) {
    const k = 4 * (y * w + x);
    tones.add((data[k] >> 4) * 256 + (data[k + 1] >> 4) * 16 + (data[k + 2] >> 4));
    // The arm is opaque; the grid is not.
    if (data[k + 3] > 250) { box[0] = Math.min(box[0], x); box[1] = Math.min(box[1], h - y); box[2] = Math.max(box[2], x); box[3] = Math.max(box[3], h - y); }
  }
  return { box, tones: tones.size };
});

const axe = async (page, what) => {
  await page.evaluate(await readFile(AXE, 'utf8'));
  const found = await page.evaluate(() => window.axe.run(document, { runOnly: ['wcag2a', 'wcag2aa', 'wcag21a', 'wcag21aa', 'wcag22aa'] }));
  const text = found.violations.map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((node) => `${node.target} ${node.failureSummary?.split('\n')[1] ?? ''}`).join(' | ')}`).join('; ');
  check(found.violations.length === 0, `${what}: ${text}`);
};

const cases = [
  ['a slider moves the arm, and undo brings it back', 'ar3', async (page) => {
    const slider = page.getByLabel('J1 slider');
    await slider.focus();
    for (let k = 0; k < 5; k++) await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowRight');
    await until(page, () => document.querySelector('[aria-label="J1 value"]').value, (value) => value === '15.00', 'five degrees and ten');
    check((await slider.getAttribute('aria-valuetext')).startsWith('J1, 15.0 degrees'), 'what a screen reader hears');
    const undo = page.getByRole('button', { name: /^(Undo|Nothing to undo)/ });
    for (let k = 0; k < 6 && (await undo.isEnabled()); k++) { await undo.click(); await page.waitForTimeout(60); }
    await until(page, () => document.querySelector('[aria-label="J1 value"]').value, (value) => value === '0.00', 'undone');
  }],
  ['typed values are understood, and bad ones are told', 'ar3', async (page) => {
    for (const [text, shown] of [['45', '45.00'], ['pi/3', '60.00'], ['0.5rad', '28.65'], ['1e3', '170.00']]) {
      await set(page, 1, text);
      await until(page, () => document.querySelector('[aria-label="J1 value"]').value, (value) => value === shown, text);
    }
    await set(page, 1, 'fast');
    await page.getByRole('alert').filter({ hasText: '"fast"' }).waitFor();
  }],
  ['a link is dragged, and escape takes it back', 'ar3', async (page) => {
    await pose(page, { 2: '40', 3: '50', 5: '20' });
    await page.waitForTimeout(300);
    const at = await place(page, 2, [0.12, 0, 0]);
    await hover(page, at);
    check((await page.locator('.touch-label').innerText()).startsWith('J2'), 'the joint under the pointer is named');
    const before = await joint(page, 2);
    await page.mouse.down();
    for (let k = 1; k <= 8; k++) { await page.mouse.move(at[0] - 3 * k, at[1] - 6 * k); await page.waitForTimeout(30); }
    await page.mouse.up();
    await page.waitForTimeout(300);
    const after = await joint(page, 2);
    check(Math.abs(after - before) > 3, `joint 2 went from ${before} to ${after}`);
    for (const other of [1, 3, 4, 5, 6]) check(Math.abs((await joint(page, other)) - { 3: 50, 5: 20 }[other] || 0) < 1e-9, `joint ${other} stands`);
    const again = await place(page, 2, [0.12, 0, 0]);
    await hover(page, again);
    await page.mouse.down();
    await page.mouse.move(again[0] + 30, again[1] + 10);
    await page.waitForTimeout(200);
    await page.keyboard.press('Escape');
    await page.mouse.up();
    await until(page, () => Number(document.querySelector('[aria-label="J2 value"]').value), (value) => Math.abs(value - after) < 0.02, 'as before the drag');
  }],
  ['with Ctrl the whole arm follows', 'ar3', async (page) => {
    await pose(page, { 2: '40', 3: '60', 5: '30' });
    await page.waitForTimeout(300);
    const at = await place(page, 4, [0, 0, 0]);
    await hover(page, at);
    await page.keyboard.down('Control');
    await page.mouse.down();
    for (let k = 1; k <= 8; k++) { await page.mouse.move(at[0] - 4 * k, at[1] - 4 * k); await page.waitForTimeout(30); }
    await page.mouse.up();
    await page.keyboard.up('Control');
    await page.waitForTimeout(300);
    const moved = [];
    for (let k = 1; k <= 4; k++) moved.push(Math.abs((await joint(page, k)) - ({ 2: 40, 3: 60 }[k] ?? 0)) > 0.2);
    check(moved.filter(Boolean).length >= 2, `several joints move: ${moved}`);
  }],
  ['the gizmo moves the tool', 'irb120', async (page) => {
    await pose(page, { 2: '20', 3: '10', 5: '40' });
    await page.keyboard.press('Escape');
    await page.locator('canvas').first().focus();
    await page.keyboard.press('w');
    await page.waitForTimeout(400);
    const reach = await page.evaluate(() => {
      const view = window.pieperViewer;
      const e = view.tool.matrix.elements;
      const from = view.project([e[12], e[13], e[14]]);
      // The handle of z: a part of the way that the gizmo draws, about 100 pixels.
      const up = view.project([e[12], e[13], e[14] + 0.1]);
      const length = Math.hypot(up[0] - from[0], up[1] - from[1]);
      return { from, along: [(up[0] - from[0]) / length, (up[1] - from[1]) / length], before: e[14] };
    });
    const grip = [0, 1].map((k) => reach.from[k] + 45 * reach.along[k]);
    await page.mouse.move(grip[0] - 1, grip[1]);
    await page.mouse.move(...grip);
    await page.waitForTimeout(200);
    await page.mouse.down();
    for (let k = 1; k <= 6; k++) { await page.mouse.move(grip[0] + 5 * k * reach.along[0], grip[1] + 5 * k * reach.along[1]); await page.waitForTimeout(40); }
    await page.mouse.up();
    await until(page, () => window.pieperViewer.tool.matrix.elements[14], (z) => z - reach.before > 0.01, 'the tool has risen');
  }],
  ['every solution is listed, and one is taken', 'irb120', async (page) => {
    await pose(page, { 1: '10', 2: '20', 3: '5', 4: '30', 5: '40', 6: '15' });
    await page.getByRole('tab', { name: /Solutions/ }).click();
    await until(page, () => document.querySelectorAll('.solution').length, (n) => n === 8, 'eight solutions');
    await page.getByLabel('Ghosts', { exact: true }).check();
    await until(page, () => window.pieperViewer.ghosts.object.children[0].count, (n) => n === 7, 'seven ghosts');
    await page.waitForTimeout(200);
    const { calls } = await page.evaluate(() => window.pieperViewer.statistics);
    check(calls <= 60, `${calls} draw calls with ghosts`);
    const before = await page.evaluate(() => [...window.pieperViewer.tool.matrix.elements]);
    await page.locator('.solution:not(.current):not(:disabled)').first().click();
    await page.waitForTimeout(400);
    const after = await page.evaluate(() => [...window.pieperViewer.tool.matrix.elements]);
    check(before.every((x, k) => Math.abs(x - after[k]) < 1e-9), 'the tool stands still');
    await page.locator('.solution.current .here').waitFor();
  }],
  ['a singular family is one more slider', 'irb120', async (page) => {
    await pose(page, { 1: '10', 2: '20', 3: '5', 4: '30', 5: '0', 6: '15' });
    await page.getByRole('tab', { name: /Solutions/ }).click();
    const slider = page.getByLabel(/^Family 1/);
    await slider.waitFor();
    const before = await page.evaluate(() => [...window.pieperViewer.tool.matrix.elements]);
    await slider.fill('0.7');
    await page.waitForTimeout(300);
    const after = await page.evaluate(() => [...window.pieperViewer.tool.matrix.elements]);
    check(before.every((x, k) => Math.abs(x - after[k]) < 1e-9), 'the tool stands still');
    await page.getByRole('tab', { name: 'Joints' }).click();
    check(Math.abs((await joint(page, 4)) - 30) > 1, 'the arm moves');
  }],
  ['an unreachable pose is explained', 'ar3', async (page) => {
    await page.getByRole('tab', { name: /^Tool/ }).click();
    await page.getByLabel('Tool X').fill('5 m');
    await page.getByLabel('Tool X').press('Enter');
    await page.getByText(/beyond the arm's reach/).first().waitFor();
    await page.getByRole('radio', { name: 'Quaternions' }).click();
    await until(page, () => document.querySelector('[role=radio][aria-checked=true]:nth-child(2)')?.textContent ?? '', (text) => text === 'Quaternions', 'the other way');
    check((await page.getByText(/The two ways differ by/).innerText()).match(/e-1[5-7]|by 0/), 'and the same pose');
  }],
  ['keyframes play and are plotted', 'ar3', async (page) => {
    await page.locator('canvas').first().focus();
    await page.keyboard.press('k');
    await set(page, 1, '60');
    await page.locator('canvas').first().focus();
    await page.keyboard.press('k');
    await page.getByRole('tab', { name: 'Plots' }).click();
    await page.locator('.uplot canvas').waitFor();
    await page.locator('canvas').first().focus();
    await page.keyboard.press('Space');
    await until(page, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value > 5 && value < 55, 'on its way');
    await until(page, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value === 60, 'arrived');
    await page.getByRole('slider', { name: 'Time' }).fill('0');
    await until(page, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value === 0, 'scrubbed back');
  }],
  ['a script runs, fails at its line, and is stopped', 'ar3', async (page) => {
    await page.getByRole('tab', { name: 'Script' }).click();
    await page.locator('.cm-content').waitFor();
    if (!(await page.getByText(/^Python 3/).waitFor({ timeout: 10_000 }).then(() => true, () => false))) return;
    const write = async (text) => { await page.locator('.cm-content').click(); await page.keyboard.press('Control+A'); await page.keyboard.press('Delete'); await page.keyboard.type(text); };
    await write('import mathmodel\nmathmodel.chain1(33)\nprint("there")');
    await page.keyboard.press('Control+Enter');
    await page.locator('.console').getByText('there').waitFor();
    await until(page, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value === 33, 'moved');
    await write('x = 1\ny = nowhere');
    await page.getByRole('button', { name: 'Run' }).click();
    await page.locator('.cm-failed').getByText('nowhere').waitFor();
    await write('while True: pass');
    await page.getByRole('button', { name: 'Run' }).click();
    const stop = page.getByRole('button', { name: 'Stop', exact: true });
    await until(page, () => [...document.querySelectorAll('.script button')].find((b) => b.textContent === 'Stop').disabled, (off) => !off, 'running');
    await stop.click();
    await page.locator('.console').getByText('stopped').waitFor();
  }],
  ['formulas stand beside the picture with their numbers', 'ar3', async (page) => {
    await page.getByRole('tab', { name: 'Formulas' }).click();
    await page.locator('.sheet-body math').first().waitFor();
    const read = () => [...document.querySelectorAll('.sheet-body output')].map((place) => place.textContent).filter(Boolean).join();
    const before = await until(page, read, (text) => text.length > 20, 'numbers');
    await set(page, 1, '30');
    await until(page, read, (text) => text !== before, 'other numbers');
    await page.getByRole('radio', { name: 'Inverse' }).click();
    await page.getByRole('heading', { name: /inverse|step/i }).first().waitFor();
    await axe(page, 'formulas');
  }],
  ['a shared file needs no program', 'irb120', async (page, { browser }) => {
    await pose(page, { 2: '20', 5: '40' });
    await page.locator('canvas').first().focus();
    await page.keyboard.press('k');
    await set(page, 1, '50');
    await page.locator('canvas').first().focus();
    await page.keyboard.press('k');
    await page.waitForTimeout(200);
    const text = await page.evaluate(() => fetch('/api/share.html').then((answer) => answer.text()));
    check(text.length < 6e6, `${text.length} characters`);
    const context = await browser.newContext({ viewport: { width: 960, height: 600 }, offline: true });
    const other = await context.newPage();
    const wrong = [];
    other.on('pageerror', (error) => wrong.push(error.message));
    other.on('request', (request) => { if (/^http/.test(request.url())) wrong.push(request.url()); });
    await other.setContent(text);
    await ready(other);
    await other.getByRole('button', { name: /^Play/ }).click();
    await until(other, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value > 5 && value < 49, 'it plays');
    await until(other, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value === 50, 'to its end');
    check(wrong.length === 0, wrong.join('; '));
    await context.close();
  }],
  ['a real arm is shown, armed, moved while a button is held, and stopped', 'ar4', async (page) => {
    const said = (value) => page.evaluate(() => document.querySelector('.phase')?.textContent).then((text) => text === value);
    const phase = (wanted) => until(page, () => document.querySelector('.phase')?.textContent ?? document.querySelector('.controller .banner')?.textContent, (text) => text === wanted, `phase ${wanted}`);
    const measured = () => page.evaluate(() => [...document.querySelectorAll('.mirror td.real')].map((cell) => Number(cell.textContent)));
    const real = () => page.evaluate(() => { const e = window.pieperViewer.real.frame; return e && e.count === 1 ? [...e.matrices.slice(-4, -1)] : null; });
    await page.getByRole('tab', { name: 'Controller' }).click();
    await page.getByLabel('Protocol').selectOption('packets');
    await page.getByRole('button', { name: 'Connect', exact: true }).click();
    await phase('watching');
    check(await real(), 'the real arm is drawn');
    // A connection shows only.
    await set(page, 1, '20');
    await page.waitForTimeout(400);
    check((await measured())[0] === 0, 'nothing moved before it was armed');
    check(await page.getByRole('button', { name: 'Hold to move here' }).isDisabled(), 'nothing to hold before it is armed');
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
    await phase('holding');
    check(await page.locator('.live-frame').isVisible(), 'a red frame while it is live');
    await page.waitForTimeout(500);
    check((await measured())[0] === 0, 'nothing moved before the button was held');
    const hold = page.getByRole('button', { name: 'Hold to move here' });
    const box = await hold.boundingBox();
    await page.mouse.move(box.x + 20, box.y + 10);
    await page.mouse.down();
    await until(page, () => Number(document.querySelector('.mirror td.real').textContent), (q) => q > 3, 'it moves while held');
    await page.mouse.up();
    await phase('holding');
    const rest = (await measured())[0];
    check(rest > 3 && rest < 19, `let go on the way, it rests there: ${rest}`);
    // Undo moves the picture, and never the arm, even while the button is held.
    await page.mouse.down();
    await until(page, () => Number(document.querySelector('.mirror td.real').textContent), (q) => Math.abs(q - 20) < 0.1, 'it arrives');
    await page.keyboard.press('Control+z');
    await page.waitForTimeout(600);
    check(Math.abs((await measured())[0] - 20) < 0.2, 'undo moved the arm');
    await page.mouse.up();
    // Stop is one action, from the keyboard too.
    await set(page, 1, '90');
    await page.mouse.down();
    await until(page, () => Number(document.querySelector('.mirror td.real').textContent), (q) => q > 25, 'it moves again');
    await page.keyboard.press('Escape');
    await phase('stopped');
    await page.mouse.up();
    check(await page.locator('.live-frame').count() === 0, 'no frame once it is stopped');
    await axe(page, 'the controller panel');
    // A window that dies stops it.
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
    await phase('holding');
    await page.evaluate(() => { const busy = Date.now() + 900; while (Date.now() < busy); });
    await phase('stopped');
    check((await page.locator('.controller .banner').textContent()).includes('silent'), 'it is told why');
    // Another arm ends the connection.
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
    await phase('holding');
    await page.getByRole('button', { name: 'Disarm' }).click();
    await phase('watching');
    check(await said('watching'), 'disarmed');
    await page.getByRole('button', { name: 'Disconnect' }).click();
    await until(page, () => document.querySelector('.phase'), (phase) => phase === null, 'disconnected');
    // What was asked, sent and measured is on record.
    const [record] = (await readdir(`${STATE}/pieper/link`)).sort().slice(-1);
    const lines = (await readFile(`${STATE}/pieper/link/${record}`, 'utf8')).trim().split('\n').map((line) => JSON.parse(line));
    check(lines[0].pieper_link === 1 && lines.some((line) => line.note === 'stopped: stopped by hand') && lines.some((line) => line.commanded), 'the session was recorded');
  }],
  ['a motion runs on a real arm while its button is held', 'ar4', async (page) => {
    const phase = (wanted) => until(page, () => document.querySelector('.phase')?.textContent, (text) => text === wanted, `phase ${wanted}`);
    await page.locator('.drawer').getByRole('button', { name: 'Add this posture as a keyframe' }).click();
    await set(page, 1, '30');
    await page.locator('.drawer').getByRole('button', { name: 'Add this posture as a keyframe' }).click();
    await page.getByRole('tab', { name: 'Controller' }).click();
    await page.getByLabel('Protocol').selectOption('ar4');
    await page.getByRole('button', { name: 'Connect', exact: true }).click();
    await phase('watching');
    await page.getByRole('button', { name: 'Arm', exact: true }).click();
    await phase('holding');
    const run = await page.getByRole('button', { name: 'Hold to run the motion' }).boundingBox();
    await page.mouse.move(run.x + 20, run.y + 10);
    await page.mouse.down();
    await until(page, () => Number(document.querySelector('.mirror td.real').textContent), (q) => Math.abs(q - 30) < 0.01, 'it runs to its end');
    await phase('holding');
    await page.mouse.up();
    // Let go on the way, it stops.
    await set(page, 1, '0');
    await page.mouse.move(run.x - 100, run.y + 10);
    await page.mouse.down();
    await until(page, () => Number(document.querySelector('.mirror td.real').textContent), (q) => Math.abs(q) < 0.01, 'back at the start');
    await page.mouse.up();
    await phase('holding');
    await page.mouse.move(run.x + 20, run.y + 10);
    await page.mouse.down();
    await phase('playing');
    await page.waitForTimeout(700);
    await phase('playing');
    await page.mouse.up();
    await phase('stopped');
  }],
  ['everything can be done from the keyboard', 'ar3', async (page) => {
    await page.keyboard.press('Control+k');
    await page.getByRole('combobox', { name: 'Search commands' }).waitFor();
    await page.keyboard.type('random');
    await page.keyboard.press('Enter');
    await until(page, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value !== 0, 'moved from the palette');
    await page.keyboard.press('Control+z');
    await until(page, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value === 0, 'undone');
    await page.keyboard.press('?');
    await page.getByRole('dialog', { name: 'Keys and gestures' }).waitFor();
    await page.keyboard.press('Escape');
    for (let k = 0; k < 60; k++) {
      await page.keyboard.press('Tab');
      if (await page.evaluate(() => document.activeElement?.getAttribute('aria-label') === 'J3 slider')) return;
    }
    throw new Error('the sliders are not reached with Tab');
  }],
  ['two windows stay in step, and a dropped one comes back', 'ar3', async (page, { browser, url }) => {
    const other = await open(browser, url);
    await set(page, 1, '25');
    await until(other.page, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value === 25, 'the other window');
    await other.page.evaluate(() => window.pieperConnection.drop());
    await set(page, 1, '35');
    await until(other.page, () => Number(document.querySelector('[aria-label="J1 value"]').value), (value) => value === 35, 'after it came back');
    check(other.outside.length === 0, 'no request leaves');
    await other.context.close();
  }],
  ['the arm is where forward kinematics says', 'ar3', async (page) => {
    await pose(page, { 1: '30', 2: '90', 3: '40' });
    await page.waitForTimeout(300);
    await page.evaluate(() => window.pieperViewer.fit('home'));
    await page.waitForTimeout(300);
    const corners = () => page.evaluate(() => {
      const view = window.pieperViewer;
      const frame = view.canvas.getBoundingClientRect();
      return view.arm.links.map((link) => { const e = link.matrix.elements; const [x, y] = view.project([e[12], e[13], e[14]]); return [x - frame.left, y - frame.top]; });
    });
    const inside = async () => {
      const { box, tones } = await pixels(page);
      check(tones > 40, `the picture has ${tones} tones`);
      for (const [x, y] of await corners()) check(x > box[0] - 6 && x < box[2] + 6 && y > box[1] - 6 && y < box[3] + 6, `${x},${y} in ${box}`);
      return box;
    };
    const high = await inside();
    await pose(page, { 1: '10', 2: '30', 3: '90' });
    await page.waitForTimeout(400);
    const low = await inside();
    check(low[1] > high[1] + 20, `lowered: ${high} ${low}`);
  }],
  ['idle draws nothing, and a picture is cheap', 'irb2400', async (page) => {
    await page.waitForTimeout(800);
    const before = await page.evaluate(() => ({ ...window.pieperViewer.statistics }));
    await page.waitForTimeout(1500);
    const after = await page.evaluate(() => ({ ...window.pieperViewer.statistics }));
    check(before.pictures === after.pictures, `${after.pictures - before.pictures} pictures while idle`);
    check(after.calls <= 40, `${after.calls} draw calls`);
    const times = [];
    for (let k = 0; k < 9; k++) {
      await page.evaluate(() => window.pieperViewer.invalidate());
      await page.waitForTimeout(120);
      times.push(await page.evaluate(() => window.pieperViewer.statistics.milliseconds));
    }
    const median = times.sort((a, b) => a - b)[4];
    check(median < 20, `${median} ms of script for a picture`);
  }],
  ['a robot is chosen, and a file is opened', 'ar3', async (page) => {
    await page.getByLabel('Robot', { exact: true }).selectOption('ur5');
    await until(page, () => window.pieperViewer.arm.links.length, (n) => n === 7, 'its links');
    await page.getByRole('tab', { name: 'Robot' }).click();
    await page.getByRole('heading', { name: /UR5/ }).waitFor();
    await page.getByLabel('Open a robot or project file').setInputFiles({ name: 'two.toml', mimeType: 'text/plain', buffer: Buffer.from('name = "two"\nconvention = "standard"\n[[joint]]\ntheta = "q1"\na = 0.4\n[[joint]]\ntheta = "q2"\na = 0.3\n') });
    await page.getByRole('heading', { name: 'two' }).waitFor();
    await page.getByLabel('Open a robot or project file').setInputFiles({ name: 'bad.toml', mimeType: 'text/plain', buffer: Buffer.from('name = ') });
    await page.getByRole('alert').filter({ hasText: 'bad.toml' }).waitFor();
  }],
  ['nothing stands in the way of anybody, light and dark', 'irb120', async (page) => {
    await pose(page, { 2: '20', 5: '30' });
    await page.getByText('Got it').click();
    for (const scheme of ['light', 'dark']) {
      await page.emulateMedia({ colorScheme: scheme });
      for (const name of ['Joints', /^Tool/, /Solutions/, 'Robot']) {
        await page.getByRole('tablist', { name: 'Control panel' }).getByRole('tab', { name }).click();
        await page.waitForTimeout(250);
        await axe(page, `${scheme} ${name}`);
      }
      await page.getByRole('tab', { name: 'Script' }).click();
      await page.locator('.cm-content').waitFor();
      await page.waitForTimeout(250);
      await axe(page, `${scheme} script`);
      await page.getByRole('tab', { name: 'Script' }).click();
    }
  }],
  ['it fits a telephone', 'ar3', async (page) => {
    await page.setViewportSize({ width: 390, height: 844 });
    await page.waitForTimeout(500);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    check(wide <= 390, `the page is ${wide} wide`);
    await set(page, 2, '30');
    await until(page, () => Number(document.querySelector('[aria-label="J2 value"]').value), (value) => value === 30, 'works');
  }],
  ['a window without the token is told so', 'ar3', async (page, { browser, url, errors }) => {
    const context = await browser.newContext();
    const stranger = await context.newPage();
    await stranger.goto(url.split('#')[0]);
    await stranger.getByRole('alert').filter({ hasText: 'not signed in' }).waitFor();
    await context.close();
    await page.reload();
    await ready(page);
    check(!(await page.evaluate(() => location.hash)).includes('token'), 'the token is not in the address');
    errors.length = 0;
  }],
];

await main(cases);
