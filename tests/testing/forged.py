"""Forged certificates: motions of other laws and starts, of equations that are none of ours, claims beside them."""

import json
from fractions import Fraction

from flint import arb

from asymptotics.certificates.certificate import certificate
from asymptotics.certificates.equation import Equation
from asymptotics.certificates.layout import Plan, swing
from asymptotics.certificates.of_results import of_states
from asymptotics.certificates.pieces import piece
from asymptotics.certificates.series import PowerSeries, _power, in_motion
from asymptotics.law import Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.context import ctx
from asymptotics.numbers.rationals import to_fmpq
from tests.certificates import examples


def changed(content, **keys):
    return {**content, **keys}


def rational(x, bits=200):
    mantissa, exponent = x.mid().man_exp()
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent)


def packed(kind, scale, p, powers, bits=80):
    """A piece from coefficients as Fractions or floats."""
    poly = lambda c: [[n, str(round(Fraction(x) * 2**bits))] for n, x in sorted(c.items()) if x or n == 0]  # noqa: E731
    return {
        "kind": kind,
        "scale": str(scale),
        "y": poly(p),
        "powers": [None if w is None else poly(w) for w in powers],
    }


def whole(law, start, pieces, claims, bits=80, root=1, stiffness="1"):
    return {
        "format": "damped oscillator certificate 1", "law": law, "stiffness": stiffness, "start": start, "bits": bits,
        "root": root, "pieces": pieces, "claims": claims,
    }  # fmt: skip


EXISTS = {"kind": "turning point", "number": 0, "digits": 1, "x": None, "t": None}


# ---------------------------------------------------------------- another law, another start


def other_law(name="sum", law=(("1", "1/20"), ("2", "1/11"))):
    return changed(examples.turning(name), law=[list(term) for term in law])


def other_start(place=None, speed=None):
    content = examples.state("in motion", "1/3", digits=5)
    x, v = content["start"]
    return changed(content, start=[place or x, speed or v])


def linear_for_quadratic():
    return changed(examples.state("pushed", "1", digits=5), law=[["2", "1/10"]])


