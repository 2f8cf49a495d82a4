"""A table of equivalent damping step by step: columns, weights, least squares, profiles, grades and order."""

from types import SimpleNamespace

import numpy as np
import pytest
from scipy.optimize import minimize
from scipy.stats import chi2

from asymptotics.decays.identification import damping_table, inverse_damping
from asymptotics.decays.identification.damping_columns import is_of_damping, read_columns, roles
from asymptotics.decays.identification.damping_table import (
    _candidates,
    _neglected,
    _positive,
    law_of_table,
)
from asymptotics.decays.identification.inverse_damping import (
    DampingCandidate,
    Problem,
    Strength,
    _candidate,
    _first_above,
    _interval,
    _scatter,
    as_zeta,
    columns,
    fitted,
    weighted,
)
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.numbers.policy import exact_number
from tests.each import each

A = np.array([0.1, 0.2, 0.4, 0.8, 1.6])


def units(monkeypatch):
    """z of a unit strength as A^(alpha - 1), without the certified cycle."""
    monkeypatch.setattr(inverse_damping, "_unit", lambda problem, alpha, a: float(a) ** (float(alpha) - 1))


def test_quantities_become_the_damping_ratio_with_their_resolutions():
    """By differences: what a resolution of Q or of a decrement is worth."""
    for quantity, inverse in (
        ("zeta", lambda z: z),
        ("Q", lambda z: 1 / (2 * z)),
        ("decrement", lambda z: 2 * np.pi * z),
    ):
        zeta = np.array([0.01, 0.02])
        values = inverse(zeta)
        found, s = as_zeta(quantity, values, np.array([1e-7, 2e-7]) * values)
        assert found == pytest.approx(zeta) and s == pytest.approx(np.array([1e-7, 2e-7]) * zeta, rel=1e-4)


def test_a_unit_strength_has_the_first_order_of_the_cycle():
    """1/2 for linear loss, 4 A/(3 pi) for quadratic, 2/(pi A) for friction; of mass and stiffness 1/(2 sqrt(m k))."""
    found = columns(Problem("zeta", ()), ("1", "2", "0"), [0.5, 1.0], None)
    assert found == pytest.approx(np.array([[0.5, 4 / 6 / np.pi, 4 / np.pi], [0.5, 4 / 3 / np.pi, 2 / np.pi]]))
    heavy = columns(Problem("zeta", (), 4, 9), ("1",), [0.5], None)
    assert heavy == pytest.approx(np.array([[1 / (2 * np.sqrt(36))]]))


def test_without_resolutions_all_are_as_large_as_the_best_candidate_needs(monkeypatch):
    units(monkeypatch)
    zeta = 0.02 + 0.01 * A + np.array([1, -1, 1, -1, 1]) * 1e-4
    problem = Problem("zeta", (("1",), ("1", "2"), ("0", "1", "2", "3", "4")))
    z = np.stack([np.ones(5), A], axis=1)
    rest = zeta - z @ np.linalg.lstsq(z, zeta, rcond=None)[0]
    best = np.sqrt((rest**2).sum() / 3)
    assert _scatter(A, zeta, problem) == (pytest.approx(best), 3)
    found, s = weighted(A, zeta, None, problem)
    assert np.array_equal(found, zeta) and s == pytest.approx(np.full(5, best))
    found, s = weighted(A, 1 / (2 * zeta), [1.0] * 5, Problem("Q", problem.candidates))
    assert found == pytest.approx(zeta) and s == pytest.approx(2 * zeta**2)
    assert _scatter(A, 0.02 + 0.01 * A, problem)[0] == pytest.approx(1e-12 * 0.036, rel=1e-3)  # no scatter at all


def noisy(scale=1.0):
    return 0.02 + 0.01 * A + scale * 1e-4 * np.array([1.0, -2.0, 0.5, 1.0, -0.5])


