// A page of mbgen in chromium, and what its tests ask of all pages.

import assert from "node:assert/strict";
import { createRequire } from "node:module";
import path from "node:path";
import { pathToFileURL } from "node:url";

const kFlags = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
  "--ignore-gpu-blocklist", "--disable-dev-shm-usage", "--force-color-profile=srgb",
  // Smooth edges take half of the time of a processor that draws: for pictures of documents alone.
  ...(process.env.MBGEN_SMOOTH_PICTURES ? [] : ["--webgl-antialiasing-mode=none"])];

/** Debian's chromium, driven by the playwright-core of a directory. */
export function launch(modules) {
  const { chromium } = createRequire(path.resolve(modules ?? ".", "package.json"))("playwright-core");
  return chromium.launch({ executablePath: "/usr/bin/chromium", args: kFlags });
}

/** A page of its own, with all that the console says and every request. */
export async function openPage(browser, file, options) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  const complaints = [];
  const requests = [];
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && complaints.push(message.text()));
  page.on("pageerror", (problem) => complaints.push(String(problem)));
  page.on("request", (request) => requests.push(request.url()));
  const url = pathToFileURL(path.resolve(file)).href;
  await page.goto(url);
  await page.waitForFunction(() => window.mbgenReport);
  return { page, complaints, requests, url, close: () => context.close() };
}

export const seek = (page, at) => page.evaluate((t) => window.mbgenReport.player.seek(t), at);

/** Waits until the picture of the time shown is drawn. */
export async function settle(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
}

/** The picture of the animation alone. */
export async function picture(page) {
  await settle(page);
  return page.locator("#view").screenshot();
}

export async function checkNothingIsLoaded({ requests, complaints, url }) {
  assert.deepEqual(complaints.filter((text) => !text.includes("GPU stall due to ReadPixels")), []);
  assert.deepEqual(requests, [url], "the page asked for something");
}
