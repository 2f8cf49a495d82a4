"""The strips of a free exponent, step by step: nothing is claimed of a piece of which one side is not proved."""

import numpy as np
import pytest
from flint import ctx

from asymptotics.decays.identification.certified_sets import free_exponent
from asymptotics.decays.identification.certified_sets.certified_ratio import BITS
from asymptotics.decays.identification.certified_sets.free_exponent import _Strips
from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.forward.swing import MAX_FREE_ALPHA

TABLE = Decrements(np.array([1.0, 0.7]), np.array([0.1, 0.05]), np.array([5e-3, 5e-3]))


@pytest.fixture(scope="module")
def strips():
    with ctx.workprec(BITS):
        return _Strips.of(TABLE)


def test_a_table_has_a_row_for_each_side_of_each_value(strips):
    """The lower side asks for less loss than the upper one, at the amplitude where the half-swing then begins."""
    for (a, least), (b, most) in zip(strips.lower, strips.upper, strict=True):
        assert least < most and a < b
    assert float(strips.upper[0][0].mid()) == 1.0
    begin, end = 1.0 + 0.105 / 2, 1.0 - 0.105 / 2
    assert float(strips.upper[0][1].mid()) == pytest.approx(np.log(begin / end), rel=1e-12)
    assert float(strips.unit.mid()) == pytest.approx(begin, rel=1e-15)


@pytest.mark.parametrize("unproved", [1, -1])
def test_strengths_of_which_one_end_is_not_proved_are_not_claimed(strips, monkeypatch, unproved):
    """The lower end needs what is too weak to be missed, the upper end what is too strong; neither alone will do."""
    with ctx.workprec(BITS):
        assert strips.strengths(1.9, 2.1) is not None
        monkeypatch.setattr(_Strips, "_misses", lambda _, sign, _alpha, _e: sign != unproved)
        assert strips.strengths(1.9, 2.1) is None


def test_what_is_too_weak_is_proved_at_the_lower_end_of_a_piece_and_what_is_too_strong_at_the_upper(
    strips, monkeypatch
):
    asked = []
    monkeypatch.setattr(_Strips, "_misses", lambda _, *given: asked.append(given) or True)
    with ctx.workprec(BITS):
        low, high = strips.strengths(1.5, 2.5)
    weak, strong = ([a for a in asked if a[0] == sign] for sign in (1, -1))
    cuts = np.linspace(1.5, 2.5, len(weak) + 1)
    assert [a[1] for a in weak] == cuts[:-1].tolist() and [b[1] for b in strong] == cuts[1:].tolist()
    assert all(a[2] < b[2] for a, b in zip(weak, strong, strict=True))
    unit = float(strips.unit.mid())
    least, most = (
        [e * unit ** (1 - alpha) for (*_, e), ends in zip(part, zip(cuts, cuts[1:]), strict=True) for alpha in ends]
        for part in (weak, strong)
    )
    assert low <= min(least) <= low * (1 + 1e-14) and high >= max(most) >= high * (1 - 1e-14)


@pytest.mark.parametrize(("empty", "missed"), [((True, True), True), ((True, False), False), ((False, True), False)])
def test_a_strip_is_empty_where_one_strength_is_proved_too_weak_and_too_strong(strips, monkeypatch, empty, missed):
    shown = dict(zip((1, -1), empty, strict=True))
    monkeypatch.setattr(_Strips, "_root", lambda _, sign, _alpha: 0.09 if sign > 0 else 0.04)  # least > most
    monkeypatch.setattr(_Strips, "_misses", lambda _, sign, alpha, e: shown[sign] and e == pytest.approx(0.06))
    assert strips._is_empty(1.0, 1.1) == missed
    monkeypatch.setattr(_Strips, "_root", lambda _, sign, _alpha: 0.04 if sign > 0 else 0.09)
    assert not strips._is_empty(1.0, 1.1)  # in doubles some strength may meet every row


