"""What an expansion can say of itself: exact residuals, and a measured order of convergence.

Three checks, in falling strength:

* ``map_residual``: the time-pi map of the flow, carried back to the turning points, against a half-swing found another
  way: L and T agree through order N, hence exp(pi V) - F = O(delta^(N+2)).
* ``equation_residual``: for odd exponents, the residual of the waveform in the equation of motion, zero through order N
  in every gauge.
* ``measured_order``: heuristic, in doubles.  The truncated L and T against a half-swing integrated numerically in
  theta: the error falls like delta^(N+1) or faster.

>>> from asymptotics.expansions.normal_form.expansion import exact_expansion
>>> expansion = exact_expansion((3,), 4, "averaging")
>>> map_residual(expansion, exact_reference((3,), 4)), equation_residual((3,), 4, "averaging")
(<Outcome.CONFIRMED: 'confirmed'>, <Outcome.CONFIRMED: 'confirmed'>)
>>> map_residual(expansion, exact_reference((5,), 4))
<Outcome.REFUTED: 'refuted'>
"""

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from math import cos, log, pi, prod, sin
from typing import Any

import numpy as np
from flint import arb, fmpq, fmpq_poly
from scipy.integrate import solve_ivp

from asymptotics.expansions.half_swings.exact import exact_quarter_swing
from asymptotics.expansions.half_swings.forces import Forces, Given, Member
from asymptotics.expansions.half_swings.fourier_flow import FourierFlow, fourier_flow
from asymptotics.expansions.half_swings.grading import may_vanish
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.half_swings.quarter import HalfSwing, half_swing
from asymptotics.expansions.normal_form.expansion import Expansion
from asymptotics.series import Series
from paper_checks.verdict import Outcome


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


def exact_reference(given: Given, order: int) -> HalfSwing:
    """The half-swing by polynomials in theta and the reversal identity: independent of the even and odd routes."""
    return half_swing(exact_quarter_swing(given, order))


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


def equation_residual(given: Given, order: int, gauge: str) -> Outcome:
    """The residual of (d_psi + D_1 + i) Z = i W (Z + Phi) for smooth forces, formed afresh from Z, U and W.

    The recurrence of ``fourier_flow`` never forms the full series; here whole series are multiplied and subtracted.
    """
    forces = Forces.read(given, order)
    residual = _waveform_residual(forces, fourier_flow(forces, order, gauge))
    zero = all(c == 0 for c in residual.coefficients.values())
    return Outcome.CONFIRMED if zero else Outcome.REFUTED


def _waveform_residual(forces: Forces, flow: FourierFlow) -> Series:
    """(2 q d_q + D_hat_1 + 1) Z - W_hat (Z + Phi_hat), each coefficient of degree n times q^(shift n + 1)."""
    M, variables, order, grading = flow.shift, forces.variables, flow.U.order, flow.grading
    Z = Series({k: p for part in flow.Z for k, p in part.items()}, variables, order)
    rotation = Z.map_keys(lambda k, p: 2 * (p.derivative().left_shift(1) - M * sum(k) * p))
    growth = Z + grading.weighted(Z)
    U, W = _shifted(flow, flow.U, 1), _shifted(flow, flow.W, 0)
    mirrored = grading.flip(Z).map_keys(lambda k, p: _mirror(p, 2 * M * sum(k)))
    turned = Z.map(lambda p: p.left_shift(1))
    phi = Series({}, variables, order)
    for member in forces.through(order):
        phi = phi + _force(turned + mirrored, turned - mirrored, member, M)
    return rotation + U * growth + Z - W * (Z + phi)


def _force(P: Series, Y: Series, member: Member, M: int) -> Series:
    """The term of Phi_hat that belongs to one member: i^(alpha+1) or i^q times 2^-d q^(-(d+1)/2) P^m Y^alpha."""
    alpha, d = member.integer_velocity, member.integer_velocity + member.position
    scale = member.ratio * fmpq((-1) ** ((alpha + (member.sign < 0)) // 2), 2**d)
    product = Y**alpha if not member.position else P**member.position * Y**alpha
    for i, n in enumerate(member.key):
        for _ in range(n):
            product = product.shift(i).truncate(Y.order)
    return product.map(lambda p: (p * scale).left_shift(M * member.order - (d + 1) // 2))


def _shifted(flow: FourierFlow, series: Series, parity: int) -> Series:
    """f^(eta) with the same shift q^(M n) as the waveform."""

    def lifted(key: tuple[int, ...], c: PiNumber) -> fmpq_poly:
        sign = (-1) ** ((flow.grading.loss_degree(key) - parity) // 2)
        return fmpq_poly([c.as_rational() * sign]).left_shift(flow.shift * sum(key))

    return series.map_keys(lifted)


def _mirror(p: fmpq_poly, degree: int) -> fmpq_poly:
    return sum((c * fmpq_poly([0, 1]) ** (degree - m) for m, c in enumerate(p.coeffs()) if c != 0), start=fmpq_poly([]))


def numerical_half_swing(given: Given | Sequence[float], deltas: Sequence[float]) -> tuple[float, float]:
    """(L, T) from integrating d ln r/d theta and d tau/d theta in doubles: heuristic, for measuring orders.

    Floats in the place of forces are the exponents of plain losses; named springs are summed as far as they go.
    """
    members = [_numbers(m, deltas) for m in Forces.read(given, 12).members]  # type: ignore[arg-type]

    def slopes(theta: float, state: np.ndarray) -> list[float]:
        s, c = abs(sin(theta)), cos(theta)
        n = 0.0
        for strength, weight, velocity, position, is_spring in members:
            factor = (abs(c) ** (position - 1) * c) if is_spring else abs(c) ** position
            n += strength * np.exp(weight * state[0]) * s**velocity * factor
        return [-n * s / (1 - n * c), n * c / (1 - n * c)]

    run = solve_ivp(slopes, (0.0, pi), [0.0, 0.0], method="DOP853", rtol=1e-13, atol=1e-15)
    return float(run.y[0, -1]), pi + float(run.y[1, -1])


def _numbers(m: Member, deltas: Sequence[float]) -> tuple[float, float, float, int, bool]:
    strength = float(prod(d**n for d, n in zip(deltas, m.key))) * float(Fraction(int(m.ratio.p), int(m.ratio.q)))
    velocity = float(m.velocity.ball().mid())
    return strength * m.side, velocity + m.position - 1, velocity, m.position, m.sign > 0


def measured_order(expansion: Expansion, given: Given | None = None, levels: int = 8) -> float:
    """The slope of ln(error) against ln(delta), errors of L and T together, all delta_i equal; nan if not measurable.

    ``given``: the forces, unless they are plain losses.  delta runs through 0.3, 0.3/sqrt(2), ...; of the errors above
    rounding the smallest pair is used.
    """
    half = expansion.turning_point_flow().half_swing(expansion.pi)
    forces = [_float(d) for d in expansion.degrees] if given is None else given
    found = []
    for j in range(levels):
        delta = 0.3 * 2 ** (-j / 2)
        L, T = numerical_half_swing(forces, [delta] * len(expansion.degrees))
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
