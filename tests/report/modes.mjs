// Opens pages of modes in chromium, uses them as people do, and checks what they show:
//   node modes.mjs PAGE NUMBERS GROWING SCREENSHOTS [PAGE_MODULES]
// NUMBERS: what mbgen linearize --json says of the same modes. GROWING: a page whose first mode is unstable.
// SCREENSHOTS: directory for the pictures. Ends with an error at the first thing that is wrong.

import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import path from "node:path";
import { checkNothingIsLoaded, launch, openPage, picture, seek, settle } from "./page.mjs";

const [file, numbers, growing, pictures, modules] = process.argv.slice(2);
const expected = JSON.parse(readFileSync(numbers, "utf8")).modes;

const end = (page) => page.evaluate(() => window.mbgenReport.player.state.end);
const chosen = (page) => page.evaluate(() => window.mbgenReport.modes.chosen());
const pause = (page) => page.evaluate(() => window.mbgenReport.player.pause());

/** A number of the list, of three digits or four. */
function assertShown(text, value, what) {
  if (value === null) assert.equal(text, "", what);
  else assert.ok(Math.abs(Number(text) - value) <= 6e-3 * Math.abs(value) + 1e-9, `${what}: ${text} instead of ${value}`);
}

async function checkList(page) {
  const rows = await page.locator("#mode-rows tr").evaluateAll((list) => list.map((row) => [...row.cells].map((cell) => cell.textContent)));
  assert.equal(rows.length, expected.length);
  expected.forEach(({ eigenvalue: [real, imaginary], frequency, damping_ratio: damping, neutral }, i) => {
    const [, hertz, ratio, time, eigenvalue] = rows[i];
    const oscillates = imaginary > 0 && !neutral;
    assertShown(hertz, oscillates ? frequency : null, `frequency of mode ${i + 1}`);
    assertShown(ratio, oscillates ? damping : null, `damping of mode ${i + 1}`);
    assertShown(time, oscillates || neutral ? null : -1 / real, `time constant of mode ${i + 1}`);
    const [shownReal, shownImaginary] = eigenvalue.replace(" i", "").split(" \u00b1 ");
    assertShown(shownReal, neutral ? 0 : real, `real part of mode ${i + 1}`);
    if (oscillates) assertShown(shownImaginary, imaginary, `imaginary part of mode ${i + 1}`);
    else assert.equal(shownImaginary, undefined);
  });
}

async function checkPlaying(page) {
  assert.equal(await page.evaluate(() => window.mbgenReport.player.state.playing), true, "the first mode moves at once");
  await page.waitForFunction(() => window.mbgenReport.player.state.time > 0, null, { timeout: 30000 });
  await page.locator("#play").click();
  await seek(page, 0);
  const first = await picture(page);
  await seek(page, 0.5 * (await end(page)));
  assert.ok(!first.equals(await picture(page)), "the picture of half a period later is the same");
  await seek(page, 0);
  assert.ok(first.equals(await picture(page)), "the picture of the same phase is another");
}

/** Whatever its frequency, a mode is shown at a speed that eyes can follow. */
async function checkPaces(page) {
  const paces = await page.evaluate(() => {
    const { modes, player, data } = window.mbgenReport;
    return data.animations.map((mode, i) => {
      modes.choose(i);
      const time = mode.oscillates ? 1 / mode.frequency : player.state.end;
      return { time, speed: player.state.speed, text: document.getElementById("pace").textContent };
    });
  });
  paces.forEach(({ time, speed, text }, i) => {
    assert.ok(time / speed >= 0.49 && time / speed <= 10.01, `mode ${i + 1} takes ${time / speed} s`);
    assert.equal(text, speed === 1 ? "real time" : speed < 1 ? `${Math.round(1 / speed)} times slower than real` : `${speed} times faster than real`);
  });
  assert.ok(paces.some(({ speed }) => speed === 1) && paces.some(({ speed }) => speed < 0.1));
}

async function checkChoosing(page) {
  await page.locator("#mode-rows tr").nth(4).click();
  assert.equal(await chosen(page), 4, "a click in the list chooses");
  const fifth = await picture(page);
  await page.locator("#view").focus();
  await page.keyboard.press("ArrowDown");
  assert.equal(await chosen(page), 5, "the arrow key chooses");
  assert.ok(!fifth.equals(await picture(page)), "another mode has the same picture");
  await page.keyboard.press("ArrowUp");
  assert.equal(await chosen(page), 4);
  await page.locator("#mode-rows input").nth(4).focus();
  await page.keyboard.press("ArrowDown");
  assert.equal(await chosen(page), 5, "the arrow key chooses in the list too");
  await page.locator(".eigenvalue.chosen circle").first().waitFor();
  await page.evaluate(() => {
    const groups = [...document.querySelectorAll(".eigenvalue")];
    groups.find((group) => group.textContent === "mode 7").querySelector("circle").dispatchEvent(new MouseEvent("click", { bubbles: true }));
  });
  assert.equal(await chosen(page), 6, "a click in the plane chooses");
  assert.equal(await page.locator(".eigenvalue.chosen").count(), 1);
  assert.equal(await page.locator("#mode-rows tr.chosen").count(), 1);
}

