"""The rows A_i^n of derivation smith-denominators against (62a) in rational arithmetic and the polynomials of time."""

from fractions import Fraction
from functools import cache
from importlib import import_module

import pytest
from flint import fmpq_poly

from benchmarks.smith_rows import rational_rows

LAST = 100


@cache
def smith():
    """The derivation, which is proved where it is imported: in the process that asks for it."""
    return import_module("derivations.smith_denominators")


@cache
def integer_rows():
    return smith().integer_rows(LAST)


@pytest.mark.parametrize("n", [1, 2, 7, 40, 99, LAST])
def test_smiths_coefficients_are_integers_over_a_double_factorial(n):
    for i, (A, C) in enumerate(zip(integer_rows()[n], rational_rows(n, Fraction), strict=True)):
        assert smith().double_factorial(n + i) * C == A
        assert A % 2**i == 0
        assert (smith().double_factorial(2 * n - 1) * C).denominator == 1
    assert n > 7 or any(A % 2 ** (i + 1) for i, A in enumerate(integer_rows()[n]))  # near miss


def time_polynomials(last, field):
    """p_0 = E, p_(k+1) = field p_k'."""
    found = [fmpq_poly([0, 1])]
    for _ in range(last):
        found.append(field * found[-1].derivative())
    return found


def agree(polynomials):
    """Whether A_i^n = (-1)^k [E^n] p_k(E) for all n + i = 2k + 1."""
    pairs = ((n, 2 * k + 1 - n, k) for k in range(len(polynomials)) for n in range(k + 1, 2 * k + 2))
    return all(integer_rows()[n][i] == (-1) ** k * polynomials[k][n] for n, i, k in pairs)


def test_the_coefficients_of_the_time_are_the_same():
    assert agree(time_polynomials(30, fmpq_poly([0, 0, -2, 1])))
    assert not agree(time_polynomials(30, fmpq_poly([0, 0, -2, 2])))
