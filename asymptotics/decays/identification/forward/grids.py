"""Grids in theta on the two quarters of a half-swing, with their integrals: for any power, and for smooth forces.

>>> import numpy as np
>>> for grid in (sinc_grid(), gauss_grid()):
...     print(len(grid.sine), f"{grid.weights @ grid.sine:.12f}", f"{grid.middle @ grid.cosine:.12f}")
130 2.000000000000 1.000000000000
48 2.000000000000 1.000000000000
"""

from dataclasses import dataclass

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray
from scipy.special import sici

from asymptotics.numbers.context import cache

Array = NDArray[np.float64]
_HALF_NODES = 32
"""Nodes on either side of the middle of each quarter: the coefficients are then right to about 1e-12.  Against 64
nodes, laws 3/2, 1/10 + 2 and 3/2 with a cubic spring through degree 5 are off by 2e-6 at most with 16, 3e-9 with 24 and
2e-12 with 32."""
_GAUSS_NODES, _TOP = 24, 2
"""Nodes of each quarter for smooth forces, and how many of the highest Legendre coefficients show what they leave."""


@dataclass(frozen=True)
class ThetaGrid:
    """theta on both quarters: its sine and cosine, the integral to each node, to pi/2 (``middle``) and to pi.

    ``top``: the highest coefficients of a function on each quarter; none where the grid serves every function.
    """

    sine: Array
    cosine: Array
    cumulative: Array
    middle: Array
    weights: Array
    top: Array


@cache
def sinc_grid(half: int = _HALF_NODES) -> ThetaGrid:
    """Sinc nodes u_k = k h with theta = (pi/4)(1 + tanh((pi/2) sinh u)); Haber's indefinite integration formula."""
    k = np.arange(-half, half + 1)
    # The step that balances the error of the sum and that of cutting it off, up to a constant.
    h = np.log(half) / half
    g = np.pi * np.sinh(k * h)
    # At the other end 1 - share has no digits; there cos theta comes from the mirror image.
    share = 1 / (1 + np.exp(-g))  # theta/(pi/2), accurate at its small end
    slope = np.pi / 2 * share * (1 - share) * np.pi * np.cosh(k * h) * h
    # The integral of sinc up to node j is 1/2 + Si(pi (j - k))/pi.
    lower = slope * (0.5 + sici(np.pi * (k[:, None] - k[None, :]))[0] / np.pi)
    return _of_quarters(share, lower, slope, np.zeros((len(k), 0)))


@cache
def gauss_grid(count: int = _GAUSS_NODES) -> ThetaGrid:
    """Gauss's nodes; the integral to a node is that of the Legendre polynomial through all of them."""
    x, w = legendre.leggauss(count)
    degrees = np.arange(count)
    # From values to Legendre coefficients, exact through the degree that the nodes determine.
    expanded = (degrees + 0.5)[:, None] * (legendre.legvander(x, count - 1) * w[:, None]).T
    integrals = legendre.legval(x, legendre.legint(np.eye(count), lbnd=-1)).T
    return _of_quarters((x + 1) / 2, np.pi / 4 * integrals @ expanded, np.pi / 4 * w, expanded[-_TOP:].T)


def _of_quarters(share: Array, lower: Array, slope: Array, top: Array) -> ThetaGrid:
    """From the nodes of one quarter, which are symmetric, in units of pi/2."""
    sine, blank, zero = np.sin(np.pi / 2 * share), np.zeros_like(slope), np.zeros_like(lower)
    # cos theta = sin(pi/2 - theta): by symmetry of the nodes, and accurate near pi/2.
    cosine, none = sine[::-1], np.zeros_like(top)
    # Up to a node of the second quarter: all of the first, and the second so far.
    cumulative = np.block([[lower, zero], [np.broadcast_to(slope, lower.shape), lower]])
    return ThetaGrid(
        np.concatenate([sine, sine[::-1]]),
        np.concatenate([cosine, -cosine[::-1]]),
        cumulative,
        np.concatenate([slope, blank]),
        np.concatenate([slope, slope]),
        np.block([[top, none], [none, top]]),
    )
