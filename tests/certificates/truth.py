"""Which claims of a certificate are false, by the library's own certified answers: the other route."""

from fractions import Fraction

from asymptotics import turning_points
from asymptotics.law import Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.numbers.digits import ends


def oscillator_of(content):
    """The motion of a certificate; strengths of equal exponents add up."""
    x0, v0 = content["start"]
    law = {}
    for a, e in content["law"]:
        law[Fraction(a)] = law.get(Fraction(a), 0) + Fraction(e)
    return Oscillator(law or {2: 0}, stiffness=Fraction(content["stiffness"]), x0=Fraction(x0), v0=Fraction(v0))


def false_claims(content):
    """The claims that the library's digits contradict, each compared with eight digits more."""
    oscillator, found = oscillator_of(content), []
    for claim in content["claims"]:
        digits = claim.get("digits", 1) + 8
        if claim["kind"] == "state":
            true = reference_motion(oscillator, Fraction(claim["t"]), digits)
            pairs = [(claim["x"], true.x), (claim["v"], true.v)]
        else:
            table = turning_points(oscillator, claim["number"] + 1, digits=digits, times=True)
            there = len(table.points) == claim["number"] + 1
            if claim["kind"] == "rest":
                held = table.ended is not None and table.ended == {"n": claim["number"], "reason": "sticks"}
                found += [] if held else [claim]
                continue
            pairs = [(claim["x"], table.points[-1].x), (claim["t"], table.points[-1].t)] if there else [("1", "2")]
        if not all(_agree(text, true, claim["digits"]) for text, true in pairs):
            found.append(claim)
    return found


def _agree(text, true, digits):
    """Whether the true number, printed to more digits, may be within half a unit of the claimed one."""
    if text is None:
        return True
    d, (low, high) = Fraction(text), ends(true)
    if d == 0 or Fraction(true) == 0:
        return d == Fraction(true)
    m = next(m for m in range(-2000, 2000) if Fraction(10) ** m > abs(d)) if abs(d) < 1 else len(str(int(abs(d))))
    half = Fraction(10) ** (m - digits) / 2
    return low <= d + half and high >= d - half
