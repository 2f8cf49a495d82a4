"""Which directions of the parameters the data see, and how well: the singular values of the weighted derivatives.

A combination of parameters that hardly changes the data has a large variance, and one that does not change them at all
an infinite one: it is not identifiable.
"""

from dataclasses import dataclass

import numpy as np

from asymptotics.decays.identification.forward.blocks import Array, decomposed

Flags = np.ndarray[tuple[int], np.dtype[np.bool_]]
_UNSEEN = 1e-10
"""Directions whose effect on the data is below this share of the largest are not seen: the derivatives are right to
about 1e-12."""


@dataclass(frozen=True)
class Directions:
    """Singular values and vectors of derivatives whose columns, of length ``size``, are brought to one length.

    Not the eigenvalues of J^T J: those would be lost below 1e-16, the squares of singular values of 1e-8.

    >>> two = Directions.of(np.array([[1.0, 1.0, 0.0], [1.0, 1.0, 1.0]]))                # the first two columns are one
    >>> [round(two.standard_error(np.array(g)), 6) for g in ([1.0, 0, 0], [1.0, 1.0, 0], [0, 0, 1.0])]
    [inf, 1.0, 1.414214]
    """

    size: Array
    left: Array
    values: Array
    right: Array

    @classmethod
    def of(cls, J: Array) -> "Directions":
        """Of as many directions as there are parameters, also where there are fewer data."""
        size = np.linalg.norm(J, axis=0)
        size[size == 0] = 1.0
        rows = np.zeros((max(J.shape[1] - len(J), 0), J.shape[1]))
        # Columns of one length: strengths, logarithms and times have different units, and the singular values compare
        # them.
        return cls(size, *decomposed(np.vstack([J / size, rows])))

    @property
    def seen(self) -> Flags:
        """Which directions the data see."""
        return np.asarray(self.values > _UNSEEN * self.values[0])

    @property
    def covariance(self) -> Array:
        """(J^T J)^(-1), a direction that is not seen having the largest variance of those that could be."""
        vectors = self.right.T / self._floored / self.size[:, None]
        return np.asarray(vectors @ vectors.T)

    def standard_error(self, gradient: Array) -> float:
        """That of a function of the parameters; infinite if most of it is what the data do not see."""
        parts = self.right @ (gradient / self.size) / self._floored
        # In units of the largest: a strength for x0 = 1 unit may be so large that its square leaves the doubles.
        largest = float(np.abs(parts).max()) or 1.0
        seen, unseen = np.linalg.norm(parts[self.seen] / largest), np.linalg.norm(parts[~self.seen] / largest)
        return largest * float(np.hypot(seen, unseen)) if unseen <= seen else float("inf")

    @property
    def _floored(self) -> Array:
        return np.asarray(np.maximum(self.values, _UNSEEN * self.values[0]))
