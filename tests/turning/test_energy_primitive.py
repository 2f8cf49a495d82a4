"""Turning points with quadratic drag, dry friction and a spring: the equation, an integrator, ends, hostile input."""

import numpy as np
import pytest
from flint import arb, ctx
from scipy.integrate import solve_ivp

from asymptotics.errors import InputError
from asymptotics.law import Law, Oscillator
from asymptotics.numbers.exact import parse_real
from asymptotics.shell.main import main
from asymptotics.turning import energy_primitive
from asymptotics.turning.choose import turning_points
from asymptotics.turning.energy_primitive import PrimitiveWell, swings
from asymptotics.turning.routes.stepping import METHOD
from tests.second_route.forced import drag_turning_points
from tests.worlds import WORLDS

STARTS = {  # worlds, each with a start and its springs in doubles
    "a pendulum in air": ("2.967", np.sin),
    "air and friction in a hard spring": ("1", lambda x: x + x**3 / 2),
    "friction in a soft spring": ("1", lambda x: x - x**3 / 2),
    "air in a kinked spring": ("3/2", lambda x: x + x * abs(x) / 4),
}
PENDULUM, SOFT = (WORLDS[name].dimensionless for name in ("a pendulum in air", "friction in a soft spring"))


def exact(text):
    return parse_real(text, "x0")


def integrated(law, force, x):
    """The next turning point in doubles."""
    drag, dry = (sum(float(t.b.rational) for t in law.losses if t.velocity == a) for a in (2, 0))

    def stop(t, y):
        return y[1]

    stop.terminal, stop.direction = True, 1
    run = solve_ivp(lambda t, y: [y[1], -force(y[0]) + drag * y[1] ** 2 + dry], (0, 40), [x, -1e-13], events=stop,
                    rtol=1e-12, atol=1e-14)  # fmt: skip
    return float(run.y[0, -1])


def swing(well, x):
    points = energy_primitive.swings(well, x, 80)
    return [next(points)[0], next(points)[0]]


@pytest.mark.parametrize("name", STARTS)
def test_against_an_integrator(name):
    law, (x0, force) = WORLDS[name].dimensionless, STARTS[name]
    points = [float(p.x) for p in drag_turning_points(law, exact(x0), 5, 15).points]
    for here, after in zip(points, points[1:]):
        side = 1 if here > 0 else -1
        assert integrated(law, force, side * here) == pytest.approx(side * after, abs=1e-9)


def test_the_pendulum_keeps_its_function():
    """(cos x + 2 eps sin x) e^(-2 eps x) at a and -q, and a wrong factor would be seen."""
    table = drag_turning_points(PENDULUM, exact("2.967"), 2, 40)
    with ctx.workprec(200):
        a, b = (arb(p.x) for p in table.points)

        def function(x, k):
            return (x.cos() + k * x.sin()) * (-k * x).exp()

        assert abs(function(a, arb("0.2")) - function(b, arb("0.2"))) < arb(10) ** -38
        assert abs(function(a, arb("0.1")) - function(b, arb("0.1"))) > arb(10) ** -3


def test_a_weak_spring_is_the_linear_one():
    """With c = 10^-40 the certified Lambert W table of the linear spring comes out."""
    linear = turning_points(Law({2: "1/3"}), 6, 30)
    weak = turning_points(Law({2: "1/3"}, spring={3: "1e-40"}), 6, 30)
    assert [p.x for p in weak.points] == [p.x for p in linear.points]
    strong = turning_points(Law({2: "1/3"}, spring={3: "1e-20"}), 6, 30)
    assert strong.points[5].x != linear.points[5].x


def test_a_pendulum_in_other_units_of_length_is_the_same_pendulum():
    """x = 2 X: sin(2 X)/2 and twice the drag; sin X from X = 1 would be another motion."""
    angle = turning_points(Law({2: "1/5", 0: "1/50"}, spring="pendulum"), 4, 20, x0=2)
    units = turning_points(Oscillator({2: "1/5", 0: "1/50"}, spring="pendulum", x0=2).dimensionless, 4, 20)
    with ctx.workprec(120):
        for p, q in zip(angle.points, units.points, strict=True):
            assert abs(arb(p.x) - 2 * arb(q.x)) <= arb(10) ** -19


