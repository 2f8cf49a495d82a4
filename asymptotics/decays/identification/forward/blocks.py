"""Products and factors of tall matrices, a few rows at a time: so small that BLAS starts no threads.

A second thread of OpenBLAS costs more than it gives here, and on a busy machine ten times as much: the singular values
of 6000 rows of 12 took 25 ms of processor time by two threads, 0.7 ms by one.  Blocks of rows are factored by
themselves, then their triangles together: the same factors to rounding (TSQR; Demmel, Grigori, Hoemmen and Langou 2012,
SIAM J. Sci. Comput. 34, A206-A239).

>>> tall = np.random.default_rng(0).standard_normal((5000, 4))
>>> left, values, right = decomposed(tall)
>>> bool(np.allclose((left * values) @ right, tall)), bool(np.allclose(left.T @ left, np.eye(4)))
(True, True)
>>> R = triangle(tall)
>>> bool(np.allclose(R.T @ R, tall.T @ tall))
True
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
_PRODUCT, _FACTOR = 200_000, 8_000
"""Multiplications in a product, and entries of a matrix that is factored, below which OpenBLAS stays in one thread (its
thresholds are 262144 and 8192).  They decide the time alone."""


def product(a: Array, b: Array) -> Array:
    """a @ b for a matrix b."""
    rows = a.reshape(-1, a.shape[-1])
    step = max(1, _PRODUCT // b.size)
    if len(rows) <= step:
        return np.asarray(a @ b)
    pieces = [rows[i : i + step] @ b for i in range(0, len(rows), step)]
    return np.concatenate(pieces).reshape(*a.shape[:-1], b.shape[1])


def decomposed(a: Array) -> tuple[Array, Array, Array]:
    """The singular value decomposition of a matrix with at least as many rows as columns: left vectors (as many as
    columns), values, right vectors."""
    if len(a) <= _rows(a):
        return np.linalg.svd(a, full_matrices=False)
    q, r = np.linalg.qr(_blocks(a))
    left, values, right = decomposed(r.reshape(-1, a.shape[1]))
    return (q @ left.reshape(r.shape)).reshape(-1, a.shape[1])[: len(a)], values, right


def triangle(a: Array) -> Array:
    """The triangular factor R of a = Q R; with data as the last column of a, that of R is their coordinates Q^T y, and
    below them the size of what the other columns leave."""
    while len(a) > _rows(a):
        a = np.asarray(np.linalg.qr(_blocks(a), mode="r")).reshape(-1, a.shape[1])
    return np.asarray(np.linalg.qr(a, mode="r"))


def _rows(a: Array) -> int:
    """Rows of a block: twice the columns at least, so that its triangle is smaller."""
    columns = int(a.shape[1])
    return max(_FACTOR // columns, 2 * columns)


def _blocks(a: Array) -> Array:
    """Blocks of equal height; rows of zeros, which change no factor, fill the last one."""
    height = _rows(a)
    missing = -len(a) % height
    return np.concatenate([a, np.zeros((missing, a.shape[1]))]).reshape(-1, height, a.shape[1])