def stronger_by_its_powers():
    """The motion with 3/20 v|v|, called one with 1/10 v|v|, with powers half as large again."""
    content = examples.turning("stronger")
    for p in content["pieces"]:
        p["powers"] = [[[n, str(int(c) * 3 // 2)] for n, c in p["powers"][0]]]
    return changed(content, law=[["2", "1/10"]])


def undamped(second):
    """The undamped motion, called one with air, with powers whose error is so wrong that it counts as less than 0."""
    content = examples.turning("undamped")
    for p in content["pieces"]:
        scale, m = Fraction(p["scale"]), 0 if p["kind"] == "pass" else 1
        v = {n - 1 - m: n * int(c) for n, c in p["y"] if n}[0] / scale
        first = round(v * v / 2 ** content["bits"])
        p["powers"] = [[[0, str(first)], [1, str(second(first))]]]
    return changed(content, law=[["2", "1/10"]])


# ---------------------------------------------------------------- motions of equations that are none of ours


def power_of(a, v):
    w = {}
    for j in v:
        _power(a, v, w, j)
    return w


def of_another_force(force, a, degree=40, e=Fraction(1, 10)):
    """(P, V, V^a) with P'' + P + e force(V, V^a) = 0 from rest at 1, in powers of the time, by iteration."""
    v = {k: arb(1 if k == 0 else 0) for k in range(degree)}
    for _ in range(60):
        f = force(power_of(a, v))
        y = {0: arb(1), 1: arb(0)}
        for k in range(degree):
            pull = arb(to_fmpq(e)) * f.get(k, arb(0))
            y[k + 2] = ((pull - y[k]) / ((k + 1) * (k + 2))).mid()
        v = {k: -(k + 2) * y[k + 2] for k in range(degree)}
    return y, v, power_of(a, v)


def one_piece(a, force, shift, root=1):
    """A certificate of one piece that leaves, its state claimed to ten digits; the powers given are the force."""
    with ctx.workprec(200):
        y, v, w = of_another_force(force, a)
        S, f = Fraction(1, 2), force(w)
        s = arb(to_fmpq(S))
        given = {n - shift: rational(c * s**n) for n, c in f.items() if n >= shift}
        p = {n: rational(c * s**n) for n, c in y.items() if n != 1}
        end = sum(p.values())
        claim = {"kind": "state", "digits": 10, "t": "1/2", "x": f"{float(end):.10f}", "v": None}
    return whole([[str(a), "1/10"]], ["1", "0"], [packed("leave", S, p, [given])], [claim], root=root)


def root_taken_as_none():
    return one_piece(Fraction(1, 2), lambda w: {n: c * arb(0.5).sqrt() for n, c in w.items()}, 0)


def growing_power():
    """The force (1 + s/2) |x'|^2/10, which begins like the power: W is V^2 at u = 0 only."""

    def force(w):
        return {k + 2: w.get(k, arb(0)) + w.get(k - 1, arb(0)) / 2 for k in range(38)}

    return one_piece(Fraction(2), force, 2)


def pushed_off():
    """A start with the speed -1/10, called rest: its series in s has a power between 0 and 2 q for q = 2."""
    content = examples.state("pushed", "1", "2", digits=8)
    first = content["pieces"][0]
    equation = Equation(((Fraction(1), Fraction(1, 10)),), Fraction(1), Fraction(1), Fraction(-1, 10))
    length = 2 * Fraction(first["scale"])
    with ctx.workprec(200):
        series = in_motion(equation, arb(1), arb(-1) / 10, 40)
        roots = PowerSeries(2, 2, {2 * n: c for n, c in series.y.items()}, series.v, ({},))
        leave = piece("leave", roots, equation, length, content["bits"])
    return changed(content, start=["1", "0"], root=2, pieces=[leave, *content["pieces"][1:]])


def gaining():
    """x'' - 2 x' + x = 0: motions part; the certificate follows one that begins 3/10 of a unit of the claim beside."""
    unit = Fraction(1, 1000)
    equation = Equation(((Fraction(1), Fraction(-2)),), Fraction(1), Fraction(1, 10), Fraction(1))
    plan = Plan(80, 40, -60.0)
    for hundredths in range(100, 150):
        t = Fraction(hundredths, 100)
        with ctx.workprec(150):
            pieces = list(swing(equation, plan, None, None, [t], 1))
        end = [int(c) * n for n, c in pieces[-1]["y"]]
        v = Fraction(sum(end), 2**80) / Fraction(pieces[-1]["scale"])
        if abs(v - round(v, 2)) < unit / 10 * 2:
            claim = {"kind": "state", "digits": 3, "t": str(t), "x": None, "v": f"{float(round(v, 2)):.2f}"}
            return whole([["1", "-2"]], ["1/10", str(1 + unit * 3)], pieces, [claim])
    raise AssertionError


# ---------------------------------------------------------------- turning points that are missing, or none


def without_one():
    """Without the piece that arrives at turning point 1, a thousandth before it: the next one is called number 1."""
    there = [{"kind": "turning point", "number": n, "digits": 8, "x": None, "t": None} for n in (1, 2)]
    before = {"kind": "state", "digits": 8, "t": "6291/2000", "x": None, "v": None}
    content = certificate(examples.OSCILLATORS["quadratic"], [*there, before]).content[0]
    at = next(i for i, p in enumerate(content["pieces"]) if p["kind"] == "arrive")
    pieces = [p for i, p in enumerate(content["pieces"]) if i != at]
    claim = {"kind": "turning point", "number": 1, "digits": 1, "x": "0.8", "t": None}
    return changed(content, pieces=pieces, claims=[claim])


def under_another_name():
    content = without_one()
    seen = next(i for i, p in enumerate(content["pieces"]) if i and p["kind"] == "leave")
    content["pieces"][seen] = {**content["pieces"][seen], "kind": "set out"}
    return content


def kicked_up():
    """A start that moves up at first, and a motion that starts downwards: turning point 0 is missing."""
    content = examples.turning("downwards", 1, 3)
    claim = {"kind": "turning point", "number": 0, "digits": 1, "x": "-0.9", "t": None}
    return changed(content, start=["1", "1/1000"], claims=[claim])


def kicked_up_in_one():
    """The same with a piece that is faster in its middle than the error, and slower at its beginning."""
    content = examples.turning("from there", 1, 3)
    S, slow = Fraction(1, 100), Fraction(1, 10_000)
    first = packed(
        "pass", S, {0: 1 - slow * S - S**2 / 2, 1: -slow * S - S**2, 2: -(S**2) / 2}, [None], content["bits"]
    )
    claim = {"kind": "turning point", "number": 0, "digits": 1, "x": "-0.9", "t": None}
    return changed(content, start=["1", "1/1000"], claims=[claim], pieces=[first, *content["pieces"]])


def before_it_rests():
    """Dry friction H and 1/(2 a) |v|v: y = y_T - a s^2/2 is exact and rests before the centre, the motion later.

    With an error of more than a the deceleration g is not shown; the time of the rest would end before y's.
    """
    a, S, H = Fraction(1, 100), Fraction(3, 2), Fraction(1, 20)
    moving = Oscillator({0: H, 2: 1 / (2 * a)}, x0="-76/1000")
    content = of_states(moving, [("5/4", reference_motion(moving, "5/4", 5))], 5).content[0]
    places = {0: a - H, 2: -a * S**2 / 2}
    arrive = packed("arrive", S, places, [None, {0: (a * S) ** 2}], content["bits"])
    claim = {"kind": "turning point", "number": 1, "digits": 1, "x": None, "t": "-2"}
    return changed(content, pieces=[*content["pieces"], arrive], claims=[claim])


def backwards():
    """A wrong strength; a piece that runs backwards, with a bump, takes its error away again."""
    content = examples.state("linear", "1", "2", digits=8)
    at = next(i for i, p in enumerate(content["pieces"]) if p["kind"] == "pass")
    good = content["pieces"][at]
    there = {n: int(c) * (-1) ** n for n, c in good["y"]}
    bump = 2 ** content["bits"] // 33
    for n, c in ((0, bump), (2, -2 * bump), (4, bump)):
        there[n] = there.get(n, 0) + c
    back = {**good, "scale": "-" + good["scale"], "y": [[n, str(c)] for n, c in sorted(there.items())]}
    pieces = [*content["pieces"][: at + 1], back, *content["pieces"][at:]]
    return changed(content, law=[["1", "101/1000"]], pieces=pieces)


def held_or_not():
    """Dry friction from 3 H + 1/1000: it leaves again; y begins at 3 H - 1/1000 and stays."""
    content = examples.turning("held", 3, 3)
    return changed(content, start=["901/1000", "0"], claims=content["claims"][-1:])


def late():
    """A short piece twice: y turns so much later than the motion, just beyond the end of a rounding."""
    edge = Fraction("3.1465")
    content, at = with_short_piece(edge - TURNS + Fraction(1, 50_000))
    return timed(content, [*content["pieces"][: at + 1], *content["pieces"][at:]], "3.147", 4)


def early():
    """A short piece left out: y turns so much earlier than the motion, just before the beginning of a rounding."""
    edge = Fraction("3.145")
    content, at = with_short_piece(TURNS - edge + Fraction(1, 50_000))
    return timed(content, [p for i, p in enumerate(content["pieces"]) if i != at], "3.14", 3)


TURNS = Fraction("3.14622255601")  # of turning point 1 of "quadratic"


def with_short_piece(length):
    oscillator, times = examples.OSCILLATORS["quadratic"], [Fraction(2), 2 + length, Fraction(4)]
    states = [(t, reference_motion(oscillator, t, 8)) for t in times]
    content = of_states(oscillator, states, 8).content[0]
    at = next(i for i, p in enumerate(content["pieces"]) if p["kind"] == "pass" and 2 * Fraction(p["scale"]) == length)
    return content, at


def timed(content, pieces, d, digits):
    claim = {"kind": "turning point", "number": 1, "digits": digits, "x": None, "t": d}
    return changed(content, pieces=pieces, claims=[claim])


def rounded_down():
    """A motion of 2e-25 at a speed of 4e22: its error is less than the last place in which errors are kept."""
    S, bits = Fraction(1, 10**25), 8
    p = {"kind": "pass", "scale": str(S), "y": [[0, "256"], [1, "-1"]], "powers": []}
    v = -1 / (S * 2**bits)
    claim = {"kind": "state", "digits": 60, "t": str(2 * S), "x": None, "v": str(v)}
    return whole([], [str(1 + Fraction(1, 256)), str(v)], [p], [claim], bits=bits)


def one_claim(name, **keys):
    content = examples.turning(name)
    return changed(content, claims=[{**content["claims"][1], **keys}])


def with_extra_key():
    return changed(examples.turning("sum"), spring="1/10")


def twice_the_law():
    """The text of a file with two laws, of which the last one is taken."""
    return '{"law":[["3","1/10"]],' + json.dumps(examples.turning("sum"))[1:]


def two_coefficients():
    content = examples.turning("sum")
    y = content["pieces"][0]["y"]
    y.insert(1, [y[1][0], "12345"])
    return content


def flat():
    """V_low = 0 exactly."""
    p = {0: 1, 2: Fraction(-3, 8), 3: Fraction(1, 4)}
    return whole([["2", "1/10"]], ["1", "0"], [packed("leave", 1, p, [{0: Fraction(1, 2)}])], [EXISTS])


def apart():
    """Powers of 1001/1000 that are 3^(1/1000) times too large: a true bound, not as near as the checker asks for."""
    content = examples.turning("near one", 2, 3)
    for p in content["pieces"]:
        p["powers"] = [[[n, str(int(c) * 10011 // 10000)] for n, c in p["powers"][0]]]
    return changed(content, claims=[{**EXISTS, "number": 1}])


def state_before_the_stop():
    content = examples.turning("held", 3, 3)
    claim = {"kind": "state", "digits": 3, "t": "1/2", "x": content["claims"][1]["x"], "v": "0"}
    return changed(content, claims=[claim])


def times_since_the_start():
    """The time of turning point 1 counted from the start in motion, not from turning point 0."""
    content = examples.turning("in motion")
    first = examples.time_of_first(content)
    return changed(content, claims=[{**content["claims"][1], "digits": 5, "t": first, "x": None}])


def stiff_start():
    return started("stiff", "501/1000")


def soft_start():
    """k = 1/100: the place is off by ten times the error of the speed."""
    return started("soft", "1001/1000")


def started(name, place):
    """From another place, with the state of the first one claimed to as many digits as the error seems to leave."""
    # Beside the stiff spring where the speed tells the jump, which it does a quarter of a period later.
    for t in ("1/2", "4/5", "11/10", "7/5") if name == "stiff" else [f"{n}/6" for n in range(1, 40)]:
        content = examples.state(name, t, digits=8)
        claim = content["claims"][0]
        shown = "x" if name == "soft" else "v"
        text = f"{float(claim[shown]):.3g}"
        unit = 10 ** -len(text.partition(".")[2])
        if len(text) >= 5 and abs(float(claim[shown]) - float(text)) < 0.2 * unit:
            given = {"x": None, "v": None, shown: text, "digits": 3}
            return changed(content, start=[place, content["start"][1]], claims=[{**claim, **given}])
    raise AssertionError


def other_law_of_a_state():
    return changed(examples.state("sum", "2"), law=[["1", "1/20"], ["2", "1/11"]])


def ten_for_twelve():
    """The rounding to eleven digits, called one to twelve, of a number whose fraction is as long below as above."""
    for name in examples.OSCILLATORS:
        text = f"{float(examples.turning(name)['claims'][1]['x']):.11f}"
        d = abs(Fraction(text))
        if len(str(d.numerator)) == len(str(d.denominator)) and not text.endswith("0"):
            return one_claim(name, x=text, t=None)
    raise AssertionError


def in_thirds():
    return changed(rounded_down(), claims=[{**rounded_down()["claims"][0], "v": None}])


def falling():
    """x'' + x + 1/(1000 x') = 0."""
    S = Fraction(1, 100)
    return whole([["-1", "1/1000"]], ["1", "-1/2"], [packed("pass", S, {0: 1, 1: -S / 2}, [{0: 2}])], [EXISTS])


def without_times(content):
    return changed(content, claims=[{**claim, "t": None} for claim in content["claims"]])
