"use strict";

// Search: ids first, then places, then words.
function rank(entry, words) {
  const [id, locus, , , text] = entry.folded;
  let best = 0;
  for (const word of words) {
    const found = id.includes(word) ? 3 : locus.includes(word) ? 2 : text.includes(word) ? 1 : 0;
    if (found === 0) return 0;
    best += found;
  }
  return best;
}

function setUpSearch() {
  const form = document.querySelector("form.search");
  const index = window.burmesterIndex;
  if (!form || !index) return;
  form.hidden = false;
  const entries = index.map((entry) => ({ entry, folded: entry.map((text) => text.toLowerCase()) }));
  const query = document.getElementById("query");
  const found = document.getElementById("found");
  const results = document.getElementById("results");
  const root = document.body.dataset.root;
  const most = 40;

  function search() {
    const words = query.value.toLowerCase().split(/\s+/).filter(Boolean);
    results.replaceChildren();
    if (words.length === 0) {
      found.textContent = "";
      return;
    }
    const hits = entries
      .map((one, place) => ({ one, place, rank: rank(one, words) }))
      .filter((hit) => hit.rank > 0)
      .sort((a, b) => b.rank - a.rank || a.place - b.place);
    found.textContent =
      hits.length === 0 ? "Nothing found" : hits.length > most ? `${hits.length} found, the first ${most}:` : `${hits.length} found:`;
    for (const { one } of hits.slice(0, most)) {
      const [id, locus, address, verdict, text] = one.entry;
      const item = document.createElement("li");
      const link = document.createElement("a");
      link.href = root + address;
      link.textContent = locus;
      const small = document.createElement("small");
      small.textContent = `${verdict} · ${id} · ${text.slice(0, 110)}`;
      item.append(link, small);
      results.append(item);
    }
  }

  query.addEventListener("input", search);
  form.addEventListener("submit", (event) => {
    event.preventDefault();
    const first = results.querySelector("a");
    if (first) first.click();
  });
  results.addEventListener("click", () => {
    query.value = "";
    search();
  });
  document.addEventListener("keydown", (event) => {
    const typing = /^(INPUT|TEXTAREA|SELECT)$/.test(document.activeElement.tagName);
    if (event.key === "/" && !typing) {
      event.preventDefault();
      query.focus();
    }
    if (event.key === "Escape" && document.activeElement === query) {
      query.value = "";
      search();
    }
  });
}

// Filter: only statements with the chosen verdicts.
function setUpFilter() {
  const form = document.querySelector("form.filter");
  if (!form) return;
  form.hidden = false;
  const boxes = [...form.querySelectorAll("input")];
  const shown = form.querySelector(".shown");
  const statements = [...document.querySelectorAll(".statement[data-verdict]")];

  function apply() {
    const chosen = new Set(boxes.filter((box) => box.checked).map((box) => box.value));
    let count = 0;
    for (const statement of statements) {
      const visible = chosen.has(statement.dataset.verdict);
      if (visible) count += 1;
      // A cell keeps its place in its table.
      if (statement.tagName !== "TD") statement.hidden = !visible;
      else statement.style.opacity = visible ? "" : "0.25";
    }
    for (const table of document.querySelectorAll("table.numbers, table.grid")) {
      const left = [...table.querySelectorAll(".statement")].some((one) => chosen.has(one.dataset.verdict));
      const block = table.closest(".scroll");
      block.hidden = !left;
      if (block.previousElementSibling?.tagName === "H3") block.previousElementSibling.hidden = !left;
    }
    const all = count === statements.length;
    for (const figure of document.querySelectorAll("main figure")) figure.hidden = !all;
    shown.textContent = all ? "" : `${count} of ${statements.length} statements`;
  }

  function choose(verdicts) {
    for (const box of boxes) box.checked = verdicts === null || verdicts.includes(box.value);
    apply();
  }

  form.addEventListener("change", apply);
  form.addEventListener("click", (event) => {
    const show = event.target.dataset.show;
    if (show === "all") choose(null);
    if (show === "errata") choose(["fails", "contradicted"]);
  });
  const wanted = new URLSearchParams(location.search).get("show");
  if (wanted) choose(wanted.split(","));
  // A link to a hidden statement shows it.
  function reveal() {
    const target = document.getElementById(decodeURIComponent(location.hash.slice(1)));
    if (target && target.closest("[hidden]")) choose(null);
    target?.scrollIntoView();
  }
  window.addEventListener("hashchange", reveal);
  if (wanted && location.hash) reveal();
}

// Pictures that move, and stop.
function setUpMotion() {
  for (const button of document.querySelectorAll("button.motion")) {
    const svg = document.getElementById(button.dataset.moves)?.querySelector("svg");
    if (!svg) continue;
    button.hidden = false;
    let begun = false;
    button.addEventListener("click", () => {
      const moving = button.getAttribute("aria-pressed") === "true";
      if (moving) {
        svg.pauseAnimations();
      } else if (begun) {
        svg.unpauseAnimations();
      } else {
        begun = true;
        for (const animation of svg.querySelectorAll("animate, animateTransform")) animation.beginElement();
      }
      button.setAttribute("aria-pressed", String(!moving));
      button.textContent = moving ? "Move" : "Stop";
    });
  }
}

// A formula that is wider than its place can be reached and moved by the keyboard.
function setUpScrolling() {
  const formulas = [...document.querySelectorAll(".formula")];
  function apply() {
    const wide = formulas.map((formula) => formula.scrollWidth > formula.clientWidth);
    formulas.forEach((formula, place) => {
      if (wide[place]) formula.tabIndex = 0;
      else formula.removeAttribute("tabindex");
    });
  }
  apply();
  window.addEventListener("resize", apply);
}

setUpScrolling();
setUpSearch();
setUpFilter();
setUpMotion();
