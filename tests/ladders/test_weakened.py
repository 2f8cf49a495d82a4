"""The list of weakened bounds: it fits the code, its tests exist, and no function that widens a ball is missing."""

import ast
import json
import os
import re
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import pytest

from benchmarks import weakened
from benchmarks.bound_sites import sites
from tests.ladders.walk import ROOT
from tests.sources import below, tree

ROOMS = {
    "bounds", "decays", "driven", "envelopes", "equivalent", "expansions", "flow", "limit_cycles",
    "motions", "numbers", "return_map", "turning",
}  # fmt: skip


OWN = {
    "bounds.explicit._ExplicitTheorem._pieces": "tests/bounds/test_explicit.py"
    "::test_on_each_piece_is_what_is_anywhere_on_it",
    "bounds.half_swing.HalfSwingSeries.at": "tests/bounds/test_half_swing.py"
    "::test_the_motion_is_within_the_bound_and_not_within_half_of_it",
    "bounds.motion._by_energy": "tests/bounds/test_late.py::test_what_is_out_of_range_falls_back_on_energy",
    "bounds.uniform._UniformTheorem._start": "tests/bounds/test_uniform.py::test_each_part_of_the_bound_counts",
    "bounds.waveform._between": "tests/bounds/test_waveform.py::test_the_pieces_are_hulls_of_their_functions",
    "bounds.waveform._hulls": "tests/bounds/test_waveform.py::test_the_pieces_are_hulls_of_their_functions",
    "driven.expansion._euler": "tests/driven/test_bounds.py"
    "::test_the_weights_of_an_uncertain_exponent_hold_those_of_both_ends",
    "expansions.divergence.abel.later": "tests/expansions/divergence/test_abel.py"
    "::test_what_an_orbit_leaves_out_is_bounded",
    "expansions.divergence.constants._solved": "tests/expansions/divergence/test_constants.py"
    "::test_a_tail_left_out_moves_the_constants",
    "expansions.divergence.half_step.at": "tests/expansions/divergence/test_half_step.py"
    "::test_a_half_swing_at_complex_strength_holds_smiths_map",
    "flow.slow_manifold.strong_damping.strong_damping_strip": "tests/flow/slow_manifold/test_strong_damping.py"
    "::test_what_the_strip_leaves_open_is_in_the_error_after_it",
    "equivalent.conservative_cycle._power": "tests/equivalent/test_conservative_cycle.py"
    "::test_the_size_of_a_power_near_zero_is_attained",
    "driven.expansion.Arc.harmonic": "tests/driven/test_bounds.py::test_the_rest_of_a_harmonic_is_that_of_the_wave",
    "driven.first_order.peak": "tests/driven/test_bounds.py::test_the_peak_is_held_at_few_bits",
    "driven.orbit.Orbit._of_v": "tests/driven/test_bounds.py"
    "::test_the_error_moves_x_and_the_speed_by_as_much_as_the_norm_lets_it",
    "driven.orbit.Orbit._of_x": "tests/driven/test_bounds.py"
    "::test_the_error_moves_x_and_the_speed_by_as_much_as_the_norm_lets_it",
    "driven.turn.turn": "tests/driven/test_turn.py::test_the_pull_is_that_at_every_place_and_angle_of_the_room",
    "driven.trial.march": "tests/driven/test_bounds.py::test_the_march_counts_every_defect_and_has_a_limit",
    "envelopes.certified.amplitude": "tests/envelopes/test_certified.py::test_too_little_precision_is_an_enclosure",
    "envelopes.certified.extinction_time": "tests/ladders/test_ladders.py::test_every_rung_holds_what_is_above_it",
    "envelopes.large.SlowFlow.extinction_time": "tests/ladders/test_ladders.py::test_every_rung_holds_what_is_above_it",
    "envelopes.large._power": "tests/envelopes/test_large.py::test_the_extinction_of_the_averaged_amplitude",
    "expansions.half_swings.symbolic._integrate": "tests/ladders/test_ladders.py"
    "::test_every_rung_holds_what_is_above_it",
    "limit_cycles.certified._interval_newton": "tests/limit_cycles/test_half_cycle.py"
    "::test_the_half_turn_encloses_and_bites",
    "motions.quadratic._angle": "tests/motions/test_quadratic.py::test_quadratic_motion_after_many_half_swings",
    "numbers.decimals.decimal_of_ball": "tests/numbers/test_decimals.py"
    "::test_a_ball_is_printed_when_both_exact_ends_round_alike_and_only_then",
    "numbers.rationals.bounds": "tests/numbers/test_rationals.py::test_bounds_enclose",
    "return_map.half_swings.HalfSwings.__call__": "tests/return_map/test_half_swings.py"
    "::test_the_residual_of_a_half_swing_is_what_it_is_off_by",
    "return_map.panels.Panels.half_swing": "tests/return_map/test_panels.py"
    "::test_the_durations_of_a_map_are_those_of_every_amplitude_within_the_error",
    "return_map.course.Course._near": "tests/return_map/test_courses.py::test_a_poor_place_on_a_quarter_is_paid_for",
    "return_map.sequence.OnCourse.all_at": "tests/return_map/test_courses.py"
    "::test_what_a_start_is_off_by_is_in_a_course",
    "return_map.courses.Along.at": "tests/return_map/test_courses.py"
    "::test_an_uncertain_place_counts_by_markovs_inequality",
    "return_map.courses.Along.of": "tests/return_map/test_courses.py::test_the_radii_of_what_is_kept_count",
    "return_map.courses.QuarterCourse._value": "tests/return_map/test_courses.py"
    "::test_what_a_way_is_off_by_is_in_what_is_read_off",
    "return_map.courses.QuarterCourse.near": "tests/return_map/test_courses.py"
    "::test_what_a_way_is_off_by_is_in_what_is_read_off",
    "return_map.hand_overs.Bundle._of_columns": "tests/return_map/test_quarters.py::test_a_late_start_is_paid_for",
    "return_map.quarters.Path.along": "tests/return_map/test_quarters.py::test_coefficients_that_are_dropped_count",
    "return_map.quarters.Path.enclosed": "tests/return_map/test_quarters.py::test_the_error_is_made_of_its_parts",
    "return_map.quarters.Path.on_ellipse": "tests/return_map/test_quarters.py::test_the_bounds_on_the_ellipse",
    "flow.slow_manifold.attraction.ForceCurve.clock": "tests/flow/slow_manifold/test_attraction.py"
    "::test_the_time_on_the_curves_is_the_integral_of_their_slope",
    "flow.slow_manifold.attraction.attracted": "tests/flow/slow_manifold/test_attraction.py"
    "::test_the_wait_is_as_long_as_it_takes_or_longer",
    "turning.jump._log": "tests/turning/test_jump.py::test_points_and_turning_points_keep_their_radii",
    "flow.wells.trapping_regions._held": "tests/flow/wells/test_trapping_regions.py"
    "::test_creep_beside_springs_and_dry_friction",
    "flow.turning.at_exact_place": "tests/flow/test_turning.py::test_a_place_that_is_known_lies_in_its_enclosure",
    "flow.error_propagation.points_forward": "tests/flow/test_error_propagation.py"
    "::test_the_force_ahead_must_point_forward",
}
"""Functions that widen a ball, none of whose lines is on the list -> the test of their own, in which the truth is
contained at few bits or the parts are evaluated again."""

