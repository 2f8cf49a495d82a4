"""Equivalent damping of an oscillator at turning amplitudes: a row each, and the formulas.

Equivalent linearisation by the energy of one cycle (Bogoliubov and Mitropolsky), beside what the motion itself does.

>>> from asymptotics.frames import BARE
>>> air = Oscillator({2: "1/10"})
>>> found = damping_at(air, [ExactReal(1)], frame=BARE, digits=6)
>>> found.formulas["Q"], found.rows[0].first.Q, found.rows[0].motion.decrement
(3*pi/(8*A*epsilon), '11.7810', '0.236684')
"""

from collections.abc import Sequence
from dataclasses import replace
from fractions import Fraction

from asymptotics.equivalent.result import EquivalentDamping
from asymptotics.equivalent.rows import DampingRow, row_at
from asymptotics.equivalent.symbolic import closed_forms
from asymptotics.errors import InputError, shown
from asymptotics.frames import Frame
from asymptotics.law import Oscillator
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.quantities import ANGLES, LENGTHS
from asymptotics.running.cut_short import keeping

# The start and what three halvings leave of it: enough to see how Q changes with the amplitude.
_SHARES = (1, 2, 4, 8)


def damping_at(
    oscillator: Oscillator,
    amplitudes: Sequence[ExactReal] | None = None,
    *,
    frame: Frame,
    digits: int,
    order: int | None = None,
    motion: bool = True,
    unit: str = "",
) -> EquivalentDamping:
    """The table at these amplitudes > 0 in ``unit`` (default: the start and its half, quarter, eighth).

    InputError for a law without a loss, a spring without a potential energy, a unit that amplitudes do not have, and
    amplitudes outside the well; an error that cuts the work short carries the rows that are done.
    """
    _require_energy(oscillator)
    size = _size(unit, oscillator, frame, given=amplitudes is not None)
    taken = _of_the_start(oscillator) if amplitudes is None else amplitudes
    formulas = closed_forms(oscillator.law.terms, frame)
    rows: list[DampingRow] = []

    def found() -> EquivalentDamping:
        length = float(size.ball().mid())
        return EquivalentDamping(
            oscillator, frame, digits, order, formulas, tuple(rows), oscillator.notes, unit, length
        )  # fmt: skip

    # Each row is a certified swing that may take seconds: those that are done outlive a time that is over.
    with keeping(lambda: found() if rows else None):
        for a in taken:
            rows.append(replace(row_at(oscillator, a * size, digits, order, motion), amplitude=str(a)))
    return found()


def _require_energy(oscillator: Oscillator) -> None:
    """Every quantity here is a loss over an energy."""
    if all(t.strength.is_zero for t in oscillator.law.losses):
        raise InputError("law", "there is no loss in it", "a law with a strength that is not 0")
    for t in oscillator.law.springs:
        # x^p |x'|^q has no potential energy, which every quantity here is divided by.
        if not t.velocity.is_zero:
            raise InputError("spring", f"{t.shape()} depends on the velocity: no potential", "springs c x|x|^(P-1)")


def _size(unit: str, oscillator: Oscillator, frame: Frame, *, given: bool) -> ExactReal:
    """The unit of the amplitudes in m or rad."""
    pendulum = oscillator.unit == "rad"
    known = ANGLES if pendulum else LENGTHS if frame else {}
    if not isinstance(unit, str) or (unit and unit not in known):
        accepted = ", ".join(known) or "deg, mrad of a pendulum; cm, in of an oscillator with mass and stiffness"
        raise InputError("unit", f"{shown(unit)} is no unit of these amplitudes", accepted)
    if unit and not given:
        raise InputError("amplitudes", "there is none in this unit", f"amplitudes in {unit}")
    # Exactly, so that 10 deg is the same number whatever precision comes next (pi to 130 digits, ``quantities``).
    return ExactReal(known.get(unit, Fraction(1)))


def _of_the_start(oscillator: Oscillator) -> list[ExactReal]:
    if oscillator.x0.is_zero:
        raise InputError("amplitudes", "the oscillator starts at x0 = 0", "amplitudes > 0")
    return [abs(oscillator.x0) / n for n in _SHARES]
