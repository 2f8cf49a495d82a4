"""What the certified flow asks of a force: of the linear spring (``swing.damping``), of any well (``wells.force``).

    u' = -w,    w' = G(u, w) = u + sum c_j u^n_j + sum d_i u^m_i w^alpha_i      on one side of u = 0, w >= 0,

with sin(r u)/r in place of u for a pendulum.  Dry friction is among the c_j, or u counts from the place of rest that it
shifts.
"""

from typing import Protocol

from flint import arb


class Force(Protocol):
    """``rate``: r of a pendulum, else None; ``linear``: 1 where G - u depends on w alone, else 0.

    ``entire``: whether every exponent of the speed is a whole number, so that the speed may vanish on a step.
    """

    @property
    def rate(self) -> arb | None:
        """r."""

    @property
    def linear(self) -> int:
        """1 or 0."""

    @property
    def entire(self) -> bool:
        """Whether the speed may vanish."""

    def rest_powers(self, side: int, /) -> list[tuple[arb, int]]:
        """(c_j, n_j) where u has the sign ``side``."""

    def loss_powers(self, side: int, /) -> list[tuple[arb, int, arb]]:
        """(d_i, m_i, alpha_i) where u has the sign ``side``."""

    def largest(self, u: arb, du: arb, w: arb, dw: arb, /) -> arb:
        """A bound of |G - ``linear`` u|, up to a constant, on the complex discs |U - u| <= du, |W - w| <= dw < w."""
