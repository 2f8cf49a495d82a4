"""The first-order envelope of an oscillator: one object for every law, in SI units or dimensionless.

A(t) in m, t in s; A(0) is the unit of length of the oscillator (|x0|, or the radius of the starting point when v0 is
not 0: the averaged law sees the energy, not the phase).  Digits are certified for the *averaged law*: how far the
averaged law is from the motion is a matter of ``validity`` and of higher orders.

>>> from asymptotics.law import Law, Oscillator
>>> drag = Oscillator(Law({"3/2": "1/10"}), mass="3/2", stiffness="30", x0="1/5")
>>> envelope = FirstOrderEnvelope(drag)
>>> envelope.amplitude("7", 20), envelope.phase("7", 8)
('0.16499144423436389044', '-0.00086348062')
>>> friction = Oscillator(Law({"0": "0.14715"}), mass="3/2", stiffness="30", x0="0.2")   # Lelas, mu = 0.01
>>> FirstOrderEnvelope(friction).extinction_time(5), FirstOrderEnvelope(friction, "squaring").extinction_time(5)
('14.322', '12.894')
>>> FirstOrderEnvelope(friction).amplitude("15", 5), FirstOrderEnvelope(drag).extinction_time(5)
('0', None)
"""

from dataclasses import dataclass
from fractions import Fraction
from functools import partial
from typing import cast

import numpy as np
from flint import acb, arb

from asymptotics.envelopes import certified
from asymptotics.envelopes.numeric import Array, NumericEnvelope
from asymptotics.envelopes.symbolic import MEAN, SQUARING, require_averaging
from asymptotics.errors import InputError
from asymptotics.expansions.moments.exact import integer_moment
from asymptotics.law import Oscillator
from asymptotics.numbers.decimals import certified_decimal
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.terms import Term

_MOST_EXACT = 10_000  # an exponent beyond it has no tie within the digits that are served


def exact_kappa(term: Term) -> ExactReal | None:
    """epsilon <|cos|^m |sin|^(alpha+1)> as an exact number, whose ties a ball cannot tell; None where it is none.

    >>> from asymptotics.law import Law
    >>> exact_kappa(Law({(3, 2): "1/2"}).terms[0]), exact_kappa(Law({2: 1}).terms[0])
    (ExactReal('1/32'), None)
    """
    a, m, e = term.velocity, term.position, term.strength
    if not (a.is_integer and a < _MOST_EXACT and m < _MOST_EXACT and m % 2 == 0 and isinstance(e, ExactReal)):
        return None
    found, over_pi = integer_moment(int(a.rational) + 1)
    for k in range(2, m + 1, 2):
        # <|c|^k |s|^b> = (k-1)/(k+b) <|c|^(k-2) |s|^b> with b = a + 1, by parts (``moments.symbolic.mean``).
        found *= Fraction(k - 1, k + int(a.rational) + 1)
    return None if over_pi else e * found


def exact_squaring(term: Term) -> ExactReal | None:
    """epsilon 2^(-(alpha+1)/2), the rate of the squaring trick, as an exact number; None where it is none.

    >>> from asymptotics.law import Law
    >>> exact_squaring(Law({3: "1/2"}).terms[0]), exact_squaring(Law({2: "1/2"}).terms[0])
    (ExactReal('1/8'), ExactReal('1/4*sqrt(1/2)'))
    """
    a, e = term.velocity, term.strength
    if not (a.is_integer and a < _MOST_EXACT and isinstance(e, ExactReal)):
        return None
    halves, odd = divmod(int(a.rational) + 1, 2)
    try:
        return e * ExactReal(Fraction(1, 2**halves), Fraction(1, 1 + odd))
    except InputError:  # two roots: no decimal, and so no tie
        return None


def start_phase(oscillator: Oscillator) -> arb:
    """phi(0) in x - i v/omega_0 = A e^(i phi), in (-pi, pi]: from rest 0, or pi where x0 < 0; rad.

    >>> [start_phase(Oscillator({2: 1}, x0=x, v0=v)).str(6, radius=False) for x, v in ((1, 0), (-1, 0), (0, 1))]
    ['0', '3.14159', '-1.57080']
    """
    speed = oscillator.v0.ball() / oscillator.omega_0()
    return acb(oscillator.x0.ball(), -speed).arg()


