"""The response to a harmonic force: first order closed, and the one periodic orbit, certified."""

from dataclasses import replace
from typing import TYPE_CHECKING, Annotated, cast

from asymptotics.ask.answers import Offers
from asymptotics.ask.kinds import REAL, SECONDS, digits
from asymptotics.ask.laws import moving
from asymptotics.ask.question import question
from asymptotics.driven.drive import Drive
from asymptotics.driven.result import MAX_DIGITS, Response, respond
from asymptotics.law import LawLike, Oscillator
from asymptotics.numbers.policy import Number

if TYPE_CHECKING:
    from asymptotics.law_given import Given

DRIVEN = moving("its strength, in units m = k = 1", springs=False, start=())


@question(
    Offers(
        latex="print the first harmonic as LaTeX",
        picture="amplitude and phase of first order against Omega, the backbone of the free decay, and the response",
        table="the numbers",
        equation=lambda found, _: found._equation(),
        lacks={"gauge": "what is observed is the same in every gauge", "points": "the answer is no curve"},
    ),
    swept=True,
    example="--law 2:1/10 --force 1/5 --omega 9/10 --digits 5",
    rests="a trial orbit with its defect and a contraction, in balls (`driven-unique`); where dry friction holds the"
    " mass, or it turns more than once in half a period, first order alone (`driven-first-order`)",
)
def response(
    law: Annotated[LawLike | Oscillator, DRIVEN],
    force: Annotated[Number, REAL.called(letter="F")],
    omega: Annotated[Number, REAL.called(letter="W")],
    *,
    digits: Annotated[int, digits(MAX_DIGITS)] = 20,
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> Response:
    """The response of m x'' + k x + sum_i b_i x'|x'|^(A_i-1) = F cos(W t): one periodic orbit, and it attracts.

      asymptotics response --law 2:1/10 --force 1/5 --omega 1
      asymptotics response --law 1:1/20 --law 3/2:1/10 --force 1/5 --omega 9/10 --digits 40
      asymptotics response --alpha 2 --damping 1/10 --mass 3/2 --stiffness 30 --force 1/2 --omega 4

    The power of a loss grows with the speed, so two motions under one force never part: there is one periodic response,
    no jumps, and every motion tends to it; of dry friction alone that is said only where the response is certified.
    To first order x = A cos(W t - phase) in closed form, for every exponent: beside A and the phase c_eq, the amplitude
    at omega_0, Q there of the decay and of the half-power width (both to leading order in the loss), where the
    amplitude is largest, and an estimate of the error by the next harmonics.  The response itself, all digits proved,
    for every sum of losses where it turns once in half a period and dry friction never holds it: `amplitude` its
    largest |x|; `x0` and `v0` at t = 0, where the force is F; `phase`, by which its first harmonic lags behind the
    force, 0 to pi; the energy that a cycle takes, the harmonics, and `difference`, what amplitude and phase are beyond
    first order.  Else `certified` is false, the notes say why, and the first order is all there is.

    Without units m = k = 1; with --damping, --mass or --stiffness everything is in SI: F in N, W in rad/s, x in m.

    Parameters
    ----------
    law
        a law or mapping exponent -> strength, or an oscillator (its start counts for nothing)
    force
        the largest force, F > 0
    omega
        its angular frequency, W > 0
    digits
        significant digits, correctly rounded
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for F <= 0, W <= 0, springs, gains, no loss at all, and a force that dry friction withstands
    LimitError
        after ``max_seconds``
    UndecidedError
        where the enclosures stay too wide

    Notes
    -----
    Source: derivations ``driven-first-order`` and ``driven-unique``.

    Examples
    --------
    >>> found = response({2: "1/10"}, "1/5", 1, digits=10)
    >>> found.amplitude, found.phase, found.first_order.amplitude, found.certified
    ('1.535518147', '1.576756652', '1.534990062', True)
    """
    given = cast("Given", law)
    return replace(respond(Drive.read(given.oscillator, force, omega), digits), frame=given.frame)
