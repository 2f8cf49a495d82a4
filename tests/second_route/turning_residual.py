"""The residual of the hierarchy in the turning-point gauge: X alone, put into the equation of motion.

The derivative along the flow, D = (1 + Omega) d_psi - p E, is applied twice to the sum of all X_k at once; nothing of
the recurrence of ``turning`` is used, neither its velocity nor its powers.  What must hold besides: x_k = 0 and
(D X)_k = 0 at psi = 0 and psi = pi, and reversal, x_k(pi - psi) = -(-1)^l(k) x_k(psi).

>>> from asymptotics.expansions.multiple_scales.turning import turning_hierarchy
>>> solved = turning_hierarchy((2,), 4)
>>> turning_outcome(solved)
<Outcome.CONFIRMED: 'confirmed'>
>>> wrong = with_rate(solved, (3,), PiNumber.rational(fmpq(1, 135)) / PI)       # 1/135 for 2/135
>>> turning_outcome(wrong), min(map(sum, turning_residual(wrong)))
(<Outcome.REFUTED: 'refuted'>, 3)
"""

from dataclasses import replace

from flint import fmpq as fmpq  # for the examples

from asymptotics.expansions.half_swings.forces import Member
from asymptotics.expansions.half_swings.pi_ring import PI as PI  # for the examples
from asymptotics.expansions.half_swings.pi_ring import PiNumber
from asymptotics.expansions.multiple_scales.ring import ONE, ZERO, Wave
from asymptotics.expansions.multiple_scales.turning import Part, TurningHierarchy
from asymptotics.series import Key
from paper_checks.verdict import Outcome


def turning_residual(h: TurningHierarchy) -> Part:
    """D^2 X + X + the forces, in units of a delta^k on 0 < psi < pi, through the order: what is not 0."""
    X = {k: f for part in h.X for k, f in part.items()}
    velocity = _along(h, X)
    total = _sum(_along(h, velocity), X)
    for member in h.forces.through(h.order):
        total = _sum(total, _force(h, member, X, velocity))
    return {k: f for k, f in total.items() if not f.is_zero}


def turning_outcome(h: TurningHierarchy) -> Outcome:
    """CONFIRMED if residual, values at both turning points and reversal are exactly right, else REFUTED."""
    later = {k: f for part in h.X[1:] for k, f in part.items()}
    velocity = _along(h, {k: f for part in h.X for k, f in part.items()})
    ends = [*later.values(), *(f for k, f in velocity.items() if any(k))]
    at_ends = all(f.at_zero() == 0 and f.at_pi() == 0 for f in ends)
    even = all((f.mirrored() + f * (-1) ** h.forces.loss_degree(k)).is_zero for k, f in later.items())
    return Outcome.CONFIRMED if at_ends and even and not turning_residual(h) else Outcome.REFUTED


def with_rate(h: TurningHierarchy, key: Key, value: PiNumber) -> TurningHierarchy:
    """The same hierarchy with one p_k (odd in the losses) or Omega_k replaced: a near miss."""
    name = "p" if h.forces.loss_degree(key) % 2 else "Omega"
    series = getattr(h, name)
    return replace(h, **{name: series.with_coefficients({**series.coefficients, key: value})})


def _along(h: TurningHierarchy, f: Part) -> Part:
    """D f = (1 + Omega) f' - p E f."""
    total = {k: g.derivative() for k, g in f.items()}
    for k, g in f.items():
        turned, grown = g.derivative(), g * -(1 + h.grading.weight(k))
        for rates, side in ((h.Omega, turned), (h.p, grown)):
            for j, c in rates.coefficients.items():
                if sum(j) + sum(k) <= h.order:
                    key = tuple(m + n for m, n in zip(j, k))
                    total[key] = total.get(key, ZERO) + side * c
    return total


def _force(h: TurningHierarchy, member: Member, X: Part, velocity: Part) -> Part:
    """sign ratio delta^key X^position (-D X)^velocity."""
    total: Part = {member.key: ONE * (member.ratio * member.sign)}
    minus = {k: -f for k, f in velocity.items()}
    for factor in [X] * member.position + [minus] * member.integer_velocity:
        total = _times(h, total, factor)
    return total


def _times(h: TurningHierarchy, a: Part, b: Part) -> Part:
    total: dict[Key, Wave] = {}
    for i, f in a.items():
        for j, g in b.items():
            if sum(i) + sum(j) <= h.order:
                key = tuple(m + n for m, n in zip(i, j))
                total[key] = total.get(key, ZERO) + f * g
    return total


def _sum(a: Part, b: Part) -> Part:
    return {k: a.get(k, ZERO) + b.get(k, ZERO) for k in {**a, **b}}
