"""What a loss is at an amplitude, in the words of linear damping: zeta, Q, decrement, energy loss, c_eq, half-life.
Equivalent linearisation by the energy of one cycle (Bogoliubov and Mitropolsky), beside what the motion itself does.

>>> air = damping({2: "1/10"}, ["1/2", 1], digits=6)
>>> air.formulas["Q"], air.rows[0].first.Q, air.rows[1].motion.decrement
(3*pi/(8*A*epsilon), '23.5619', '0.236684')
>>> damping("symbolic").formulas["zeta"]
A**(alpha - 1)*epsilon*gamma(alpha/2 + 1)/(sqrt(pi)*gamma(alpha/2 + 3/2))
>>> swing = damping({1: "1/50", 2: "1/20"}, [10, 40], spring="pendulum", unit="deg", digits=4)
>>> [(row.amplitude, row.first.Q) for row in swing.rows], swing.header()[1]
([('10', '36.47'), ('40', '20.12')], 'amplitude [deg]')
"""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction
from itertools import islice
from typing import Any

from asymptotics.api.units import law_of
from asymptotics.cut_short import keeping
from asymptotics.equivalent.result import EquivalentDamping
from asymptotics.equivalent.rows import DampingRow, row_at
from asymptotics.equivalent.symbolic import closed_forms, symbolic_exponent
from asymptotics.errors import InputError, LimitError, require_flag, shown
from asymptotics.law import LawLike, Oscillator, SpringLike
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_integer, exact_number, float_notes
from asymptotics.public import public
from asymptotics.records.units import ANGLES, LENGTHS

# 100 digits leave thirty of the 130 that pi has in the units of angles; 12 is the order of the bounds
# (``bounds.uniform``), and a thousand certified swings are the work of minutes.  Refusals.
MAX_DIGITS, MAX_ORDER, MAX_AMPLITUDES = 100, 12, 1000
# The start and what three halvings leave of it: enough to see how Q changes with the amplitude.
_SHARES = (1, 2, 4, 8)


@public
def damping(
    law: LawLike,
    amplitudes: Number | Sequence[Number] | None = None,
    *,
    order: int | None = None,
    digits: int = 12,
    motion: bool = True,
    spring: SpringLike | None = None,
    unit: str = "",
    max_seconds: Number = 60,
) -> EquivalentDamping:
    """Equivalent damping of any law, sum or spring at turning amplitudes A: formulas and certified numbers.

        zeta = Delta E/(4 pi E),  Q = 2 pi E/Delta E,  decrement = ln(A_n/A_(n+2)),  c_eq = Delta E/closed int v dx

    of first order (one cycle without loss) with the half-life, the time in which A falls to A/2; of the ``motion``
    itself, one full swing from rest at A; and with ``order`` N of the series to delta^N, each with the proved bound of
    what it lacks.  ``law``: epsilons (A in their unit), an oscillator (A in m, answers in SI) or "symbolic".
    ``amplitudes``: a number or a list (default: the start and its half, quarter, eighth), in ``unit``: cm, mm, um, in,
    ft of an oscillator in SI; deg, mrad, arcmin of a pendulum (pi to 130 digits).  InputError for a law without a loss,
    amplitudes <= 0 or outside the well; LimitError after ``max_seconds``, which ``asymptotics.cut_short.done`` asks for
    the rows that were done.  Source: derivation ``equivalent-damping``.
    """
    D = exact_integer(digits, "digits", 1, MAX_DIGITS)
    N = None if order is None else exact_integer(order, "order", 1, MAX_ORDER)
    require_flag(motion, "motion")
    if isinstance(law, str) and law == "symbolic":
        if amplitudes is not None or N is not None or spring is not None or unit:
            raise InputError("law", "a symbolic exponent has formulas only", "no amplitudes, order or spring beside it")
        return EquivalentDamping(None, False, D, None, symbolic_exponent(si=False), ())
    si = isinstance(law, Oscillator)
    oscillator = _oscillator(law, spring)
    size = _size(unit, oscillator, si, amplitudes)
    given, notes = _amplitudes(amplitudes, oscillator)
    formulas = closed_forms(oscillator.law.terms, si=si)
    rows: list[DampingRow] = []

    def found() -> EquivalentDamping:
        told = (*oscillator.notes, *notes)
        return EquivalentDamping(oscillator, si, D, N, formulas, tuple(rows), told, unit, float(size.ball().mid()))

    # Each row is a certified swing that may take seconds: those that are done outlive a time that is over.
    with keeping(lambda: found() if rows else None):
        for a in given:
            rows.append(replace(row_at(oscillator, a * size, D, N, motion), amplitude=str(a)))
    return found()


def _size(unit: str, oscillator: Oscillator, si: bool, amplitudes: Any) -> ExactReal:
    """The unit of the amplitudes in m or rad."""
    pendulum = oscillator.unit == "rad"
    known = ANGLES if pendulum else LENGTHS if si else {}
    if not isinstance(unit, str) or (unit and unit not in known):
        accepted = ", ".join(known) or "deg, mrad of a pendulum; cm, in of an oscillator with mass and stiffness"
        raise InputError("unit", f"{shown(unit)} is no unit of these amplitudes", accepted)
    if unit and amplitudes is None:
        raise InputError("amplitudes", "there is none in this unit", f"amplitudes in {unit}")
    # Exactly, so that 10 deg is the same number whatever precision comes next (pi to 130 digits, ``records.units``).
    return ExactReal(known.get(unit, Fraction(1)))


def _oscillator(law: Any, spring: Any) -> Oscillator:
    """The oscillator with the losses that act; InputError where there is none."""
    if isinstance(law, Oscillator):
        if spring is not None:
            raise InputError("spring", "it belongs to the oscillator", "Oscillator(..., spring=)")
        made = law
    else:
        made = Oscillator(law_of(law), spring=spring)
    if all(t.strength.is_zero for t in made.law.losses):
        raise InputError("law", "there is no loss in it", "a law with a strength that is not 0")
    for t in made.law.springs:
        # x^p |x'|^q has no potential energy, which every quantity here is divided by.
        if not t.velocity.is_zero:
            raise InputError("spring", f"{t.shape()} depends on the velocity: no potential", "springs c x|x|^(P-1)")
    return made


def _amplitudes(given: Any, oscillator: Oscillator) -> tuple[list[ExactReal], tuple[str, ...]]:
    if given is None:
        if oscillator.x0.is_zero:
            raise InputError("amplitudes", "the oscillator starts at x0 = 0", "amplitudes > 0")
        return [abs(oscillator.x0) / n for n in _SHARES], ()
    try:
        # A text and an exact number are one amplitude, though a text has a length; an array without dimensions has the
        # method and refuses it, hence the TypeError below.
        values = (
            [given]
            if isinstance(given, str | ExactReal) or not hasattr(given, "__len__")
            else [*islice(given, MAX_AMPLITUDES + 1)]
        )
    except TypeError:
        values = [given]
    if not values:
        raise InputError("amplitudes", "there is none", "a number > 0 or a list of them")
    if len(values) > MAX_AMPLITUDES:
        raise LimitError("amplitudes", "they are too many", f"at most {MAX_AMPLITUDES}")
    numbers = [exact_number(a, "amplitudes") for a in values]
    for a in numbers:
        if not a > 0:
            raise InputError("amplitudes", f"{a} is not positive", "amplitudes > 0")
    return numbers, tuple(note for a in values for note in float_notes(amplitudes=a))