NO_BOUND = {
    "bounds.local._sharp": "asks whether radii are small enough",
    "driven.expansion.piece": "balls as a key of a cache",
    "expansions.half_swings.finite_majorant._seems_to_exist": "balls as a key of a cache; the answer is in floats",
    "expansions.half_swings.nodes._lost": "how wide the balls are; wider than wanted, they are made again",
    "decays.identification.certified_sets.set_valued._searched": "boxes of doubles, searched; table_rows claims",
    "motions.formal_forces.FormalForces.__init__": "a union of sets",
    "motions.reference._within": "asks whether a radius is small enough",
    "numbers.alike.key": "a ball as a key: which results are equal",
    "numbers.pickling._make_arb": "the same ball, read and written",
    "numbers.pickling._reduce_arb": "the same ball, read and written",
    "flow.slow_manifold.slow_curve_series.truncated": "balls as a key of a cache",
}
"""Functions that name a radius or a hull, and bound nothing by it."""


def test_every_line_is_in_its_file_once_and_every_test_exists():
    texts = {w.file: (ROOT / w.file).read_text() for w in weakened.listed()}
    for w in weakened.listed():
        assert texts[w.file].count(w.line) == 1, w
        assert w.weaker != w.line and bool(w.test) != bool(w.equivalent), w
        if w.test:
            file, name = w.test.split("::")
            assert f"def {name}(" in (ROOT / file).read_text(), w
    assert len({(w.file, w.line, w.weaker) for w in weakened.listed()}) == len(weakened.listed())


