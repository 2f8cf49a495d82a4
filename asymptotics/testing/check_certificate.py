"""Checks a certificate of a damped motion, with the standard library alone:  python check_certificate.py FILE

The motion:  x'' + k x + F(x') = 0,  F(v) = sum of e sgn(v)|v|^a  over the terms (a, e) of the law; k > 0, e, a >= 0
rational, x(0) and x'(0) given.  a = 0 is dry friction: F(0) is what holds the mass, up to H, the sum of these e.

The lemma.  Let y be smooth on pieces, y'' + k y + F(y') = r on each of them, E^2 = k (x - y)^2 + (x' - y')^2.  Then
E(t) <= E(0) + the jumps of y + the integral of |r|, as d(E^2)/dt = -2 (F(x') - F(y') + r)(x' - y') <= 2 |r| E: F does
not fall.  Hence |x - y| <= E/sqrt(k), |x' - y'| <= E, wherever y comes from: nothing else in the file is believed.

A piece of y is a polynomial P in u, its coefficients integers over 2^bits, in one of three ways:
  leave   u = (s/S)^(1/q) from 0 to 1, s the time since the piece began, at rest: no power of u between 0 and 2 q
  pass    u = s/S from -1 to 1, s the time since the middle of the piece
  arrive  as leave, run backwards: s is the time until the piece ends, at rest
so that |y'| = u^m V(u), V a polynomial, m = q (pass: 0).  V >= V_low > 0 is asked for: y' has one sign there, and
|y'|^a = u^(m a) V^a.  For V^a the file brings a polynomial W (a = 0 and 1 need none): log(W/V^a) changes by the
integral of (V W' - a W V')/(V W) and is known at u = 0: it is h at most, and |W - V^a| <= W (e^h - 1) <= W h/(1 - h).
For |u| <= 1 a polynomial is as far from its first coefficient as the absolute values of the others say, at most.

Turning points.  As V_low > E, the true speed has the sign of y', but for the times within S E/V_low of a rest of y.
Arriving at the end T of y, upwards say, a mass that moves on is slowed down by g = k (y(T) - E/sqrt(k)) + H at least;
g > 0 is asked for.  So it rests between T - S E/V_low and T + E/g, within E/sqrt(k) of y(T), as k (x + H/k)^2 + x'^2
falls on the way up.  If k|x| <= H there it stays.  Else it does so once.  The same of y, R^2, only grows by r: R > E at
T by g > 0, and two rests in the piece, k x > H and then k x < -H, cannot both be nearer to y than R.  While y leaves,
down say, a rest at x <= 0 leaves y' no more than E at the end, by k y^2 + y'^2 while y > 0 and as y' slows down below.
"""

import json
import re
import sys
from fractions import Fraction
from math import isqrt
from typing import Any

FORMAT = "damped oscillator certificate 1"
BYTES, PIECES, TERMS, BITS, EXPONENT, WORK = 100_000_000, 50_000, 20_000, 4096, 2500, 10**9  # what is more is refused
RATIONAL, INTEGER, DECIMAL = r"-?\d+(/0*[1-9]\d*)?", r"-?\d+", r"-?\d+(\.\d+)?(e-?\d{1,3})?"
CLAIMS = {  # x, v and t as decimals of so many digits, or null
    "turning point": {"kind", "number", "digits", "x", "t"},  # t since turning point 0
    "state": {"kind", "digits", "t", "x", "v"},  # at the exact time t since the start
    "rest": {"kind", "number"},  # the mass stays at that turning point for ever
}


class RefusedError(Exception):
    """The certificate is not accepted; the message says which inequality of which piece, or what cannot be read."""


def need(holds: object, reason: str) -> None:
    """Every condition of this page goes through here."""
    if not holds:
        raise RefusedError(reason)