@pytest.mark.parametrize(
    ("start", "end", "border"), [(0.0, 5.0, 1.7), (5.0, 0.0, 2.3), (0.0, 5.0, 0.0), (0.0, 5.0, 9.0)]
)
@pytest.mark.parametrize("goal", [None, 2.0])
def test_what_is_excluded_is_a_chain_of_proved_strips(strips, monkeypatch, start, end, border, goal):
    """From the start on without a gap, up to the first place where no strip is proved any more."""
    proved = []

    def is_empty(_, low, high):
        free = high <= border if end > start else low >= border
        proved.extend([(low, high)] if free else [])
        return free

    monkeypatch.setattr(_Strips, "_is_empty", is_empty)
    reached = strips.excluded(start, end, goal)
    chain = sorted(proved, reverse=end < start)
    edges = [start, *(high if end > start else low for low, high in chain)]
    assert [(low if end > start else high) for low, high in chain] == edges[:-1] and reached == edges[-1]
    if goal is not None:
        assert not any(low <= goal <= high for low, high in chain)
    last = (min if end > start else max)(border, end) if goal is None or border != 9.0 else goal
    assert abs(reached - last) < 0.05


@pytest.mark.parametrize(
    ("meets", "low", "high", "ends", "verdict"),
    [
        (True, 1.0, 2.0, (0.04, 0.06), "consistent"),
        (True, 1.0, 2.0, None, "consistent"),
        (False, 1.0, 2.0, (0.04, 0.06), "undetermined"),
        (False, 1.0, 2.0, None, "undetermined"),
        (False, MAX_FREE_ALPHA, 0.0, None, "refuted"),
    ],
)
@pytest.mark.parametrize("least", [0.5, 1.5])
def test_the_answer_for_an_exponent_follows_from_its_proofs(monkeypatch, meets, low, high, ends, verdict, least):
    """A point is claimed of what balls confirm only; an interval where both ends are proved."""
    found_low = iter([low, high])
    monkeypatch.setattr(free_exponent, "chebyshev_point", lambda *_: (least, np.array([0.05, 1.5])))
    monkeypatch.setattr(_Strips, "meets", lambda *_: meets)
    monkeypatch.setattr(_Strips, "excluded", lambda *_: next(found_low))
    monkeypatch.setattr(_Strips, "strengths", lambda *_: ends)
    found = free_exponent.exponents_that_fit(TABLE)
    if verdict == "consistent" and least > 1:
        verdict = "undetermined"
    assert found.verdict == verdict
    if verdict == "refuted":
        assert found.alpha is found.epsilon is None
        return
    middle = 1.5
    assert (found.alpha.low, found.alpha.estimate, found.alpha.high) == (1.0, middle, 2.0)
    if verdict == "consistent":
        wanted = (None, None) if ends is None else ends
        assert (found.epsilon.low, found.epsilon.estimate, found.epsilon.high) == (wanted[0], 0.05, wanted[1])
    else:
        assert (found.epsilon is None) == (ends is None) and found.reason.startswith("neither a point nor its absence")
        assert ends is None or (found.epsilon.low, found.epsilon.estimate, found.epsilon.high) == (0.04, 0.05, 0.06)


def test_what_reaches_the_largest_exponent_says_how_far_was_searched(monkeypatch):
    for high, said in ((MAX_FREE_ALPHA, f"searched with 0 <= alpha <= {MAX_FREE_ALPHA:g}"), (2.0, "")):
        ends = iter([1.0, high])
        monkeypatch.setattr(_Strips, "excluded", lambda *_, ends=ends: next(ends))
        monkeypatch.setattr(_Strips, "meets", lambda *_: True)
        monkeypatch.setattr(free_exponent, "chebyshev_point", lambda *_: (0.5, np.array([0.05, 1.5])))
        monkeypatch.setattr(_Strips, "strengths", lambda *_: None)
        assert free_exponent.exponents_that_fit(TABLE).reason == said


def test_an_amplitude_that_grows_refutes_every_exponent():
    growing = Decrements(np.array([1.0, 0.7]), np.array([0.1, -0.05]), np.array([5e-3, 5e-3]))
    found = free_exponent.exponents_that_fit(growing)
    assert found.verdict == "refuted" and "grows" in found.reason