def test_every_function_that_widens_a_ball_is_on_the_list():
    """arb(middle, radius), .rad(), .union(): who writes one bounds something, or says here why not."""
    missing, all_of_them = set(), set()
    for path in (path for room in ROOMS for path in (ROOT / "asymptotics" / room).rglob("*.py")):
        text, file = path.read_text(), path.relative_to(ROOT).as_posix()
        if path.name == "__init__.py" or not re.search("arb|rad|union", text):  # what is looked for, in any notation
            continue
        planted = [text[: text.index(w.line)].count("\n") + 1 for w in weakened.listed() if w.file == file]
        module = ".".join(path.relative_to(ROOT / "asymptotics").with_suffix("").parts)
        for name, node in functions(tree(path).body, module):
            if widens(node):
                all_of_them.add(name)
                if not any(node.lineno <= line <= (node.end_lineno or 0) for line in planted):
                    missing.add(name)
    named = {*NO_BOUND, *OWN}
    assert not missing - named, "weaken what they bound in benchmarks/weakened_bounds.json, or name their test here"
    assert not named - all_of_them, "these widen no ball any more"
    for test in OWN.values():
        file, name = test.split("::")
        assert f"def {name}(" in (ROOT / file).read_text(), test


def widens(node: ast.FunctionDef) -> bool:
    calls = [n for n in below(node) if isinstance(n, ast.Call)]
    pairs = [n for n in calls if isinstance(n.func, ast.Name) and len(n.args) == 2]
    balls = any(n.func.id == "arb" and not isinstance(n.args[0], ast.Tuple) for n in pairs)
    return balls or any(isinstance(n.func, ast.Attribute) and n.func.attr in ("rad", "union") for n in calls)


def functions(body: list[ast.stmt], prefix: str) -> Iterator[tuple[str, ast.FunctionDef]]:
    for node in body:
        if isinstance(node, ast.FunctionDef):
            yield f"{prefix}.{node.name}", node
        elif isinstance(node, ast.ClassDef):
            yield from functions(node.body, f"{prefix}.{node.name}")


@pytest.mark.slow
def test_a_weakened_bound_is_noticed_and_a_harmless_change_is_not(tmp_path):
    folder = weakened.copy_of_the_project(tmp_path / "copy")
    fault = next(w for w in weakened.listed() if w.file.endswith("quadratic_map.py"))
    harmless = weakened.Weakened(fault.file, "nothing", fault.line, f"{fault.line}  # the same", fault.test)
    assert weakened.is_noticed(fault, Path(folder)) and not weakened.is_noticed(harmless, Path(folder))


def test_the_page_on_certified_results_counts_them():
    rows = weakened.table([(w, "equivalent" if w.equivalent else "noticed") for w in weakened.listed()]).rows
    page = (ROOT / "docs" / "certified.md").read_text()
    for room, noticed, equivalent, _ in rows:
        assert f"| {room} | {noticed} | {equivalent} |" in page


def test_no_new_place_of_a_bound_is_left_unanswered():
    """The ratchet: in each room as many places as the list says lack an answer, not one more; and none is gone."""
    known = json.loads(weakened.SITES.read_text())
    left = Counter(Path(site.file).parts[1].removesuffix(".py") for site in weakened.unanswered())
    more = {room: count - known["unanswered"].get(room, 0) for room, count in left.items()}
    told = "answer for them in benchmarks/bound_sites.json (python -m benchmarks.weakened --search ROOM)"
    assert not {room: count for room, count in more.items() if count > 0}, told
    assert known["unanswered"] == dict(left), "fewer are left: lower the numbers"
    assert known["answers"].keys() <= {site.key for site in sites()}, "answers for places that are gone"
    for answer in weakened.answered():
        assert bool(answer.test) != bool(answer.equivalent), answer
        if answer.test.startswith("tests/"):
            file, name = answer.test.split("::")
            assert f"def {name}(" in (ROOT / file).read_text(), answer


def test_the_wall_time_is_told_beside_that_of_the_tests():
    before, after = os.times_result((1.0, 1.0, 10.0, 2.0, 100.0)), os.times_result((5.0, 5.0, 40.0, 4.0, 1334.0))
    told = weakened.how_long(before, after, 1006, 0, 2)
    assert told == "1,006 bounds, 2 at once: 1,234 s of wall time, 32 s of processor time"
    assert "; 30 of them were written down by an earlier run" in weakened.how_long(before, after, 1006, 30, 2)
