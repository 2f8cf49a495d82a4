"""The certified values of an envelope as numbers: mpf, interval and ball, by name.

>>> from asymptotics.curves.slow import envelope
>>> slow = envelope({2: "1/10"})
>>> slow.number("amplitude", 7, digits=6).interval(), float(slow.number("kappa_1", digits=4))
(mpi('0.7709565', '0.7709575'), 0.04244)
>>> slow.number("extinction_time")
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument name: there is no extinction_time here (accepted: ...)
"""

from typing import Any

from asymptotics.errors import InputError, require_choice
from asymptotics.numbers.policy import Number, exact_number, float_notes
from asymptotics.numbers.value import Coefficient
from asymptotics.running.public import public

_AT = {"amplitude": "a time", "phase": "a time", "time": "an amplitude", "period": "an amplitude"}


class SlowNumbers:
    """What the two kinds of envelopes share: their values by name."""

    @public
    def number(self, name: str, at: Any = None, *, digits: int = 30, max_seconds: Number = 60) -> Coefficient:
        """A value as a number that knows mpf, interval, ball and float, certified for the averaged law.

        ``name``: "amplitude" (m) or "phase" (rad) ``at`` a time in s; "time" (s) or, beside a spring, "period" (s)
        ``at`` an amplitude in m; "extinction_time" (s) and "kappa_1", "kappa_2", ... without.  InputError for a name
        or a place that this envelope does not have.
        """
        # A mixin: the methods are those of the envelope that inherits, and their names are what can be asked for.
        this: Any = self
        # One digit is enough to count them.
        kappas = [f"kappa_{i}" for i in range(1, len(this.kappas(digits=1)) + 1)]
        known = [n for n in (*_AT, "extinction_time") if hasattr(this, n)]
        require_choice(name, "name", [*known, *kappas])
        if name not in _AT and at is not None:
            raise InputError("at", f"{name} is at no place", f"{name} alone")
        if name in _AT:
            place = exact_number(at, "at") if at is not None else None
            if place is None:
                raise InputError("at", "is missing", _AT[name])
            return Coefficient(getattr(this, name)(place, digits=digits), None, float_notes(at=at))
        if name in kappas:
            return Coefficient(this.kappas(digits=digits)[kappas.index(name)], None)
        found = this.extinction_time(digits=digits)
        if found is None:
            there = [n for n in known if n != "extinction_time"]
            raise InputError("name", "there is no extinction_time here", ", ".join([*there, *kappas]))
        return Coefficient(found, None)
