"""A solution with what is proved of its error, for all times at once (``bounds.explicit``, ``bounds.uniform``).  A
differential inequality along the nonexpansive flow turns the defect of the formula into a bound of its error.

>>> from asymptotics.curves.solve import solution
>>> air = solution({2: "1/20"}, order=2)
>>> air.proved(), air.proved_until("1/1000000")
(|x - x_N| <= 0.000023 for ever: proved, |x - x_N| <= 1/1000000 for 0 <= t <= 0: not proved)
>>> solution({1: "1/10", 2: "1/20"}, order=2).proved()
|x - x_N| <= 0.00094 for ever: proved
>>> solution(2).validity["not_proved"]
"argument epsilon: no strength is given (accepted: a law with its strength, such as {2: '1/10'})"
"""

from typing import Any

from asymptotics.bounds.reach import Reach, Theorem, reach_within
from asymptotics.curves.solution_curve import SolutionCurve
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.policy import Number
from asymptotics.running.public import public


class ProvedCurve(SolutionCurve):
    """What has a ``_theorem`` and the asymptotic ``valid_until`` besides."""

    @property
    def certified(self) -> bool:
        """False, because its values are those of an expansion."""
        return False

    @property
    def valid_until(self) -> Any:
        """tau until which the expansion makes sense; None where nothing is known."""
        return None

    def _theorem(self) -> Theorem:
        """A time, or None, -> the bound up to it; InputError where there is no theorem."""
        raise NotImplementedError

    @public
    def proved(self, *, until: Number | None = None, max_seconds: Number = 60) -> Reach:
        """A proved bound of |x - x_N| for x_N as it stands here, before rounding, in units of the start.

        For every tau >= 0, or up to the tau ``until``; for an exponent below 1 up to the tau that is stated.
        InputError without a strength, beside springs, and for the explicit form of a start in motion; LimitError where
        damping is too strong.
        """
        return self._theorem()(until)

    @public
    def proved_until(self, within: Number, *, max_seconds: Number = 60) -> Reach:
        """Until which tau |x - x_N| <= ``within`` (in units of the start) is proved, before rounding.

        The label is computed: "proved", or "not proved" with until = "0".  InputError for a size <= 0, and as above.
        """
        return reach_within(self._theorem(), within)

    @cached_property
    def validity(self) -> dict[str, str | None]:
        """``valid_until`` and ``valid_label``: proved, with the size of the error, or asymptotic, with the reason."""
        try:
            found = self.proved()
        # No strength, a force or a start without a theorem, damping too strong for it, or balls that do not decide: the
        # label says asymptotic then, with the reason.
        except (InputError, LimitError, UndecidedError) as reason:
            end = None if self.valid_until is None else str(self.valid_until)
            return {"valid_until": end, "valid_label": "asymptotic", "not_proved": str(reason)}
        return {"valid_until": found.until, "valid_label": found.label, "valid_within": found.size}
