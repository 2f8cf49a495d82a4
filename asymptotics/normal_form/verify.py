"""What an expansion can say of itself: exact residuals, and a measured order of convergence.

Three checks, in falling strength:

* ``map_residual``: the time-pi map of the flow, carried back to the turning points, against a half-swing found another
  way: L and T agree through order N, hence exp(pi V) - F = O(delta^(N+2)).
* ``equation_residual``: for odd exponents, the residual of the waveform in the equation of motion, zero through order N
  in every gauge.
* ``measured_order``: heuristic, in doubles.  The truncated L and T against a half-swing integrated numerically in
  theta: the error falls like delta^(N+1) or faster.

>>> from asymptotics.normal_form.expansion import exact_expansion
>>> expansion = exact_expansion((3,), 4, "averaging")
>>> map_residual(expansion, exact_reference((3,), 4)), equation_residual((3,), 4, "averaging")
(<Outcome.CONFIRMED: 'confirmed'>, <Outcome.CONFIRMED: 'confirmed'>)
>>> map_residual(expansion, exact_reference((5,), 4))
<Outcome.REFUTED: 'refuted'>
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import cos, log, pi, sin
from typing import Any

import numpy as np
from flint import arb, fmpq, fmpq_poly
from scipy.integrate import solve_ivp

from asymptotics.half_swings.exact import exact_quarter_swing
from asymptotics.half_swings.fourier_flow import FourierFlow, fourier_flow
from asymptotics.half_swings.grading import may_vanish
from asymptotics.half_swings.pi_ring import PiNumber
from asymptotics.half_swings.quarter import HalfSwing, half_swing
from asymptotics.normal_form.expansion import Expansion
from asymptotics.series import Series
from asymptotics.verdict import Outcome


@dataclass(frozen=True)
class Verification:
    """``residual``: the map residual; ``residual_order``: the order through which L and T agree, plus one.

    ``exact`` tells an exact residual from one by balls; ``measured_order`` is heuristic, nan if it was not measurable.
    """

    residual: Outcome
    residual_order: int
    exact: bool
    measured_order: float


def verify(expansion: Expansion, reference: HalfSwing | None = None) -> Verification:
    """Check an expansion against a half-swing: ``reference``, or by default the one it was built from."""
    target = expansion.half if reference is None else reference
    order = residual_order(expansion, target)
    good = map_residual(expansion, target)
    return Verification(good, order, expansion.arithmetic == "exact", measured_order(expansion))


def exact_reference(alphas: tuple[int, ...], order: int) -> HalfSwing:
    """The half-swing by polynomials in theta and the reversal identity: independent of the even and odd routes."""
    return half_swing(exact_quarter_swing(alphas, order))


def _differences(expansion: Expansion, reference: HalfSwing) -> list[Series]:
    half = expansion.turning_point_flow().half_swing(expansion.pi)
    return [half.L - reference.L, half.T - reference.T]


def residual_order(expansion: Expansion, reference: HalfSwing) -> int:
    """The lowest degree at which L or T certainly differ; one more than the order known if there is none."""
    series = _differences(expansion, reference)
    bad = [sum(k) for s in series for k, c in s.coefficients.items() if not may_vanish(c)]
    return min(bad, default=min(s.order for s in series) + 1)


def map_residual(expansion: Expansion, reference: HalfSwing) -> Outcome:
    """CONFIRMED if exp(pi V) - F vanishes through the order (exactly, or in narrow balls around 0)."""
    if residual_order(expansion, reference) <= expansion.order:
        return Outcome.REFUTED
    wide = arb(10) ** -10
    balls = [c for s in _differences(expansion, reference) for c in s.coefficients.values() if isinstance(c, arb)]
    return Outcome.CONFIRMED if all(bool(c.rad() < wide) for c in balls) else Outcome.UNDECIDED


def equation_residual(alphas: tuple[int, ...], order: int, gauge: str) -> Outcome:
    """The residual of (d_psi + D_1 + i) Z = i W (Z + Phi) for odd exponents, formed afresh from Z, U and W.

    The recurrence of ``fourier_flow`` never forms the full series; here whole series are multiplied and subtracted.
    """
    flow = fourier_flow(alphas, order, gauge)
    residual = _waveform_residual(alphas, flow)
    zero = all(c == 0 for c in residual.coefficients.values())
    return Outcome.CONFIRMED if zero else Outcome.REFUTED


def _waveform_residual(alphas: tuple[int, ...], flow: FourierFlow) -> Series:
    """(2 q d_q + D^_1 + 1) Z - W^ (Z + Phi^), each coefficient of degree n times q^(shift n + 1)."""
    M, variables, order = flow.shift, len(alphas), flow.U.order
    Z = Series({k: p for part in flow.Z for k, p in part.items()}, variables, order)
    rotation = Z.map_keys(lambda k, p: 2 * (p.derivative().left_shift(1) - M * sum(k) * p))
    growth = Z + flow.grading.weighted(Z)
    U = _shifted(flow.U, 1, M)
    W = _shifted(flow.W, 0, M)
    mirrored = Z.map_keys(lambda k, p: (-1) ** sum(k) * _mirror(p, 2 * M * sum(k)))
    Y = Z.map(lambda p: p.left_shift(1)) - mirrored
    phi = Series({}, variables, order)
    for i, a in enumerate(alphas):
        phi = phi + _force(Y, i, a, M)
    return rotation + U * growth + Z - W * (Z + phi)


def _force(Y: Series, i: int, a: int, M: int) -> Series:
    """The term of Phi^ that belongs to the odd exponent a of the i-th law."""
    half = (a + 1) // 2
    scale = fmpq((-1) ** half, 2**a)
    return (Y**a).shift(i).truncate(Y.order).map(lambda p: (p * scale).left_shift(M - half))


def _shifted(series: Series, parity: int, M: int) -> Series:
    """f^(eta) with the same shift q^(M n) as the waveform."""

    def lifted(key: tuple[int, ...], c: PiNumber) -> fmpq_poly:
        n = sum(key)
        return fmpq_poly([c.as_rational() * (-1) ** ((n - parity) // 2)]).left_shift(M * n)

    return series.map_keys(lifted)


def _mirror(p: fmpq_poly, degree: int) -> fmpq_poly:
    return sum((c * fmpq_poly([0, 1]) ** (degree - m) for m, c in enumerate(p.coeffs()) if c != 0), start=fmpq_poly([]))


def numerical_half_swing(alphas: Sequence[float], deltas: Sequence[float]) -> tuple[float, float]:
    """(L, T) from integrating d ln r/d theta and d tau/d theta in doubles: heuristic, for measuring orders."""

    def slopes(theta: float, state: np.ndarray) -> list[float]:
        s, c = abs(sin(theta)), cos(theta)
        n = sum(d * np.exp((a - 1) * state[0]) * s**a for a, d in zip(alphas, deltas))
        return [-n * s / (1 - n * c), n * c / (1 - n * c)]

    run = solve_ivp(slopes, (0.0, pi), [0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-15)
    return float(run.y[0, -1]), pi + float(run.y[1, -1])


def measured_order(expansion: Expansion, levels: int = 8) -> float:
    """The slope of ln(error) against ln(delta), errors of L and T together, all delta_i equal; nan if not measurable.

    delta runs through 0.3, 0.3/sqrt(2), ...; of the errors above rounding the smallest pair is used.
    """
    half = expansion.turning_point_flow().half_swing(expansion.pi)
    alphas = [_float(d) for d in expansion.degrees]
    found = []
    for j in range(levels):
        delta = 0.3 * 2 ** (-j / 2)
        L, T = numerical_half_swing(alphas, [delta] * len(alphas))
        error = abs(L - _at(half.L, delta)) + abs(T - _at(half.T, delta))
        if error > 1e-11:
            found.append((delta, error))
    if len(found) < 2:
        return float("nan")
    (d1, e1), (d2, e2) = found[-2:]
    return log(e1 / e2) / log(d1 / d2)


def _at(series: Series, delta: float) -> float:
    return sum(_float(c) * delta ** sum(k) for k, c in series.coefficients.items())


def _float(c: Any) -> float:
    return float((c.ball() if isinstance(c, PiNumber) else arb(c)).mid())
