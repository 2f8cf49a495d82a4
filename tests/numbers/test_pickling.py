"""Balls and exact numbers through pickles, copies and a pool of processes."""

import pickle
from concurrent.futures import ProcessPoolExecutor
from copy import deepcopy
from multiprocessing import get_context

import pytest
from flint import acb, acb_poly, arb, arb_poly, arb_series, ctx, fmpq, fmpq_poly, fmpq_series, fmpz, fmpz_poly

import asymptotics.numbers.pickling  # noqa: F401  what pickles balls is registered there


def _numbers():
    with ctx.workprec(200):
        root = arb(2).sqrt()
        z = acb(root, arb.pi())
    rationals = [fmpq_poly([1, fmpq(1, 2)]), fmpq_series([1, fmpq(1, 3)], prec=7), fmpz_poly([fmpz(10) ** 5000, 2])]
    return [root, z, arb_poly([1, root]), acb_poly([z, 1]), arb_series([root, 1], 5), *rationals, fmpq(1, 3), arb.nan()]


def _same(a, b) -> bool:
    return a.repr() == b.repr() if hasattr(a, "repr") else str(a) == str(b)


def _square(x: arb) -> arb:
    return x * x


@pytest.mark.parametrize("number", _numbers(), ids=lambda x: type(x).__name__)
def test_pickling_and_copying_are_exact(number):
    with ctx.workprec(30):  # the receiver's precision must not matter
        assert _same(pickle.loads(pickle.dumps(number)), number)
        assert _same(deepcopy(number), number)


def test_balls_travel_through_a_process_pool():
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        assert pool.submit(_square, arb(3)).result().contains(9)
