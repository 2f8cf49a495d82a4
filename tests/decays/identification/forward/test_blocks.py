"""Factors of tall matrices in blocks: those of NumPy's own routines, from matrices that leave BLAS in one thread."""

import numpy as np
import pytest

from asymptotics.decays.identification.forward.blocks import decomposed, product, triangle

SERIAL = 8192
"""Entries of a matrix up to which OpenBLAS applies a reflection in one thread."""
SHAPES = [(5, 5), (700, 12), (6001, 12), (40_000, 7), (3000, 60), (900, 300)]


@pytest.fixture(params=SHAPES, ids=str)
def tall(request):
    return np.random.default_rng(1).standard_normal(request.param) * np.logspace(0, -6, request.param[1])


def test_singular_values_and_vectors_are_those_of_one_factorisation(tall):
    left, values, right = decomposed(tall)
    assert left.shape == tall.shape
    assert np.allclose(values, np.linalg.svd(tall, compute_uv=False), rtol=1e-9)
    assert np.allclose((left * values) @ right, tall, rtol=0, atol=1e-13 * len(tall) ** 0.5)
    assert np.allclose(left.T @ left, np.eye(tall.shape[1]), atol=1e-13)


def test_the_triangle_is_that_of_one_factorisation(tall):
    ours, theirs = triangle(tall), np.linalg.qr(tall, mode="r")
    assert np.allclose(np.abs(ours), np.abs(theirs), rtol=1e-8, atol=1e-11)


def test_data_in_the_last_column_become_coordinates_and_what_is_left():
    random = np.random.default_rng(2)
    columns, y = random.standard_normal((5000, 6)), random.standard_normal(5000)
    last = triangle(np.column_stack([columns, y]))[:, -1]
    c, left, *_ = np.linalg.lstsq(columns, y, rcond=None)
    assert np.isclose(last[-1] ** 2, left[0])
    assert np.isclose((last[:-1] ** 2).sum(), ((columns @ c) ** 2).sum())


@pytest.mark.parametrize("columns", [2, 12, 30, 60])
def test_no_matrix_is_so_large_that_a_second_thread_begins(columns, monkeypatch):
    sizes, plain = [], np.linalg.qr

    def watched(a, mode="reduced"):
        sizes.append(a.shape[-2] * a.shape[-1])
        return plain(a, mode)

    monkeypatch.setattr(np.linalg, "qr", watched)
    triangle(np.ones((20_000, columns)))
    assert sizes
    assert max(sizes) <= SERIAL


def test_a_product_in_pieces_is_the_product():
    random = np.random.default_rng(3)
    a, b = random.standard_normal((3, 50, 90)), random.standard_normal((90, 40))
    assert np.allclose(product(a, b), a @ b, atol=1e-12)
