"""The driven response to first order where the force and the speed are in step, Omega = omega_0."""

from asymptotics.driven.drive import Drive
from asymptotics.driven.first_numbers import resonance
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.tables.cells import Nearest
from asymptotics.tables.inputs import SUMS, Inputs, label
from asymptotics.tables.recipe import Found


def resonances(inputs: Inputs, digits: int) -> Found:
    """Rows (law, amplitude, Q_decay, Q_width) for the force 1 and m = k = 1."""
    rows = []
    for law in inputs.laws_or(SUMS):
        found = resonance(Drive.read(Oscillator(law), 1, 1), digits)
        if found is not None:
            rows.append((label(law), *(Nearest(found[column]) for column in ("amplitude", "Q_decay", "Q_width"))))
        elif inputs.law is not None or inputs.alphas:
            raise InputError("alpha", "dry friction alone does not bound the amplitude at omega_0", "exponents above 0")
    return Found(list(rows), True)
