// A second checker of certificates, in another language, written from docs/theory/certificates.md alone.
//
//     node check_certificate.js FILE...        one line for each file: "accepted", or "refused" with the reason
"use strict";
const fs = require("fs");

class Refused extends Error {}
const need = (holds, reason) => { if (!holds) throw new Refused(reason); };

// ---- JSON with keys that stand once: "integer", strings, null, lists, objects as Map

function parse(text) {
  let i = 0, depth = 0;
  const space = () => { while (" \t\n\r".includes(text[i]) && i < text.length) i++; };
  const word = (w, value) => { need(text.startsWith(w, i), "no JSON"); i += w.length; return value; };
  function string() {
    let end = i + 1;
    while (end < text.length && text[end] !== '"') end += text[end] === "\\" ? 2 : 1;
    let value;
    try { value = JSON.parse(text.slice(i, end + 1)); } catch (e) { throw new Refused("no JSON string"); }
    i = end + 1;
    return value;
  }
  function value() {
    need(++depth < 500, "nested too deep");
    space();
    let found;
    const c = text[i];
    if (c === "{") {
      found = new Map(); i++; space();
      if (text[i] === "}") i++;
      else for (;;) {
        space(); need(text[i] === '"', "a key is no string");
        const key = string(); space();
        need(text[i++] === ":", "no JSON");
        need(!found.has(key), "a key stands twice");
        found.set(key, value()); space();
        if (text[i] === ",") { i++; continue; }
        need(text[i++] === "}", "no JSON"); break;
      }
    } else if (c === "[") {
      found = []; i++; space();
      if (text[i] === "]") i++;
      else for (;;) {
        found.push(value()); space();
        if (text[i] === ",") { i++; continue; }
        need(text[i++] === "]", "no JSON"); break;
      }
    } else if (c === '"') found = string();
    else if (c === "n") found = word("null", null);
    else if (c === "t") found = word("true", true);
    else if (c === "f") found = word("false", false);
    else {
      const number = /^-?(0|[1-9][0-9]*)(\.[0-9]+)?([eE][-+]?[0-9]+)?/.exec(text.slice(i, i + 400));
      need(number, "no JSON");
      i += number[0].length;
      // Anything but an integer of at most nine digits fits no place of a certificate.
      found = /^-?[0-9]{1,9}$/.test(number[0]) ? Number(number[0]) : Symbol("a long or broken number");
    }
    depth--;
    return found;
  }
  const found = value();
  space();
  need(i === text.length, "more than one JSON value");
  return found;
}

// ---- exact fractions

const abs = (a) => (a < 0n ? -a : a);
const gcd = (a, b) => { a = abs(a); b = abs(b); while (b) [a, b] = [b, a % b]; return a; };
class Q {
  constructor(n, d = 1n) {
    if (d < 0n) { n = -n; d = -d; }
    const g = d === 1n ? 1n : gcd(n, d);
    this.n = g === 1n ? n : n / g; this.d = g === 1n ? d : d / g;
  }
  add(o) { return new Q(this.n * o.d + o.n * this.d, this.d * o.d); }
  sub(o) { return new Q(this.n * o.d - o.n * this.d, this.d * o.d); }
  mul(o) { return new Q(this.n * o.n, this.d * o.d); }
  div(o) { return new Q(this.n * o.d, this.d * o.n); }
  neg() { return new Q(-this.n, this.d); }
  abs() { return this.n < 0n ? this.neg() : this; }
  cmp(o) { const c = this.n * o.d - o.n * this.d; return c < 0n ? -1 : c > 0n ? 1 : 0; }
  get sign() { return this.n < 0n ? -1 : this.n > 0n ? 1 : 0; }
  pow(k) { return new Q(this.n ** BigInt(k), this.d ** BigInt(k)); }
}
const q = (n, d = 1) => new Q(BigInt(n), BigInt(d));
const ZERO = q(0), ONE = q(1);

// ---- reading, as "The file" says

