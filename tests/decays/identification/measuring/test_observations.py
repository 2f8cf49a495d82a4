"""Turning points as they were measured: signs, stretches, and what goes with each of them."""

from dataclasses import replace

import numpy as np
import pytest

from asymptotics.decays.identification.measuring.observations import Observations, Samples

X = np.array([1.0, -0.8, 0.3, -0.2, 0.5, -0.6, 0.7, -0.1])
STRETCH = [4, 5, 6]
"""The longest stretch of |x| from 0.4 to 0.9 starts at the fifth turning point; the first one is shorter."""


def beat(**changed):
    n = np.arange(8)
    given = {
        "t": n + 0.1, "passage_n": n[:-1], "passage_t": n[:-1] + 0.6, "sigma_x": 0.01 + n, "sigma_t": 0.02 + n,
        "sigma_passage": 0.03 + n[:-1], "unit": "cm", "name": "beat", "notes": ("before",), "floor": 1e-7,
    }  # fmt: skip
    return Observations.of(n, X, **(given | changed))


def test_the_longest_stretch_in_a_range_is_taken_with_all_that_belongs_to_it():
    seen = beat().between(0.4, 0.9)
    assert seen.n.tolist() == [0, 1, 2] and seen.x.tolist() == X[STRETCH].tolist()
    assert seen.t.tolist() == [4.1, 5.1, 6.1] and seen.sigma_x.tolist() == [4.01, 5.01, 6.01]
    assert seen.sigma_t.tolist() == [4.02, 5.02, 6.02]
    # The passage after the last turning point leads out of the stretch.
    assert seen.passage_n.tolist() == [0, 1] and seen.passage_t.tolist() == [4.6, 5.6]
    assert seen.sigma_passage.tolist() == [4.03, 5.03]
    assert (seen.unit, seen.name, seen.floor, seen.samples) == ("cm", "beat", 1e-7, None)
    assert seen.notes == ("before", "3 turning points with amplitudes from 0.4 to 0.9")


@pytest.mark.parametrize(("low", "high", "kept"), [(0.5, 0.7, [4, 5, 6]), (0.51, 0.7, [5, 6]), (0.5, 0.69, [4, 5])])
def test_both_ends_of_a_range_belong_to_it(low, high, kept):
    assert beat().between(low, high).x.tolist() == X[kept].tolist()


def test_of_stretches_as_long_as_each_other_the_first_counts():
    assert beat().between(0.6, 0.9).x.tolist() == [-0.6, 0.7]
    assert beat().between(0.75, 2).x.tolist() == [1.0, -0.8]
    seen = Observations.of(range(5), [1.0, -0.9, 0.1, -0.9, 1.0]).between(0.5, 2)
    assert seen.x.tolist() == [1.0, -0.9]


def test_a_stretch_without_times_or_errors_has_none():
    seen = Observations.of(range(8), X).between(0.4, 0.9)
    assert [len(v) for v in (seen.t, seen.sigma_x, seen.sigma_t, seen.passage_t, seen.sigma_passage)] == [0] * 5


def test_a_stretch_keeps_the_gaps_in_its_numbers():
    seen = Observations.of([2, 5, 6, 9], [1.0, -0.8, 0.7, -0.1], passage_n=[2, 5, 6], passage_t=[1.0, 2.0, 3.0])
    assert seen.n.tolist() == [0, 3, 4, 7] and seen.passage_n.tolist() == [0, 3, 4] and seen.last == 7
    found = seen.between(0.6, 0.9)
    assert found.n.tolist() == [0, 1] and found.passage_t.tolist() == [2.0] and found.passage_n.tolist() == [0]


def test_up_to_a_turning_point_the_passage_after_it_is_left_out():
    seen = beat().up_to(3)
    assert seen.n.tolist() == [0, 1, 2, 3] and seen.x.tolist() == X[:4].tolist() and len(seen.t) == 4
    assert seen.passage_n.tolist() == [0, 1, 2] and len(seen.sigma_passage) == len(seen.passage_t) == 3
    assert len(seen.sigma_x) == len(seen.sigma_t) == 4 and seen.last == 3
    assert len(Observations.of(range(8), X).up_to(3).t) == 0


def test_without_times_only_the_amplitudes_stay():
    samples = Samples(np.arange(3.0), np.arange(3.0), 0.1, 3.0)
    alone = replace(beat(), samples=samples).without_times()
    assert not alone.has_times and alone.samples is None and alone.x.tolist() == X.tolist() and len(alone.sigma_x) == 8
    assert [len(v) for v in (alone.passage_n, alone.passage_t, alone.sigma_t, alone.sigma_passage)] == [0] * 4


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_the_sign_alternates_from_that_of_all_of_them_together(side):
    seen = Observations.of([0, 1, 3, 4], side * np.array([1.0, -0.5, -0.2, -0.01]))  # the last has lost its sign
    assert seen.sign.tolist() == [side, -side, -side, side] and seen.reference == 1.0


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_values_of_one_sign_are_amplitudes_and_it_is_said(side):
    seen = Observations.of([1, 2, 4], side * np.array([1.0, 0.8, 0.5]))
    assert seen.x.tolist() == [1.0, -0.8, -0.5] and seen.n.tolist() == [0, 1, 3]
    said = "the values have one sign: read as amplitudes |x_n|"
    assert seen.notes == (f"{said}, two in a period (of peaks of one side: call their column cycle)",)
    assert Observations.of([0, 2, 4], [1.0, 0.8, 0.5]).notes == (said,)
    assert Observations.of([0, 1], [1.0, -0.8]).notes == () and Observations.of([0], [-1.0]).x.tolist() == [-1.0]


def test_whole_numbers_are_read_as_doubles():
    seen = Observations.of((0, 1), (2, -1), (0, 3), sigma_x=(1, 1), passage_n=(0,), passage_t=(2,))
    kinds = [v.dtype.kind for v in (seen.x, seen.t, seen.sigma_x, seen.passage_t, seen.n, seen.passage_n)]
    assert kinds == ["f", "f", "f", "f", "i", "i"]
