"""What the data still allow beside the law of the verdict: the largest strength of each further term.

A term is not needed when its interval holds 0.  That does not exclude it: the end of the interval in the law with that
term added says how strong it may be, and its share what it may then carry, compared with the loss of the law at the
first amplitude.

>>> str(Allowance("2", 0.0123, 0.034)), str(Allowance("s3", None))
('2 up to 0.012 (3.4 %)', 's3 without limit')
>>> str(Allowance("2", 0.46, 1.19))  # more than the law without it loses: no share of anything
'2 up to 0.46 (all of it)'
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from asymptotics.decays.identification.forward.coefficients import Element, swing_coefficients
from asymptotics.decays.identification.judging.laws import Judged
from asymptotics.present.percent import percent
from asymptotics.present.shown import Shown

WEAK = 0.2
"""The share of the loss from which on a term that is not excluded makes the verdict too weak for one law.  A choice: a
smaller one says "several" more often, and the share itself is told either way."""


@dataclass(frozen=True, repr=False)
class Allowance(Shown):
    """``term``: beside the law; ``largest``: the end of its 95 % interval (None: no limit); ``share``: of the loss of
    the law at the first amplitude, to first order (None for springs)."""

    term: str
    largest: float | None
    share: float | None = None

    def __str__(self) -> str:
        if self.largest is None:
            return f"{self.term} without limit"
        part = "" if self.share is None else f" ({percent(self.share) if self.share < 1 else 'all of it'})"
        return f"{self.term} up to {self.largest:.2g}{part}"

    def to_dict(self) -> dict[str, str | None]:
        """JSON-ready: numbers are strings."""
        numbers = {"largest": self.largest, "share": self.share}
        return {"term": self.term, **{k: None if v is None else f"{v:.4g}" for k, v in numbers.items()}}


def allowance_text(allowed: Sequence[Allowance], how: str = "95 %") -> str:
    """The end of a verdict in words; ``how``: what the ends of the intervals are."""
    if not allowed:
        return ""
    shares = "; in brackets the share of the loss at the first amplitude" if any(a.share for a in allowed) else ""
    return f"; not excluded beside it ({how}{shares}): {', '.join(map(str, allowed))}"


def allowances(chosen: Judged, laws: Sequence[Judged], first: float | None) -> tuple[Allowance, ...]:
    """One for each term that stands alone beside ``chosen`` in a consistent law; ``first``: the first amplitude."""
    found = []
    for law in laws:
        further = set(law.candidate.elements) - set(chosen.candidate.elements)
        # A law with a fitted exponent is no extension of one whose exponent is given.
        alike = law.candidate.free == chosen.candidate.free and chosen.candidate.is_within(law.candidate)
        if law.verdict == "consistent" and alike and len(further) == 1:
            found.append(_allowance(chosen, law, next(iter(further)), first))
    # A loss is not negative: a term whose whole interval is, is excluded.
    found = [allowed for allowed in found if allowed.largest is None or allowed.largest > 0]
    return (*found, *_instead_of_sine(chosen, laws))


def _instead_of_sine(chosen: Judged, laws: Sequence[Judged]) -> tuple[Allowance, ...]:
    """By what the spring of a pendulum may deviate: the coefficients of the smallest consistent spring in its place."""
    alike = [
        law
        for law in laws
        if chosen.candidate.pendulum and law.candidate.losses == chosen.candidate.losses and law.candidate.springs
    ]
    standing = [law for law in alike if law.verdict == "consistent"]
    # The cubic alone if it will do: with x^5 beside it, its coefficient has a wider interval.
    law = min(standing, key=lambda law: len(law.candidate.springs), default=None)
    if law is None:
        return ()
    found = (_allowance(chosen, law, element, None) for element in law.candidate.elements if element.kind == "spring")
    return tuple(replace(a, term=f"{a.term} in place of sin x") for a in found)


def _allowance(chosen: Judged, law: Judged, term: Element, first: float | None) -> Allowance:
    candidate, strengths = law.candidate, dict(law.strengths)
    name = (*candidate.alphas, *(f"s{p}" for p in candidate.springs))[candidate.elements.index(term)]
    ends = strengths.get(name)
    # A law that is consistent by the point of a smaller one alone has no intervals.
    if ends is None or ends.low is None or ends.high is None:
        return Allowance(name, None)
    if term.kind == "spring":
        return Allowance(name, max(abs(ends.low), abs(ends.high)))
    largest = ends.high
    if first is None or law.candidate.free:
        return Allowance(name, largest)
    own = _first_order(term) * first**term.weight * largest
    losses = zip(chosen.candidate.elements, chosen.epsilon)  # losses stand first
    total = sum(_first_order(e) * first**e.weight * ends.estimate for e, ends in losses)
    return Allowance(name, largest, own / total if total > 0 else None)


def _first_order(term: Element) -> float:
    # L = -J delta + ..., the same for all amplitudes.
    return -float(swing_coefficients((term,), 1).L[0, 1])
