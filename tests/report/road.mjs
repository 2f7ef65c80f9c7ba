// Opens the page of a ride in chromium, checks that its road is drawn, and takes a picture:
//   node road.mjs REPORT.html TIME KEYS PICTURE.png [PAGE_MODULES]
// TIME: s; KEYS: that are pressed before the picture, of cameras and orbit. Writes the lowest and the highest place of
// each strip of road, m. Ends with an error at the first thing that is wrong.

import assert from "node:assert/strict";
import { checkNothingIsLoaded, launch, openPage, picture, seek, settle } from "./page.mjs";

const [report, time, keys, png, modules] = process.argv.slice(2);
const browser = await launch(modules);
try {
  const opened = await openPage(browser, report, { viewport: { width: 1280, height: 800 } });
  const { page } = opened;
  const strips = await page.evaluate(() => window.mbgenReport.view.drawnRoads());
  assert.ok(strips.length > 0, "the page has no road");
  strips.forEach(({ triangles, lowest, highest }) => {
    assert.ok(triangles >= 2 && Number.isFinite(lowest) && highest >= lowest, "a strip of road is empty");
    console.log(lowest.toFixed(4), highest.toFixed(4));
  });
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
