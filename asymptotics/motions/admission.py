"""Which oscillators the asymptotic motion takes: what it would answer wrongly is refused by name.

*The well.*  The error is clipped to what the energy allows, |X| <= 1 in units of the start.  The springs are
X (1 + sum_j c_j |X|^(p_j-1) |X'|^q_j).  Those that soften have q = 0 here, so that for |X| <= 1 this is at least
X (1 - S), where S is the sum of the -c_j > 0: for S < 1 it points to the origin, orbits without losses are closed by
reversal of time, and losses only lead inwards.  sin x points to the origin for |x| < pi.  A start with a velocity has
|X| <= 1 for springs that only stiffen, since X'^2 + X^2 then falls as |X| grows; one that softens goes further.

*Dry friction* ends the motion at a distance that the arc of friction alone gives beside the linear spring only
(``stopping``).

*Kinks.*  With |x|^m, m odd, or x|x|^(p-1), p even, the waveform is good to O(delta^(m+2)) where X changes its sign
(``formal_forces``), which is order N of the motion for N <= m + 2.  The estimate reads its terms of degree N and N + 1:
with N <= m + 1 the first is right, and of the second, which is wrong by as much as it adds, only the size is used.

>>> require_served(Oscillator({2: "1/10"}, spring={3: "-3/2"}), 3)
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument spring: ... (accepted: a start inside the well...)
"""

from flint import arb

from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.terms import Term

_FIRST = 6
"""sin x = x - x^3/6 + ...: the strength of a pendulum's first term is A^2/6."""


def local_strength(oscillator: Oscillator) -> arb:
    """The sum of the |delta_i| at the start; 0 for dry friction alone, whose series ends."""
    terms = oscillator.law.terms
    # Dry friction alone: A falls by 2 eps_0 a half-swing exactly, at any strength.
    if all(t.degree == 0 for t in terms):
        return arb(0)
    sizes = [abs(e) / (_FIRST if t.family else 1) for t, e in zip(terms, oscillator.epsilons())]
    return sum(sizes, arb(0))


def require_served(oscillator: Oscillator, order: int) -> None:
    """InputError by name for what the motion of this order does not know."""
    law = oscillator.law
    # Powers of the velocity beside the linear spring: every start is in the well, and the waveform has no kink.
    if law.is_pure:
        return
    for t in law.losses:
        if t.degree.is_zero and not t.strength.is_zero:
            reason = (
                "dry friction beside a spring or a position-dependent loss: where it stops the mass is not known here"
            )
            raise InputError("law", reason, "alpha > 0 with them, or alpha = 0 with the linear spring")
    for t in law.terms:
        if is_kinked(t) and not t.strength.is_zero and order > t.position + 1:
            reason = f"{t.shape()} has a kink at x = 0, which no waveform of order {order} describes"
            raise InputError("order", reason, f"1 to {t.position + 1} with this force")
    _require_well(oscillator)


def is_kinked(term: Term) -> bool:
    """Whether the force is no power series at x = 0: |x|^m with m odd, x|x|^(p-1) with p even."""
    return term.position % 2 == (1 if term.sign < 0 else 0) and bool(term.position)


def _require_well(oscillator: Oscillator) -> None:
    law = oscillator.law
    pendulum = any(t.family for t in law.springs)
    softening = [e for t, e in zip(law.terms, oscillator.epsilons()) if t.sign > 0 and not t.family and e < 0]
    if not pendulum and not softening:
        return
    if not oscillator.v0.is_zero:
        reason = "beside a spring that softens, how far a start with a velocity goes is not known here"
        raise InputError("v0", reason, "v0 = 0, or springs with strengths >= 0")
    if any(t.strength.sign < 0 and not t.velocity.is_zero for t in law.springs):
        raise InputError(
            "spring", "one that softens with the velocity: its well is not known here", "C >= 0 with |x'|^Q"
        )
    if pendulum and len(law.springs) > 1:
        raise InputError("spring", "a pendulum beside another spring: its well is not known here", "the pendulum alone")
    # V' > 0 up to the start: |x0| < pi for a pendulum, S < 1 otherwise (module's docstring).
    inside = oscillator.length() < arb.pi() if pendulum else -sum(softening, arb(0)) < 1
    if not inside:
        reason = f"from x0 = {oscillator.x0} the force need not point to the origin: the start may lie outside the well"
        raise InputError("spring", reason, "a start inside the well: strengths < 0 with the sum > -1 at x0, |x0| < pi")