def test_a_ball_is_mapped_to_a_ball_that_contains_it():
    law = PENDULUM
    short, long = (drag_turning_points(law, exact("2"), 12, d) for d in (10, 40))
    for p, q in zip(short.points, long.points):
        assert abs(arb(p.x) - arb(q.x)) <= abs(arb(q.x)) * arb(10) ** -9 / 2


def test_dry_friction_holds_where_the_force_is_at_most_the_friction():
    table = drag_turning_points(SOFT, exact("1"), 40, 20)
    assert table.ended == {"n": len(table.points) - 1, "reason": "sticks"}
    with ctx.workprec(100):
        well = PrimitiveWell.of(SOFT)
        assert (
            well.force.spring_force(abs(arb(table.points[-1].x)))
            < well.dry
            < well.force.spring_force(abs(arb(table.points[-2].x)))
        )


@pytest.mark.parametrize(
    ("law", "x0", "reason"),
    [
        (Law({2: 1}, spring="pendulum"), "3.15", "rotates"),
        (Law({2: 1}, spring={3: -1}), "1", "escapes"),
        (Law({2: 1}, spring={3: -1, 5: "1/8"}), "3", "escapes"),
        (Law({2: 1}, spring={(3, 2): 1}), "1", "depends on the velocity"),
        (Law({2: 1}, spring="pendulum"), "0", "place of rest"),
        (Law({2: -1}, spring="pendulum"), "1", "negative"),
    ],
)
def test_what_cannot_be_taken_is_refused_by_name(law, x0, reason):
    with pytest.raises(InputError, match=reason):
        turning_points(law, 3, 10, x0=x0)


@pytest.mark.parametrize(
    ("law", "reason"),
    [
        (Law({"3/2": 1}, spring={3: 1}), "no exact swing"),
        (Law({2: 1, (2, 1): 1}, spring={3: 1}), "no exact swing"),
        (Law({0: "1/10"}, spring={3: 1, 5: -1}), "both signs"),
    ],
)
def test_what_the_primitive_does_not_know_goes_by_pieces(law, reason):
    assert turning_points(law, 2, 10, x0="1/2").method == METHOD
    with pytest.raises(InputError, match=reason):
        PrimitiveWell.of(law)
    with pytest.raises(InputError, match="closed-primitive does not serve"):
        drag_turning_points(law, exact("1/2"), 2, 10)


def test_the_command(capsys):
    line = ["turning-points", "--law", "2:1/5", "--spring", "pendulum", "--x0", "2", "--count", "2", "--digits", "10"]
    assert main(line) == 0
    assert "-1.203804096" in capsys.readouterr().out
    assert main([*line, "--times"]) == 0
    assert "3.888542453" in capsys.readouterr().out
    assert main([*line[:6], "4", "--count", "2"]) == 2


def test_a_force_that_may_hold_the_mass_leaves_it_open():
    """V' = x + x^3 at x = 0.5 +- 0.05 is on both sides of the friction 5/8: whether it stays is not told."""
    well = PrimitiveWell.of(Law({0: "5/8"}, spring={3: 1}))
    assert [stays for _, stays in swings(well, arb("0.5", "0.05"), 60)] == [None]
    assert next(swings(well, arb("0.3"), 60))[1] is True and next(swings(well, arb("0.9"), 60))[1] is False


def test_a_guess_that_is_off_is_refused(monkeypatch):
    """Without the two signs beside it any number would be a turning point."""
    with ctx.workprec(160):
        well = energy_primitive.PrimitiveWell.of(Law({0: "1/20", 2: "1/7"}, spring={3: "1/3"}))
        right = energy_primitive._next(well, arb(1), 80)
        assert right is not None and right.rad() < abs(right) * arb(2) ** -50
        for off in (-1, 1):
            monkeypatch.setattr(energy_primitive, "_guess", lambda *_, off=off: right.mid() * (1 + off * arb(2) ** -40))
            assert energy_primitive._next(well, arb(1), 80) is None


def test_the_image_of_a_ball_is_the_hull_of_both_ends():
    with ctx.workprec(160):
        well = energy_primitive.PrimitiveWell.of(Law({2: "1/7"}, spring={3: "1/3"}))
        wide, *ends = (
            list(swing(well, x)) for x in (arb(1, arb(2) ** -20), arb(1) - arb(2) ** -20, arb(1) + arb(2) ** -20)
        )
        assert all(wide[1].contains(end[1]) for end in ends)
