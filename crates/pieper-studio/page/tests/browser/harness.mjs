// Starts the real program and a real browser; runs cases one after the other on one studio each.

import { spawn } from 'node:child_process';
import { mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { chromium } from 'playwright-core';

const PROGRAM = process.env.PIEPER ?? new URL('../../../../../target/debug/pieper', import.meta.url).pathname;
const CHROMIUM = process.env.CHROMIUM ?? '/usr/bin/chromium';
/** Sessions with controllers are recorded here, not among the person's own. */
export const STATE = mkdtempSync(join(tmpdir(), 'pieper-state-'));
const ARGUMENTS = ['--no-sandbox', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync',
  '--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

export const launch = () => chromium.launch({ executablePath: CHROMIUM, headless: true, args: ARGUMENTS });

/** A studio with an arm: its address, and a way to end it. */
export async function studio(robot = 'ar3', more = []) {
  const child = spawn(PROGRAM, ['studio', robot, '--no-open', ...more], { stdio: ['ignore', 'pipe', 'inherit'], env: { ...process.env, XDG_STATE_HOME: STATE } });
  const url = await new Promise((resolve, reject) => {
    child.stdout.once('data', (data) => resolve(String(data).trim()));
    child.once('exit', (code) => reject(new Error(`the studio ended with ${code}`)));
  });
  return { url, stop: () => child.kill() };
}

/** A window on it; requests that leave this computer and errors of the page are collected. */
export async function open(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 960, height: 600 }, colorScheme: 'light', ...options });
  const page = await context.newPage();
  const outside = [];
  const errors = [];
  page.on('request', (request) => {
    const { protocol, hostname } = new URL(request.url());
    if (!['data:', 'blob:'].includes(protocol) && hostname !== '127.0.0.1') outside.push(request.url());
  });
  page.on('pageerror', (error) => errors.push(error.message));
  page.on('console', (message) => { if (message.type() === 'error') errors.push(message.text()); });
  const [address, token] = url.split('#');
  await page.goto(`${address}?plain#${token}`);
  await ready(page);
  return { page, outside, errors, context };
}

export async function ready(page) {
  await page.waitForFunction(() => document.documentElement.dataset.ready === '1', null, { timeout: 60_000 });
}

export function check(condition, text) {
  if (!condition) throw new Error(text);
}

/** Waits until a value read in the page satisfies a condition. */
export async function until(page, read, wanted, text, argument) {
  const deadline = Date.now() + 20_000;
  let value;
  while (Date.now() < deadline) {
    value = await page.evaluate(read, argument);
    if (wanted(value)) return value;
    await page.waitForTimeout(40);
  }
  throw new Error(`${text}: ${JSON.stringify(value)}`);
}

export const joint = (page, index) => page.getByLabel(`J${index} value`).inputValue().then(Number);

/** The watchdogs of the link: a computer too busy to run the studio in time trips them, as it should. */
const LATE = /has been silent for|has told no position for/;

/** One case on a studio and in a window of its own: what went wrong, and what the studio said of it. */
async function attempt(browser, [name, robot, run]) {
  const served = await studio(robot);
  let window;
  try {
    window = await open(browser, served.url);
    await run(window.page, { ...window, browser, url: served.url });
    check(window.outside.length === 0, `requests left this computer: ${window.outside}`);
    check(window.errors.length === 0, `errors in the page: ${window.errors.join('; ')}`);
    return null;
  } catch (error) {
    if (window && process.env.SHOTS) await window.page.screenshot({ path: `${process.env.SHOTS}/${name.replace(/\W+/g, '-')}.png` }).catch(() => {});
    const said = await window?.page.locator('.controller, .console, .toast').allInnerTexts().catch(() => []) ?? [];
    return { text: error.message, said: said.join('\n') };
  } finally {
    await window?.context.close();
    served.stop();
  }
}

/** Runs all cases, one that a watchdog has ended up to three times; the exit code says whether they passed. */
export async function main(cases) {
  const only = process.argv[2];
  const browser = await launch();
  let failed = 0;
  for (const one of cases.filter(([name]) => !only || name.includes(only))) {
    const started = Date.now();
    let wrong = await attempt(browser, one);
    for (let again = 0; again < 2 && wrong && LATE.test(wrong.said); again++) {
      console.log(`AGAIN ${one[0]}: ${wrong.said.split('\n').find((line) => LATE.test(line))}`);
      wrong = await attempt(browser, one);
    }
    if (wrong) {
      failed += 1;
      console.log(`FAIL  ${one[0]}: ${wrong.text}`);
      for (const line of wrong.said.split('\n').filter(Boolean)) console.log(`      | ${line}`);
    } else {
      console.log(`PASS  ${one[0]} (${Date.now() - started} ms)`);
    }
  }
  await browser.close();
  console.log(failed === 0 ? 'all passed' : `${failed} failed`);
  process.exit(failed === 0 ? 0 : 1);
}
