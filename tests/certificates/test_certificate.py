"""What is printed has a certificate that the checker accepts; what has none is refused by name."""

import ast
import json
import subprocess
import sys
from dataclasses import replace
from pathlib import Path
from time import process_time

import pytest

import asymptotics as asy
from asymptotics import turning_points
from asymptotics.certificates.certificate import certificate, together
from asymptotics.certificates.claims import turning_claim
from asymptotics.certificates.of_results import of_states, of_turning_points
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.law import Law, Oscillator
from asymptotics.motions.reference import reference_motion
from asymptotics.testing import check_certificate
from asymptotics.turning.choose import turning_points as dimensionless
from tests.certificates import examples

CHECKER = Path(check_certificate.__file__)


@pytest.mark.parametrize("name", examples.OSCILLATORS)
def test_turning_points_with_times(name):
    content = examples.turning(name)
    said = check_certificate.check(content)[1:]
    numbers = [claim["number"] for claim in content["claims"]]
    assert [line.split(":")[0] for line in said] == [f"turning point {n}" for n in numbers]
    assert max(numbers) == 2


@pytest.mark.parametrize("name", examples.OSCILLATORS)
def test_states(name):
    assert len(check_certificate.check(examples.state(name, "1/3", "1", "10"))) == 4


def test_the_stop_and_the_motion_after_it():
    content = examples.turning("friction", count=40)
    assert check_certificate.check(content)[-1].endswith(": it stays")
    assert check_certificate.check(examples.state("friction", "1000"))[1].endswith(" v = 0 exactly")


def test_a_state_a_little_beyond_the_longest_piece():
    friction = Oscillator({0: "1/10"}, x0=0, v0=1)
    assert of_states(friction, [("10", reference_motion(friction, "10", 26))], 26).proved


def test_rest_from_the_start():
    stuck = Oscillator({0: 2})
    assert of_turning_points(stuck, turning_points(stuck, 3, digits=5)).proved[-1] == "turning point 0: it stays"


def test_creep_and_overdamped_motions_are_served():
    for law in ({1: 3}, {"1/2": 1}, {2: 50}):
        slow = Oscillator(law)
        assert of_states(slow, [("10", reference_motion(slow, "10", 15))], 15).proved


@pytest.mark.parametrize("digits", [40, 100])
def test_many_digits(digits):
    table = dimensionless(Law({"3/2": "1/10"}), 2, digits, times=True)
    assert f"x = {table.points[1].x}" in of_turning_points(Law({"3/2": "1/10"}), table).proved[2]


def test_a_time_right_beside_a_turning_point():
    drag = Oscillator({2: "1/10"})
    times = ["157/50", "3.1450000001", "3.1469"]
    assert of_states(drag, [(t, reference_motion(drag, t, 20)) for t in times], 20).proved


@pytest.mark.parametrize(
    ("oscillator", "reason"),
    [
        (Oscillator({2: "1/10"}, spring={3: "1/10"}), "motions may part"),
        (Oscillator({(1, 2): "1/10"}), "motions may part"),
        (Oscillator({"sqrt(2)": "1/10"}), "exponent sqrt"),
        (Oscillator({"1251/1250": "1/10"}), "too long"),
        (Oscillator({2: "sqrt(2)"}), "strength sqrt"),
        (Oscillator({2: 1}, mass="sqrt(2)"), "mass sqrt"),
        (Oscillator({2: 1}, x0="sqrt(2)"), "x0 sqrt"),
    ],
)
def test_what_has_none_is_refused_by_name(oscillator, reason):
    table = turning_points(oscillator, 6, digits=8)
    with pytest.raises(InputError, match=reason):
        of_turning_points(oscillator, table)


def test_other_refusals():
    drag = Oscillator({2: "1/10"})
    with pytest.raises(InputError, match="estimate"):
        of_states(drag, [("7", replace(reference_motion(drag, "7", 5), certified=False))], 5)
    with pytest.raises(InputError, match="not rational"):
        of_states(drag, [("sqrt(2)", reference_motion(drag, "sqrt(2)", 5))], 5)
    with pytest.raises(InputError, match="amplitude"):
        law = Law({2: "1/10"})
        of_turning_points(law, dimensionless(law, 2, 5, x0="3/5", v0="4/5"))
    far = dimensionless(Law({2: "1/10"}), 1, 5, start=1001)
    with pytest.raises(InputError, match="count"):
        of_turning_points(Law({2: "1/10"}), far)
    with pytest.raises(InputError, match="digits"):
        of_turning_points(Law({2: "1/10"}), dimensionless(Law({2: "1/10"}), 1, 101))
    with pytest.raises(LimitError):
        of_turning_points(law, dimensionless(law, 300, 50, times=True), max_seconds=0.2)


def test_a_motion_that_never_turns_has_states_alone():
    creeping = Oscillator({"1/7": "5/3"}, x0=2, v0="-1/3")
    with pytest.raises(InputError, match="no turning point"):
        of_turning_points(creeping, turning_points(creeping, 2, digits=2))