def test_a_candidate_is_weighted_least_squares_with_its_chi_squared(monkeypatch):
    units(monkeypatch)
    s = 1e-4 * np.array([1.0, 1, 2, 1, 1])
    found = _candidate(Problem("zeta", ()), ("1", "2"), A, noisy(), s)
    z = np.stack([np.ones(5), A], axis=1)
    b = np.linalg.lstsq(z / s[:, None], noisy() / s, rcond=None)[0]
    square = (((noisy() - z @ b) / s) ** 2).sum()
    assert found.name == "1+2" and [e.estimate for e in found.strengths] == pytest.approx(b)
    assert found.chi_squared == pytest.approx(square) and found.p == pytest.approx(chi2.sf(square, 3))
    assert found.criterion == pytest.approx(square + 4 + 2 * 2 * 3 / (5 - 3))
    assert found.left == pytest.approx(np.sqrt(np.mean(((noisy() - z @ b) / noisy()) ** 2)))
    exact = _candidate(Problem("zeta", ()), ("0", "1", "2", "3", "4"), A, noisy(), s)
    assert exact.p == 1.0 and exact.criterion == np.inf


@pytest.mark.parametrize(("share", "grade"), [(0.999, "consistent"), (1.001, "adequate")])
def test_a_law_is_consistent_up_to_the_five_percent_of_chi_squared(monkeypatch, share, grade):
    units(monkeypatch)
    z = np.stack([np.ones(5), A], axis=1)
    rest = noisy() - z @ np.linalg.lstsq(z, noisy(), rcond=None)[0]
    s = np.full(5, np.sqrt((rest**2).sum() / chi2.isf(0.05, 3)) / np.sqrt(share))
    assert _candidate(Problem("zeta", ()), ("1", "2"), A, noisy(), s).grade == grade


@pytest.mark.parametrize("rise", [0.3, 10.0])
@pytest.mark.parametrize("i", [0, 1])
def test_an_interval_ends_where_the_profile_has_risen(rise, i):
    """By another minimiser."""
    s = 1e-4
    z, y = np.stack([np.ones(5), A], axis=1) / s, noisy() / s
    b = np.linalg.lstsq(z, y, rcond=None)[0]
    least = float(((y - z @ b) ** 2).sum())
    error = np.sqrt(rise * np.linalg.inv(z.T @ z)[i, i])
    assert _interval(z, y, b, i, least, rise) == pytest.approx((b[i] - error, b[i] + error), rel=1e-6)


def test_a_strength_that_the_table_does_not_need_begins_at_zero():
    z, y = np.stack([np.ones(5), A], axis=1) / 1e-3, (0.02 + 1e-4 * A) / 1e-3
    b = np.linalg.lstsq(z, y, rcond=None)[0]
    low, high = _interval(z, y, b, 1, 0.0, 3.84)

    def square(v):
        return minimize(lambda u: ((y - z[:, 0] * u[0] - z[:, 1] * v) ** 2).sum(), [0.02], method="Nelder-Mead").fun

    assert low == 0.0 and square(high) == pytest.approx(3.84, rel=1e-3)
    alone = _interval(z[:, :1], y, b[:1], 0, 0.0, 3.84)  # without others the rest itself
    assert (alone[1] - b[0]) > 0 and ((y - z[:, 0] * alone[1]) ** 2).sum() == pytest.approx(3.84)


def test_a_place_where_a_profile_has_risen_enough_is_sought_in_doubled_steps():
    asked = []
    found = _first_above(lambda v: (asked.append(v), v - 4.2)[1], 1.0, 0.5)
    assert asked == [1.5, 2.0, 3.0, 5.0] and found == 5.0
    assert _first_above(lambda v: v - 1.5, 1.0, 0.5) == 2.0  # where it is just 0 it has not risen


def test_candidates_stand_by_grade_then_by_need_then_by_criterion(monkeypatch):
    units(monkeypatch)
    made = {
        ("1",): ("adequate", 1.0, -9.0), ("2",): ("consistent", 0.0, 0.0), ("3",): ("consistent", 1.0, 5.0),
        ("0",): ("refuted", 1.0, -99.0), ("1", "3"): ("consistent", 1.0, 4.0),
    }  # fmt: skip

    def candidate(problem, alphas, amplitudes, zeta, s, rise):
        grade, low, criterion = made[alphas]
        assert rise == 3.84
        return DampingCandidate("+".join(alphas), (Strength("1", low, 2.0, 3.0),), 0.0, 0.0, 1.0, criterion, grade)

    monkeypatch.setattr(inverse_damping, "_candidate", candidate)
    found = fitted(A, noisy(), [1.0] * 5, Problem("zeta", tuple(made)))
    assert [c.name for c in found] == ["1+3", "3", "2", "1", "0"] and found[2].unneeded == ("1",)


