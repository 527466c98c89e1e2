// Pages in a real browser, as a person would use them.
//
//   node browser_test.mjs MBCC CHROMIUM NODE_MODULES EXAMPLES [SCREENSHOTS]
//
// Makes pages of examples with `mbcc run --plot` and opens them in Chromium without a screen. SCREENSHOTS is a
// directory for pictures of each page, light and dark, to look at.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, statSync, writeFileSync } from "node:fs";
import { createRequire } from "node:module";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const [mbcc, chromium, nodeModules, examples, screenshots] = process.argv.slice(2);
const playwright = createRequire(join(nodeModules, "x"))("playwright-core");

const largestPage = 3e6; // bytes
const rodColour = [0x8a, 0x94, 0x9d]; // in the light scheme of style.css
// Positions are drawn in single precision; half of its last digit, for numbers of the size of the scenes (below 16).
const singlePrecision = 16 * 2 ** -24;

/** The columns of a result, by name. Names with commas in them do not occur in these examples. */
function readCsv(path) {
  const [header, ...rows] = readFileSync(path, "utf8").trim().split("\n").map((line) => line.split(","));
  return Object.fromEntries(header.map((name, index) => [name, rows.map((row) => Number(row[index]))]));
}

/** Makes the page of an example, and a recording of the same run. */
function makePage(directory, example) {
  const page = join(directory, `${example}.html`);
  const csv = join(directory, `${example}.csv`);
  const model = join(examples, example, `${example}.mbd`);
  const stdio = ["ignore", "inherit", "inherit"];
  execFileSync(mbcc, ["run", model, "--quiet", "--csv", csv, "--plot", page], { stdio });
  assert.ok(statSync(page).size < largestPage, `${page} has ${statSync(page).size} bytes`);
  return { url: pathToFileURL(page).href, columns: readCsv(csv) };
}

/** Opens a page; whatever it complains of or asks the network for fails the test. */
async function open(browser, url, colorScheme = "light") {
  const page = await browser.newPage({ viewport: { width: 1366, height: 768 }, colorScheme });
  page.complaints = [];
  page.on("pageerror", (error) => page.complaints.push(error.stack));
  page.on("console", (message) => {
    // Chromium's own remark on reading pixels back for a screenshot.
    if (!message.text().includes("GPU stall due to ReadPixels")) page.complaints.push(message.text());
  });
  page.on("request", (request) => {
    if (request.url() !== url && !request.url().startsWith("data:")) page.complaints.push(`asks for ${request.url()}`);
  });
  await page.goto(url);
  await page.waitForFunction(() => globalThis.mbcc !== undefined);
  return page;
}

/** Rows from the whole result, those that the page was thinned by among them. */
function someRows(times) {
  return [0, 1, 2, 777, 778, 779, times.length - 2, times.length - 1];
}

async function positionsAgree(page, columns, points) {
  for (const row of someRows(columns.t)) {
    const time = columns.t[row];
    const drawn = await page.evaluate(async (t) => {
      globalThis.mbcc.seek(t);
      await new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
      return globalThis.mbcc.positions();
    }, time);
    assert.equal(drawn.length, points.length);
    points.forEach((point, index) => {
      ["x", "y", "z"].forEach((axis, i) => {
        const expected = columns[`${point}.${axis}`]?.[row] ?? 0;
        const found = drawn[index][i];
        const agrees = Math.abs(found - expected) <= singlePrecision;
        assert.ok(agrees, `${point}.${axis} at ${time} is drawn at ${found}, not ${expected}`);
      });
    });
  }
}

async function plays(page) {
  const time = () => page.evaluate(() => globalThis.mbcc.time());
  const linePlace = async () => (await page.locator(".time-line").first().boundingBox()).x;
  await page.keyboard.press("Home");
  const [timeBefore, lineBefore] = [await time(), await linePlace()];
  const sceneBefore = await page.locator("#stage").screenshot();
  await page.keyboard.press("Space");
  await page.waitForFunction((start) => globalThis.mbcc.time() > start + 0.2, timeBefore);
  await page.keyboard.press("Space");
  const stopped = await time();
  assert.ok((await linePlace()) > lineBefore, "the line of time did not move");
  assert.ok(!sceneBefore.equals(await page.locator("#stage").screenshot()), "the scene did not move");
  assert.equal(await time(), stopped, "it plays on though it is paused");
  await page.keyboard.press("ArrowRight");
  assert.ok((await time()) > stopped, "the arrow key does not step on");
  await page.keyboard.press("End");
  assert.equal(await page.locator("#time").inputValue(), "1");
}

