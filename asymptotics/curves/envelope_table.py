"""An envelope as a table from 0 to T, and each of its rows again, certified for the averaged law.

>>> from asymptotics.curves.slow import envelope
>>> slow = envelope({2: "1/10"})
>>> envelope_table(slow, ExactReal(3), 1).splitlines()[2][:31]
'3.0,0.8870564632568468,-0.00443'
>>> certified_row(slow, "3", 6)
('0.887056', '-0.00443528')
"""

import numpy as np
from numpy.typing import NDArray

from asymptotics.curves.double_errors import of_envelope
from asymptotics.curves.large import SpringEnvelope
from asymptotics.curves.slow import Envelope
from asymptotics.envelopes.symbolic import SQUARING
from asymptotics.numbers.double_words import with_errors
from asymptotics.numbers.exact import ExactReal
from asymptotics.present.inputs import csv_text

Curve = Envelope | SpringEnvelope


def envelope_table(found: Curve, until: ExactReal, points: int, order: int | None = None) -> str:
    """t, A and phi at ``points`` + 1 times as CSV, in doubles; of the first order, or of ``order``."""
    times = table_times(until, points)
    rows = zip(*found.columns(times, order=order))
    text = csv_text(table_head(found), ([repr(float(c)) for c in row] for row in rows))
    return with_errors(text, of_envelope(found, times, order))


def table_head(found: Curve) -> tuple[str, str, str]:
    """The names of its columns."""
    frame = found.frame
    return frame.named("t"), frame.named("amplitude"), frame.named("phase")


def table_times(until: ExactReal, points: int) -> NDArray[np.float64]:
    """The times of its rows."""
    # In one place: ``compare`` makes the same doubles again to find the rows of an exported envelope.
    return np.linspace(0.0, float(until.ball().mid()), points + 1)


def certified_row(found: Curve, time: str, digits: int) -> tuple[str, str]:
    """A and phi of one row, certified for the averaged law; nan where the table has no phase: extinct, or squaring."""
    amplitude = found.amplitude(time, digits=digits)
    phase = None if found.averaging == SQUARING or amplitude == "0" else found.phase(time, digits=digits)
    return amplitude, "nan" if phase is None else phase
