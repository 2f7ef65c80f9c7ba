// Opens a report in chromium, uses it as people do, and checks what it shows:
//   node browser.mjs REPORT.html SCREENSHOTS [PAGE_MODULES [MOVED.html RUBBER.html]]
// MOVED.html: of a run whose initial value of rocker_pin was moved. RUBBER.html: of a run of rubber_wishbone.
// SCREENSHOTS: directory for the pictures. Ends with an error at the first thing that is wrong.

import assert from "node:assert/strict";
import path from "node:path";
import { checkNothingIsLoaded, launch, openPage, picture, seek, settle } from "./page.mjs";

const [report, pictures, modules, moved, rubber] = process.argv.slice(2);
const openReport = (browser, options) => openPage(browser, report, options);

const time = (page) => page.evaluate(() => window.mbgenReport.player.state.time);

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

/** Whoever comes back to the vehicle finds it where it is by now, not where it began. */
async function checkFollowing(page) {
  const place = () => page.evaluate(() => window.mbgenReport.view.cameraPlace());
  await seek(page, 0.8 * (await page.evaluate(() => window.mbgenReport.player.state.end)));
  await settle(page);
  await page.locator("#camera").selectOption("chase");
  await page.locator("#camera").selectOption("follow");
  const before = await place();
  await page.locator("#followed").selectOption("bell_crank");
  await page.locator("#followed").selectOption("chassis");
  (await place()).forEach((x, i) => assert.ok(Math.abs(x - before[i]) < 1e-6, "the camera does not come back"));
}

/** Whoever clicked something goes on with the keys; who came to it by Tab has its own keys. */
async function checkKeysAfterClicks(page) {
  const playing = () => page.evaluate(() => window.mbgenReport.player.state.playing);
  const bodies = page.locator("#layers input[name=joints]");
  await bodies.click();
  await page.keyboard.press("Home");
  assert.equal(await time(page), 0, "Home after a click on a box");
  await page.keyboard.press("Space");
  assert.equal(await playing(), true, "space plays after a click on a box");
  await page.keyboard.press("Space");
  await bodies.click();
  await page.locator("#start").click();
  await page.keyboard.press("ArrowRight");
  assert.ok((await time(page)) > 0, "the arrow key steps after a click on a button");
  await bodies.focus();
  await page.keyboard.press("Space");
  assert.equal(await playing(), false, "a box that has the focus takes its space itself");
  assert.equal(await bodies.isChecked(), false);
  await page.keyboard.press("End");
  assert.ok((await time(page)) > 1, "and leaves the other keys");
  await page.keyboard.press("Space");
}

async function checkSingleBodies(page) {
  const list = page.locator("#layers details summary");
  const box = page.locator("#layers input[name='body chassis']");
  /** The picture with the box so, the list closed before it. */
  const shown = async (isChecked) => {
    await list.click();
    await box.setChecked(isChecked);
    await list.click();
    return picture(page);
  };
  const before = await shown(true);
  assert.ok(!before.equals(await shown(false)), "a body that is hidden is seen");
  assert.ok(before.equals(await shown(true)), "a body that is shown again is another");
}

/** Ticks of all vertical axes, and how much of its height each curve fills, as the plots have them. */
async function checkPanels(page) {
  const panels = await page.evaluate(() => window.mbgenReport.plots.plots.map(({ chart, columns }) => {
    const { min, max } = chart.scales.y;
    const steps = chart.axes[1]._splits;
    return {
      ticks: chart.axes[1]._values,
      increasing: steps.every((y, i) => i === 0 || y > steps[i - 1]),
      filled: chart.data.slice(1).map((values) => (Math.max(...values) - Math.min(...values)) / (max - min)),
      quantities: [...new Set(columns.map((c) => window.mbgenReport.data.table.columns[c].quantity))],
      smooth: chart.series.slice(1).every((series) => series.pxAlign === 0),
    };
  }));
  panels.forEach(({ ticks, increasing, quantities, smooth }) => {
    assert.ok(ticks.every((text) => !/^-0(\.0*)?$/.test(text)), `ticks ${ticks}`);
    assert.ok(increasing && smooth);
    assert.equal(quantities.length, 1, `a panel of ${quantities}`);
  });
}

