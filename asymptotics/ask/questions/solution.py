"""A(t), phi(t), x(t) of any order as functions: formulas, LaTeX, numbers, curve."""

from dataclasses import dataclass, field, replace
from typing import Annotated, Any, cast

import numpy as np

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.kinds import FLAG, SECONDS, Option, choice, digits, whole
from asymptotics.ask.laws import MOVES_OR_FORMULAS
from asymptotics.ask.moving import OVERLAY, TIME, overlaid, require_stretch
from asymptotics.ask.pairs import demands, needs
from asymptotics.ask.question import question
from asymptotics.bounds.motion import proved_bound
from asymptotics.curves.double_errors import of_solution
from asymptotics.curves.implicit import ImplicitSolution
from asymptotics.curves.shown_solution import SolutionPoint
from asymptotics.curves.solution import MAX_DIGITS, MAX_ORDER, UNITS, Solution
from asymptotics.curves.solve import solution
from asymptotics.errors import InputError
from asymptotics.law import LawLike, Oscillator
from asymptotics.law_given import Given
from asymptotics.numbers.double_words import with_errors
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number
from asymptotics.present.inputs import csv_text

Found = Solution | ImplicitSolution


@dataclass(frozen=True)
class SolutionAtTime:
    """The solution, A and phi in other ``units`` by name, and its numbers at a time with a bound, where asked for."""

    solution: Found
    units: str
    in_units: dict[str, str] = field(default_factory=dict)
    time: ExactReal | None = None
    point: SolutionPoint | None = None
    bound: str | None = None

    @property
    def values(self) -> dict[str, str]:
        """The time, A, phi and x there, and the bound of x, by name."""
        if self.point is None:
            return {}
        found = {"time": str(self.time), **{f"{name}_value": text for name, text in self.point._asdict().items()}}
        return found if self.bound is None else found | {"bound": self.bound}


def _data(found: SolutionAtTime, request: Request) -> dict[str, Any]:
    data: dict[str, Any] = found.solution.to_dict() | {"units": found.units} | found.in_units | found.values
    if found.point is not None:
        data["files"] = []
    # LaTeX of a high order takes seconds: made only where it is shown, once.
    if request.typed("json") and not request.has_latex:
        data["latex"] = _latex(found, request)
    return data


def _latex(found: SolutionAtTime, request: Request) -> str:
    return found.solution.latex(standalone=not request.typed("fragment"))


_MEANINGS = {"kappa": "kappa = p_1 epsilon", "SI": "omega_0^2 = k/m; A in m, t in s"}


def _text(found: SolutionAtTime, request: Request) -> str:
    lines, made = [str(found.solution)], found.solution
    if found.in_units:
        meaning = _MEANINGS[found.units]
        if found.units == "SI" and made.mirrored:
            meaning += "; x_0 = |x(0)|"
        if found.units == "SI" and isinstance(made, Solution) and made.start is not None:
            meaning += f"; epsilon = {made.strength_in_SI}"
        A, phi = found.in_units.values()
        lines += [f"A       = {A}", f"phi     = {phi}", f"units   {meaning}"]
    if found.values:
        frame = cast("Given", request["law"]).frame
        # No phase is told where the mass is held or the amplitude has vanished.
        values = {name.removesuffix("_value"): text for name, text in found.values.items() if text}
        lines += [f"{name:10} {frame.with_unit(name, text)}" for name, text in values.items()]
    lines += ["bound: proved, |x - x_N| is at most this"] if found.bound is not None else []
    return "\n".join(lines)


def _csv(found: SolutionAtTime, request: Request) -> str:
    header = [found.solution.frame.named(name) for name in ("t", "amplitude", "phase", "x")]
    t = np.linspace(0.0, float(cast("ExactReal", found.time).ball().mid()), request.points + 1)
    text = csv_text(header, [[repr(float(c)) for c in row] for row in zip(*found.solution.columns(t))])
    return with_errors(text, of_solution(found.solution, t))


def _drawn(found: SolutionAtTime, request: Request) -> list[Any]:
    order, frame = found.solution.order, found.solution.frame

    def again(other: Oscillator) -> Found:
        """The same of another law."""
        return replace(solution(other, order=order), frame=frame)

    return overlaid(request.options, found.solution, request["law"], again)


