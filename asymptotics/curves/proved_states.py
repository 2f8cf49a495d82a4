"""What a motion that is certified at times offers besides: a certificate of them.

>>> from asymptotics.curves.motions import reference
>>> reference({2: "1/10"}).certificate([1, "5/2"], digits=8).proved[2]
't = 5/2: x = -0.70324400 (known to 1e-13) v = -0.53762389 (known to 1e-13)'
"""

from collections.abc import Sequence
from typing import Any, cast

from asymptotics.certificates.certificate import Certificate
from asymptotics.certificates.of_results import of_states
from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.policy import Number, exact_integer, exact_number
from asymptotics.running.public import public

MAX_STATES = 1000
"""Times of one file, as half-swings are."""


class ProvedStates:
    """A motion with ``at(t, digits=...)``, whose digits a page of standard Python proves."""

    oscillator: Oscillator
    static: Number | None
    at: Any

    @public
    def certificate(self, t: Number | Sequence[Number], *, digits: int = 30, max_seconds: Number = 60) -> Certificate:
        """A file from which ``check_certificate.py`` proves x and v at one time in s or at several.

        InputError for what has none: springs, losses that know the place, irrational numbers and times, estimates.
        """
        if self.static is not None:
            raise InputError("certificate", "static friction is another equation", "a motion without it")
        digits = exact_integer(digits, "digits", 1, 1000)
        several = isinstance(t, Sequence) and not isinstance(t, str)
        if several and not 1 <= len(cast("Sequence[Number]", t)) <= MAX_STATES:
            raise InputError("t", f"{len(cast('Sequence[Number]', t))} times", f"1 to {MAX_STATES} times")
        times = list(cast("Sequence[Number]", t)) if several else [cast("Number", t)]
        states = [(exact_number(each, "t"), self.at(each, digits=digits)) for each in times]
        return of_states(self.oscillator, states, digits)
