"""By what angle the local fits of a record find its turning points too late, for a law: what its losses make of them.

The sum over the losses of their local strengths s exp(w a) times the ``lateness`` of the window (``late_extremes``), to
first order; a spring is even about a turning point and moves no extreme.

>>> from asymptotics.decays.identification.forward.coefficients import loss
>>> window = Window((tuple(np.linspace(-0.7, 0.7, 71)),))
>>> a = np.log([1.0, 0.1])                       # dry friction of 0.01: the later, the smaller the swing
>>> late, by = lateness(HalfSwingModel((loss(0.0),)), window, a, np.array([[1.0, 1.0], [0.0, 0.0]]), np.array([0.01]))
>>> late.round(5), by[1].round(4)
(array([0.00073, 0.00731]), array([0.0731, 0.7312]))
"""

import numpy as np

from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.forward.swing import HalfSwingModel
from asymptotics.decays.identification.measuring.late_extremes import Window


def lateness(
    swing: HalfSwingModel, window: Window | None, a: Array, d_a: Array, parameters: Array
) -> tuple[Array, Array]:
    """The angles at the amplitudes ``a`` = ln A, and their derivatives by the first amplitude and the ``parameters``.

    ``d_a``: the derivatives of a, a row for each; ``window``: None where no local fits were made.
    """
    late, by = np.zeros(len(a)), np.zeros((1 + len(parameters), len(a)))
    for i, element in enumerate(swing.elements if window is not None else ()):
        if element.kind != "loss":
            continue
        assert window is not None
        free = swing.free and i == 0
        exponent = float(parameters[-1]) if free else element.velocity
        weight = exponent + element.position - 1
        one = window.lateness(exponent, element.position) * np.exp(weight * a)
        late += parameters[i] * one
        by += weight * parameters[i] * one * d_a
        by[1 + i] += one
        if free:
            slope = window.by_exponent(exponent, element.position) * np.exp(weight * a)
            by[-1] += parameters[i] * (a * one + slope)
    return late, by
