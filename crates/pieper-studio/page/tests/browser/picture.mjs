// The README's picture of the studio: node tests/browser/picture.mjs ../../../docs/studio.png

import { launch, open, studio } from './harness.mjs';

const file = process.argv[2] ?? '../../../docs/studio.png';
const served = await studio('irb120', ['--q', '-35deg,18deg,22deg,40deg,55deg,10deg']);
const browser = await launch();
const context = await browser.newContext({ viewport: { width: 1280, height: 720 }, colorScheme: 'light' });
const page = await context.newPage();
await page.goto(served.url);
await page.waitForFunction(() => document.documentElement.dataset.ready === '1');
await page.getByText('Got it').click();
const posture = async (values) => {
  for (const [joint, text] of Object.entries(values)) {
    await page.getByLabel(`J${joint} value`).fill(text);
    await page.getByLabel(`J${joint} value`).press('Enter');
  }
};
// A motion of three postures: its way through space, its plots.
for (const values of [{}, { 1: '20', 2: '35', 3: '5', 5: '30' }, { 1: '60', 2: '10', 3: '25', 5: '60' }]) {
  await posture(values);
  await page.locator('canvas').first().focus();
  await page.keyboard.press('k');
  await page.waitForTimeout(150);
}
await page.evaluate(() => window.pieperViewer.path.clearTrail());
await page.getByRole('slider', { name: 'Time' }).fill('2');
await page.getByRole('tab', { name: 'Plots' }).click();
await page.getByRole('tab', { name: /Solutions/ }).click();
await page.getByLabel('Ghosts', { exact: true }).check();
await page.waitForTimeout(500);
await page.evaluate(() => { window.pieperViewer.path.clearTrail(); window.pieperViewer.fit('home'); });
await page.mouse.move(1100, 650);
await page.locator('.toast').waitFor({ state: 'detached' });
await page.waitForTimeout(800);
await page.screenshot({ path: file });
await browser.close();
served.stop();
