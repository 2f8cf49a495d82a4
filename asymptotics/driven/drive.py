"""What is driven, by which force: read, refused by name, and in balls with the angle theta = Omega t as the time.

>>> from asymptotics.law import Oscillator
>>> drive = Drive.read(Oscillator({2: "1/10"}, mass=2), "1/5", 3)
>>> drive.balls().mu, drive.balls().losses[0][0].str(5)
(18.0000000000000, '[0.90000 +/- ...]')
>>> Drive.read(Oscillator({0: "1/5"}), "1/5", 1)
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument force: 1/5 never moves the mass: dry friction holds it ... (accepted: ...)
"""

from dataclasses import dataclass

from flint import arb

from asymptotics.errors import InputError
from asymptotics.law import Oscillator
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_number
from asymptotics.terms import Term


@dataclass(frozen=True)
class Balls:
    """mu x'' + k x + sum c x'|x'|^(alpha-1) = f cos(theta); ``losses`` has (c, alpha)."""

    mu: arb
    k: arb
    f: arb
    losses: tuple[tuple[arb, arb], ...]

    def in_units(self, length: arb) -> "Balls":
        """The same with x in units of ``length`` and forces in units of f."""
        losses = tuple((c * length**alpha / self.f, alpha) for c, alpha in self.losses)
        return Balls(self.mu * length / self.f, self.k * length / self.f, arb(1), losses)


@dataclass(frozen=True)
class Drive:
    """An oscillator, whose start counts for nothing, under the force f cos(Omega t)."""

    oscillator: Oscillator
    force: ExactReal
    omega: ExactReal

    @classmethod
    def read(cls, oscillator: Oscillator, force: Number, omega: Number) -> "Drive":
        """InputError for f <= 0, Omega <= 0, springs, gains, no loss, and a force that dry friction withstands."""
        law, given = oscillator.law, {"force": exact_number(force, "force"), "omega": exact_number(omega, "omega")}
        for name, value in given.items():
            if not value > 0:
                raise InputError(name, f"{value} is not positive", "a positive number")
        law.require_pure("the driven response")
        law.require_dissipative("response that attracts")
        found = cls(oscillator, **given)
        if not found.losses:
            raise InputError("law", "all strengths are 0: without a loss no motion attracts", "a strength > 0")
        friction = found.friction
        if friction is not None and not friction.strength.ball() < given["force"].ball():
            reason = f"{given['force']} never moves the mass: dry friction holds it up to {friction.strength}"
            raise InputError("force", reason, "a force above the dry friction")
        return found

    @property
    def losses(self) -> tuple[Term, ...]:
        """The terms that act."""
        return tuple(t for t in self.oscillator.law.terms if not t.strength.is_zero)

    @property
    def friction(self) -> Term | None:
        """The dry friction, if there is any."""
        return next((t for t in self.losses if t.velocity.is_zero), None)

    @property
    def alphas(self) -> tuple[ExactReal, ...]:
        """The exponents that act."""
        return tuple(t.velocity for t in self.losses)

    def balls(self) -> Balls:
        """mu, k, f and c at the precision in force."""
        return self._balls(self.omega.ball(), self.oscillator.mass.ball() * self.omega.ball() ** 2)

    def balls_at_resonance(self) -> Balls:
        """The same at omega_0 = sqrt(k/m), where mu = k."""
        return self._balls(self.oscillator.omega_0(), self.oscillator.stiffness.ball())

    def _balls(self, omega: arb, mu: arb) -> Balls:
        losses = tuple((t.strength.ball() * omega ** t.velocity.ball(), t.velocity.ball()) for t in self.losses)
        return Balls(mu, self.oscillator.stiffness.ball(), self.force.ball(), losses)