async function zooms(page) {
  const shown = () => page.evaluate(() => globalThis.mbcc.shown());
  const whole = await shown();
  const box = await page.locator(".u-over").first().boundingBox();
  const at = (part) => box.x + part * box.width;
  const middle = box.y + box.height / 2;
  await page.mouse.move(at(0.25), middle);
  await page.mouse.down();
  await page.mouse.move(at(0.5), middle, { steps: 4 });
  await page.mouse.up();
  const [from, to] = await shown();
  const pixel = (whole[1] - whole[0]) / box.width;
  assert.ok(Math.abs(from - (0.75 * whole[0] + 0.25 * whole[1])) < 2 * pixel, `zoomed to ${from}`);
  assert.ok(Math.abs(to - (whole[0] + whole[1]) / 2) < 2 * pixel, `zoomed to ${to}`);
  await page.mouse.dblclick(at(0.5), middle);
  assert.deepEqual(await shown(), whole);
  await page.mouse.wheel(0, -300);
  assert.ok((await shown())[1] < whole[1], "the wheel does not zoom");
  await page.keyboard.press("z");
  assert.deepEqual(await shown(), whole);
  await page.mouse.click(at(0.5), middle);
  const time = () => page.evaluate(() => globalThis.mbcc.time());
  assert.ok(Math.abs((await time()) - (whole[0] + whole[1]) / 2) < 2 * pixel, `a click goes to ${await time()}`);
  const axis = await page.locator(".time-axis").first().boundingBox();
  await page.mouse.move(at(0.5), axis.y + 10);
  await page.mouse.down();
  await page.mouse.move(at(0.25), axis.y + 10);
  await page.mouse.up();
  const quarter = 0.75 * whole[0] + 0.25 * whole[1];
  assert.ok(Math.abs((await time()) - quarter) < 2 * pixel, `dragging along the axis goes to ${await time()}`);
}

/** The colour of one pixel of what is on the screen: [red, green, blue]. */
async function pixelAt(page, x, y) {
  const picture = await page.screenshot({ clip: { x: Math.round(x) - 1, y: Math.round(y) - 1, width: 3, height: 3 } });
  return page.evaluate(async (base64) => {
    const bytes = Uint8Array.from(atob(base64), (character) => character.charCodeAt(0));
    const context = new OffscreenCanvas(3, 3).getContext("2d");
    context.drawImage(await createImageBitmap(new Blob([bytes])), 0, 0);
    return [...context.getImageData(1, 1, 1, 1).data.slice(0, 3)];
  }, picture.toString("base64"));
}

/** In a flat scene balls have their plain colour: it is on the screen where the data says, and can be picked there. */
async function isOnScreen(page, colours) {
  await page.mouse.move(0, 0);
  const places = await page.evaluate(() => globalThis.mbcc.onScreen());
  const isColoured = async ([x, y], colour, what) => {
    const pixel = await pixelAt(page, x, y);
    const off = Math.max(...pixel.map((value, i) => Math.abs(value - colour[i])));
    assert.ok(off <= 2, `${what} at (${x}, ${y}) is ${pixel}, not ${colour}`); // two roundings to bytes
  };
  for (const [index, place] of places.entries()) await isColoured(place, colours[index], `point ${index}`);
  const rods = await page.evaluate(() => globalThis.mbcc.result.scene.rods.filter((rod) => !rod.anchor));
  assert.ok(rods.length > 0);
  for (const { point, other } of rods) {
    for (const part of [0.2, 0.8]) {
      const place = [0, 1].map((i) => (1 - part) * places[point][i] + part * places[other][i]);
      await isColoured(place, rodColour, `the rod from ${point} to ${other}`);
    }
  }
  const [x, y] = places.at(-1);
  await page.mouse.click(x, y);
  const chosen = await page.locator("nav button[aria-pressed=true]").textContent();
  const names = await page.evaluate(() => globalThis.mbcc.result.scene.points.map(({ name }) => name));
  assert.equal(chosen, names.at(-1));
}

