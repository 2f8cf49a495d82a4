// The page: sliders, four pictures, a table, and the commands that give the certified numbers.
// The state stands in the address: play.html#alpha=2&epsilon=0.1&x0=1&time=40&alpha2=0&epsilon2=0.01

const START = { alpha: "1.5", epsilon: "0.1", x0: "1", time: "40", alpha2: "", epsilon2: "0.01" };
const LIMITS = { alpha: [0, 5], epsilon: [0.001, 1], x0: [0.1, 10], time: [5, 200], alpha2: [0, 5], epsilon2: [0.001, 1] };
const LOGARITHMIC = { epsilon: true, x0: true, epsilon2: true };
const SECOND = "1"; // the exponent of the second law when it is switched on
const state = { ...START };
const element = id => document.getElementById(id);

// Decimals and fractions are kept as they are typed: the command lines carry them exactly.
const number = text => text.split("/").map(Number).reduce((top, bottom) => top / bottom);

// What is typed is judged as a whole, at Enter or on leaving the field: what cannot be drawn is said, in red, at the field.
function accept(name, typed) {
  const text = typed.trim().replace(",", ".").replace(/\.$/, ""), [low, high] = LIMITS[name];
  const read = /^(\d*\.?\d+|\d+\/[1-9]\d*)$/.test(text), good = read && number(text) >= low && number(text) <= high;
  if (good) state[name] = text;
  wrong[name] = good ? null : typed;
  return good;
}

const wrong = {}; // what has been typed and cannot be drawn, by its field

const laws = () => [["alpha", "epsilon"], ["alpha2", "epsilon2"]].filter(([a]) => state[a] !== "")
  .map(([a, e]) => ({ alpha: number(state[a]), epsilon: number(state[e]) }));

// Two laws of one exponent are one law.
function merged(given) {
  const same = given.length === 2 && given[0].alpha === given[1].alpha;
  return same ? [{ alpha: given[0].alpha, epsilon: given[0].epsilon + given[1].epsilon }] : given;
}

function commands() {
  const law = `--law ${state.alpha}:${state.epsilon}` + (state.alpha2 === "" ? "" : ` --law ${state.alpha2}:${state.epsilon2}`);
  const start = `${law} --mass 1 --stiffness 1 --x0 ${state.x0}`;
  return {
    motion: `asymptotics motion ${start} --time ${state.time} --reference --digits 20`,
    points: `asymptotics turning-points ${start} --count ${COUNT} --times --digits 20`,
    envelope: `asymptotics envelope ${start} --time ${state.time} --digits 20`,
    squaring: `asymptotics envelope ${start} --time ${state.time} --digits 20 --squaring`,
  };
}

const COUNT = 7, SAMPLES = 240, AMPLITUDES = 33;

function compute() {
  const given = merged(laws()), x0 = number(state.x0), time = number(state.time), one = given.length === 1 ? given[0] : null;
  const whole = motion(given, x0, time), times = Array.from({ length: SAMPLES + 1 }, (_, i) => time * i / SAMPLES);
  const at = points => ({
    lancaster: envelope(given, x0, points, moment),
    lelas: envelope(given, x0, points, squared),
    third: one ? thirdOrder(one, x0, points) : null,
  });
  const amplitudes = Array.from({ length: AMPLITUDES }, (_, i) => x0 * Math.pow(50, i / (AMPLITUDES - 1) - 1));
  return { given, one, x0, time, whole, times, curves: at(times), ends: at([time]),
    seen: amplitudes.map(A => observed(given, one, A)), at };
}

// Decrement and Q of the full swing from one amplitude: integrated, and as each envelope has them, a period later.
function observed(given, one, A) {
  const later = mean => { // an envelope that has gone by then has no second amplitude
    const end = envelope(given, A, [2 * Math.PI], mean)[0];
    return both(end > 0 ? Math.log(A / end) : NaN);
  };
  return { A, truth: swing(given, A) || both(NaN), lancaster: later(moment), lelas: later(squared),
    third: both(one ? thirdDecrement(one, A) : NaN) };
}

const both = decrement => ({ decrement, Q: 2 * Math.PI / (1 - Math.exp(-2 * decrement)) });

const short = (value, digits = innerWidth < 640 ? 5 : 7) => Number.isFinite(value) ? String(Number(value.toPrecision(digits))) : "–";
const minus = text => text.replace("-", "−");

function show() {
  const found = compute();
  for (const name of Object.keys(START)) place(name);
  element("equation").replaceChildren(...equation());
  for (const [name, text] of Object.entries(commands())) element("command-" + name).replaceChildren(...words(text));
  numbers(found);
  table(found);
  drawMotion(found);
  drawEnvelope(found);
  drawSeen(found, "decrement", "Λ", "amplitude A", false);
  drawSeen(found, "Q", "Q", "amplitude A", true);
  const address = Object.entries(state).filter(([, value]) => value !== "").map(pair => pair.join("=")).join("&");
  history.replaceState(null, "", "#" + address);
}

