// Opens pages with a course, with a second result, and with frequency responses in chromium:
//   node overlay.mjs OVERLAY.html RESPONSES.html PICTURES [PAGE_MODULES]
// OVERLAY: two results of a lane change. Ends with an error at the first thing that is wrong.

import assert from "node:assert/strict";
import path from "node:path";
import { checkNothingIsLoaded, launch, openPage, picture, seek, settle } from "./page.mjs";

const [overlay, responses, pictures, modules] = process.argv.slice(2);

/** Hiding a layer changes the picture. */
async function checkLayer(page, name) {
  const shown = await picture(page);
  await page.locator(`#layers input[name=${name}]`).uncheck();
  assert.ok(!shown.equals(await picture(page)), `${name} are not drawn`);
  await page.locator(`#layers input[name=${name}]`).check();
}

/** Cones stand at the limits of the three lanes, at most 3 m apart: 2 (6 + 10 + 11). */
async function checkCourse(page) {
  const { lanes, cones, course } = await page.evaluate(() => window.mbgenReport.view.drawnCourse());
  assert.equal(lanes, 3);
  assert.equal(cones, 54);
  assert.ok(course > 50, `${course} places of the course`);
  await checkLayer(page, "course");
}

/** The second result is where its own poses say, at the same time, and stays at its end. */
async function checkGhost(page) {
  const facts = await page.locator("#facts").textContent();
  assert.match(facts, /; manoeuvre.speed = 12, translucent: manoeuvre.speed = 14$/);
  const at = async (time) => {
    await seek(page, time);
    await settle(page);
    return page.evaluate(() => {
      const { data, view } = window.mbgenReport;
      const body = data.scene.follow;
      const { animation } = data.others[0];
      const frame = animation.times.findLastIndex((t) => t <= window.mbgenReport.player.state.time + 1e-6);
      return { drawn: view.ghostPlace(0, body), pose: Array.from(animation.poses.slice((frame * animation.bodyCount + body) * 7).slice(0, 3)) };
    });
  };
  const { drawn, pose } = await at(3);
  drawn.forEach((value, i) => assert.ok(Math.abs(value - pose[i]) < 0.2, `the ghost is at ${drawn}, its result at ${pose}`));
  const end = await at(1e9);
  assert.ok(end.drawn[0] - drawn[0] > 1, "the ghost does not move");
  await seek(page, 1); // 2 m ahead
  await checkLayer(page, "ghosts");
  const labels = await page.locator(".plot .legend").first().locator("li").allTextContents();
  assert.ok(labels.some((text) => text.includes("(manoeuvre.speed = 14)")), labels.join());
}

/** The metrics of both results stand beside each other; limits of the lanes, which are the same, once. */
async function checkMetrics(page) {
  const head = await page.locator("#metrics thead td").allTextContents();
  assert.deepEqual(head, ["manoeuvre.speed = 12", "manoeuvre.speed = 14", ""]);
  const [first, second] = (await page.locator("#metrics tbody tr").first().locator("td.number").allTextContents()).map(Number);
  assert.ok(Math.abs(first - 11.95) < 0.01 && Math.abs(second - 13.95) < 0.01, `entry speeds ${first} and ${second}`);
  assert.deepEqual(await page.locator(".diagram").first().locator("li").allTextContents(),
    ["reference point", "left limits", "right limits", "reference point (manoeuvre.speed = 14)"]);
}

/** Two diagrams over a logarithmic frequency: magnitude and phase. */
async function checkResponses(page) {
  assert.ok(await page.locator("#responses").isVisible());
  assert.ok(await page.locator("#to-responses").isVisible());
  const diagrams = page.locator("#response-diagrams .diagram");
  assert.deepEqual(await diagrams.locator("figcaption").allTextContents(), ["Magnitude of z/force", "Phase of z/force"]);
  const placeOf = async (diagram, text, axis) => Number(await diagrams.nth(diagram).locator("text", { hasText: new RegExp(`^${text}$`) }).first().getAttribute(axis));
  const [one, ten] = [await placeOf(0, "1", "x"), await placeOf(0, "10", "x")];
  const tenth = await placeOf(0, "0.1", "x");
  assert.ok(Math.abs(one - tenth - (ten - one)) < 0.2, "decades of frequency are not of one length");
  // The mass of 1 kg on 40 N/m with little damping: 1/40 m/N at rest, phase -90 deg at sqrt(40)/2/pi = 1.0066 Hz.
  const d = await diagrams.nth(1).locator(".curve").getAttribute("d");
  const points = d.slice(1).split("L").map((pair) => pair.split(" ").map(Number));
  const minus90 = (await placeOf(1, "-100", "y")) + 0.1 * ((await placeOf(1, "0", "y")) - (await placeOf(1, "-100", "y"))) - 3;
  const crossing = points.find(([, y]) => y >= minus90);
  const frequency = 10 ** ((crossing[0] - one) / (ten - one));
  assert.ok(Math.abs(frequency - 1.0066) < 0.03, `the phase is -90 deg at ${frequency} Hz`);
}

const browser = await launch(modules);
try {
  const opened = await openPage(browser, overlay, { viewport: { width: 1280, height: 800 } });
  await seek(opened.page, 3);
  await checkCourse(opened.page);
  await checkGhost(opened.page);
  await checkMetrics(opened.page);
  await seek(opened.page, 1.4);
  await opened.page.locator("#view").focus();
  await opened.page.keyboard.press("2"); // the camera behind
  await settle(opened.page);
  await opened.page.screenshot({ path: path.join(pictures, "report_overlay.png") });
  await checkNothingIsLoaded(opened);
  await opened.close();
  const modes = await openPage(browser, responses, { viewport: { width: 1000, height: 700 } });
  await checkResponses(modes.page);
  await modes.page.locator("#responses").scrollIntoViewIfNeeded();
  await modes.page.screenshot({ path: path.join(pictures, "linearisation_responses.png"), fullPage: true });
  await checkNothingIsLoaded(modes);
  await modes.close();
} finally {
  await browser.close();
}