/** Smallest and largest length of each link over a period of a mode, at an amplitude. */
const lengths = (page, mode, amplitude) => page.evaluate(async ([index, part]) => {
  const { modes, player, view, data } = window.mbgenReport;
  const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  const slider = document.getElementById("amplitude");
  slider.value = String(part);
  slider.dispatchEvent(new Event("input"));
  modes.choose(index);
  const links = data.scene.links.map(({ kind }) => ({ kind, low: Infinity, high: 0 }));
  for (let i = 0; i < 7; ++i) {
    player.seek((player.state.end * (i + 0.3)) / 7);
    await drawn();
    data.scene.links.forEach((link, k) => {
      const [a, b] = view.endPlaces(link);
      const length = Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]);
      Object.assign(links[k], { low: Math.min(links[k].low, length), high: Math.max(links[k].high, length) });
    });
  }
  slider.value = "0.5";
  slider.dispatchEvent(new Event("input"));
  return links;
}, [mode, amplitude]);

/** Rods are loops that are closed: between the frames and at any amplitude they keep their lengths, to 4 mm. */
async function checkRods(page) {
  for (const amplitude of [0.5, 1]) {
    for (const mode of [0, 4]) {
      const links = await lengths(page, mode, amplitude);
      const changes = (kind) => links.filter((link) => link.kind === kind).map(({ low, high }) => high - low);
      assert.ok(Math.max(...changes("rod")) < 4e-3, `rods change by ${Math.max(...changes("rod"))} m in mode ${mode + 1}`);
      assert.ok(Math.max(...changes("air_spring")) > 0.02, `no air spring moves in mode ${mode + 1}`);
    }
  }
}

async function checkSwing(page) {
  await page.locator("#mode-rows tr").nth(4).click();
  await page.locator("#amplitude").fill("0");
  const still = await picture(page);
  await seek(page, 0.5 * (await end(page)));
  assert.ok(still.equals(await picture(page)), "without amplitude nothing moves");
  await page.locator("#amplitude").fill("0.5");
  const half = await picture(page);
  assert.ok(!still.equals(half));
  const period = await end(page);
  await page.locator("#damped").check();
  assert.ok((await end(page)) > 1.5 * period, "a damped swing lasts more than a period");
  await seek(page, 0.5 * period);
  assert.ok(!half.equals(await picture(page)), "a damped swing is smaller after half a period");
  await page.locator("#damped").uncheck();
}

async function checkGrowing(browser) {
  const opened = await openPage(browser, growing, { viewport: { width: 390, height: 800 }, colorScheme: "dark" });
  const { page } = opened;
  assert.equal(await page.locator("#mode-rows b.unstable").count(), 1, "what grows is marked in the list");
  assert.match(await page.locator("#shape").textContent(), /^Unstable\. Moves most: coupler_pin/);
  assert.equal(await page.locator("#plane circle.unstable").count(), 2, "and in the plane, with its conjugate");
  const overflow = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(overflow <= 0, `a narrow window scrolls sideways by ${overflow} px`);
  await checkNothingIsLoaded(opened);
  await opened.close();
}

const browser = await launch(modules);
try {
  const opened = await openPage(browser, file, { viewport: { width: 1070, height: 520 } });
  const { page } = opened;
  await checkList(page);
  await checkPlaying(page);
  await checkPaces(page);
  await checkChoosing(page);
  await checkRods(page);
  await checkSwing(page);
  await page.locator("#layers input[name=hulls]").uncheck();
  await page.locator("#followed").selectOption("rear_axle");
  await page.locator("#mode-rows tr").nth(0).click();
  await pause(page);
  await settle(page);
  await page.screenshot({ path: path.join(pictures, "modes.png") });
  await checkNothingIsLoaded(opened);
  await opened.close();
  await checkGrowing(browser);
} finally {
  await browser.close();
}
console.log("modes: listed, chosen, animated; rods keep their lengths, nothing was loaded, the console is empty");