const integer = (v, low, high) => { need(Number.isInteger(v) && low <= v && v <= high, "an integer"); return v; };
const list = (v, low, high) => { need(Array.isArray(v) && low <= v.length && v.length <= high, "a list"); return v; };
const object = (v, keys) => {
  need(v instanceof Map && v.size === keys.length && keys.every((k) => v.has(k)), "the keys of an object");
  return v;
};
function text(v, most, form) {
  need(typeof v === "string" && v.length <= most && form.test(v), "a number");
  return v;
}
function rational(v, most = 200) {
  const [n, d] = text(v, most, /^-?[0-9]+(\/[0-9]+)?$/).split("/");
  need(d === undefined || BigInt(d) !== 0n, "a denominator that is 0");
  return new Q(BigInt(n), BigInt(d ?? 1));
}
function decimal(v) {
  const [, sign, whole, part, power] = /^(-?)([0-9]+)(?:\.([0-9]+))?(?:e(-?[0-9]{1,3}))?$/.exec(
    text(v, 2000, /^-?[0-9]+(\.[0-9]+)?(e-?[0-9]{1,3})?$/));
  const n = BigInt(whole + (part ?? "")) * (sign ? -1n : 1n), e = Number(power ?? 0) - (part ?? "").length;
  return e < 0 ? new Q(n, 10n ** BigInt(-e)) : new Q(n * 10n ** BigInt(e));
}
function polynomial(v, B) {
  let before = -1;
  const found = list(v, 1, 20000).map((pair) => {
    const [n, c] = list(pair, 2, 2);
    need(integer(n, 0, 1e7) > before, "the powers increase");
    before = n;
    return [n, new Q(BigInt(text(c, Math.floor(B / 3) + 50, /^-?[0-9]+$/)), 1n << BigInt(B))];
  });
  need(found[0][0] === 0, "the first power is 0");
  return found;
}

// ---- a piece: conditions 1 to 3

const rest = (p) => p.reduce((sum, [n, c]) => (n ? sum.add(c.abs()) : sum), ZERO);
const low = (p) => p[0][1].sub(rest(p)), high = (p) => p[0][1].add(rest(p));

function powerError(V, W, a, B) {
  need(low(W).sign > 0, "W_low > 0");
  const p = BigInt(a.n), d = BigInt(a.d), c = new Map();
  // Over one denominator each, so that only integers are multiplied.
  const common = (r) => r.reduce((D, [, x]) => D * (x.d / gcd(D, x.d)), 1n);
  const DV = common(V), DW = common(W);
  const v = V.map(([n, x]) => [n, x.n * (DV / x.d)]), w = W.map(([n, x]) => [n, x.n * (DW / x.d)]);
  for (const [i, x] of v) for (const [j, y] of w) c.set(i + j, (c.get(i + j) ?? 0n) + (d * BigInt(j) - p * BigInt(i)) * x * y);
  let sum = ZERO;
  for (const [n, x] of c) if (n) sum = sum.add(new Q(abs(x), BigInt(n)));
  sum = sum.div(new Q(DV * DW)).div(low(V).mul(low(W)));
  // L = W(0)^d and R = V(0)^p over one denominator.
  const W0 = W[0][1], V0 = V[0][1];
  const L = W0.n ** d * V0.d ** p, R = V0.n ** p * W0.d ** d;
  need(L < 2n * R && 2n * R < 4n * L, "L < 2 R < 4 L");
  const least = L < R ? L : R, fine = 1n << BigInt(2 * B);
  const begin = new Q((abs(L - R) * fine) / least + 1n, fine);
  const h = sum.add(begin).div(new Q(d));
  need(h.cmp(ONE) < 0, "h < 1");
  return h;
}

