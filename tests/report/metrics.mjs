// Metrics of a manoeuvre on the page:
//   node metrics.mjs describe RUN.json OTHER.json        writes a run's description with metrics into it
//   node metrics.mjs check REPORT.html SCREENSHOTS [PAGE_MODULES]
// REPORT.html: of such a run. Ends with an error at the first thing that is wrong.

import assert from "node:assert/strict";
import { readFileSync, writeFileSync } from "node:fs";
import path from "node:path";
import { checkNothingIsLoaded, launch, openPage, settle } from "./page.mjs";

const kMetrics = {
  manoeuvre: { type: "steady_circle", file: "circle_100.json" },
  metrics: [
    { name: "understeer_gradient", value: 0.0032, unit: "rad/(m/s^2)", meaning: "more steer <b>than</b> geometry" },
    { name: "yaw_rate_gain", value: -5.25, unit: "(m/s^2)/rad", meaning: "yaw rate over steer angle" },
    { name: "roll_moment_share_axle_1", value: 0.625, unit: "1", meaning: "of all axles'" },
  ],
  diagrams: [
    { title: "Steer angle", x: { name: "lateral acceleration", unit: "m/s^2" }, y: { name: "steer angle", unit: "rad" },
      curves: [{ name: "left", x: [0, 1, 2, 3], y: [0.1, 0.2, null, 0.4] }, { name: "right", x: [0, 3], y: [0.1, 0.3] }] },
    { title: "Standing", x: { name: "t", unit: "s" }, y: { name: "roll", unit: "1" }, curves: [{ name: "roll", x: [0, 1], y: [0, 0] }] },
  ],
  metric_notes: ["characteristic_speed: the vehicle steers neutrally"],
};

function describe(file, other) {
  writeFileSync(other, JSON.stringify({ ...JSON.parse(readFileSync(file)), ...kMetrics }));
}

async function checkNumbers(page) {
  assert.equal(await page.locator("#metrics summary").textContent(), "Steady circlecircle_100.json");
  const rows = await page.locator("#metrics tr").evaluateAll((list) => list.map((row) => [...row.children].map((cell) => cell.textContent)));
  assert.deepEqual(rows, [
    ["understeer gradientmore steer <b>than</b> geometry", "0.1833", "deg/(m/s^2)"],
    ["yaw rate gainyaw rate over steer angle", "-0.09163", "(m/s^2)/deg"],
    ["roll moment share axle 1of all axles'", "0.625", ""],
  ]);
  assert.deepEqual(await page.locator("#metrics p").allTextContents(), kMetrics.metric_notes);
}

/** Curves break where a value is missing; their ends stand where the axes say. */
async function checkDiagrams(page) {
  const first = page.locator(".diagram").first();
  const [left, right] = await first.locator(".curve").evaluateAll((paths) => paths.map((path) => path.getAttribute("d")));
  assert.equal(left.match(/M/g).length, 2);
  assert.equal(right.match(/M/g).length, 1);
  const labels = await first.locator("text").allTextContents();
  assert.ok(labels.includes("lateral acceleration, m/s^2") && labels.includes("steer angle, deg"), labels.join());
  const placeOf = async (text) => Number(await first.locator("text", { hasText: new RegExp(`^${text}$`) }).first().getAttribute("y")) - 3;
  const [ten, twenty] = [await placeOf("10"), await placeOf("20")];
  const end = Number(right.split(" ").at(-1)); // 0.3 rad
  const degrees = 10 + (10 * (end - ten)) / (twenty - ten);
  assert.ok(Math.abs(degrees - (0.3 * 180) / Math.PI) < 0.05, `0.3 rad is drawn at ${degrees} deg`);
  assert.deepEqual(await first.locator("li").allTextContents(), ["left", "right"]);
  assert.equal(await page.locator(".diagram").count(), 2);
}

async function check(report, pictures, modules) {
  const browser = await launch(modules);
  try {
    const opened = await openPage(browser, report, { viewport: { width: 1280, height: 800 } });
    await checkNumbers(opened.page);
    await checkDiagrams(opened.page);
    await opened.page.screenshot({ path: path.join(pictures, "report_metrics.png") });
    await opened.page.setViewportSize({ width: 390, height: 800 });
    await settle(opened.page);
    const overflow = await opened.page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
    assert.ok(overflow <= 0, `metrics in a narrow window scroll sideways by ${overflow} px`);
    await checkNothingIsLoaded(opened);
    await opened.close();
  } finally {
    await browser.close();
  }
}

const [what, ...others] = process.argv.slice(2);
await (what === "describe" ? describe : check)(...others);
