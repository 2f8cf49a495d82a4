"""What the classical route can say of itself: the residual in the equation of motion, exact.

Whole series are multiplied here, D X is formed from p, Omega and X as they stand, and nothing of the recurrence of
``exact`` is used.  The near miss is a published one: the package oscilate takes D_1 D_2 for D_2 D_1 and reports
p_3 = 567/8192 for x'^3 with the waveform for which 351/8192 is right.  The residual shows it, and shows its size,
27/512 a^7 sin psi, which is the commutator of the slow derivatives.

>>> from asymptotics.expansions.multiple_scales.exact import odd_hierarchy
>>> solved = odd_hierarchy((3,), 6)
>>> equation_residual(solved)
<Outcome.CONFIRMED: 'confirmed'>
>>> wrong = with_amplitude_coefficient(solved, (3,), fmpq(567, 8192))
>>> equation_residual(wrong), residual(wrong)[3,]
(<Outcome.REFUTED: 'refuted'>, {1: 27/512})
"""

from dataclasses import replace
from math import prod

from flint import fmpq, fmpq_poly

from asymptotics.expansions.half_swings.forces import Member
from asymptotics.expansions.multiple_scales.exact import OddHierarchy, Part, in_eta, rotated, sign
from asymptotics.series import Key, Series
from paper_checks.verdict import Outcome


def residual(hierarchy: OddHierarchy) -> dict[Key, dict[int, fmpq]]:
    """D^2 X + X + the forces at X and D X, through the order of the hierarchy, in units of a delta^k.

    Exponent k -> {m: coefficient of cos(m psi) (loss degree even) or sin(m psi) (odd)}, without zeros.
    """
    X = _series(hierarchy, hierarchy.X)
    velocity = _derivative(hierarchy, X)
    total = X - _derivative(hierarchy, velocity)
    for member in hierarchy.forces.through(hierarchy.order):
        total = total + _force(hierarchy, X, velocity, member)
    parts = {k: _harmonics(hierarchy, k, p) for k, p in total.coefficients.items()}
    return {k: harmonics for k, harmonics in parts.items() if harmonics}


def _harmonics(hierarchy: OddHierarchy, key: Key, p: fmpq_poly) -> dict[int, fmpq]:
    h = 1 + sum(key) * hierarchy.spread
    parity = -1 if hierarchy.forces.loss_degree(key) % 2 else 1
    broken = {-m: p[(h - m) // 2] - parity * p[(h + m) // 2] for m in range(1, h + 1, 2)}
    return hierarchy.real_harmonics(key, p) | {m: c for m, c in broken.items() if c != 0}


def equation_residual(hierarchy: OddHierarchy) -> Outcome:
    """CONFIRMED if the residual is exactly zero through the order of the hierarchy, else REFUTED."""
    return Outcome.REFUTED if residual(hierarchy) else Outcome.CONFIRMED


def residual_order(hierarchy: OddHierarchy) -> int:
    """The lowest order with a residual; one more than the order of the hierarchy if there is none."""
    return min((sum(k) for k in residual(hierarchy)), default=hierarchy.order + 1)


def with_amplitude_coefficient(hierarchy: OddHierarchy, key: Key, value: fmpq) -> OddHierarchy:
    """The same hierarchy with one coefficient of p replaced: a near miss, to see the residual fail."""
    changed = {**hierarchy.p_hat.coefficients, key: value * sign(hierarchy.forces.loss_degree(key))}
    return replace(hierarchy, p_hat=hierarchy.p_hat.with_coefficients(changed))


def _series(hierarchy: OddHierarchy, parts: tuple[Part, ...]) -> Series:
    return Series({k: p for part in parts for k, p in part.items()}, hierarchy.forces.variables, hierarchy.order)


def _derivative(hierarchy: OddHierarchy, f: Series) -> Series:
    """Dhat f = (1 + Omegahat) q d_q f - phat E f, each coefficient of degree n stored as q^(h_n) times itself."""
    spread = hierarchy.spread
    turned = f.map_keys(lambda k, p: rotated(p, 1 + sum(k) * spread))
    scaled = f + hierarchy.grading.weighted(f)
    return (_lifted(hierarchy.Omega_hat, spread) + fmpq_poly([1])) * turned - _lifted(hierarchy.p_hat, spread) * scaled


def _lifted(series: Series, spread: int) -> Series:
    """The coefficients of degree n times q^(n spread), as polynomials in q^2."""
    return series.map_keys(lambda k, c: fmpq_poly([c]).left_shift(sum(k) * spread // 2))


def _force(hierarchy: OddHierarchy, X: Series, velocity: Series, member: Member) -> Series:
    """One force in eta: its sign and ratio times eta^key X^position (Dhat Xhat)^velocity."""
    factors = [X] * member.position + [velocity] * member.integer_velocity
    power = prod(factors[1:], start=factors[0])
    for i in (i for i, n in enumerate(member.key) for _ in range(n)):
        power = power.shift(i).truncate(hierarchy.order)
    shift = (member.order * hierarchy.spread + 1 - len(factors)) // 2
    return power.map(lambda p: (p * in_eta(member)).left_shift(shift))
