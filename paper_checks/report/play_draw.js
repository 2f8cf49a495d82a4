// Curves as SVG: axes with ticks, lines that a reader without colours can tell apart, dots.

const SVG = "http://www.w3.org/2000/svg", WIDTH = 560, HEIGHT = 300, EDGE = { left: 58, right: 12, top: 12, bottom: 40 };

function node(parent, name, attributes, text) {
  const made = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
}

// lines: [{points: [[x, y], ...], kind}], dots the same; axes: {title, x, y, logX, logY}
function draw(id, lines, dots, axes) {
  const figure = element(id), svg = document.createElementNS(SVG, "svg");
  svg.setAttribute("viewBox", `0 0 ${WIDTH} ${HEIGHT}`);
  svg.setAttribute("role", "img");
  node(svg, "title", {}, axes.title);
  const good = ([x, y]) => Number.isFinite(x) && Number.isFinite(y) && (!axes.logX || x > 0) && (!axes.logY || y > 0);
  const all = [...lines, ...dots].flatMap(line => line.points.filter(good));
  const xs = scale(all.map(p => p[0]), axes.logX, EDGE.left, WIDTH - EDGE.right, axes.tight);
  const ys = scale(all.map(p => p[1]), axes.logY, HEIGHT - EDGE.bottom, EDGE.top, false);
  if (all.length) frame(svg, xs, ys, axes);
  else node(svg, "text", { x: WIDTH / 2, y: HEIGHT / 2, "text-anchor": "middle" }, axes.empty);
  for (const { points, kind } of lines) {
    let path = "", pen = "M";
    for (const point of points) {
      if (!good(point)) { pen = "M"; continue; }
      path += `${pen}${xs.to(point[0]).toFixed(1)} ${ys.to(point[1]).toFixed(1)}`;
      pen = "L";
    }
    if (path) node(svg, "path", { d: path, class: kind });
  }
  for (const { points, kind } of dots) {
    for (const [x, y] of points.filter(good)) node(svg, "circle", { cx: xs.to(x), cy: ys.to(y), r: 3, class: kind });
  }
  figure.querySelector("svg")?.remove();
  figure.prepend(svg);
}

function scale(values, logarithmic, from, to, tight) {
  const by = logarithmic ? Math.log10 : value => value, shown = values.map(by);
  let low = shown.reduce((a, b) => Math.min(a, b), Infinity), high = shown.reduce((a, b) => Math.max(a, b), -Infinity);
  const middle = (low + high) / 2, least = 1e-6 * Math.abs(middle); // less than that is rounding
  if (!(high - low > least)) { [low, high] = [middle - Math.abs(middle || 1) / 2, middle + Math.abs(middle || 1) / 2]; }
  const margin = tight ? 0 : 0.04 * (high - low);
  low -= margin; high += margin;
  const toPixel = value => from + (by(value) - low) / (high - low) * (to - from);
  return { to: toPixel, ticks: logarithmic ? powers(low, high) : round(low, high) };
}

function round(low, high) { // four to eight round numbers
  const raw = (high - low) / 5, power = Math.pow(10, Math.floor(Math.log10(raw)));
  const size = [1, 2, 5, 10].map(k => k * power).find(s => (high - low) / s <= 7), found = [];
  for (let k = Math.ceil(low / size); k * size <= high; k++) found.push(Number((k * size).toPrecision(10)));
  return found;
}

function powers(low, high) { // 1, 2, 5 of each decade, or powers of ten alone
  const found = [];
  for (let k = Math.floor(low); k <= high; k++) for (const d of [1, 2, 5]) found.push(Number((d * Math.pow(10, k)).toPrecision(3)));
  const inside = found.filter(v => Math.log10(v) >= low && Math.log10(v) <= high);
  const tens = inside.filter(v => /^(1|0\.0*1|10*)$/.test(String(v)) || Math.abs(Math.log10(v) % 1) < 1e-9);
  const kept = inside.length <= 9 ? inside : tens;
  if (kept.length < 3) return round(Math.pow(10, low), Math.pow(10, high)).filter(v => v > 0);
  return kept.length <= 7 ? kept : kept.filter((_, i) => i % Math.ceil(kept.length / 6) === 0);
}

const label = value => value !== 0 && (Math.abs(value) < 1e-3 || Math.abs(value) >= 1e5)
  ? value.toExponential().replace("e+", "e") : minus(String(value));

function frame(svg, xs, ys, axes) {
  const bottom = HEIGHT - EDGE.bottom, left = EDGE.left;
  for (const value of xs.ticks) {
    node(svg, "line", { x1: xs.to(value), x2: xs.to(value), y1: EDGE.top, y2: bottom, class: "grid" });
    node(svg, "text", { x: xs.to(value), y: bottom + 16, "text-anchor": "middle" }, label(value));
  }
  for (const value of ys.ticks) {
    node(svg, "line", { x1: left, x2: WIDTH - EDGE.right, y1: ys.to(value), y2: ys.to(value), class: "grid" });
    node(svg, "text", { x: left - 6, y: ys.to(value) + 4, "text-anchor": "end" }, label(value));
  }
  node(svg, "text", { x: (left + WIDTH - EDGE.right) / 2, y: HEIGHT - 6, "text-anchor": "middle", class: "name" }, axes.x);
  const middle = (EDGE.top + bottom) / 2;
  node(svg, "text", { x: 14, y: middle, "text-anchor": "middle", transform: `rotate(-90 14 ${middle})`, class: "name" }, axes.y);
}

function drawMotion({ whole, times, curves }) {
  const line = (values, kind) => ({ points: times.map((t, i) => [t, values[i]]), kind });
  const fine = 4, waves = [];
  for (let i = 0; i < times.length - 1; i++) for (let k = 0; k < fine; k++) {
    const s = k / fine, t = times[i] + s * (times[i + 1] - times[i]);
    waves.push([t, ((1 - s) * curves.lancaster[i] + s * curves.lancaster[i + 1]) * Math.cos(t)]);
  }
  draw("plot-motion", [{ points: waves, kind: "lancaster" }, { points: whole.path.map(([t, x]) => [t, x]), kind: "truth" },
    line(curves.lelas, "lelas"), line(curves.lelas.map(a => -a), "lelas")], [],
    { title: "Displacement against time", x: "time t", y: "x", tight: true });
}

function drawEnvelope({ whole, times, curves }) {
  const line = (values, kind) => ({ points: times.map((t, i) => [t, values[i]]), kind });
  const lines = [line(curves.lancaster, "lancaster"), line(curves.lelas, "lelas")];
  if (curves.third) lines.push(line(curves.third, "third"));
  draw("plot-envelope", lines, [{ points: whole.points.map(p => [p.t, Math.abs(p.x)]), kind: "truth" }],
    { title: "Amplitude against time", x: "time t", y: "amplitude", tight: true });
}

function drawSeen({ seen, one, whole, given, x0 }, name, y, x, logY) {
  const line = way => ({ points: seen.map(s => [s.A, s[way][name]]), kind: way });
  const lines = ["truth", "lancaster", "lelas"].map(line), p = whole.points.map(q => Math.abs(q.x)).filter(a => !rests(given, a, x0));
  if (one) lines.push(line("third"));
  const own = p.slice(2).map((a, i) => [p[i], name === "Q" ? 2 * Math.PI / (1 - (a / p[i]) ** 2) : Math.log(p[i] / a)]);
  draw("plot-" + name, lines, [{ points: own.filter(([A]) => A >= seen[0].A), kind: "truth" }],
    { title: `${name} against amplitude`, x, y, logX: true, logY, empty: "No full swing: it creeps or stops before." });
}