/** All buttons show plots; a curve, smooth as it is drawn, has hundreds of colours. */
async function showsEveryFigure(page, fewestColours = 10) {
  for (const button of await page.locator("nav button").all()) {
    await button.click();
    const panels = await page.locator(".panel canvas").count();
    assert.ok(panels >= 1 && panels <= 3, `${await button.textContent()} has ${panels} panels`);
    const drawn = await page.locator(".panel canvas").first().evaluate((canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
    assert.ok(drawn > fewestColours, `${await button.textContent()} is drawn in ${drawn} colours`);
  }
}

async function changesScheme(page) {
  const background = () => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const light = await background();
  await page.keyboard.press("d");
  assert.notEqual(await background(), light);
}

/** Without WebGL the page says so in place of the scene, and all else works. */
async function doesWithoutScene(url) {
  const args = ["--no-sandbox", "--disable-3d-apis"];
  const browser = await playwright.chromium.launch({ executablePath: chromium, args });
  try {
    const page = await browser.newPage();
    await page.goto(url);
    const problem = await page.locator("#stage").getAttribute("data-problem");
    assert.match(problem, /^This browser cannot draw the scene: /);
    await showsEveryFigure(page);
    await page.keyboard.press("Space");
    await page.waitForFunction(() => globalThis.mbcc.time() > 0.1);
  } finally {
    await browser.close();
  }
}

async function takePictures(browser, url, name) {
  for (const scheme of ["light", "dark"]) {
    const page = await open(browser, url, scheme);
    await page.evaluate(() => globalThis.mbcc.seek(0.37 * globalThis.mbcc.result.times.at(-1)));
    await page.waitForTimeout(300);
    await page.screenshot({ path: join(screenshots, `${name}-${scheme}.png`) });
    await page.close();
  }
}

const scenes = {
  spherical_pendulum: { points: ["bob"] },
  chain: { points: Array.from({ length: 10 }, (_, index) => `p[${index + 1}]`) },
  four_bar: { points: ["crank", "rocker"], colours: [[0x00, 0x72, 0xb2], [0xd5, 0x5e, 0x00]] },
};

/** Results that have little to show: no page of them may complain. */
const oddResults = {
  one_row: "t,x1,y1,rod.position_error\n0.5,1,2,0\n",
  no_numbers: "t,x1,y1,x2,y2,ratio\n0,0,0,1,1,nan\n1,nan,1,nan,nan,inf\n2,1,1,2,2,-1e300\n",
  no_points: "t,spin\n1e6,1\n1000001,2\n",
};

async function survivesOddResults(browser, directory) {
  for (const [name, text] of Object.entries(oddResults)) {
    const [csv, path] = [join(directory, `${name}.csv`), join(directory, `${name}.html`)];
    writeFileSync(csv, text);
    execFileSync(mbcc, ["plot", csv, "-o", path]);
    const page = await open(browser, pathToFileURL(path).href);
    await page.keyboard.press("Space");
    await page.keyboard.press("t");
    await page.waitForTimeout(100);
    await showsEveryFigure(page, 1);
    assert.deepEqual(page.complaints, [], name);
    if (screenshots) await page.screenshot({ path: join(screenshots, `${name}.png`) });
    await page.close();
    console.log(`${name}: fine`);
  }
}

const directory = mkdtempSync(join(tmpdir(), "mbcc-page-"));
// --no-sandbox: Chromium refuses root otherwise. The other flag draws WebGL without a graphics card.
const browser = await playwright.chromium.launch({
  executablePath: chromium,
  args: ["--no-sandbox", "--enable-unsafe-swiftshader"],
});
try {
  for (const [name, { points, colours }] of Object.entries(scenes)) {
    const { url, columns } = makePage(directory, name);
    const page = await open(browser, url);
    await positionsAgree(page, columns, points);
    await plays(page);
    await zooms(page);
    if (colours) await isOnScreen(page, colours);
    await showsEveryFigure(page);
    await changesScheme(page);
    assert.deepEqual(page.complaints, []);
    await page.close();
    if (name === "four_bar") await doesWithoutScene(url);
    if (screenshots) await takePictures(browser, url, name);
    console.log(`${name}: fine`);
  }
  await survivesOddResults(browser, directory);
} finally {
  await browser.close();
  rmSync(directory, { recursive: true });
}