function piece(v, law, k, root, B) {
  object(v, ["kind", "scale", "y", "powers"]);
  const kind = v.get("kind");
  need(["leave", "pass", "arrive"].includes(kind), "the kind of a piece");
  const S = rational(v.get("scale"), 2 * (Math.floor(B / 3) + 50));
  need(S.sign > 0, "S > 0");
  const given = list(v.get("powers"), law.length, law.length);
  const P = polynomial(v.get("y"), B);
  const Ws = law.map(([a], i) => {
    const none = a.d === 1n && (a.n === 0n || a.n === 1n);
    need((given[i] === null) === none, "powers but for 0 and 1");
    return none ? null : polynomial(given[i], B);
  });
  return () => {
    const r = kind === "pass" ? 1 : root, m = kind === "pass" ? 0 : root;
    if (kind !== "pass") need(P.every(([n]) => n === 0 || n >= 2 * r), "no power between 0 and 2 q");
    const scale = S.mul(q(r));
    let V = P.filter(([n]) => n).map(([n, c]) => [n - r - m, c.mul(q(n)).div(scale)]);
    need(V.length && V[0][0] === 0, "V(0)");
    const sign = V[0][1].sign;
    V = V.map(([n, c]) => [n, sign < 0 ? c.neg() : c]);
    need(low(V).sign > 0, "V_low > 0");
    const forward = kind === "arrive" ? -sign : sign;
    const residual = new Map();
    const add = (n, c) => residual.set(n, (residual.get(n) ?? ZERO).add(c));
    for (const [n, c] of P) {
      add(n, k.mul(c));
      if (n !== 0 && n !== r) add(n - 2 * r, c.mul(q(n)).mul(q(n - r)).div(scale.mul(scale)));
    }
    let beyond = ZERO;
    law.forEach(([a, e], i) => {
      const shift = a.mul(q(m));
      need(shift.d === 1n, "m a is whole");
      let G = a.n === 0n ? [[0, ONE]] : V;
      if (Ws[i]) {
        const h = powerError(V, Ws[i], a, B);
        G = Ws[i];
        beyond = beyond.add(e.mul(high(G)).mul(h).div(ONE.sub(h)));
      }
      for (const [n, c] of G) add(n + Number(shift.n), c.mul(e).mul(q(forward)));
    });
    let rho = beyond;
    for (const c of residual.values()) rho = rho.add(c.abs());
    const at = (u) => {
      let y = ZERO, speed = ZERO;
      for (const [n, c] of P) {
        const odd = u < 0 && n % 2 === 1;
        if (u !== 0 || n === 0) y = y.add(odd ? c.neg() : c);
        if (n && u !== 0) speed = speed.add((u < 0 && n % 2 === 0 ? c.neg() : c).mul(q(n)).div(scale));
      }
      return [y, speed];
    };
    const one = at(1), other = kind === "pass" ? at(-1) : [at(0)[0], ZERO];
    const [begin, end] = kind === "arrive" ? [[one[0], one[1].neg()], other] : [other, one];
    return { kind, S, begin, end, rho, low: low(V), forward, time: kind === "pass" ? S.mul(q(2)) : S };
  };
}

// ---- the motion: conditions 4 to 7

function isqrt(n) {
  if (n < 2n) return n;
  let x = 1n << BigInt((n.toString(2).length + 1) >> 1);
  for (;;) { const y = (x + n / x) >> 1n; if (y >= x) return x; x = y; }
}

function check(c) {
  object(c, ["format", "law", "stiffness", "start", "bits", "root", "pieces", "claims"]);
  need(c.get("format") === "damped oscillator certificate 1", "the format");
  const B = integer(c.get("bits"), 1, 4096), root = integer(c.get("root"), 1, 10000);
  const law = list(c.get("law"), 0, 20).map((t) => list(t, 2, 2).map((x) => rational(x)));
  need(law.every(([a, e]) => a.sign >= 0 && e.sign >= 0 && a.n + a.d <= 2500n), "a, e >= 0, a not too long");
  const k = rational(c.get("stiffness"));
  need(k.sign > 0, "k > 0");
  let [x, v] = list(c.get("start"), 2, 2).map((t) => rational(t));
  const H = law.reduce((sum, [a, e]) => (a.n === 0n ? sum.add(e) : sum), ZERO);
  const fine = 1n << BigInt(B + 64), kappa = new Q(isqrt((k.n * fine * fine) / k.d), fine);
  need(kappa.sign > 0, "kappa > 0");
  const pieces = list(c.get("pieces"), 0, 50000).map((p) => piece(p, law, k, root, B));
  let resting = v.sign === 0, E = ZERO, T = ZERO;
  let stays = resting && k.mul(x.abs()).cmp(H) <= 0;
  const turned = resting ? [{ x, within: ZERO, first: ZERO, last: ZERO }] : [], states = new Map();
  const remember = (t, s) => states.set(`${t.n}/${t.d}`, s);
  remember(T, { x, v, dx: ZERO, dv: ZERO });
  for (const make of pieces) {
    const p = make();
    need(p.kind !== "leave" || resting, "a piece leaves where the mass rests");
    E = E.add(p.begin[0].sub(x).abs().mul(k).div(kappa)).add(p.begin[1].sub(v).abs()).add(p.time.mul(p.rho));
    const scaled = E.n * fine;
    E = new Q(scaled % E.d === 0n ? scaled / E.d : scaled / E.d + 1n, fine);
    T = T.add(p.time);
    need(T.d.toString(2).length <= 8192, "the denominator of the time");
    need(p.low.cmp(E) > 0, "V_low > E");
    [x, v] = p.end;
    const off = E.div(kappa);
    remember(T, { x, v, dx: off, dv: E });
    resting = p.kind === "arrive";
    if (resting) {
      const g = x.mul(q(p.forward)).sub(off).mul(k).add(H);
      need(g.sign > 0, "g > 0");
      turned.push({ x, within: off, first: T.sub(p.S.mul(E).div(p.low)), last: T.add(E.div(g)) });
      stays = k.mul(x.abs().add(off)).cmp(H) <= 0;
    }
  }
  for (const claim of list(c.get("claims"), 1, 100000)) checkClaim(claim, turned, states, stays);
}

