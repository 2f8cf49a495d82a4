"""Limit cycles: amplitude, frequency, multiplier in powers of mu; certified at a number."""

from typing import Annotated, cast

from asymptotics.ask.answers import Offers, Request
from asymptotics.ask.kinds import REAL, SECONDS, digits, whole
from asymptotics.ask.laws import law_with_strengths
from asymptotics.ask.question import question
from asymptotics.ask.rows import row_text, rows_csv, rows_latex
from asymptotics.errors import InputError
from asymptotics.law import Law, LawLike, SpringLike
from asymptotics.limit_cycles.result import LimitCycle
from asymptotics.limit_cycles.result import limit_cycle as of_law
from asymptotics.limit_cycles.series import MAX_ORDER
from asymptotics.numbers.policy import Number, exact_double, exact_number
from asymptotics.present.inputs import csv_text

MAX_DIGITS = 200
_NUMBERS = {"amplitude": "A", "period": "T", "frequency": r"\omega", "multiplier": r"\rho"}


def _latex(found: LimitCycle, request: Request) -> str:
    """The series, and the numbers at mu."""
    rows = {"A": found.amplitude, r"\omega": found.frequency, r"\log\rho": found.log_multiplier}
    series = rows_latex({name: row for name, row in rows.items() if row}, (r"\mu",), request["digits"])
    if found.at_mu is None:
        return series
    numbers = [rf"{letter}({found.at_mu.mu}) = {getattr(found.at_mu, name)}" for name, letter in _NUMBERS.items()]
    return " \\\\\n".join([*([series] if series else []), *numbers])


def _table(found: LimitCycle) -> str:
    """The coefficients as CSV, or (beside springs) the numbers at mu."""
    if found.at_mu is not None and not found.amplitude:
        return csv_text(["quantity", "value"], [(name, getattr(found.at_mu, name)) for name in _NUMBERS])
    names = ("amplitude", "frequency", "multiplier", "log_multiplier")
    return rows_csv({name: getattr(found, name) for name in names})


def _text(found: LimitCycle) -> str:
    # Beside springs there is no series in mu, whose first term would be the linear frequency 1.
    lines = [f"{found.equation}, {found.arithmetic}; powers of mu" if found.frequency else found.equation]
    lines += [*row_text("A", found.amplitude), *row_text("omega", found.frequency)]
    lines += row_text("log multiplier", found.log_multiplier)
    if found.at_mu is not None:
        # ``stable`` is None where the ball of the multiplier holds 1: neither is proved.
        names = ("amplitude", "period", "frequency", "multiplier")
        kind = {True: "stable", False: "unstable", None: "stability undecided"}[found.at_mu.stable]
        lines += [f"at mu = {found.at_mu.mu}: certified, {kind}"]
        lines += [f"{name:10}  {getattr(found.at_mu, name)}" for name in names]
    return "\n".join(lines)


@question(
    Offers(
        latex="print the series, or the numbers, as LaTeX",
        picture="amplitude and frequency against mu",
        table="the coefficients; beside springs the numbers at mu",
        text=lambda found, _: _text(found),
        as_latex=_latex,
        as_csv=lambda found, _: _table(found),
        lacks={"gauge": "what is observed is the same in every gauge", "points": "there is no curve"},
    ),
    swept=True,
    example="--law 1:-1 --law 1,2:1 --order 2 --digits 5",
    rests="formal series, exact; at a strength mu balls",
)
def limit_cycle(
    law: Annotated[LawLike, law_with_strengths("its strength, negative for a gain", negative=True)],
    *,
    order: Annotated[int, whole(0, MAX_ORDER)] = 8,
    digits: Annotated[int, digits(MAX_DIGITS)] = 30,
    mu: Annotated[Number | None, REAL.called(letter="M")] = None,
    spring: SpringLike | None = None,
    near: Annotated[Number | None, REAL.called(letter="A")] = None,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> LimitCycle:
    """The limit cycle of x'' + x + mu sum_i E_i |x|^M_i x'|x'|^(A_i-1) = 0, where gains and losses of energy balance:

    turning amplitude and frequency as series in mu, the common factor of the laws, exactly; the multiplier of a small
    departure per period, and its logarithm.  With --mu the cycle itself at that number: turning amplitude, period,
    frequency and multiplier, certified by interval Newton.

      asymptotics limit-cycle --law 1:-1 --law 1,2:1 --order 8             van der Pol
      asymptotics limit-cycle --law 1:-1 --law 3:1 --order 8 --mu 1/2      Rayleigh
      asymptotics limit-cycle --law 1:-1 --law 1,2:1 --spring 3:1/2 --mu 1 a cubic spring beside x, at a number
      asymptotics limit-cycle --law 1:1 --law 1,2:-5 --law 1,4:1 --near 4  the outer of two cycles

    The laws must be polynomials in x and x': M even, A odd, and their strengths rational for the series.  Springs x^P
    x'^Q (P odd, Q even) are not multiplied by mu; beside them there is no series, and --mu is needed.  |mu| is in
    1e-100 .. 20: stronger relaxation oscillations are left out, and cycles whose multiplier is 1 to a hundred digits.

    Parameters
    ----------
    law
        a law or mapping exponent -> strength, negative for a gain
    order
        the highest power of mu
    digits
        significant digits, correctly rounded
    mu
        a number: the cycle there as well, certified
    spring
        springs beside the linear one (those of the law in the shell)
    near
        the amplitude of the cycle that is meant, if there are several
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for a law without a limit cycle, with several and no ``near``, or that is no polynomial
    LimitError
        after ``max_seconds``

    Examples
    --------
    >>> van_der_pol = limit_cycle({1: -1, (1, 2): 1}, order=4)
    >>> van_der_pol.amplitude["2"].exact, van_der_pol.frequency["2"].exact
    ('1/96', '-1/16')
    >>> limit_cycle({1: -1, (1, 2): 1}, mu=1, spring={3: "1/2"}, digits=12).at_mu.amplitude
    '1.95363409607'
    """
    if near is not None and not exact_number(near, "near") > 0:
        raise InputError("near", f"{near} is not positive", "an amplitude > 0")
    # ``near`` only chooses among cycles that are then proved: a double is enough.
    place = None if near is None else exact_double(near, "near")
    # mu multiplies the losses alone: ``of_law`` does not read springs as part of what grows with it.
    return of_law(cast("Law", law), order, digits, mu if mu is None else exact_number(mu, "mu"), place)