@dataclass(frozen=True)
class FirstOrderEnvelope:
    """dA/dtau = -sum_i kappa_i A^alpha_i for an oscillator; ``averaging`` "mean" (Lancaster) or "squaring".

    Raises InputError for anti-damping (b < 0) and an unknown averaging.
    """

    oscillator: Oscillator
    averaging: str = MEAN

    def __post_init__(self) -> None:
        require_averaging(self.averaging)
        self.oscillator.law.require_dissipative("decaying envelope")

    def laws(self) -> list[tuple[ExactReal, arb]]:
        """(alpha_i, kappa_i) with balls at the current precision; laws of zero strength are left out."""
        # A strength is exactly 0, or its ball does not hold 0 (``ExactReal.ball``): none that acts is dropped.
        return [(a, k) for a, k in zip(self.oscillator.law.alphas, self.rates()) if k > 0]

    def rates(self) -> tuple[arb, ...]:
        """kappa_i of every law, also of zero strength: M_(alpha_i+1) epsilon_i, or 2^(-(alpha_i+1)/2) epsilon_i."""
        if self.averaging == MEAN:
            return self.oscillator.kappas()
        alphas = self.oscillator.law.alphas
        return tuple(arb(2) ** (-(a.ball() + 1) / 2) * e for a, e in zip(alphas, self.oscillator.epsilons()))

    def kappas(self, digits: int) -> tuple[str, ...]:
        """The same as decimals, correctly rounded."""
        # A rational rate may be a tie between two decimals, which no ball tells from its neighbours; others are balls.
        exact = exact_kappa if self.averaging == MEAN else exact_squaring
        found = [exact(term) for term in self.oscillator.dimensionless.terms]
        return tuple(certified_decimal(partial(self._rate, i, known), digits) for i, known in enumerate(found))

    def _rate(self, i: int, known: ExactReal | None) -> arb | ExactReal:
        return self.rates()[i] if known is None else known

    def amplitude(self, t: Number, digits: int) -> str:
        """A(t) in m at an exact time t >= 0 in s, correctly rounded; "0" from the extinction time on."""
        seconds = exact_number(t, "time")
        # A(0) is then the number that was given, of which a ball could not tell a tie between two decimals.
        if seconds.is_zero and self.oscillator.v0.is_zero:
            return certified_decimal(lambda: abs(self.oscillator.x0), digits)
        return certified_decimal(lambda: self.amplitude_ball(seconds.ball() * self.oscillator.omega_0()), digits)

    def amplitude_ball(self, tau: arb) -> arb:
        """A(tau) in m as a ball."""
        return certified.amplitude(self.laws(), tau) * self.oscillator.length()

    def time(self, amplitude: Number, digits: int) -> str:
        """t in s at which A(t) equals an exact amplitude in m, correctly rounded; InputError unless 0 < A <= A(0)."""
        metres, start = exact_number(amplitude, "amplitude"), self.oscillator.x0
        released = not (self.oscillator.v0 < 0 or self.oscillator.v0 > 0)
        if released and metres == abs(start):
            return "0"

        def seconds() -> arb:
            relative = metres.ball() / self.oscillator.length()
            # Only what is certainly above the start is refused: a ball that holds 1 goes on, and is narrowed.
            if relative > 1:
                raise InputError("amplitude", f"{metres} m is above the start", "0 < amplitude <= A(0)")
            return certified.time(self.laws(), relative) / self.oscillator.omega_0()

        return certified_decimal(seconds, digits)

    def phase(self, t: Number, digits: int) -> str:
        """phi(t) in rad, from ``start_phase`` on; turning-point gauge, uniform first order; "0" for "squaring".

        InputError once extinct.
        """
        seconds = exact_number(t, "time")
        if self.averaging == SQUARING:
            return "0"
        return certified_decimal(
            lambda: start_phase(self.oscillator) + self.lag_ball(seconds.ball() * self.oscillator.omega_0()), digits
        )

    def lag_ball(self, tau: arb) -> arb:
        """phi(tau) - phi(0) as a ball."""
        A = certified.amplitude(self.laws(), tau)
        if A == 0:
            raise InputError("time", "the averaged amplitude is 0 and has no phase", "a time before the extinction")
        strengths = [e for e in self.oscillator.epsilons() if e > 0]
        return certified.phase(self.laws(), strengths, A)

    def extinction_time(self, digits: int) -> str | None:
        """The time in s from which the averaged amplitude is 0, if an exponent is below 1; None if there is none.

        It is the end of the averaged law, not of the motion, which sticks (alpha = 0) or creeps (0 < alpha < 1).
        """

        if certified.extinction_time(self.laws()) is None:
            return None

        def seconds() -> arb:  # whether there is an end depends on the exponents, not on the precision
            return cast("arb", certified.extinction_time(self.laws())) / self.oscillator.omega_0()

        return certified_decimal(seconds, digits)

    def numeric(self) -> NumericEnvelope:
        """The dimensionless averaged law in double precision, for arrays of tau; heuristic."""
        return NumericEnvelope.of_weights([(float((a - 1).ball().mid()), float(k.mid())) for a, k in self.laws()])

    def amplitudes(self, t: Array) -> Array:
        """A in m at an array of times in s, in double precision: heuristic.  NaN stays NaN, extinct is 0."""
        # Heuristic from here on: middles of balls, and no bound.
        omega_0, length = (float(x.mid()) for x in (self.oscillator.omega_0(), self.oscillator.length()))
        with np.errstate(over="ignore"):  # beyond the range of doubles is at infinity, where nothing is left
            return self.numeric().amplitude(omega_0 * t) * length
