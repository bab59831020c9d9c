// Every page of the site in a validator, in headless Chromium, and in an accessibility checker.
import { readdirSync, readFileSync, statSync } from "node:fs";
import { join, relative } from "node:path";
import { pathToFileURL } from "node:url";
import { createRequire } from "node:module";
import { HtmlValidate } from "html-validate";
import { chromium } from "playwright-core";

const [browserPath, site] = process.argv.slice(2);
const faults = [];
const fault = (page, what) => faults.push(`${page}: ${what}`);

function pagesBelow(folder) {
  return readdirSync(folder).flatMap((name) => {
    const path = join(folder, name);
    if (statSync(path).isDirectory()) return pagesBelow(path);
    return name.endsWith(".html") ? [path] : [];
  });
}
const pages = pagesBelow(site).sort();
const named = (page) => relative(site, page);

const idsOf = new Map();
function checkLink(name, link) {
  const url = new URL(link);
  if (url.protocol !== "file:") return;
  const path = decodeURIComponent(url.pathname);
  if (!idsOf.has(path)) {
    let text = null;
    try {
      text = readFileSync(path, "utf8");
    } catch {
      text = null;
    }
    idsOf.set(path, text && new Set([...text.matchAll(/\bid="([^"]+)"/g)].map((match) => match[1])));
  }
  const ids = idsOf.get(path);
  if (!ids) fault(name, `leads to ${link}, which is not there`);
  else if (url.hash && !ids.has(decodeURIComponent(url.hash.slice(1)))) fault(name, `leads to ${link}, and there is no such place`);
}

// The validator. Style that is no matter of validity is left to us.
const validator = new HtmlValidate({
  extends: ["html-validate:standard"],
  rules: {
    "valid-id": ["error", { relaxed: true }],
    "long-title": "off",
    "no-trailing-whitespace": "off",
    "void-style": "off",
    "no-inline-style": "off",
    // SVG and MathML have attributes of their own.
    "attr-case": "off",
    "element-case": "off",
    "prefer-native-element": ["error", { exclude: ["img", "search"] }],
  },
});
for (const page of pages) {
  const report = await validator.validateString(readFileSync(page, "utf8"), page);
  for (const { messages } of report.results) {
    for (const message of messages.slice(0, 5)) {
      fault(named(page), `line ${message.line}: ${message.message} (${message.ruleId})`);
    }
  }
}
console.log(`${pages.length} pages validated`);

const browser = await chromium.launch({
  executablePath: browserPath,
  args: ["--no-sandbox", "--disable-gpu", "--disable-background-networking", "--disable-component-update", "--disable-sync", "--no-first-run"],
});
const axe = createRequire(import.meta.url).resolve("axe-core/axe.min.js");
const schemes = { light: pages, dark: pages.filter((page) => !named(page).includes("/")) };
for (const [colorScheme, list] of Object.entries(schemes)) {
  const context = await browser.newContext({ colorScheme, bypassCSP: true });
  for (const path of list) {
    const page = await context.newPage();
    const name = named(path);
    page.on("console", (message) => {
      if (message.type() === "error") fault(name, `console: ${message.text()}`);
    });
    page.on("pageerror", (error) => fault(name, `script: ${error.message}`));
    page.on("request", (request) => {
      const url = request.url();
      if (!url.startsWith("file:") && !url.startsWith("data:")) fault(name, `fetches ${url}`);
    });
    page.on("requestfailed", (request) => fault(name, `does not find ${request.url()}`));
    await page.goto(pathToFileURL(path).href);
    const own = await page.evaluate(() => {
      const pictures = [...document.querySelectorAll("svg, img")].filter((picture) => {
        const box = picture.getBoundingClientRect();
        const words = (picture.getAttribute("aria-labelledby") ?? "").split(" ").map((id) => document.getElementById(id)?.textContent ?? "");
        const told = picture.getAttribute("alt") || words.join("").trim();
        return !told || (picture.checkVisibility() && (box.width < 50 || box.height < 50));
      });
      const ids = [...document.querySelectorAll("[id]")].map((element) => element.id);
      const twice = ids.filter((id, place) => ids.indexOf(id) !== place);
      const links = [...document.querySelectorAll("a[href]")].map((link) => link.href);
      return { pictures: pictures.length, twice, links, wide: document.documentElement.scrollWidth > innerWidth + 1 };
    });
    if (own.pictures > 0) fault(name, `${own.pictures} pictures without size or text alternative`);
    if (own.twice.length > 0) fault(name, `ids that stand twice: ${own.twice.slice(0, 5)}`);
    if (own.wide) fault(name, "is wider than its window");
    for (const link of new Set(own.links)) checkLink(name, link);
    await page.addScriptTag({ path: axe });
    const violations = await page.evaluate(async () => {
      // What is within formulas and pictures is no text of the page.
      const context = { exclude: [["math"], ["svg > *"]] };
      const { violations } = await window.axe.run(context, { resultTypes: ["violations"], preload: false });
      return violations.map(({ id, help, nodes }) => `${id}: ${help}; ${nodes.length} times, as in ${nodes[0].html.slice(0, 160)}`);
    });
    for (const violation of violations) fault(name, `${colorScheme}: ${violation}`);
    await page.close();
  }
  await context.close();
  console.log(`${list.length} pages seen in ${colorScheme} colours`);
}

// What a reader does.
const context = await browser.newContext();
const page = await context.newPage();
const open = (name) => page.goto(pathToFileURL(join(site, name)).href);
await open("index.html");
await page.keyboard.press("/");
await page.keyboard.type("3.25");
const first = await page.locator("#results a").first().textContent();
if (!first?.includes("(3.25)")) fault("search", `3.25 finds first: ${first}`);
await page.keyboard.press("Enter");
await page.waitForURL(/tesar1964\.html#/);
for (const [query, expected] of [["eq/1.8", "wunderlich1968"], ["0.4613", "tesar1964"], ["cognate", "."]]) {
  await open("index.html");
  await page.fill("#query", query);
  const found = await page.locator("#results a").count();
  const href = found > 0 ? await page.locator("#results a").first().getAttribute("href") : "";
  if (found === 0 || !href.includes(expected)) fault("search", `${query} finds ${found}, the first at ${href}`);
}
await open("index.html");
await page.fill("#query", "no such words");
if ((await page.locator("#found").textContent()) !== "Nothing found") fault("search", "what is not there is found");

await open("tesar1964.html");
const visible = () => page.locator(".statement[data-verdict]:visible").count();
const all = await visible();
await page.click('button[data-show="errata"]');
const errata = await visible();
const wrong = await page.locator('.statement[data-verdict="fails"], .statement[data-verdict="contradicted"]').count();
if (errata !== wrong || errata >= all) fault("filter", `${errata} shown of ${wrong} errata and ${all} statements`);
await page.click('button[data-show="all"]');
if ((await visible()) !== all) fault("filter", "does not show all again");
await page.goto(`${pathToFileURL(join(site, "tesar1964.html")).href}?show=contradicted`);
if ((await page.locator('.statement[data-verdict="holds"]:visible').count()) > 0) fault("filter", "the address does not choose");

await open("wunderlich1968.html");
for (const button of await page.locator("button.motion").all()) {
  await button.click();
  const name = await button.getAttribute("data-moves");
  const time = () => page.evaluate((id) => document.getElementById(id).querySelector("svg").getCurrentTime(), name);
  await page.waitForTimeout(200);
  await button.click();
  const stopped = await time();
  await page.waitForTimeout(200);
  if ((await time()) !== stopped) fault("motion", `${name} does not stop`);
}

// A phone.
const phone = await browser.newContext({ viewport: { width: 360, height: 740 } });
for (const path of pages.filter((path) => !named(path).startsWith("code/"))) {
  const page = await phone.newPage();
  await page.goto(pathToFileURL(path).href);
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  if (width > 361) fault(named(path), `is ${width} wide on a phone of 360`);
  await page.close();
}
await browser.close();

for (const one of faults.slice(0, 60)) console.error(one);
console.log(faults.length === 0 ? "no fault" : `${faults.length} faults`);
process.exit(faults.length === 0 ? 0 : 1);