def test_a_candidate_and_a_strength_are_told():
    one = DampingCandidate(
        "1+2", (Strength("1", 0.0, 0.02, 0.03), Strength("2", 0.1, 0.2, 0.3)), 0.034, 1.0, 0.012, 0.0, "adequate"
    )
    page = one._page()
    assert page.title == "law 1+2: adequate to 3.4 % of the loss" and one.unneeded == ("1",)
    assert page.lines == ("estimate; its damping is 3.4 % off on average, p = 0.012",)
    assert page.rows == (("1", "0.02", "[0, 0.03]"), ("2", "0.2", "[0.1, 0.3]")) and page.head == (
        "exponent",
        "strength",
        "95 %",
    )
    assert one.strengths[1]._page().title == "strength of v^2 = 0.2 [0.1, 0.3]"
    assert one.strengths[1]._page().lines == ("estimate, profile 95 %",)


# The table.


@each(
    ("name", "what"),
    [
        ("A", "amplitude"), ("Amplitude [deg]", "amplitude"), (" a (mm) ", "amplitude"), ("A / mm", "amplitude"),
        ("zeta", "zeta"), ("Damping Ratio", "zeta"), ("Q", "Q"), ("log decrement", "decrement"),
        ("Lambda", "decrement"),
        ("s", "resolution"), ("Uncertainty", "resolution"), ("ab", None), ("", None), ("time", "t"),
        ("n", "n"), ("Cycles", "cycles"), ("zeta_percent", "zeta"),
    ],
)  # fmt: skip
def test_columns_are_known_by_their_names_without_units(name, what):
    assert roles([name]) == [what]


def test_a_mapping_is_read_with_its_unit_and_what_is_not_used_is_told():
    read = read_columns({"A (deg)": [10, 20], "Q": [50, 40], "time": [0, 1], "room": [1, 2]})
    assert read.values["amplitude"] == pytest.approx(np.radians([10, 20])) and read.values["Q"].tolist() == [50, 40]
    assert (read.quantity, read.unit) == ("Q", "deg")
    assert read.notes == ("not used: time, room", "amplitudes in deg taken as rad")
    read = read_columns({"A [mm]": [10, 20], "zeta": [0.01, 0.02], "sigma": [1e-3, 1e-3]})
    assert read.values["amplitude"] == pytest.approx([0.01, 0.02]) and read.notes == ("amplitudes in mm taken as m",)
    assert read.values["resolution"].tolist() == [1e-3, 1e-3] and (read.quantity, read.unit) == ("zeta", "mm")
    assert (
        read_columns({"A [m]": [1], "decrement": [2]}).notes == () == read_columns({"A": [1], "decrement": [2]}).notes
    )


def test_angles_and_errors_as_reports_of_towing_tanks_name_them():
    """Each was refused, or its errors were "not used" (issue 40, item 11)."""
    for names in (
        ["theta (deg)", "zeta"], ["roll angle (deg)", "damping ratio"], ["phi_a", "zeta [%]"], ["x [mm]", "Q"],
        ["φ / °", "Dämpfungsgrad"],
    ):  # fmt: skip
        assert roles(names)[0] == "amplitude" and is_of_damping(names)
    # Near misses: a record, a record of a sensor, an amplitude beside an angle, a resonance with its phase.
    assert not is_of_damping(["t", "theta", "zeta"]) and roles(["x", "force"])[0] is None
    assert roles(["theta", "A", "zeta"]) == [None, "amplitude", "zeta"]
    assert roles(["A", "force", "phi"]) == ["amplitude", "force", None]
    for name in ("u(zeta)", "sd zeta", "zeta_err", "dzeta", "±", "resolution"):
        assert roles(["A", "zeta", name]) == ["amplitude", "zeta", "resolution"]
    assert roles(["A", "u(A)", "zeta"]) == ["amplitude", None, "zeta"]  # an error of the place is none of the loss
    assert roles(["A", "u(A)", "force", "phase", "u(phase)"])[1::3] == ["resolution", "phase_resolution"]
    assert roles(["A", "u(A)", "n"])[1] == "resolution"


