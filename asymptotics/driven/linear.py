"""Viscous damping alone: x = Re(C e^(i theta)) with C = f/(k - mu + i c), exactly.

>>> from asymptotics.law import Oscillator
>>> found = exact(Drive.read(Oscillator({1: "1/10"}), "1/5", 1))
>>> str(found.amplitude), str(found.x0), str(found.v0)
('2', '0', '2')
"""

from dataclasses import dataclass

from flint import acb, arb

from asymptotics.driven.drive import Drive
from asymptotics.numbers.exact import ExactReal, square_root


@dataclass(frozen=True)
class Exact:
    """Amplitude, x and x' at t = 0; ties and zeros, which no ball tells, are exact where the numbers are rational."""

    amplitude: ExactReal | arb
    x0: ExactReal | arb
    v0: ExactReal | arb


def is_linear(drive: Drive) -> bool:
    """Whether the one loss that acts is viscous."""
    return all(a == 1 for a in drive.alphas)


def exact(drive: Drive) -> Exact:
    """For ``is_linear``; balls at the precision in force where a number is irrational."""
    b, given = drive.losses[0].strength, (drive.oscillator.mass, drive.oscillator.stiffness, drive.force, drive.omega)
    if isinstance(b, ExactReal) and all(n.is_rational for n in (b, *given)):
        m, k, f, omega = (n.rational for n in given)
        apart, c = k - m * omega**2, b.rational * omega
        size = apart**2 + c**2
        return Exact(square_root(f**2 / size), ExactReal(f * apart / size), ExactReal(omega * f * c / size))
    found = coefficient(drive)
    return Exact(abs(found), found.real, -found.imag * drive.omega.ball())


def coefficient(drive: Drive) -> acb:
    """C as a ball."""
    balls = drive.balls()
    return balls.f / acb(balls.k - balls.mu, balls.losses[0][0])
