"""The names of the three gauges: what A and psi mean in z = X - i X' = A e^(i psi) Z(psi, delta) (``normal_form``).

=====================  ==============================================================================================
``turning-point``      Z(0, delta) = 1: A is the turning amplitude, psi = n pi at the n-th turning point
``averaging``          <Z> = 1: the e^(i psi) coefficient of X - i X' is exactly A
``no-first-harmonic``  <Z + conj(Z) e^(-2 i psi)> = 1: the e^(i psi) coefficient of X is exactly A/2
=====================  ==============================================================================================

>>> require_gauge("averaging")
>>> require_gauge("average")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument gauge: 'average' is unknown (accepted: turning-point, averaging, ...)
"""

from asymptotics.errors import require_choice

# On the ground floor, so that whoever reads an option or a result needs no engine for it.
GAUGES = ("turning-point", "averaging", "no-first-harmonic")
TURNING_POINT, AVERAGING, NO_FIRST_HARMONIC = GAUGES


def require_gauge(gauge: str) -> None:
    """InputError unless ``gauge`` is one of the three."""
    require_choice(gauge, "gauge", GAUGES)
