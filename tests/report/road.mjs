// Opens the page of a ride in chromium, checks that its road is drawn, and takes a picture:
//   node road.mjs REPORT.html TIME KEYS PICTURE.png [PAGE_MODULES [PLOTS]]
// TIME: s; KEYS: that are pressed before the picture, of cameras and orbit; PLOTS: columns of the plots in place of those
// at first, a comma between columns of one plot and a slash between plots. Writes the lowest and the highest place of
// each strip of road, m. Ends with an error at the first thing that is wrong.

import assert from "node:assert/strict";
import { checkNothingIsLoaded, launch, openPage, picture, seek, settle } from "./page.mjs";

const [report, time, keys, png, modules, plots] = process.argv.slice(2);

async function choosePlots(page) {
  while (await page.locator(".plot").count() > 0) await page.locator(".plot button", { hasText: "Remove" }).first().click();
  const chosen = plots.split("/").map((names) => names.split(","));
  await page.evaluate((panels) => {
    const { columns } = window.mbgenReport.data.table;
    panels.forEach((names) => window.mbgenReport.plots.add(names.map((name) => columns.findIndex((column) => column.name === name))));
  }, chosen);
}

const browser = await launch(modules);
try {
  const opened = await openPage(browser, report, { viewport: { width: 1200, height: 740 } });
  const { page } = opened;
  const strips = await page.evaluate(() => window.mbgenReport.view.drawnRoads());
  assert.ok(strips.length > 0, "the page has no road");
  strips.forEach(({ triangles, lowest, highest }) => {
    assert.ok(triangles >= 2 && Number.isFinite(lowest) && highest >= lowest, "a strip of road is empty");
    console.log(lowest.toFixed(4), highest.toFixed(4));
  });
  if (plots) await choosePlots(page);
  await seek(page, Number(time));
  await page.locator("#view").focus();
  for (const key of keys) await page.keyboard.press(key);
  await settle(page);
  await page.mouse.move(1, 1);
  const shown = await picture(page);
  await page.screenshot({ path: png });
  await page.locator("#layers input[name=ground]").uncheck();
  assert.ok(!shown.equals(await picture(page)), "the road stays when the ground is hidden");
  await checkNothingIsLoaded(opened);
  await opened.close();
} finally {
  await browser.close();
}