/** A curve of rounding noise is a line in its panel, one of the same shape and a real size fills it. */
async function checkNoise(page) {
  for (const [size, isNoise] of [[1e-15, true], [1e-3, false]]) {
    await page.evaluate((amplitude) => {
      const { plots, data } = window.mbgenReport;
      const values = data.table.times.map((t) => amplitude * Math.sin(9 * t));
      data.table.columns.push({ name: "wave", unit: "V", group: "output", smallest: -amplitude, largest: amplitude, noise: 1e-10, values });
      plots.add([data.table.columns.length - 1]);
    }, size);
    await settle(page);
    const filled = await page.evaluate((amplitude) => {
      const { min, max } = window.mbgenReport.plots.plots.at(-1).chart.scales.y;
      return (2 * amplitude) / (max - min);
    }, size);
    assert.ok(isNoise ? filled < 1e-6 : filled > 0.5 && filled < 1, `a wave of ${size} V fills ${filled} of its panel`);
    await page.locator(".plot").last().locator("button", { hasText: "Remove" }).click();
  }
}

async function checkMovedStart(browser) {
  const opened = await openPage(browser, moved);
  const row = opened.page.locator("table", { hasText: "Initial values that moved" }).locator("tbody tr");
  assert.equal(await row.count(), 1);
  const [name, quantity, asked, found] = await row.locator("th, td").allTextContents();
  assert.deepEqual([name, quantity, asked], ["rocker_pin", "position", "-0.9"]);
  assert.ok(Math.abs(found - -0.1625) < 1e-3, `rocker_pin is said to be moved to ${found}`);
  assert.equal(await opened.page.locator("#metrics").count(), 0, "a run without metrics shows some");
  await checkNothingIsLoaded(opened);
  await opened.close();
}

/** Arrows are as long as the forces in the table, at every bushing; a box hides them. */
async function checkForces(browser) {
  const opened = await openPage(browser, rubber);
  const { page } = opened;
  await seek(page, await page.evaluate(() => window.mbgenReport.player.state.end));
  await settle(page);
  const forces = await page.evaluate(() => {
    const { view, data } = window.mbgenReport;
    return view.drawnForces().map(({ name, force }) => {
      const last = (axis) => data.table.columns.find((column) => column.name === `${name}.force_${axis}`).values.at(-1);
      return { name, force, expected: Math.hypot(last("x"), last("y"), last("z")) };
    });
  });
  assert.ok(forces.length > 0, "no force of a bushing is drawn");
  for (const { name, force, expected } of forces)
    assert.ok(expected > 1 && Math.abs(force - expected) < 1e-3 * expected, `${name}: ${force} N drawn, ${expected} N in the table`);
  await page.screenshot({ path: path.join(pictures, "report_forces.png") });
  const shown = await picture(page);
  await page.locator("#layers input[name=forces]").uncheck();
  assert.ok(!shown.equals(await picture(page)), "the forces stay");
  await checkNothingIsLoaded(opened);
  await opened.close();
}

const browser = await launch(modules);
try {
  if (moved) await checkMovedStart(browser);
  if (rubber) await checkForces(browser);
  const wide = await openReport(browser, { viewport: { width: 1280, height: 800 } });
  await checkPlaying(wide.page);
  await checkScrubbing(wide.page);
  await checkZoom(wide.page);
  await checkPicker(wide.page);
  await checkCameras(wide.page);
  await checkKeysAfterClicks(wide.page);
  await checkSingleBodies(wide.page);
  await checkPanels(wide.page);
  await checkNoise(wide.page);
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
  await checkFollowing(narrow.page);
  await checkNothingIsLoaded(narrow);
  await narrow.close();
} finally {
  await browser.close();
}
console.log("report: played, scrubbed, zoomed; nothing was loaded, the console is empty");