function equation() {
  const parts = ["x″ + x"];
  for (const [a, e] of [["alpha", "epsilon"], ["alpha2", "epsilon2"]]) {
    if (state[a] === "") continue;
    const power = document.createElement("sup"), less = number(state[a]) - 1;
    power.textContent = less === 1 ? "" : minus(short(less));
    parts.push(` + ${state[e]} ` + (less === -1 ? "sgn x′" : "x′"), ...(less === 0 || less === -1 ? [] : ["|x′|", power]));
  }
  return [...parts, ` = 0,   x(0) = ${state.x0},   x′(0) = 0`];
}

function words(text) { // a line may break between them, not after a hyphen
  return text.split(" ").flatMap((word, i) => {
    const span = document.createElement("span");
    span.textContent = word;
    return i ? [" ", span] : [span];
  });
}

function numbers({ given, one, x0, time, whole, ends }) {
  const [, x, v] = whole.path[whole.path.length - 1], start = observed(given, one, x0), cosine = Math.cos(time);
  const cells = {
    "x-truth": x, "x-lancaster": ends.lancaster[0] * cosine, "x-lelas": ends.lelas[0] * cosine, "v-truth": v,
    "A-lancaster": ends.lancaster[0], "A-lelas": ends.lelas[0], "A-third": ends.third ? ends.third[0] : NaN,
  };
  for (const way of ["truth", "lancaster", "lelas", "third"]) {
    cells["decrement-" + way] = start[way].decrement;
    cells["Q-" + way] = start[way].Q;
  }
  for (const [name, value] of Object.entries(cells)) put(element(name), value);
  element("ended").textContent = whole.ended === "sticks"
    ? `It sticks at turning point ${whole.points.length - 1}.` : "";
  for (const cell of document.querySelectorAll(".t")) cell.textContent = state.time;
}

function put(cell, value) { // a few digits to read; the whole double for who looks
  cell.textContent = minus(short(value));
  cell.dataset.value = String(value);
}

function table({ given, one, x0, whole, at }) {
  const points = whole.points.slice(0, COUNT), beside = at(points.map(p => p.t));
  const smith = one && one.alpha === 2;
  element("smith-head").hidden = !smith;
  let u = smith ? one.epsilon * x0 : NaN;
  element("points").replaceChildren(...points.map(({ n, x, t }, i) => {
    if (smith && i) u = lambert(u);
    const cells = [n, x, t, beside.lancaster[i], beside.lelas[i], beside.third ? beside.third[i] : NaN];
    if (smith) cells.push((n % 2 ? -u : u) / one.epsilon);
    const row = document.createElement("tr");
    row.append(...cells.map(value => { const cell = document.createElement("td"); put(cell, value); return cell; }));
    return row;
  }));
}

// ---- controls

function place(name) {
  const slider = element(name + "-slider"), box = element(name), [low, high] = LIMITS[name];
  if (name === "alpha2") {
    element("second").checked = state.alpha2 !== "";
    element("second-law").hidden = state.alpha2 === "";
    if (state.alpha2 === "") return;
  }
  const typed = wrong[name] ?? null; // null: nothing is wrong
  const bad = typed === null ? "" : `${typed.trim() || "nothing"} cannot be drawn: ${low} … ${high}; drawn is ${state[name]}`;
  box.value = typed ?? state[name];
  box.setAttribute("aria-invalid", String(bad !== ""));
  element(name + "-wrong").textContent = bad;
  const value = number(state[name]);
  slider.value = LOGARITHMIC[name] ? 1000 * Math.log(value / low) / Math.log(high / low) : value;
}

function slid(name, raw) {
  const [low, high] = LIMITS[name], value = LOGARITHMIC[name] ? low * Math.pow(high / low, raw / 1000) : Number(raw);
  accept(name, short(value, LOGARITHMIC[name] ? 2 : 4));
}

function listen() {
  for (const name of Object.keys(LIMITS)) {
    element(name + "-slider").addEventListener("input", event => { slid(name, event.target.value); show(); });
    element(name).addEventListener("change", event => { accept(name, event.target.value); show(); });
  }
  element("second").addEventListener("change", event => { state.alpha2 = event.target.checked ? SECOND : ""; show(); });
  for (const button of document.querySelectorAll("button.preset")) {
    button.addEventListener("click", () => { fresh(); read(button.dataset.state); show(); });
  }
  for (const button of document.querySelectorAll("button.copy")) {
    button.addEventListener("click", () => {
      navigator.clipboard?.writeText(button.parentElement.querySelector("code").textContent);
      button.textContent = "copied";
    });
  }
  window.addEventListener("hashchange", () => { fresh(); read(location.hash.slice(1)); show(); });
}

function fresh() {
  Object.assign(state, START);
  for (const name of Object.keys(wrong)) wrong[name] = null;
}

function read(text) {
  for (const part of text.split("&")) {
    const [name, value] = part.split("=");
    if (name in LIMITS && value !== undefined) accept(name, value);
  }
}

read(location.hash.slice(1));
listen();
show();
