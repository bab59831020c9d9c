// Five positions by Newton's method from random starts, and poles: what one writes in an afternoon.
// Every problem gets the same starts in every run.
//
// Nothing to install; tried with Node 20.20.2.

const readline = require("readline");

function number(value) {
  const [numerator, denominator] = String(value).split("/");
  return Number(numerator) / Number(denominator ?? 1);
}

function rotation(angle) {
  if ("cos" in angle) return [number(angle.cos), number(angle.sin)];
  if ("tan_half" in angle) {
    const t = number(angle.tan_half);
    return [(1 - t * t) / (1 + t * t), (2 * t) / (1 + t * t)];
  }
  const phi = "degrees" in angle ? (number(angle.degrees) * Math.PI) / 180 : number(angle.radians);
  return [Math.cos(phi), Math.sin(phi)];
}

const positions = (problem) =>
  problem.positions.map(({ x, y, angle }) => [...rotation(angle), number(x), number(y)]);

const apply = ([c, s, a, b], x, y) => [c * x - s * y + a, s * x + c * y + b];

// Gauss with pivots; null where it does not work.
function linear(rows) {
  const n = rows.length;
  for (let k = 0; k < n; k++) {
    let best = k;
    for (let i = k; i < n; i++) if (Math.abs(rows[i][k]) > Math.abs(rows[best][k])) best = i;
    [rows[k], rows[best]] = [rows[best], rows[k]];
    if (!(Math.abs(rows[k][k]) > 1e-300)) return null;
    for (let i = 0; i < n; i++) {
      if (i === k) continue;
      const f = rows[i][k] / rows[k][k];
      for (let j = k; j <= n; j++) rows[i][j] -= f * rows[k][j];
    }
  }
  return rows.map((row, k) => row[n] / row[k]);
}

// |A_j - M|^2 - |A_1 - M|^2 and its derivatives by x, y, X, Y.
function newton(all, v) {
  for (let step = 0; step < 60; step++) {
    const [x, y, X, Y] = v;
    const row = (p) => {
      const [u, w] = apply(p, x, y);
      const [c, s] = p;
      const [d, e] = [u - X, w - Y];
      return [2 * (d * c + e * s), 2 * (e * c - d * s), -2 * d, -2 * e, d * d + e * e];
    };
    const first = row(all[0]);
    const rows = all.slice(1).map((p) => row(p).map((value, k) => value - first[k]));
    const change = linear(rows);
    if (!change) return null;
    v = v.map((value, k) => value - change[k]);
    const size = Math.max(...v.map(Math.abs));
    if (!(size < 1e9)) return null;
    if (Math.max(...change.map(Math.abs)) < 1e-13 * size) return v;
  }
  return null;
}

let seed = 0;

function random() {
  seed = (seed * 1664525 + 1013904223) % 2 ** 32;
  return seed / 2 ** 32;
}

function pairs(problem) {
  seed = 1964;
  const all = positions(problem);
  const scale = Math.max(1, ...all.map(([, , a, b]) => Math.hypot(a, b)));
  const found = [];
  for (let start = 0; start < 400; start++) {
    const v = newton(all, [0, 0, 0, 0].map(() => (random() - 0.5) * 6 * scale));
    const same = (other) => v.every((value, k) => Math.abs(value - other[k]) < 1e-6 * scale);
    if (v && !found.some(same)) found.push(v);
  }
  return { pairs: found.map(([x, y, X, Y]) => ({ circlepoint: [x, y], center: [X, Y] })) };
}

function poles(problem) {
  const all = positions(problem);
  const answer = {};
  all.forEach((p, i) =>
    all.slice(i + 1).forEach((q, k) => {
      // (r1 - r2) z = t2 - t1, taken to the fixed plane.
      const [c, s, a, b] = p.map((value, m) => value - q[m]);
      const n = c * c + s * s;
      const z = [-(c * a + s * b) / n, (s * a - c * b) / n];
      if (n > 1e-24) answer[`${i + 1}${i + k + 2}`] = apply(p, ...z);
    })
  );
  return { poles: answer };
}

const tasks = { "five-positions": pairs, poles };

readline.createInterface({ input: process.stdin }).on("line", (line) => {
  const problem = JSON.parse(line);
  const task = tasks[problem.problem];
  let answer = { skipped: "not done here" };
  if (problem.positions?.some((position) => "points" in position)) answer = { skipped: "positions by angles only" };
  else if (task) answer = { result: task(problem) };
  console.log(JSON.stringify(answer));
});
