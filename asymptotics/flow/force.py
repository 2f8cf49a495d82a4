"""What the certified flow asks of a force: of the linear spring (``flow.damping``), of any well (``flow.wells.force``).

    u' = -w,    w' = G(u, w) = u + sum c_j u^n_j + sum d_i u^m_i w^alpha_i      on one side of u = 0, w >= 0,

with sin(r u)/r in place of u for a pendulum.  Dry friction is among the c_j, or u counts from the place of rest that it
shifts.
"""

from typing import Protocol

from flint import arb


# Three protocols, from the one that asks least: a Taylor step needs no sign of anything, the distance of two motions
# needs slopes, and turning points need a force that only loses energy (limit cycles stop at the second).
class Smooth(Protocol):
    """What a Taylor step asks.  ``rate``: r of a pendulum, else None; ``linear``: 1 where G - u depends on w alone.

    ``entire``: whether G is one polynomial in the speed on both sides of w = 0, so that it may vanish on a step; then
    every exponent of the speed is a whole number, which a step asks for again.
    """

    @property
    def rate(self) -> arb | None:
        """r in the pendulum's sin(r u)/r; None without a pendulum."""

    @property
    def linear(self) -> int:
        """1 where the linear spring stands apart from what is bounded by ``largest``, else 0."""

    @property
    def entire(self) -> bool:
        """Whether the speed may vanish."""

    def restoring_powers(self, side: int, /) -> list[tuple[arb, int]]:
        """(c_j, n_j) where u has the sign ``side``."""

    def loss_powers(self, side: int, /) -> list[tuple[arb, int, arb]]:
        """(d_i, m_i, alpha_i) where u has the sign ``side``."""

    def largest(self, u: arb, du: arb, w: arb, dw: arb, /) -> arb:
        """A bound of |G - ``linear`` u|, up to a constant, on the complex discs |U - u| <= du, |W - w| <= dw < w."""


class HasSlopes(Smooth, Protocol):
    """What the distance of two motions asks.  ``nonexpansive``: whether it never grows."""

    @property
    def nonexpansive(self) -> bool:
        """Whether two motions never part."""

    def slopes(self, u: arb, w: arb, /) -> tuple[arb, arb]:
        """Balls with all G_u, and with all G_w above 0 (0 where losses only grow with the speed)."""


class Force(HasSlopes, Protocol):
    """A force that only loses energy.  ``kinked``: not one analytic function on both sides of u = 0.

    ``viscous``: the strength of the loss epsilon w that contracts; ``least_power``: a <= 1, on which hangs how relative
    distances of turning points grow.
    """

    @property
    def kinked(self) -> bool:
        """Whether a Taylor step must end at u = 0."""

    @property
    def viscous(self) -> arb:
        """The strength of the loss epsilon w, by which ``contraction_by_energy`` sharpens its bound."""

    @property
    def least_power(self) -> arb | None:
        """1 where ln q of two motions draw together, less where they may part; None where nothing is known."""

    @property
    def grips(self) -> object:
        """Whether (or what) dry friction holds the mass somewhere."""

    def restoring(self, u: arb, /) -> arb:
        """The acceleration from rest, s_0(u) = G(u, 0)."""

    def drag(self, u: arb, w: arb, /) -> arb:
        """s_0 - G at speeds up to that of a ball w."""

    def strongest(self, u: arb, w: arb, /) -> arb:
        """A bound of the acceleration in either direction at the place u, not counted from a shifted rest."""
