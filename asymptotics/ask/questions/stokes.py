"""Why the series diverge: the Stokes constants of the half-swing, certified."""

from typing import Annotated

from asymptotics.ask.answers import Offers
from asymptotics.ask.kinds import REAL, SECONDS, digits, whole
from asymptotics.ask.question import question
from asymptotics.expansions.divergence.result import MAX_COUNT, MAX_DIGITS, StokesConstants, stokes_constants
from asymptotics.numbers.policy import Number
from asymptotics.present.inputs import csv_text


@question(
    Offers(
        latex="print the constants as LaTeX",
        picture="|c_k| and |d_k|",
        table="both constants of each k",
        as_csv=lambda found, _: csv_text(found._page().head, found.rows()),
        lacks={"gauge": "the constants are the same in every gauge", "points": "`--count` says how many"},
    ),
    swept=True,
    example="--alpha 0 --digits 5",
    rests="balls (`abel-petal`)",
)
def stokes(
    alpha: Annotated[Number, REAL],
    *,
    count: Annotated[int, whole(1, MAX_COUNT, "K")] = 1,
    digits: Annotated[int, digits(MAX_DIGITS)] = 17,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> StokesConstants:
    """Why the series diverge: the Stokes constants of the half-swing of one law, certified.

    c_k belong to the amplitude and d_k to the time: in front of the factorial growth of p_k stands c_1 + d_1/pi, of
    Omega_k d_1, and a truncated expansion at the local strength delta leaves about |c_1| e^(-2 pi |c|/delta).

      asymptotics stokes --alpha 2
      asymptotics stokes --alpha 3/2 --count 2 --digits 20

    alpha > 0 other than 1 (at 0 all vanish); near 1 the work grows like 1/|alpha - 1| and is refused by its estimate.

    Parameters
    ----------
    alpha
        the exponent, 0 or more, not 1
    count
        how many constants
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for an exponent that is 1, negative or above 50
    LimitError
        with the estimate, where it takes longer than ``max_seconds``
    UndecidedError
        where a bound does not hold

    Notes
    -----
    Phi_+ - Phi_- = sum c_k q^k and theta_+ - theta_- = sum d_k q^k, q = e^(-2 pi i w), for the Abel function Phi of the
    half-swing and its time theta on the two petals (Ecalle).  Sums of laws and springs are not treated.  Source:
    derivation ``abel-petal``.

    Examples
    --------
    >>> stokes(2, digits=12).constants
    ('-0.0909280010378',)
    """
    return stokes_constants(alpha, count, digits, ())