def test_a_resolution_has_the_unit_of_what_it_belongs_to():
    """That of amplitudes in mm was taken as m: thousand times too wide an interval."""
    for name, size in (("A [mm]", 1e-3), ("A [m]", 1.0), ("A [deg]", np.pi / 180)):
        for error in ("resolution", "u(A)"):
            read = read_columns({name: [20, 18], "n": [0, 2], error: [0.1, 0.2]})
            assert read.values["resolution"] == pytest.approx(size * np.array([0.1, 0.2])) and read.size == size
    own = read_columns({"A [mm]": [20, 18], "n": [0, 2], "sd A [m]": [1e-4, 2e-4]})
    assert own.values["resolution"].tolist() == [1e-4, 2e-4]
    own = read_columns({"A [mm]": [20, 18], "n": [0, 2], "resolution [m]": [1e-4, 2e-4]})
    assert own.values["resolution"].tolist() == [1e-4, 2e-4]
    read = read_columns({"A": [1, 2], "zeta [%]": [1, 2], "u(zeta)": [0.1, 0.2]})
    assert read.values["resolution"] == pytest.approx([1e-3, 2e-3]) and read.size == 0.01
    assert read_columns({"A [mm]": [1, 2], "zeta": [0.01, 0.02], "sigma": [1e-3, 1e-3]}).size == 1.0
    ends = [
        law_of_table({name: size * np.array([20, 18, 16.2, 14.5]), "n": [0, 2, 4, 6]}, resolution=exact_number(r, "r"))
        for name, size, r in (("A [mm]", 1, "0.1"), ("A [m]", 1e-3, "0.0001"))
    ]
    one, other = (found.law("1").strengths[0] for found in ends)
    assert (one.low, one.high) == pytest.approx((other.low, other.high)) and one.low > 0.03


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"zeta": [1]}, "no column A"), ({"A": [1]}, "0 of the columns zeta"),
        ({"A": [1], "Q": [1], "zeta": [1]}, "2 of the"),
        ({"A": [1, 2], "Q": [1]}, "differ in length"), ({"A [furlong]": [1], "Q": [1]}, "'furlong'"),
    ],
)  # fmt: skip
def test_tables_that_cannot_be_used_say_why(given, said):
    with pytest.raises(InputError, match=f"argument table.*{said}"):
        read_columns(given)


def test_only_positive_numbers_in_one_column_are_served():
    assert _positive(np.array([1.0, 2.0]), "A").tolist() == [1.0, 2.0]
    for values, said in (([1.0, 0.0], "0 in row 2"), ([-1.0, 2.0], "-1 in row 1"), ([1.0, np.nan], "nan in row 2"),
                         ([1e-100, 1.0], "1e-100 in row 1"), ([1.0, 1e100], "1e[+]100 in row 2")):  # fmt: skip
        with pytest.raises(InputError, match=f"argument A: {said} is not positive"):
            _positive(np.array(values), "A")
    assert len(_positive(np.ones(1000), "A")) == 1000
    for shape in ((1001,), (2, 2)):
        with pytest.raises(LimitError, match="argument A"):
            _positive(np.ones(shape), "A")