// ---- the claims

function checkDecimal(claim, name, least, most) {
  if (claim.get(name) === null) return;
  const d = decimal(claim.get(name)), digits = integer(claim.get("digits"), 1, 1300);
  let half = ZERO;
  if (d.sign) {
    const a = d.abs();
    let m = a.n.toString().length - a.d.toString().length + 1;
    const ten = (e) => (e < 0 ? new Q(1n, 10n ** BigInt(-e)) : new Q(10n ** BigInt(e)));
    while (ten(m).cmp(a) > 0) m--;
    const unit = ten(m + 1 - digits);
    need(d.div(unit).d === 1n, "a multiple of its unit");
    half = unit.div(q(2));
  }
  need(most.sub(d).cmp(half) <= 0 && d.sub(least).cmp(half) <= 0, `${name} is not shown`);
}

function checkClaim(claim, turned, states, stays) {
  const keys = {
    "turning point": ["kind", "number", "digits", "x", "t"], state: ["kind", "digits", "t", "x", "v"], rest: ["kind", "number"],
  };
  need(claim instanceof Map && typeof claim.get("kind") === "string" && Object.hasOwn(keys, claim.get("kind")), "a claim");
  object(claim, keys[claim.get("kind")]);
  if (claim.get("kind") === "state") {
    const t = rational(claim.get("t")), last = turned[turned.length - 1];
    let s = states.get(`${t.n}/${t.d}`);
    if (stays && last.last.cmp(t) <= 0) s = { x: last.x, dx: last.within, v: ZERO, dv: ZERO };
    need(s, "no piece ends there");
    checkDecimal(claim, "x", s.x.sub(s.dx), s.x.add(s.dx));
    checkDecimal(claim, "v", s.v.sub(s.dv), s.v.add(s.dv));
    return;
  }
  const n = integer(claim.get("number"), 0, 50000);
  need(n < turned.length, "not so many turning points");
  if (claim.get("kind") === "rest") { need(stays && n === turned.length - 1, "it stays"); return; }
  const p = turned[n], o = turned[0];
  checkDecimal(claim, "x", p.x.sub(p.within), p.x.add(p.within));
  if (n === 0) checkDecimal(claim, "t", ZERO, ZERO);
  else checkDecimal(claim, "t", p.first.sub(o.last), p.last.sub(o.first));
}

for (const path of process.argv.slice(2)) {
  try {
    const data = fs.readFileSync(path);
    need(data.length <= 100000000, "the length of the file");
    const found = parse(new TextDecoder("utf-8", { fatal: true, ignoreBOM: true }).decode(data));
    for (const c of Array.isArray(found) ? list(found, 1, 1000) : [found]) check(c);
    console.log("accepted");
  } catch (error) {
    if (!(error instanceof Refused || error instanceof TypeError && /decode|encoded/.test(error.message))) throw error;
    console.log(`refused: ${error.message}`);
  }
}
