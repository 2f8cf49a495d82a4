"""A solution of one law with what is proved of its error, for all times at once (``bounds.explicit``).

>>> from asymptotics.api.solution import solution
>>> air = solution({2: "1/20"}, order=2)
>>> air.proved(), air.proved_until("1/1000000")
(|x - x_N| <= 0.000023 for ever: proved, |x - x_N| <= 1/1000000 for 0 <= t <= 0: not proved)
>>> solution(2).validity["not_proved"]
"argument epsilon: no strength is given (accepted: a law with its strength, such as {2: '1/10'})"
"""

from typing import Any

from asymptotics.api.solution_curve import SolutionCurve
from asymptotics.bounds.explicit import explicit_bound
from asymptotics.bounds.reach import Reach, reach_within
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Oscillator
from asymptotics.numbers.context import cached_property
from asymptotics.numbers.policy import Number


class ProvedCurve(SolutionCurve):
    """What has ``start`` and the asymptotic ``valid_until`` besides."""

    start: Any

    @property
    def valid_until(self) -> Any:
        """tau until which the expansion makes sense."""
        raise NotImplementedError

    def proved(self, *, until: Number | None = None) -> Reach:
        """A proved bound of |x - x_N| for x_N as it stands here, before rounding, in units of x_0.

        For every tau >= 0, or up to the tau ``until``; for alpha < 1 up to the tau that is stated.

        InputError without a strength and for a start in motion; LimitError where damping is too strong.
        """
        return explicit_bound(self._from_rest(), self.order, until=until)

    def proved_until(self, within: Number) -> Reach:
        """Until which tau |x - x_N| <= ``within`` (in units of x_0) is proved; "not proved" with until = "0"."""
        oscillator = self._from_rest()
        return reach_within(lambda until: explicit_bound(oscillator, self.order, until=until), within)

    def _from_rest(self) -> Oscillator:
        """The motion in units of tau and x_0."""
        if self.start is not None:
            raise InputError("v0", "for a start in motion no bound for all times is proved", "v0 = 0, proved_bound")
        return Oscillator(self._given().dimensionless)

    @cached_property
    def validity(self) -> dict[str, str]:
        """``valid_until`` and ``valid_label``: proved, with the size of the error, or asymptotic, with the reason."""
        try:
            found = self.proved()
        except (InputError, LimitError, UndecidedError) as reason:
            return {
                "valid_until": str(self.valid_until),
                "valid_label": "asymptotic",
                "not_proved": str(reason),
            }
        return {"valid_until": found.until, "valid_label": found.label, "valid_within": found.size}
