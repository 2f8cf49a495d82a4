"""The averages of |sin|^p."""

from importlib import import_module
from typing import Annotated

from asymptotics.ask.answers import Again, Offers, Request
from asymptotics.ask.kinds import REAL, SECONDS, digits
from asymptotics.ask.question import question
from asymptotics.errors import InputError
from asymptotics.expansions.moments import exact
from asymptotics.expansions.moments.certified import moment as moment_ball
from asymptotics.numbers.decimals import certified_decimal, rational_decimal
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.numbers.value import Coefficient

# Sizes of answers that still come at once and can be read; they refuse, and nothing that is answered rests on them.
MAX_P, MAX_DIGITS = 10_000, 10_000


def _latex(found: Coefficient, request: Request) -> str:
    return rf"M_{{{request['p']}}} = {found._formula()}"


@question(
    Offers(
        latex="print the closed form as LaTeX",
        again=Again(exact=True),  # a quotient of Gamma functions in balls
        data=lambda found, request: {"p": str(request["p"]), "value": found.value, "exact": found.exact},
        text=lambda found, request: f"M_{request['p']} = {found.value} = {found.exact}",
        as_latex=_latex,
        lacks={
            "alpha": "an average has a power, `--p`: of a loss with the exponent alpha it is alpha + 1",
            "csv": "it is one number; `table moments --csv` has many",
            "gauge": "an average has no gauge",
            "plot": "it is one number",
            "points": "it is one number; `table moments --rows` has many",
        },
    ),
    swept=True,
    example="--p 2 --digits 5",
    rests="balls (`certified_zero`: exact where it is rational)",
)
def moment(
    p: Annotated[Number, REAL.called(letter="P", suffix=f", at most {MAX_P}")],
    *,
    digits: Annotated[int, digits(MAX_DIGITS)] = 30,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> Coefficient:
    """The average M_p of |sin|^p, which everything is made of: M_p = Gamma((p+1)/2) / (sqrt(pi) Gamma(p/2+1)).

      asymptotics moment --p 5/2 --digits 40

    Parameters
    ----------
    p
        a real number above -1
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for p <= -1, where the average diverges, and for what is no exact number

    Examples
    --------
    >>> print(moment("5/2", digits=12), moment(3).exact)
    0.457655858101 4/(3*pi)
    """
    number = exact_number(p, "p")
    # |sin|^p is integrable at the zeros of the sine for p > -1 alone.
    if not number > -1 or number > MAX_P:
        reason = "the average diverges" if not number > -1 else "is out of range"
        raise InputError("p", f"{number}: {reason}", f"a real number above -1, at most {MAX_P}")
    # M_p is rational for even p, a rational over pi for odd p; a rational may be a tie, which only exact rounding
    # tells.
    if number.is_integer and number.rational.numerator % 2 == 0:
        value = rational_decimal(exact.integer_moment(number.rational.numerator)[0], digits)
    else:
        value = certified_decimal(lambda: moment_ball(number.ball()), digits)
    # SymPy for irrational p alone: it takes longer to load than digits and closed form take.
    closed = exact if number.is_rational else import_module("asymptotics.expansions.moments.symbolic")
    return Coefficient(value, closed.moment(closed.number(number)))