def test_candidates_are_sums_of_different_exponents():
    made, skipped = _candidates(None, 4)
    assert made[:5] == (("0",), ("1",), ("2",), ("3",), ("0", "1")) and len(made) == 9 and skipped == ()
    assert _candidates("1+2", 2) == ((("1", "2"),), ()) == _candidates(["1+2", "1+2"], 2)
    assert _candidates((1, "0+1+2+3"), 4) == ((("1",), ("0", "1", "2", "3")), ())
    assert _candidates(["1", "1+2", "free"], 1)[0] == (("1",),)
    assert _candidates(["1", "1+2"], 1)[1] == ("skipped: 1+2 (2 strengths)",)
    for laws in ([], 3, ["1+1"], ["-1"], ["0+1+2+3+4"]):
        with pytest.raises(InputError, match="argument laws"):
            _candidates(laws, 4)
    with pytest.raises(InputError, match="argument table: too few rows: skipped: 1.2 .2 strengths."):
        _candidates("1+2", 1)


def neglected(monkeypatch, motions, first=1.0, ends=(0.5, 2.0), strengths=(("1", 0.1), ("2", 0.0))):
    asked = []

    def row(law, amplitude, digits, extra):
        asked.append((float(amplitude.ball().mid()), digits, extra))
        found = motions[len(asked) - 1]
        if isinstance(found, Exception):
            raise found
        motion = None if found is None else SimpleNamespace(zeta=found, Q=found, decrement=found)
        return SimpleNamespace(first=SimpleNamespace(zeta=first, Q=first, decrement=first), motion=motion)

    monkeypatch.setattr(damping_table, "row_at", row)
    monkeypatch.setattr(damping_table, "OF_MOTION", {})
    best = SimpleNamespace(strengths=[SimpleNamespace(alpha=a, estimate=e) for a, e in strengths])
    return _neglected(Problem("Q", ()), best, ends), asked


def test_what_the_first_order_lacks_is_the_larger_at_both_ends(monkeypatch):
    found, asked = neglected(monkeypatch, [1.02, 0.95])
    assert found == pytest.approx(0.05) and asked == [(0.5, 6, None), (2.0, 6, None)]
    assert neglected(monkeypatch, [1.5, 0.9], first=2.0)[0] == pytest.approx(0.55)
    assert neglected(monkeypatch, [1.0, None])[0] is None and neglected(monkeypatch, [UndecidedError("no")])[0] is None
    assert neglected(monkeypatch, [], strengths=(("1", 0.0),)) == (None, [])


def test_a_table_becomes_a_law_with_its_notes():
    zeta = [0.012, 0.0141, 0.0178, 0.0261]
    found = law_of_table({"A": A[:4], "zeta": zeta}, resolution=exact_number("0.0002", "resolution"), laws=["1", "1+2"])
    assert found.points == 4 and found.amplitudes == (0.1, 0.8) and not found.frame and found.notes == ()
    assert found.resolution == pytest.approx(np.median(2e-4 / np.array(zeta))) and found.best.name == "1+2"
    used = dict(found.table)
    assert used.pop("resolution") == pytest.approx([2e-4] * 4) and used == {"A": A[:4].tolist(), "zeta": zeta}
    plain = law_of_table({"A": A[:4], "zeta": zeta, "x": zeta}, laws="1+2")
    assert plain.notes[0] == "not used: x" and plain.notes[1].startswith("no resolutions: taken equal")
    assert "resolution" not in plain.table and plain.problem.mass == 1 == plain.problem.stiffness
    heavy = law_of_table(
        {"A": A[:4], "zeta": zeta}, laws="1", mass=exact_number(2, "m"), stiffness=exact_number(8, "k")
    )
    assert heavy.frame and heavy.best.strengths[0].estimate == pytest.approx(
        8 * law_of_table({"A": A[:4], "zeta": zeta}, laws="1").best.strengths[0].estimate / 2
    )


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"resolution": exact_number(1, "r"), "table": {"sigma": [1.0] * 4}}, "argument resolution"),
        ({"mass": exact_number(1, "m")}, "argument stiffness: is missing"),
        ({"stiffness": exact_number(1, "k")}, "argument mass: is missing"),
        ({"laws": "0+1+2+3"}, "too few rows"),
    ],
)
def test_options_that_do_not_fit_are_refused(more, said):
    table = {"A": A[:4], "zeta": [0.01, 0.02, 0.03, 0.04]} | more.pop("table", {})
    with pytest.raises(InputError, match=said):
        law_of_table(table, **more)