def read(path: str) -> Any:
    """The file as plain objects, in which no key stands twice and a long bare integer is one too large."""

    def pairs(found: list[tuple[str, Any]]) -> dict[str, Any]:
        need(len(dict(found)) == len(found), "a key stands twice")
        return dict(found)

    try:
        with open(path, "rb") as file:  # noqa: PTH123 (fewer lines to trust)
            data = file.read(BYTES + 1)
        need(len(data) <= BYTES, f"more than {BYTES} bytes")
        return json.loads(data.decode(), object_pairs_hook=pairs, parse_int=lambda text: int(text[:10]))
    except (OSError, ValueError, RecursionError) as error:
        raise RefusedError(f"the file cannot be read: {type(error).__name__}") from None


def keyed(value: Any, keys: set[str]) -> Any:
    """An object with these keys, and no other that might be thought to matter."""
    need(type(value) is dict and set(value) == keys, f"the keys are not {', '.join(sorted(keys))}")
    return value


def listed(value: Any, low: int, high: int) -> Any:
    """A list of so many."""
    need(type(value) is list and low <= len(value) <= high, f"no list of {low} to {high}")
    return value


def counted(value: Any, low: int, high: int) -> int:
    """An integer in a range."""
    need(type(value) is int and low <= value <= high, f"no integer from {low} to {high}")
    return int(value)


def number(text: Any, form: str = RATIONAL, most: int = 200) -> Fraction:
    """A number of at most so many characters, exactly."""
    need(type(text) is str and len(text) <= most and re.fullmatch(form, text, re.ASCII), "no number, or too long")
    return Fraction(text)


def polynomial(value: Any, most: int) -> dict[int, int]:
    """{n: c} from [[n, "c"], ...], n increasing from 0."""
    powers = [counted(n, 0, 10**7) for n, _ in (listed(pair, 2, 2) for pair in listed(value, 1, TERMS))]
    need(powers[0] == 0 and all(n < m for n, m in zip(powers, powers[1:])), "the powers do not increase from 0")
    return {n: int(number(text, INTEGER, most)) for n, text in value}


def shaped(p: Any, law: list[Any], most: int) -> tuple[str, Fraction, dict[int, int], list[dict[int, int]]]:
    """(kind, S, P, a polynomial W for each term, empty for a = 0 and 1) of a piece."""
    S = number(keyed(p, {"kind", "scale", "y", "powers"})["scale"], RATIONAL, 2 * most)
    need(p["kind"] in ("leave", "pass", "arrive") and S > 0, "the kind or the scale")
    need([w is None for w in listed(p["powers"], 0, 20)] == [a in (0, 1) for a, _ in law], "powers, but of 0 and 1")
    return p["kind"], S, polynomial(p["y"], most), [{} if w is None else polynomial(w, most) for w in p["powers"]]


def others(p: dict[int, Any]) -> Any:
    """How far a polynomial is from its first coefficient at most, for |u| <= 1."""
    return sum(abs(c) for n, c in p.items() if n)


