"""The driven response to first order where the force and the speed are in step, Omega = omega_0."""

from fractions import Fraction

from asymptotics.driven.drive import Drive
from asymptotics.driven.first_numbers import resonance
from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.numbers.exact import ExactReal
from asymptotics.tables.cells import Cell, Nearest
from asymptotics.tables.inputs import SUMS, Inputs, label
from asymptotics.tables.recipe import Found


def resonances(inputs: Inputs, digits: int) -> Found:
    """Rows (law, amplitude, Q_decay, Q_width) for the force 1 and m = k = 1."""
    rows: list[tuple[Cell, ...]] = []
    for law in inputs.laws_or(SUMS):
        if (exact := _of_linear_damping(law)) is not None:
            rows.append((label(law), exact, exact, exact))
        elif (found := resonance(Drive.read(Oscillator(law), 1, 1), digits)) is not None:
            rows.append((label(law), *(Nearest(found[column]) for column in ("amplitude", "Q_decay", "Q_width"))))
        elif inputs.law is not None or inputs.alphas:
            raise InputError("alpha", "dry friction alone does not bound the amplitude at omega_0", "exponents above 0")
    return Found(rows, True)


def _of_linear_damping(law: Law) -> Fraction | None:
    """1/epsilon, which is amplitude and Q at once: a rational number, that no ball tells from a tie."""
    term, *others = law.terms
    strength = term.strength
    if others or term.velocity != 1 or not isinstance(strength, ExactReal) or not strength.is_rational:
        return None
    return 1 / strength.rational
