"""What the O() of an expansion holds, proved: on each half-swing (``bounds.local``), and of x for every time.

>>> print(remainder(2, order=2))
proved for d = sum delta_i <= ..., on each half-swing: |L - L_2| <= ... d^3, |T - T_2| <= ... d^4
|x - x_2| <= ... A d^2 for every t >= 0, ...
"""

from dataclasses import dataclass
from typing import Any

from asymptotics.bounds.local import LocalBounds, local_bounds
from asymptotics.bounds.uniform import Displacement, displacement_bound
from asymptotics.errors import InputError
from asymptotics.expansions.equations.given import terms_of
from asymptotics.law import LawLike
from asymptotics.numbers.alike import Alike
from asymptotics.numbers.policy import Number, exact_integer
from asymptotics.present.shown import Shown
from asymptotics.running.public import public

MAX_ORDER = 12


@dataclass(frozen=True, repr=False, eq=False)
class ExpansionBounds(Alike, Shown):
    """``half_swing``: of ln(A'/A) and of the time; ``displacement``: of x, None where an exponent is below 1."""

    half_swing: LocalBounds
    displacement: Displacement | None

    def to_dict(self) -> dict[str, Any]:
        """Decimals rounded up."""
        return self.half_swing.to_dict() | ({} if self.displacement is None else self.displacement.to_dict())

    def __str__(self) -> str:
        return "\n".join(str(part) for part in (self.half_swing, self.displacement) if part is not None)


@public
def remainder(law: LawLike, *, order: int = 4, max_seconds: Number = 60) -> ExpansionBounds:
    """Proved constants of what the expansion of this order leaves out, in the turning-point gauge.

    |L - L_N| <= C_A d^a and |T - T_N| <= C_T d^b on each half-swing, d = sum_i delta_i up to ``delta_max``, L the
    logarithm of the ratio of its amplitudes and T its duration; for exponents >= 1 also |x - x_N| <= C A d^N for every
    t >= 0. Source: derivations ``expansion-bounds``, ``uniform-bound``.

    Parameters
    ----------
    law
        powers of the velocity: an exponent, a list of exponents, a law or an oscillator
    order
        N, 1 to 12
    max_seconds
        the time the call may take, in s

    Returns
    -------
    ExpansionBounds
        ``half_swing`` and ``displacement`` (None where an exponent is below 1): constants, powers, and the range of d

    Raises
    ------
    InputError
        for other forces and an order out of range
    LimitError
        after ``max_seconds``

    Examples
    --------
    >>> remainder(2, order=3).to_dict()["amplitude_power"]
    5
    """
    N = exact_integer(order, "order", 1, MAX_ORDER)
    terms = terms_of(law)[0]
    if not terms or not all(t.is_power_of_velocity for t in terms):
        raise InputError("law", "a bound is known for powers of the velocity alone", "an exponent, or a law of them")
    found = local_bounds([t.velocity for t in terms], N)
    return ExpansionBounds(found, displacement_bound(found.alphas, N))