def log_error(V: dict[int, int], unit: Fraction, W: dict[int, int], one: int, a: Fraction) -> Fraction:
    """h >= |log(w/v^a)| for |u| <= 1, where v = V/unit and w = W/one."""
    need(W[0] > others(W), "W > 0 is not shown")
    products: dict[int, int] = {}  # (V W' - a W V') u a.denominator
    for i, b in V.items():
        for j, c in W.items():
            products[i + j] = products.get(i + j, 0) + (j * a.denominator - i * a.numerator) * b * c
    change = sum((Fraction(abs(c), n) for n, c in products.items() if n), Fraction(0))
    left = W[0] ** a.denominator * unit.numerator**a.numerator  # of w^denominator = v^numerator at u = 0
    right = (V[0] * unit.denominator) ** a.numerator * one**a.denominator
    need(left < 2 * right < 4 * left, "W is not V^a at u = 0")
    begins = Fraction(abs(left - right) * one**2 // min(left, right) + 1, one**2)  # at least |log(left/right)|
    return Fraction(change / ((V[0] - others(V)) * (W[0] - others(W))) + begins) / a.denominator


def piece(shape: Any, law: list[Any], k: Fraction, root: int, one: int) -> Any:
    """(duration, beginning, end, sup |r|, V_low, sign of y') of a piece."""
    kind, S, P, powers = shape
    q, m = (1, 0) if kind == "pass" else (root, root)
    need(kind == "pass" or all(n == 0 or n >= 2 * q for n in P), "a power between 0 and 2 q: no rest")
    V, unit = {n - q - m: n * c for n, c in P.items() if n}, q * S * one  # dP/ds = u^m V/unit
    sign = 1 if V.setdefault(0, 0) > 0 else -1
    V, forward = {n: sign * c for n, c in V.items()}, -sign if kind == "arrive" else sign
    need(V[0] > others(V), "V > 0 is not shown")
    beyond, terms = Fraction(0), [(n, k * c / one) for n, c in P.items()]  # what is in no polynomial; k y
    terms += [(n - 2 * q, n * (n - q) * c / (unit * q * S)) for n, c in P.items() if n not in (0, q)]  # y''
    for (a, e), W in zip(law, powers):
        need((m * a).denominator == 1, "an exponent is no multiple of 1/root")
        power = {0: Fraction(1)} if a == 0 else {n: c / unit for n, c in V.items()}
        if W:
            h, power = log_error(V, unit, W, one, a), {n: Fraction(c, one) for n, c in W.items()}
            need(h < 1, "W is not V^a")
            beyond += e * (power[0] + others(power)) * h / (1 - h)
        terms += [(n + int(m * a), forward * e * c) for n, c in power.items()]  # F(y')
    r = dict.fromkeys((n for n, _ in terms), Fraction(0))
    for n, c in terms:
        r[n] += c
    ends = []
    for u in (-1, 1) if kind == "pass" else (0, 1):
        speed = sum(n * c * u ** (n - 1) for n, c in P.items() if n) / unit
        ends.append((Fraction(sum(c * u**n for n, c in P.items()), one), speed))
    begin, end = ends if kind != "arrive" else ((ends[1][0], -ends[1][1]), ends[0])
    low, defect = (V[0] - others(V)) / unit, sum(map(abs, r.values())) + beyond
    return (2 if kind == "pass" else 1) * S, begin, end, defect, low, forward


def follow(c: Any, share: int) -> tuple[list[Any], dict[Fraction, Any], bool]:
    """([(x, within, first time, last time) of each turning point], {t: (x, v, within, within)}, whether it stays)."""
    keyed(c, {"format", "law", "stiffness", "start", "bits", "root", "pieces", "claims"})
    need(c["format"] == FORMAT, "another format")
    bits, root = counted(c["bits"], 1, BITS), counted(c["root"], 1, 10_000)
    law = [(number(a), number(e)) for a, e in (listed(term, 2, 2) for term in listed(c["law"], 0, 20))]
    need(all(a >= 0 and e >= 0 and a.numerator + a.denominator <= EXPONENT for a, e in law), "a < 0, e < 0 or a long")
    k, (x, v), H = number(c["stiffness"]), map(number, listed(c["start"], 2, 2)), sum(e for a, e in law if a == 0)
    one, fine = 1 << bits, 1 << bits + 64
    root_low = Fraction(isqrt(max(k.numerator, 0) * fine**2 // k.denominator), fine)  # <= sqrt(k) <= k/root_low
    need(root_low > 0, "the stiffness is not positive, or too small")
    shapes = [shaped(p, law, bits // 3 + 50) for p in listed(c["pieces"], 0, PIECES)]
    ends = sum(a.numerator + a.denominator for a, _ in law) * bits // 8
    work = sum(ends + len(P) * (40 + sum(map(len, Ws))) for _, _, P, Ws in shapes) * (bits + 600) // 600
    need(work * share <= WORK, f"the work would take {work * share // 2_500_000} s")
    resting, E, T = v == 0, Fraction(0), Fraction(0)
    turned, states, stays = [(x, E, T, T)] if resting else [], {T: (x, v, E, E)}, resting and k * abs(x) <= H
    for i, shape in enumerate(shapes):
        try:
            duration, begin, end, defect, low, forward = piece(shape, law, k, root, one)
            need(shape[0] != "leave" or resting, "to leave is to begin at rest")
            E += k / root_low * abs(begin[0] - x) + abs(begin[1] - v) + duration * defect
            E, T = Fraction(-(-E * fine // 1), fine), T + duration
            need(T.denominator.bit_length() <= 2 * BITS, "the time has too long a denominator")
            need(low > E, "V_low > E")
            (x, v), off, resting = end, E / root_low, shape[0] == "arrive"
            states[T] = x, v, off, E
            if resting:
                g = k * (forward * x - off) + H
                need(g > 0, "g > 0")
                turned.append((x, off, T - duration * E / low, T + E / g))
                stays = k * (abs(x) + off) <= H
        except RefusedError as reason:
            raise RefusedError(f"piece {i}: {reason}") from None
    return turned, states, stays


def rounds(claim: Any, name: str, low: Fraction, high: Fraction) -> str:
    """Every number from low to high is within half a unit of the last digit of the decimal; 0 is claimed exactly."""
    if claim[name] is None:
        return ""
    d, digits, unit = number(claim[name], DECIMAL, 2000), counted(claim["digits"], 1, 1300), Fraction(0)
    if d:
        unit = Fraction(10) ** (len(str(abs(d.numerator))) - len(str(d.denominator)) - digits + 1)
        unit /= 10 if unit * 10 ** (digits - 1) > abs(d) else 1
        need((d / unit).denominator == 1, f"{name} has more than {digits} digits")
    need(max(high - d, d - low) <= unit / 2, f"{name} = {claim[name][:40]} is not shown to {digits} digits")
    size = (high - low).numerator.bit_length() - (high - low).denominator.bit_length()  # half of it < 2^size
    return f" {name} = {claim[name]}" + (f" (known to 1e{size * 30102 // 100_000 + 2})" if high > low else " exactly")


def check(c: Any, share: int = 1) -> list[str]:
    """The equation and its start, and what was proved, a line for each claim; RefusedError."""
    turned, states, stays = follow(c, share)
    force, (x, v) = "".join(f" + {e} sgn(x')|x'|^({a})" for a, e in c["law"]), c["start"]
    said = [f"x'' + {c['stiffness']} x{force} = 0, x(0) = {x}, x'(0) = {v}"]
    for claim in listed(c["claims"], 1, 100_000):
        kind = claim["kind"] if type(claim) is dict and type(claim.get("kind")) is str else ""
        need(kind in CLAIMS, "no kind of claim")
        keyed(claim, CLAIMS[kind])
        if kind == "state":
            t = number(claim["t"])
            rest = (turned[-1][0], Fraction(0), turned[-1][1], Fraction(0)) if stays and turned[-1][3] <= t else None
            need(rest or t in states, f"t = {claim['t']}: no piece ends at this time")
            x, v, off, E = rest or states[t]
            said.append(f"t = {claim['t']}:" + rounds(claim, "x", x - off, x + off) + rounds(claim, "v", v - E, v + E))
            continue
        n = counted(claim["number"], 0, PIECES)
        need(n < len(turned), f"turning point {n} is not reached")
        x, within, first, last = turned[n]
        first, last = (first - turned[0][3], last - turned[0][2]) if n else (Fraction(0), Fraction(0))
        if kind == "rest":
            need(stays and n == len(turned) - 1, f"the mass is not shown to stay at turning point {n}")
        held = " it stays" if kind == "rest" else rounds(claim, "x", x - within, x + within)
        said.append(f"turning point {n}:" + held + ("" if kind == "rest" else rounds(claim, "t", first, last)))
    return said


def told(content: Any) -> list[str]:
    """What was proved of a certificate, or of each in a list of them."""
    each = listed(content, 1, 1000) if type(content) is list else [content]
    return [line for c in each for line in check(c, len(each))]


if __name__ == "__main__":
    try:
        need(len(sys.argv) == 2, "usage: python check_certificate.py FILE")
        print("accepted", *told(read(sys.argv[1])), sep="\n")
    except RefusedError as reason:
        print(f"refused: {reason}")
        sys.exit(1)
