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
  ['the link under the pointer is outlined', 'ar3', async (page) => {
    await pose(page, { 2: '40', 3: '50', 5: '20' });
    const calls = () => page.evaluate(() => window.pieperViewer.statistics.calls);
    await page.mouse.move(20, 300);
    await page.waitForTimeout(300);
    const [before, plain] = [await calls(), await pixels(page)];
    await hover(page, await place(page, 2, [0.12, 0, 0]));
    // The mask and the line; and the line is outside of the link.
    await until(page, () => window.pieperViewer.statistics.calls, (now) => now > before + 1, 'more draw calls');
    check((await calls()) <= 40, `${await calls()} draw calls`);
    const violet = await page.evaluate(() => {
      const { canvas } = window.pieperViewer;
      const gl = canvas.getContext('webgl2');
      const data = new Uint8Array(4 * canvas.width * canvas.height);
      gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, data);
      let found = 0;
      for (let k = 0; k < data.length; k += 4) if (Math.abs(data[k] - 124) < 14 && Math.abs(data[k + 1] - 58) < 14 && Math.abs(data[k + 2] - 237) < 14) found += 1;
      return found;
    });
    check(violet > 200, `${violet} pixels of the line, silhouette ${plain.box}`);
  }],
  ['the view tumbles over the pole where one asks for it, and comes back upright', 'ar3', async (page) => {
    const up = () => page.evaluate(() => { const { camera } = window.pieperViewer; return [camera.matrixWorld.elements[6], camera.position.z]; });
    const drag = async () => {
      await page.mouse.move(150, 480);
      await page.waitForTimeout(300);
      await page.mouse.down();
      for (let k = 1; k <= 8; k++) await page.mouse.move(150, 480 - 25 * k);
      await page.mouse.up();
      await page.waitForTimeout(200);
    };
    await drag();
    check((await up())[0] >= 0, 'the turntable stays upright');
    await page.keyboard.press('?');
    await page.getByLabel(/turns the view freely/).check();
    await page.keyboard.press('Escape');
    await drag();
    check((await up())[0] < 0, `upside down: ${await up()}`);
    await page.locator('canvas').focus();
    await page.keyboard.press('v');
    await page.waitForTimeout(200);
    check((await up())[0] > 0, 'upright again');
  }],
  ['the panel and the drawer take the size they are dragged to, and keep it', 'ar3', async (page) => {
    const edge = page.getByRole('separator', { name: 'Width of the side panel' });
    const width = () => page.locator('.panel').evaluate((panel) => panel.clientWidth);
    const before = await width();
    const box = await edge.boundingBox();
    await page.mouse.move(box.x + 5, 300);
    await page.mouse.down();
    await page.mouse.move(box.x - 75, 300, { steps: 4 });
    await page.mouse.up();
    const after = await width();
    check(Math.abs(after - before - 80) <= 2, `${before} to ${after}`);
    await edge.focus();
    await page.keyboard.press('ArrowRight');
    await until(page, () => document.querySelector('.panel').clientWidth, (now) => now === after - 16, 'sixteen pixels by key');
    await page.locator('#drawer-tab-log').click();
    const drawer = page.getByRole('separator', { name: 'Height of the drawer' });
    await drawer.focus();
    const tall = await page.locator('.drawer-body').evaluate((body) => body.clientHeight);
    await page.keyboard.press('ArrowUp');
    await until(page, () => document.querySelector('.drawer-body').clientHeight, (now) => now === tall + 16, 'sixteen pixels higher');
    await page.reload();
    await ready(page);
    check((await width()) === after - 16, 'kept over a reload');
  }],
  ['joint values are pasted, and what is no list of them is told', 'ar3', async (page, { context }) => {
    await context.grantPermissions(['clipboard-read', 'clipboard-write']);
    const value = (joint) => page.getByLabel(`J${joint} value`).inputValue();
    const paste = (text) => page.evaluate((text) => {
      const data = new DataTransfer();
      data.setData('text/plain', text);
      document.body.dispatchEvent(new ClipboardEvent('paste', { clipboardData: data, bubbles: true, cancelable: true }));
    }, text);
    for (const [text, third] of [['10, 20, 30, 0, 0, 0', '30.00'], ['q = [0.1rad; 0.2rad; pi/4 rad; 0; 0; 0]', '45.00'], ['5 10 15 0 0 0', '15.00'], ['(0\t20\t25\t0\t0\t0)', '25.00']]) {
      await paste(text);
      await until(page, () => document.querySelector('[aria-label="J3 value"]').value, (now) => now === third, text);
    }
    await paste('1, 2, 3');
    await page.getByRole('alert').filter({ hasText: '"1, 2, 3" has 3 values: 6 were expected' }).waitFor();
    await paste('1, 2, 3, fast, 5, 6');
    await page.getByRole('alert').filter({ hasText: 'fast' }).waitFor();
    check((await value(3)) === '25.00', 'nothing moved');
    await page.getByRole('button', { name: 'Copy the joint values' }).click();
    await page.getByRole('button', { name: 'Zero', exact: true }).click();
    await until(page, () => document.querySelector('[aria-label="J3 value"]').value, (now) => now === '0.00', 'zero');
    await page.getByRole('button', { name: /^Paste joint values/ }).click();
    await until(page, () => document.querySelector('[aria-label="J3 value"]').value, (now) => now === '25.00', 'what was copied');
  }],
  ['keyframes are dragged to other times, one step of undo each', 'ar3', async (page) => {
    for (const [t, q] of [[0, 0], [1, 0.4], [3, 0.8]]) {
      await page.evaluate(([t, q]) => window.pieperConnection.send({ do: 'joints', q: [q, 0.2, 0.2, 0, 0.3, 0] }).then(() => window.pieperConnection.send({ do: 'keyframe', op: 'add', t })), [t, q]);
    }
    await page.locator('#drawer-tab-motion').click();
    const mark = page.getByRole('slider', { name: 'Keyframe 2' });
    const time = () => mark.evaluate((button) => Number(button.getAttribute('aria-valuenow')));
    const box = await mark.boundingBox();
    const last = await page.getByRole('slider', { name: 'Keyframe 3' }).boundingBox();
    const first = await page.getByRole('slider', { name: 'Keyframe 1' }).boundingBox();
    const second = (last.x + last.width / 2 - first.x - first.width / 2) / 3;
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 0.9 * second, y, { steps: 6 });
    await page.mouse.up();
    const moved = await until(page, () => Number([...document.querySelectorAll('.mark')].find((mark) => mark.textContent === '2').getAttribute('aria-valuenow')), (t) => Math.abs(t - 1.9) < 0.03, 'at 1.9 s');
    await mark.focus();
    await page.keyboard.press('ArrowLeft');
    await until(page, () => Number([...document.querySelectorAll('.mark')].find((mark) => mark.textContent === '2').getAttribute('aria-valuenow')), (t) => Math.abs(t - moved + 0.1) < 1e-6, 'a tenth of a second back');
    for (let k = 0; k < 2; k++) await page.getByRole('button', { name: /^Undo: move keyframe/ }).click();
    await until(page, () => Number([...document.querySelectorAll('.mark')].find((mark) => mark.textContent === '2').getAttribute('aria-valuenow')), (t) => t === 1, 'where it began');
    // Past another one, and not onto it.
    await mark.focus();
    for (let k = 0; k < 3; k++) { await page.keyboard.press('Shift+ArrowRight'); await page.waitForTimeout(120); }
    check((await time()) === 2, `it waits before the other: ${await time()}`);
  }],
  ['keyframes are gone to, changed, moved by number and removed', 'ar3', async (page) => {
    const add = (q) => page.evaluate((q) => window.pieperConnection.send({ do: 'joints', q: [q, 0.2, 0.2, 0, 0.3, 0] }).then(() => window.pieperConnection.send({ do: 'keyframe', op: 'add' })), q);
    for (const q of [0.1, 0.2, 0.3]) await add(q);
    await page.locator('#drawer-tab-motion').click();
    const row = (k) => page.locator('.keyframes li').nth(k);
    await row(0).locator('.keyframe-name').click();
    await until(page, () => document.querySelector('[aria-label="J1 value"]').value, (value) => value === '5.73', 'the first posture');
    await set(page, 1, '20');
    await row(0).getByRole('button', { name: 'Set' }).click();
    await row(1).locator('.keyframe-name').click();
    await until(page, () => document.querySelector('[aria-label="J1 value"]').value, (value) => value === '11.46', 'the second posture');
    await row(0).locator('.keyframe-name').click();
    await until(page, () => document.querySelector('[aria-label="J1 value"]').value, (value) => value === '20.00', 'what was set');
    const time = page.getByLabel('Time of keyframe 3');
    await time.fill('5.5 s');
    await time.press('Enter');
    await until(page, () => document.querySelector('.transport .time').textContent, (text) => text.endsWith('/ 5.50 s'), 'a longer motion');
    await page.getByRole('button', { name: 'Remove keyframe 3' }).click();
    await until(page, () => document.querySelectorAll('.keyframes li').length, (count) => count === 2, 'two are left');
  }],
  ['every button, list and slider is answered', 'ar3', async (page) => {
    for (const q of [0.1, 0.4]) await page.evaluate((q) => window.pieperConnection.send({ do: 'joints', q: [q, 0.2, 0.2, 0, 0.3, 0] }).then(() => window.pieperConnection.send({ do: 'keyframe', op: 'add' })), q);
    // What opens another window or a file, and what moves a real arm or runs a script, has tests of its own.
    const not = /Share|Snapshot|Open|Paste|Copy|Connect|Arm|Stop|Run|Close|Hold/;
    let pressed = 0;
    const all = async (inside) => {
      for (const kind of ['button:not([role=tab]):not(:disabled)', 'select', 'input[type=range]']) {
        const count = await page.locator(`${inside} ${kind}`).count();
        for (let k = 0; k < count; k++) {
          const one = page.locator(`${inside} ${kind}`).nth(k);
          if (!(await one.count()) || !(await one.isVisible()) || !(await one.isEnabled())) continue;
          const name = await one.evaluate((element) => element.getAttribute('aria-label') ?? element.textContent);
          if (not.test(name)) continue;
          if (kind === 'select') {
            if ((await one.evaluate((select) => select.closest('label')?.textContent ?? '')).startsWith('Export')) continue;
            const values = await one.locator('option').evaluateAll((options) => options.map((option) => option.value));
            await one.selectOption(values.at(-1)).catch(() => {});
          } else if (kind === 'button:not([role=tab]):not(:disabled)') {
            await one.click({ timeout: 3000 });
          } else {
            await one.press('ArrowRight');
          }
          pressed += 1;
          await until(page, () => window.pieperConnection.waiting.size, (waiting) => waiting === 0, `${inside}: ${name} is not answered`);
          const alert = page.getByRole('alert');
          check((await alert.count()) === 0, `${inside}: ${name}: ${await alert.allTextContents()}`);
        }
      }
    };
    for (const name of ['Joints', 'Tool', 'Solutions', 'Robot']) {
      await page.getByRole('tab', { name: new RegExp(`^${name}`) }).first().click();
      await all('.panel-body');
    }
    await all('.transport');
    for (const name of ['motion', 'plots', 'formulas', 'log']) {
      await page.locator(`#drawer-tab-${name}`).click();
      await all('.drawer-body');
    }
    check(pressed > 45, `only ${pressed} were pressed`);
  }],
  ['a picture is saved in the size asked for, with and without what lies over the arm', 'ar3', async (page) => {
    const take = async (scale, bare) => {
      await page.getByRole('button', { name: 'A picture of the view' }).click();
      await page.getByRole('radio', { name: scale }).click();
      await page.getByLabel(/Ground, frames/).setChecked(!bare);
      await page.getByLabel('Transparent background').setChecked(bare);
      const [download] = await Promise.all([page.waitForEvent('download'), page.getByRole('button', { name: 'Save as PNG' }).click()]);
      const bytes = await readFile(await download.path());
      check(download.suggestedFilename() === 'ar3.png' && bytes.subarray(1, 4).toString() === 'PNG', 'a PNG');
      return { width: bytes.readUInt32BE(16), height: bytes.readUInt32BE(20), bytes };
    };
    const view = await page.locator('canvas').boundingBox();
    const whole = await take('2×', false);
    check(Math.abs(whole.width - 2 * view.width) <= 2 && Math.abs(whole.height - 2 * view.height) <= 2, `${whole.width} by ${whole.height}`);
    const bare = await take('1×', true);
    check(Math.abs(bare.width - view.width) <= 1, `${bare.width} wide`);
    // Its corners are clear, where the other has a background.
    const corner = ({ bytes }) => page.evaluate(async (data) => {
      const image = await createImageBitmap(new Blob([Uint8Array.from(data)]));
      const ink = new OffscreenCanvas(image.width, image.height).getContext('2d');
      ink.drawImage(image, 0, 0);
      return ink.getImageData(3, image.height - 3, 1, 1).data[3];
    }, [...bytes]);
    check((await corner(whole)) === 255 && (await corner(bare)) === 0, 'backgrounds');
    // And what was hidden is there again.
    check(await page.evaluate(() => window.pieperViewer.ground.object.visible && window.pieperViewer.tool.visible), 'the ground is back');
  }],
  ['an arm whose frame has Y up stands upright', 'abb-paper', async (page) => {
    const up = await page.evaluate(() => window.pieperViewer.camera.up.toArray());
    check(Math.abs(up[1] - 1) < 1e-9, `up is ${up}`);
    await hover(page, await place(page, 2, [-0.04, 0, 0]));
    await page.locator('.touch-label:not([hidden])').waitFor();
    await page.locator('canvas').focus();
    await page.keyboard.press('1');
    await page.waitForTimeout(200);
    const eye = await page.evaluate(() => { const { camera, controls } = window.pieperViewer; return camera.position.clone().sub(controls.target).normalize().toArray(); });
    check(eye[0] > 0.99, `seen from the front: ${eye}`);
  }],
  ['at 200 % zoom everything is there', 'ar3', async (page) => {
    await page.setViewportSize({ width: 640, height: 360 });
    await page.waitForTimeout(300);
    const stage = await page.locator('.stage').boundingBox();
    check(stage.width > 300 && stage.height > 200, `the view is ${stage.width} by ${stage.height}`);
    for (const name of ['Joints', 'Tool', 'Robot']) {
      await page.getByRole('tab', { name, exact: true }).click();
      const box = await page.locator('.panel-body').boundingBox();
      check(box.height > 120 && box.x + box.width <= 641, `${name}: ${JSON.stringify(box)}`);
    }
    for (const name of ['motion', 'plots', 'script', 'log']) {
      await page.locator(`#drawer-tab-${name}`).click();
      await page.waitForTimeout(100);
    }
    await axe(page, '200 % zoom');
    check(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth), 'nothing to scroll sideways');
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
    await page.locator('.console .note').getByText('stopped', { exact: true }).waitFor();
    check(await page.locator('.console .err').count() === 0, 'nothing but that it was stopped');
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