@question(
    Offers(
        latex="print a LaTeX document instead of text",
        more=(Option("fragment", "", "print the formulas of that document alone", "output"),),
        picture="A(t) and x(t) from 0 to T",
        table="t, amplitude, phase, x from 0 to T",
        curve=True,
        overlay=OVERLAY,
        oscillator_alone=True,
        data=_data,
        text=_text,
        as_latex=_latex,
        formula=lambda found, _: found.solution.latex(standalone=False),
        letters=lambda found, _: found.solution._letters(),
        as_csv=_csv,
        drawn=_drawn,
        style=lambda found, _: {"until": found.time},
        typed=require_stretch,
        lacks={"gauge": "the solution is in the turning-point gauge: A is the turning amplitude"},
    ),
    pairs=(
        demands("time", "epsilon law spring damping mass stiffness", "a strength with --time"),
        needs("bound", "time", "a bound belongs to a time", "--bound with --time T"),
    ),
    name="solution",
    example="--alpha 2 --epsilon 1/10 --order 1 --time 1 --digits 5",
    rests="the same series, explicit in the slow time: O(epsilon^N), not bounded",
)
def solution_at(
    law: Annotated[LawLike | Oscillator, MOVES_OR_FORMULAS],
    time: Annotated[Number | None, TIME] = None,
    *,
    order: Annotated[int, whole(1, MAX_ORDER)] = 3,
    bound: Annotated[bool, FLAG] = False,
    units: Annotated[str | None, choice(*UNITS, letter="U").called(group="output")] = None,
    digits: Annotated[int, digits(MAX_DIGITS)] = 30,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> SolutionAtTime:
    """The multiple-scale solution as functions of time: A(tau), phi(tau), x(tau) of order N, as formulas and numbers.

      asymptotics solution --alpha 2 --epsilon 1/10 --order 3
      asymptotics solution --alpha 2 --epsilon 1/10 --order 3 --time 50 --bound
      asymptotics solution --alpha 3/2 --units kappa --order 4
      asymptotics solution --alpha 2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --order 3 --time 7
      asymptotics solution --alpha 2 --epsilon 1/10 --order 3 --time 100 --plot decay.svg --csv decay.csv
      asymptotics solution --alpha 2 --order 4 --latex > solution.tex
      asymptotics solution --law 1:1/10 --law 2:1/20 --order 2

    One law: A and phi explicit in the slow time, x through order N (x(0) = 1, turning-point gauge); without a strength
    the formulas alone.  Sums of laws and springs: tau(A) and phi(A), with the numeric inverse.  --units epsilon
    (default), kappa = M_(alpha+1) epsilon (Lancaster 2020), or SI: t, m, k, b, x_0, the default where --damping, --mass
    or --stiffness is given.  --time is in s there, else tau.  Proved are the line "proved" (valid_until in JSON: |x -
    x_N| for all times, before rounding) and what --bound tells, |x - x_N| at T; the rest is an expansion.
    x = A cos(psi) + ..., A > 0: phi holds pi where --x0 is negative, and x_0 in the formulas is |x0|.
    --v0: a start in motion; the unit of length is sqrt(x0^2 + m v0^2/k) then, and x_0 in the formulas means it.
    A sum and a spring have --units epsilon alone.
    --latex prints a document that compiles, --fragment its formulas alone.

    In Python ``asy.solution(law, order=N)``, then ``.at(tau)``, or ``.at_time(oscillator, T, digits)`` in its units,
    ``.bound(tau)``, ``.in_units(U)``, ``.latex(standalone=False)``.

    Parameters
    ----------
    law
        a law or mapping exponent -> strength (epsilon) from rest, or an oscillator; an exponent, or "symbolic", for
        formulas alone
    time
        the time in s (or tau) at which A, phi and x are wanted
    order
        the order of the solution
    bound
        with a time: a proved bound of |x - x_N| there
    units
        the units of the formulas
    digits
        significant digits of the numbers
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for values out of range, anti-damping, a sum without losses, and a time or a bound without a strength
    LimitError
        where no enclosure for the bound is within reach

    Examples
    --------
    >>> found = solution_at({2: "1/10"}, 7, bound=True, digits=10)
    >>> found.point.x, found.bound
    ('0.6004602446', '0.000015')
    >>> print(solution_at("3/2", order=1, units="kappa").in_units["amplitude_in_units"])
    (kappa*tau/2 + 1)**(-2)
    """
    given = law if isinstance(law, Given) else None
    found = solution(cast("Any", law) if given is None else given.oscillator, order=order)
    found = found if given is None else replace(found, frame=given.frame)
    if isinstance(found, ImplicitSolution):
        # tau(A) and phi(A) have a letter for each strength, and no form in other units.
        if units not in (None, "epsilon"):
            raise InputError(
                "units", f"the formulas of a sum, or beside a spring, are not served in {units}", "epsilon"
            )
        units = "epsilon"
    # The units in which the numbers came are those in which the formulas are expected.
    units = units or ("SI" if given is not None and given.frame else "epsilon")
    made, moment = SolutionAtTime(found, units, _formulas(found, units)), cast("ExactReal | None", time)
    if moment is None:
        return made
    if given is None:
        raise InputError("epsilon", "no strength is given", "a law with its strength, such as {2: '1/10'}")
    point = found.at_time(given.oscillator, moment, digits)
    # Of the x that is printed, in the same units.
    proved = proved_bound(given.oscillator, point.x, moment) if bound else None
    return replace(made, time=moment, point=point, bound=proved)


def _formulas(found: Found, units: str) -> dict[str, str]:
    """A and phi in other units, where they are asked for and explicit."""
    if units == "epsilon" or isinstance(found, ImplicitSolution):
        return {}
    amplitude, phase = found.in_units(units)
    return {"amplitude_in_units": str(amplitude), "phase_in_units": str(phase)}
