"""A soundness ladder: a function that returns balls, at rising precision and with wide inputs, against 400 bits."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

from flint import arb, ctx

RUNGS = (10, 20, 40, 80, 160)


@dataclass(frozen=True)
class Ladder:
    """``value`` at a ball x gives balls at the current precision; ``covers``: what is computed on the way.

    ``lost``: bits by which the radius may exceed that of the precision, in units of 1 and of the value; ``stretch``:
    by how much the radius may exceed that of a wide x, None where x is exact by contract; ``least``: the bits from
    which on an answer is demanded (below it, UndecidedError is one); ``rungs`` and ``truth`` where it is dear;
    ``wide``: log2 of the radii of wide inputs.
    """

    covers: tuple[str, ...]
    value: Callable[[arb], Sequence[arb]]
    at: str = "0.75"
    lost: int = 10
    stretch: float | None = None
    least: int = 10
    rungs: tuple[int, ...] = RUNGS
    truth: int = 400
    wide: tuple[int, ...] = (-6, -20)

    def exact(self) -> arb:
        """The input: a number of few bits."""
        return dyadic(self.at)

    def balls(self, x: arb, bits: int) -> list[arb]:
        """The values at a precision."""
        with ctx.workprec(bits):
            return list(self.value(x))


def dyadic(text: str) -> arb:
    """The number of at most 8 bits near a decimal: exact at every rung."""
    with ctx.workprec(8):
        return arb(text).mid()


def size(x: arb) -> arb:
    """max(1, |x|)."""
    return arb(max(1.0, float(abs(x).upper())))
