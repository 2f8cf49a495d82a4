"""Printed tables of decrements of a known law, and the laws."""

import numpy as np

from asymptotics.decays.identification.fitting.printed import DecrementModel, Decrements
from asymptotics.decays.identification.forward.candidates import read_candidate
from asymptotics.terms import Term


def losses(law):
    """Terms of strength 1 from a candidate such as 1+1,2:."""
    return tuple(Term(1, a, m) for a, m in read_candidate(law).losses)


def printed(law, strengths, digits, rows=12):
    a = np.round(np.linspace(1.0, 0.3, rows), 4)
    model = DecrementModel(read_candidate(law).swing(), Decrements(a, a))
    D = model.predict(np.array(strengths, dtype=float))[0]  # the reference amplitude is 1
    return Decrements(a, np.round(D, digits), np.full(rows, 0.5 * 10.0**-digits))
