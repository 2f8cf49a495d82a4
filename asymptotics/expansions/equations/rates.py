"""The right sides of the equations evaluated: doubles and arrays, or mpmath numbers; heuristic.

Apart from the equations themselves, so that they are made and printed without NumPy, which takes long to load.

>>> law = rates([((1,), 0.5)], [((2,), -0.125)], ([0.1], [1.0], 1), "numpy")       # p, Omega, what delta is
>>> law(np.array([1.0, 0.5]))
(array([-0.05  , -0.0125]), array([0.99875  , 0.9996875]))
"""

from collections.abc import Callable
from typing import Any

import mpmath
import numpy as np
from flint import arb

from asymptotics.errors import InputError
from asymptotics.expansions.equations.row import sum_at
from asymptotics.expansions.equations.strengths import Strengths
from asymptotics.numbers.arrays import real_array
from asymptotics.numbers.context import ctx
from asymptotics.numbers.policy import exact_number
from asymptotics.series import Key

Terms = list[tuple[Key, Any]]


def rates(
    p: Terms, Omega: Terms, strengths: tuple[list[Any], list[Any], Any], modules: str
) -> Callable[..., tuple[Any, Any]]:
    """``f(A, psi) -> (-scale A p(delta), scale (1 + Omega(delta)))``; strengths (b, w, scale) say delta = b A^w."""
    factors, weights, scale = strengths

    def found(A: Any, psi: Any = 0.0) -> tuple[Any, Any]:
        amplitude = _amplitudes(A) if modules == "numpy" else _mpmath_amplitude(A)
        with np.errstate(all="ignore"):  # out of the range of doubles is inf or nan, as in NumPy itself
            deltas = [s * amplitude**w for s, w in zip(factors, weights)]
            both = -scale * amplitude * sum_at(p, deltas), scale * (1 + sum_at(Omega, deltas))
        # A number in gives Python's numbers out; an array gives arrays.
        return tuple(map(float, both)) if isinstance(amplitude, np.float64) else both  # type: ignore[return-value]

    return found


def strengths_in(modules: str, given: Strengths, epsilon: Any) -> tuple[list[Any], list[Any], Any]:
    """The strengths as ``rates`` takes them: doubles, or mpmath numbers at the precision in force."""
    return given.numbers(epsilon) if modules == "numpy" else given.numbers(epsilon, as_mpf)


def as_mpf(x: arb) -> Any:
    """The midpoint at mpmath's precision; the ball is made at that precision by the caller's context."""
    with ctx.workprec(mpmath.mp.prec + 20):
        # Twenty bits and five digits beyond mpmath's precision, so that only its own rounding is seen.
        return mpmath.mpf(x.mid().str(mpmath.mp.dps + 5, radius=False))


def state_of(y: Any) -> Any:
    """(A, psi) as an array of two doubles; InputError for anything else."""
    state = real_array(y, "y")
    if state.shape != (2,):
        raise InputError("y", f"its shape is {state.shape}", "the two numbers A, psi")
    return state


def _amplitudes(A: Any) -> Any:
    """A number or array of doubles >= 0 (NaN stays); InputError for anything else."""
    values = real_array(A, "A")
    if np.any(values < 0):
        raise InputError("A", f"{values[values < 0].flat[0]:g} is negative", "amplitudes >= 0")
    return values if values.ndim else np.float64(values)


def _mpmath_amplitude(A: Any) -> Any:
    """An mpmath number as it is, at the precision in force; anything else is read exactly first."""
    return A if isinstance(A, mpmath.mpf) else as_mpf(exact_number(A, "A").ball())