def test_a_next_turning_point_that_is_far_off_is_not_waited_for():
    near_critical = Oscillator({"1001/1000": 10})
    assert of_states(near_critical, [("1", reference_motion(near_critical, "1", 9))], 9).proved


def test_a_series_of_thousands_of_terms_is_refused_at_once():
    flat = Oscillator({"1/1000": "1/10"})
    with pytest.raises(LimitError, match="terms"):
        of_turning_points(flat, turning_points(flat, 2, digits=15), max_seconds=10)


def test_a_false_digit_gets_no_certificate():
    drag = Oscillator({2: "1/10"})
    point = turning_points(drag, 2, digits=12, times=True).points[1]
    claim = turning_claim(point, 12)
    assert certificate(drag, [claim]).proved
    last = "12345678900"[int(claim["x"][-1])]
    with pytest.raises(UndecidedError, match="the checker refuses: x"):
        certificate(drag, [{**claim, "x": claim["x"][:-1] + last}])


def test_the_file_is_checked_by_the_page_alone(tmp_path):
    drag = Oscillator({"3/2": "1/5"})
    made = of_turning_points(drag, turning_points(drag, 6, digits=20, times=True))
    made.save(tmp_path / "a.json")
    assert json.loads((tmp_path / "a.json").read_text()) == made.content[0]
    ran = subprocess.run(
        [sys.executable, "-I", "-S", CHECKER, tmp_path / "a.json"], capture_output=True, text=True, cwd=tmp_path
    )
    assert (ran.returncode, ran.stderr) == (0, "")
    assert ran.stdout.splitlines() == ["accepted", *made.proved]


def test_the_checker_is_one_short_page_of_the_standard_library():
    text = CHECKER.read_text()
    assert len(text.splitlines()) <= 250
    ast.parse(text, feature_version=(3, 9))
    imported = [line for line in text.splitlines() if line.startswith(("import ", "from "))]
    assert {line.split()[1] for line in imported} == {"json", "re", "sys", "fractions", "math", "typing"}


def test_exact_places_and_stops_on_the_edge_are_left_and_told():
    centre = turning_points(Oscillator({0: "1/10"}), 6, digits=8, times=True).certificate()
    assert centre.proved[-2].startswith("turning point 5: t = 15.707963 (known")
    assert centre.proved[-1] == "turning point 5: it stays"
    assert centre.left == ("turning point 5: x = 0 exactly, which no bound tells",)
    edge = turning_points(Oscillator({0: "1/5"}, x0=-1), 3, digits=3).certificate()
    assert edge.proved[-1].startswith("turning point 2: x = -0.200 (known")
    assert edge.left == ("turning point 2: friction just holds the mass there, which no bound tells",)
    # A place that only rounds to the edge is no exact one.
    beside = turning_points(Oscillator({0: "1/5", 2: "1/1000000"}), 3, digits=3).certificate()
    assert beside.left == () and beside.proved[-1] == "turning point 2: it stays"


def test_the_results_themselves_have_certificates():
    """The claims are what is printed, in the units of the result."""
    for found in (
        turning_points({2: 1}, 3, digits=9, times=True),
        turning_points(Oscillator({2: 1}, x0="1/3", mass=2), 3, digits=9, times=True),
        turning_points(Oscillator({2: 1}, v0="1/3"), 2, digits=9),
    ):
        claims = found.certificate().content[0]["claims"]
        assert [(c["number"], c["x"], c["t"]) for c in claims] == [(p.n, p.x, p.time) for p in found.points]
    drag = asy.reference({2: "1/10"})
    claims = drag.certificate(["1/2", 2], digits=9).content[0]["claims"]
    assert [(c["t"], c["x"], c["v"]) for c in claims] == [
        (t, drag.at(t, digits=9).x, drag.at(t, digits=9).v) for t in ("1/2", "2")
    ]
    assert drag.certificate(2, digits=9).content[0]["claims"] == claims[1:]
    with pytest.raises(InputError, match="static"):
        asy.reference({0: "1/10"}, static="1/5").certificate(1)


def test_several_in_one_file():
    one, two = (turning_points({a: "1/10"}, 2, digits=5).certificate() for a in (1, 2))
    both = together([one, two], ["what is left"])
    assert check_certificate.told(json.loads(both.to_json())) == [*one.proved, *two.proved]
    assert both.left == ("what is left",)
    with pytest.raises(LimitError, match="equations"):
        together([both] * 501)


@pytest.mark.slow
def test_a_thousand_half_swings_and_a_hundred_digits():
    """The limits that the help states, within the minute of the processor that a request has."""
    long = turning_points({"3/2": "1/1000"}, 1001, digits=12, times=True, max_seconds=600)
    fine = turning_points({"3/2": "1/10"}, 11, digits=100, times=True, max_seconds=600)
    for found, claims in ((long, 1001), (fine, 11)):
        begun = process_time()
        assert len(found.certificate(max_seconds=600).proved) == claims + 1
        assert process_time() - begun < 60
    with pytest.raises(InputError, match="count"):
        turning_points({"3/2": "1/1000"}, 1, start=1001, digits=3).certificate()
