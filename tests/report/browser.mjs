// Opens a report in chromium, uses it as people do, and checks what it shows:
//   node browser.mjs REPORT.html SCREENSHOTS [PAGE_MODULES]
// SCREENSHOTS: directory for the pictures. Ends with an error at the first thing that is wrong.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import path from "node:path";

const [report, pictures, modules] = process.argv.slice(2);
const { chromium } = createRequire(path.resolve(modules ?? ".", "package.json"))("playwright-core");

const kFlags = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  "--ignore-gpu-blocklist", "--disable-dev-shm-usage", "--force-color-profile=srgb"];

/** A page of its own, with all that the console says and every request. */
async function openReport(browser, options) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const complaints = [];
  const requests = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
  page.on("pageerror", (problem) => complaints.push(String(problem)));
  page.on("request", (request) => requests.push(request.url()));
  const url = pathToFileURL(path.resolve(report)).href;
  await page.goto(url);
  await page.waitForFunction(() => window.mbgenReport);
  return { page, complaints, requests, url, close: () => context.close() };
}

const time = (page) => page.evaluate(() => window.mbgenReport.player.state.time);
const seek = (page, at) => page.evaluate((t) => window.mbgenReport.player.seek(t), at);

/** Waits until the picture of the time shown is drawn. */
async function settle(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** The picture of the animation alone. */
async function picture(page) {
  await settle(page);
  return page.locator("#view").screenshot();
}

/** Distance in px of the first plot's time line from where its time stands on the axis. */
const markerError = (page) => page.evaluate(() => {
  const { plots, player } = window.mbgenReport;
  const [plot] = plots.plots;
  const expected = plot.chart.over.getBoundingClientRect().left + plot.chart.valToPos(player.state.time, "x");
  const box = plot.marker.getBoundingClientRect();
  return Math.abs((box.left + box.right) / 2 - expected);
});

async function checkPlaying(page) {
  await seek(page, 0);
  const first = await picture(page);
  await page.locator("#speed").selectOption("0.25"); // a busy machine must not come to the end
  await page.locator("#play").click();
  await page.waitForFunction(() => window.mbgenReport.player.state.time > 0.05, null, { timeout: 30000 });
  await page.locator("#play").click();
  assert.equal(await page.evaluate(() => window.mbgenReport.player.state.playing), false);
  assert.ok(!first.equals(await picture(page)), "the picture did not change while it played");
  const before = await time(page);
  await page.locator("#view").focus();
  await page.keyboard.press("ArrowRight");
  assert.ok((await time(page)) > before, "the arrow key does not step");
  await page.keyboard.press("Home");
  assert.equal(await time(page), 0);
  await page.locator("#speed").selectOption("1");
}

async function checkScrubbing(page) {
  const end = await page.evaluate(() => window.mbgenReport.player.state.end);
  const slider = page.locator("#scrub");
  const box = await slider.boundingBox();
  await page.mouse.click(box.x + 0.5 * box.width, box.y + box.height / 2);
  assert.ok(Math.abs((await time(page)) - end / 2) < 0.05 * end, "the slider does not go to the middle");
  assert.ok((await markerError(page)) < 2, "the line in the plot is not where the slider is");
  const shown = await page.locator(".legend output").first().textContent();
  await seek(page, 0.1 * end);
  assert.notEqual(await page.locator(".legend output").first().textContent(), shown, "the legend stays");
  const over = await page.locator(".u-over").first().boundingBox();
  await page.mouse.click(over.x + 0.75 * over.width, over.y + over.height / 2);
  assert.ok(Math.abs((await time(page)) - 0.75 * end) < 0.03 * end, "a click in a plot does not go there");
  assert.ok((await markerError(page)) < 2);
}

async function checkZoom(page) {
  const scales = () => page.evaluate(() => window.mbgenReport.plots.plots.map((plot) => {
    const { min, max } = plot.chart.scales.x;
    return [min, max];
  }));
  const [[low, high]] = await scales();
  const over = await page.locator(".u-over").first().boundingBox();
  await page.mouse.move(over.x + 0.4 * over.width, over.y + 20);
  await page.mouse.down();
  await page.mouse.move(over.x + 0.6 * over.width, over.y + 40, { steps: 4 });
  await page.mouse.up();
  for (const [min, max] of await scales()) {
    assert.ok(Math.abs(max - min - 0.2 * (high - low)) < 0.02 * (high - low), "the plots do not zoom together");
  }
  await page.locator("#reset-zoom").click();
  assert.deepEqual(await scales(), (await scales()).map(() => [low, high]));
}

async function checkPicker(page) {
  const becomes = (count) => page.waitForFunction((n) => document.querySelectorAll(".plot").length === n, count, { timeout: 5000 });
  const before = await page.locator(".plot").count();
  await page.locator("#add-plot").click();
  await page.locator("#picker-filter").fill("z.");
  await page.locator("#picker-list label:visible input").first().check();
  await page.locator("#picker button.primary").click();
  await becomes(before + 1);
  await page.locator(".plot").last().locator("button", { hasText: "Remove" }).click();
  await becomes(before);
}

async function checkCameras(page) {
  const places = [];
  for (const key of ["1", "2", "3", "4"]) {
    await page.locator("#view").focus();
    await page.keyboard.press(key);
    await settle(page);
    places.push((await page.evaluate(() => window.mbgenReport.view.cameraPlace())).map((x) => x.toFixed(3)).join());
  }
  const cameras = await page.locator("#camera option").count();
  assert.equal(new Set(places).size, cameras, "each camera stands elsewhere");
  await page.keyboard.press("1");
}

async function checkNothingIsLoaded({ requests, complaints, url }) {
  assert.deepEqual(complaints.filter((text) => !text.includes("GPU stall due to ReadPixels")), []);
  assert.deepEqual(requests, [url], "the page asked for something");
}

const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: kFlags });
try {
  const wide = await openReport(browser, { viewport: { width: 1280, height: 800 } });
  await checkPlaying(wide.page);
  await checkScrubbing(wide.page);
  await checkZoom(wide.page);
  await checkPicker(wide.page);
  await checkCameras(wide.page);
  const end = await wide.page.evaluate(() => window.mbgenReport.player.state.end);
  await wide.page.mouse.move(1, 1);
  await wide.page.locator("#charts").evaluate((charts) => charts.scrollTo(0, 0));
  await seek(wide.page, 0.62 * end);
  await settle(wide.page);
  await wide.page.screenshot({ path: path.join(pictures, "report.png") });
  await wide.page.locator("#followed").selectOption("bell_crank");
  await wide.page.locator("#layers input[name=hulls]").uncheck();
  await wide.page.locator("#view").focus();
  for (const key of "wwaaaaaa") await wide.page.keyboard.press(key);
  await settle(wide.page);
  await wide.page.locator("#motion").screenshot({ path: path.join(pictures, "report_suspension.png") });
  await checkNothingIsLoaded(wide);
  await wide.close();

  const narrow = await openReport(browser, { viewport: { width: 390, height: 800 }, colorScheme: "dark" });
  const overflow = await narrow.page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.ok(overflow <= 0, `a narrow window scrolls sideways by ${overflow} px`);
  await seek(narrow.page, 0.62 * end);
  await settle(narrow.page);
  await narrow.page.screenshot({ path: path.join(pictures, "report_narrow.png") });
  await checkNothingIsLoaded(narrow);
  await narrow.close();
} finally {
  await browser.close();
}
console.log("report: played, scrubbed, zoomed; nothing was loaded, the console is empty");
