"""Correctly rounded decimals of L, F, T and of the slow flow U, V, W, p, Omega in the turning-point gauge, any alpha >=
0.

The half-swing comes in balls from ``expansions.half_swings.certified_zeros``, the flow from it by ``flow.flow_of``.

Zero by theorem, and therefore "0" or absent, besides what `certified_zeros` lists: U in even and W in odd loss degree
(t → −t with epsilon → −epsilon); for linear friction alone p = epsilon/2; and what would carry a negative power of the
amplitude if all exponents are integers (`certified_zeros`), which is how U = −(2/pi)delta for dry friction stops.  A
coefficient that vanishes for a reason not known here, or that is exactly half way between two decimals, cannot be
rounded from balls: UndecidedError names it (odd alpha and few digits: take the exact engine).

>>> from asymptotics.numbers.exact import parse_real
>>> three_halves = certified_digits([parse_real("3/2", "--alpha")], 3, 20)
>>> three_halves["p"]
{(1,): '0.45765585810108791284', (3,): '0.0016147792023822891647'}
>>> certified_digits([parse_real("0", "--alpha")], 3, 10)["U"]
{(1,): '-0.6366197724', (2,): '0', (3,): '0'}
"""

from collections.abc import Callable, Mapping, Sequence

from flint import arb

from asymptotics.expansions.half_swings.certified import MAX_SECONDS
from asymptotics.expansions.half_swings.certified_zeros import (
    certified_half_swing,
    dry_friction_cancels,
    is_linear_friction,
    negative_power,
    without,
)
from asymptotics.expansions.half_swings.forces import Forces, Given
from asymptotics.expansions.half_swings.quarter import HalfSwing
from asymptotics.expansions.normal_form.flow import flow_of
from asymptotics.numbers.decimals import bits_for, decimal_of_ball
from asymptotics.numbers.precision import TooWideError, at_growing_precision
from asymptotics.running.budget import tick
from asymptotics.series import Key, Series, monomials

MAX_RAISE = 6
"""How many times the first working precision is tried before a coefficient counts as undecided."""

Digits = dict[str, dict[Key, str]]


def certified_digits(
    given: Given,
    order: int,
    digits: int,
    *,
    max_seconds: float = MAX_SECONDS,
    names: Sequence[str] | None = None,
    known: Mapping[str, Mapping[Key, str]] | None = None,
) -> Digits:
    """Every coefficient through ``order`` to ``digits`` significant digits, correctly rounded and proved to be.

    Names: L, T, U, W, p (odd degrees), Omega (even degrees from 2 on), and F_i, V_i for each law i = 0, 1, …;
    keys are multi-indices; ``names`` selects some.  UndecidedError names the coefficient that could not be decided.
    """
    forces = Forces.read(given, order)

    def evaluate() -> dict[str, Series]:
        series = expansions(forces, order, max_seconds)
        return {name: series[name] for name in names or series}

    return round_all(evaluate, digits, 4 * order + 32, known or {}, forces)


def expansions(given: Given, order: int, max_seconds: float = MAX_SECONDS) -> dict[str, Series]:
    """The same as balls at the current precision, zeros by theorem absent."""
    forces = Forces.read(given, order)
    half = certified_half_swing(forces, order, max_seconds=max_seconds)
    U, W = _flow(half, forces)
    inverse, l = W.inverse(), forces.loss_degree  # noqa: E741 (the letter of ``grading``)
    per_law = {f"F_{i}": f for i, f in enumerate(half.F)}
    for i, weight in enumerate(half.grading.weights):
        per_law[f"V_{i}"] = (U * weight).shift(i).truncate(order)
    # Products of balls that hold 0 are balls again: the zeros of p and Omega are taken out once more.
    p = without(-(U * inverse), lambda n: l(n) % 2 == 0 or (sum(n) > 1 and is_linear_friction(forces, n)))
    Omega = without(inverse, lambda n: l(n) % 2 == 1)
    return {"L": half.L, "T": half.T, "U": U, "W": W, "p": p, "Omega": Omega.without_constant(), **per_law}


def _flow(half: HalfSwing, forces: Forces) -> tuple[Series, Series]:
    """U and W of the half-swing, zeros by theorem absent."""
    flow = flow_of(half)
    # The field a U carries the power a_n + 1 of a, W the power a_n (``certified_zeros``, integer exponents).
    U = without(flow.U, lambda n: negative_power(forces, n, 1))
    W = without(flow.W, lambda n: negative_power(forces, n, 0) or dry_friction_cancels(forces, n))
    return U, W


def round_all(
    evaluate: Callable[[], Mapping[str, Series]],
    digits: int,
    guard: int,
    known: Mapping[str, Mapping[Key, str]],
    forces: Forces,
) -> Digits:
    """Raise the precision by what is missing until every coefficient of every series is rounded.

    UndecidedError names the first that is not, with its ball.
    ``known``: decimals that another arithmetic has decided (zeros and ties that no ball can).
    """

    def attempt(bits: int) -> Digits:
        tick(f"coefficients at {bits} bits")
        series = evaluate()
        rounded = {name: _round(one, name, digits, known.get(name, {}), forces) for name, one in series.items()}
        # All are rounded before the precision grows: the worst one says by how much.
        open_ones = [(name, n) for name, row in rounded.items() for n, text in row.items() if text is None]
        if not open_ones:
            return {name: {n: text for n, text in row.items() if text} for name, row in rounded.items()}
        name, n = open_ones[0]
        # What the worst ball lacks, with 8 bits for the rounding of the decimal: at least 16 bits more, so that a tie
        # does not creep up to the limit, and at most as many again.
        missing = max(bits_for(digits, 8) - series[name][n].rel_accuracy_bits() for name, n in open_ones)
        reason = f"the enclosure is {series[name][n].str(5)}"
        raise TooWideError(reason, max(16, min(missing, bits)), f"{name}{n}")

    first = bits_for(digits, guard)
    return at_growing_precision(attempt, digits, first, max_bits=MAX_RAISE * first)


def _round(series: Series, name: str, digits: int, known: Mapping[Key, str], forces: Forces) -> dict[Key, str | None]:
    """Decimals of all coefficients, "0" for the absent ones; p in odd and Omega in even loss degrees only."""
    parity = {"p": 1, "Omega": 0}.get(name)
    row: dict[Key, str | None] = {}
    for degree in range(series.order + 1):
        for n in monomials(series.variables, degree):
            value = series[n]
            other = parity is not None and forces.loss_degree(n) % 2 != parity
            if other or (degree == 0 and value == 0):
                continue
            if n in known:
                row[n] = known[n]
                continue
            # Absent is the exact 0, "0". A ball around 0 is no zero:
            # it has no first digit, and None asks for more precision.
            row[n] = decimal_of_ball(arb(value), digits) if value != 0 or not arb(value).is_exact() else "0"
    return row
