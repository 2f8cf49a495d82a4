"use strict";
// x'' + x + sum_i epsilon_i x'|x'|^(alpha_i - 1) = 0 from rest at x0, in doubles: nothing here is proved.
// A law is {alpha, epsilon}; a motion is integrated half-swing by half-swing, on which the velocity keeps its sign.

const LANCZOS = [0.99999999999980993, 676.5203681218851, -1259.1392167224028, 771.32342877765313,
  -176.61502916214059, 12.507343278686905, -0.13857109526572012, 9.9843695780195716e-6, 1.5056327351493116e-7];

function gamma(z) { // C. Lanczos 1964, with g = 7 and nine terms; z > 1/2 is all that is asked for
  const sum = LANCZOS.reduce((total, c, k) => total + (k ? c / (z - 1 + k) : c), 0), t = z + 6.5;
  return Math.sqrt(2 * Math.PI) * Math.pow(t, z - 0.5) * Math.exp(-t) * sum;
}

const moment = p => gamma((p + 1) / 2) / (Math.sqrt(Math.PI) * gamma(p / 2 + 1)); // M_p, the mean of |sin|^p
const squared = p => Math.pow(2, -p / 2); // the same by the squaring trick

// One step of Dormand and Prince (1980): the new values, the size of the error, in units of the tolerance.
const C = [[1 / 5], [3 / 40, 9 / 40], [44 / 45, -56 / 15, 32 / 9],
  [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
  [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
  [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84]];
const E = [71 / 57600, 0, -71 / 16695, 71 / 1920, -17253 / 339200, 22 / 525, -1 / 40];
const TOLERANCE = 1e-11, MOST_STEPS = 200000;

function step(rate, y, h, scale) {
  const k = [rate(y)];
  let next = y, wrong = 0;
  for (const row of C) {
    next = y.slice();
    for (let j = 0; j < row.length; j++) for (let i = 0; i < y.length; i++) next[i] += h * row[j] * k[j][i];
    k.push(rate(next));
  }
  for (let i = 0; i < y.length; i++) {
    let sum = 0;
    for (let j = 0; j < E.length; j++) sum += E[j] * k[j][i];
    wrong = Math.max(wrong, Math.abs(h * sum));
  }
  return { y: next, error: wrong / (TOLERANCE * scale) };
}

const grown = (h, error) => h * (error < 1e9 ? Math.min(4, Math.max(0.2, 0.9 * Math.pow(error + 1e-12, -0.2))) : 0.2);

const dry = laws => laws.reduce((sum, law) => sum + (law.alpha === 0 ? law.epsilon : 0), 0); // holds a mass at rest

// From the turning point at x to the next one, or to the time `most`: [t, x, v] of every step, and how it ends.
function halfSwing(laws, x, most) {
  const path = [[0, x, 0]], side = -Math.sign(x);
  if (Math.abs(x) <= dry(laws) || x === 0) return { path, ends: "sticks" };
  const loss = speed => {
    let sum = 0;
    for (const { alpha, epsilon } of laws) sum += alpha ? epsilon * Math.pow(speed, alpha) : epsilon;
    return sum;
  };
  const rate = ([q, v]) => [v, -q - side * loss(Math.max(0, side * v))];
  let t = 0, y = [x, 0], h = 1e-4;
  for (let count = 0; count < MOST_STEPS; count++) {
    const left = most - t, length = Math.min(h, left), scale = Math.abs(x);
    const tried = step(rate, y, length, scale);
    if (!(tried.error <= 1)) { h = grown(length, tried.error); continue; }
    if (side * tried.y[1] < 0) {
      const found = turn(rate, y, length, scale);
      if (!(found.error <= 1) && found.h > 1e-12) { h = found.h / 2; continue; }
      path.push([t + found.h, found.y[0], 0]);
      return { path, ends: "turns" };
    }
    t += length; y = tried.y; h = grown(length, tried.error);
    path.push([t, ...y]);
    if (length === left) return { path, ends: "goes on" };
  }
  return { path, ends: "too slow" };
}

function turn(rate, y, length, scale) { // the step on which the velocity comes to 0: regula falsi (Illinois)
  let [a, b] = [0, length], [fa, fb] = [y[1], step(rate, y, length, scale).y[1]], found = { h: b };
  for (let count = 0; count < 60 && Math.abs(fb - fa) > 0; count++) {
    const h = b - fb * (b - a) / (fb - fa), tried = step(rate, y, h, scale), f = tried.y[1];
    found = { h, ...tried };
    if (Math.abs(f) <= 1e-16 * scale || Math.abs(b - a) < 1e-15) break;
    if (Math.sign(f) === Math.sign(fb)) { fa /= 2; } else { [a, fa] = [b, fb]; }
    [b, fb] = [h, f];
  }
  return found;
}

// The motion up to a time: its path, its turning points {n, x, t}, and why there are no more ("" if there are).
function motion(laws, x0, until) {
  const path = [[0, x0, 0]], points = [{ n: 0, x: x0, t: 0 }];
  let ended = "";
  for (let t = 0, x = x0; t < until && !ended;) {
    const { path: half, ends } = halfSwing(laws, x, until - t);
    for (const [s, q, v] of half.slice(1)) path.push([t + s, q, v]);
    [t, x] = path[path.length - 1];
    if (ends === "turns") points.push({ n: points.length, x, t });
    else ended = ends;
  }
  if (ended === "sticks") path.push([until, path[path.length - 1][1], 0]);
  return { path, points, ended: ended === "goes on" ? "" : ended };
}

// What an experiment sees on the full swing from a turning amplitude: Lambda = ln(A_n/A_(n+2)) and
// Q = 2 pi V(A_n)/(V(A_n) - V(A_(n+2))), V = A^2/2; null where there is no second turning point.
const LONGEST = 20; // who has not turned by then creeps

// Where a mass comes to rest is no amplitude of a swing: friction holds it, or it is at 0 as far as doubles can tell.
const rests = (laws, x, start) => Math.abs(x) <= Math.max(dry(laws), 1e-7 * start);

function swing(laws, amplitude) {
  let x = amplitude;
  for (let n = 0; n < 2; n++) {
    const { path, ends } = halfSwing(laws, x, LONGEST);
    if (ends !== "turns") return null;
    x = path[path.length - 1][1];
    if (rests(laws, x, amplitude)) return null;
  }
  return { decrement: Math.log(amplitude / Math.abs(x)), Q: 2 * Math.PI / (1 - (x / amplitude) ** 2) };
}

// First order: dA/dt = -sum kappa_i A^alpha_i, kappa_i = M_(alpha_i+1) epsilon_i, or by the squaring trick.
const kappas = (laws, mean) => laws.map(law => ({ alpha: law.alpha, kappa: mean(law.alpha + 1) * law.epsilon }));

function envelope(laws, x0, times, mean) {
  const terms = kappas(laws, mean);
  if (terms.length === 1) return times.map(t => closed(terms[0], x0, t));
  return slow(([A]) => [-terms.reduce((sum, k) => sum + k.kappa * Math.pow(A, k.alpha), 0)], x0, times);
}

function closed({ alpha, kappa }, x0, t) {
  if (Math.abs(alpha - 1) < 1e-12) return x0 * Math.exp(-kappa * t);
  const base = 1 + (alpha - 1) * kappa * Math.pow(x0, alpha - 1) * t;
  return base > 0 ? x0 * Math.pow(base, 1 / (1 - alpha)) : 0;
}

// Third order of one law: dA/dt = -A (p_1 delta + p_3 delta^3), dpsi/dt = 1 + Omega_2 delta^2, delta = epsilon A^(alpha-1).
function third(alpha) {
  const a = alpha, p1 = moment(a + 1), omega2 = -((a / (a + 1)) ** 2) * moment(2 * a);
  return { p1, omega2, p3: a * (3 * a + 1) / (6 * (a + 1) ** 2) * moment(3 * a + 1) + omega2 * p1 };
}

function thirdOrder({ alpha, epsilon }, x0, times) {
  const { p1, p3 } = third(alpha), delta = A => epsilon * Math.pow(A, alpha - 1);
  return slow(([A]) => [-A * (p1 * delta(A) + p3 * delta(A) ** 3)], x0, times);
}

function thirdDecrement({ alpha, epsilon }, x0) { // over a full swing the phase gains 2 pi
  const { p1, p3, omega2 } = third(alpha), delta = A => epsilon * Math.pow(A, alpha - 1);
  const pace = A => 1 + omega2 * delta(A) ** 2; // a series of no use where it is far from 1
  const rate = ([A]) => [pace(A) > 0.5 ? -A * (p1 * delta(A) + p3 * delta(A) ** 3) / pace(A) : NaN];
  const [A] = slow(rate, x0, [2 * Math.PI]);
  return A > 0 ? Math.log(x0 / A) : NaN;
}

// A slow equation at increasing times; 0 from where the amplitude has gone, NaN from where the rate is none.
function slow(rate, x0, times) {
  let t = 0, y = [x0], h = 1e-3, count = 0;
  return times.map(end => {
    while (t < end && y[0] > 1e-9 * x0 && count++ < 5000) {
      const length = Math.min(h, end - t), tried = step(rate, y, length, x0);
      if (!(tried.error <= 1) && length > 1e-12) { h = grown(length, tried.error); continue; }
      t += length; y = tried.y; h = grown(length, tried.error);
    }
    return y[0] > 1e-9 * x0 ? (t < end ? NaN : y[0]) : Number.isNaN(y[0]) ? NaN : 0;
  });
}

// Quadratic damping alone: Smith's turning points, 2|u'| = 1 + W_0(-y e^-y), y = 1 + 2|u|, u = epsilon x (Newton).
function lambert(u) {
  const y = 1 + 2 * u, target = -y * Math.exp(-y);
  let w = -1 + Math.min(2 * u, 0.9);
  for (let count = 0; count < 80; count++) {
    const e = Math.exp(w), by = (w * e - target) / (e * (w + 1));
    w -= by;
    if (Math.abs(by) < 1e-16) break;
  }
  return (1 + w) / 2;
}
