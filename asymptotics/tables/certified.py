"""Certificates of tables: the rows that are turning points or times, an equation for each law.

>>> rows = (("3/2:1/10", "0.870193291989", "3.14608217222", "true", ""),)
>>> of_rows("half-periods", ("law", "ratio", "T", "certified", "ended"), rows, 12).proved[1][:37]
'turning point 1: x = -0.870193291989 '
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

from asymptotics.certificates.certificate import Certificate, together
from asymptotics.certificates.claims import Claim, rest_claim
from asymptotics.certificates.of_results import of_claims
from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.running.budget import DEFAULT_SECONDS, seconds_left
from asymptotics.tables.inputs import terms_of_label

Row = Mapping[str, str]


@dataclass
class Claimed:
    """What a table claims of the motion of one oscillator."""

    oscillator: Oscillator
    name: str
    claims: list[Claim] = field(default_factory=list)


def of_rows(
    name: str, columns: Sequence[str], rows: Sequence[Sequence[str]], digits: int, *,
    max_seconds: float = DEFAULT_SECONDS,
) -> Certificate:  # fmt: skip
    """The certificate of a table: all of its laws in one file; what has none is told in ``left``.

    InputError for a table without turning points and times.
    """
    if name not in CLAIMS:
        raise InputError("certificate", f"{name} has neither turning points nor times", ", ".join(CLAIMS))
    claimed: dict[str, Claimed] = {}
    left: list[str] = []
    for cells in rows:
        row = dict(zip(columns, cells))
        if row.get("certified", "true") != "true":
            left.append(f"{row['law']}: an estimate")
            continue
        try:
            for key, oscillator, claim in CLAIMS[name](row, digits):
                claimed.setdefault(key, Claimed(oscillator, key)).claims.append(claim)
        except InputError as refused:
            left.append(f"{row['law']}: {refused.reason}")
    made = []
    for each in claimed.values():
        try:
            one = of_claims(each.oscillator, each.claims, max_seconds=min(max_seconds, seconds_left()))
            made.append(replace(one, left=tuple(f"{each.name}: {line}" for line in one.left)))
        except InputError as refused:
            if refused.argument != "certificate":
                raise
            left.append(f"{each.name}: {refused.reason}")
    return together(made, dict.fromkeys([*left, *LEFT.get(name, ())]))


def _turning_points(row: Row, digits: int) -> Iterator[tuple[str, Oscillator, Claim]]:
    law, n = row["law"], int(row["n"])
    yield law, _oscillator(law), _turned(n, row["x"], row["tau"], digits)
    if row["ended"] == "sticks":
        yield law, _oscillator(law), rest_claim(n)


def _half_periods(row: Row, digits: int) -> Iterator[tuple[str, Oscillator, Claim]]:
    if row["ratio"]:  # none where the motion has no second turning point
        x = row["ratio"] if row["ratio"] == "0" else f"-{row['ratio']}"
        yield row["law"], _oscillator(row["law"]), _turned(1, x, row["T"], digits)


def _stops(row: Row, digits: int) -> Iterator[tuple[str, Oscillator, Claim]]:
    law, n = f"0:{row['epsilon']}", int(row["N"])
    yield law, _oscillator(law), _turned(n, row["x_N"], row["tau_N"], digits)
    yield law, _oscillator(law), rest_claim(n)


def _smith_table_1(row: Row, digits: int) -> Iterator[tuple[str, Oscillator, Claim]]:
    start = row.get("u_0", "1")
    yield f"u_0 = {start}", Oscillator({2: 1}, x0=start), _turned(int(row["half_cycle"]) - 1, row["u"], None, digits)


def _turned(n: int, x: str, t: str | None, digits: int) -> Claim:
    return {"kind": "turning point", "number": n, "digits": digits, "x": x, "t": t}


def _oscillator(law: str) -> Oscillator:
    """A law as the tables write it."""
    found: dict[str | tuple[str, int], str] = {}
    for term in terms_of_label(law):
        if term.startswith("spring"):
            raise InputError("certificate", "beside a spring two motions may part", "powers of the velocity")
        exponents, _, strength = term.partition(":")
        velocity, _, place = exponents.partition(",")
        found[(velocity, int(place)) if place else velocity] = strength
    return Oscillator(Law(found))


CLAIMS: dict[str, Callable[[Row, int], Iterator[tuple[str, Oscillator, Claim]]]] = {
    "turning-points": _turning_points,
    "half-periods": _half_periods,
    "stops": _stops,
    "smith2012.table1": _smith_table_1,
}
LEFT = {"smith2012.table1": ("S_hat: a constant of the motion, which is neither a place nor a time",)}
