"""Pictures: law, start and order in them, units on the axes, no legend over the data; --plot is the plot of Python."""

import re
import sys
from pathlib import Path

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.telling.plots import draw_decrements
from asymptotics.errors import InputError
from asymptotics.present.drawn import Drawn, head
from asymptotics.shell.main import main
from tests.worlds import OSCILLATOR as OSC

sys.path.insert(0, str(Path(__file__).parents[2] / "docs/extensions"))

from picture_faults import faults  # noqa: E402 (the pages of the docs are looked at by the same function)

mpl.use("Agg")
LAW = {2: "1/10"}
MADE = {
    "motion": lambda: asy.motion(OSC, order=2),
    "reference": lambda: asy.reference(LAW),
    "envelope": lambda: asy.envelope(OSC),
    "envelope beside a spring": lambda: asy.envelope(asy.Oscillator({2: "1/20"}, spring="pendulum", x0=3)),
    "solution": lambda: asy.solution(LAW, order=3),
    "solution of a sum": lambda: asy.solution({1: "1/10", 2: "1/20"}, order=1),
    "turning points": lambda: asy.turning_points(LAW, 5, digits=9),
    "turning points in SI": lambda: asy.turning_points(OSC, 5, digits=9),
    "half-swing": lambda: asy.half_swing(2, order=3, digits=9),
    "limit cycle": lambda: asy.limit_cycle({1: -1, (1, 2): 1}, order=4, digits=9),
    "stokes": lambda: asy.stokes(2, digits=6),
    "table": lambda: asy.table("smith2012.table1", digits=9),
    "samples": lambda: asy.motion(OSC, order=2).sample(np.linspace(0, 3, 9)),
}


def drawn(result, **style):
    axes = result.plot(**style)
    axes.figure.canvas.draw()
    mpl.pyplot.close(axes.figure)
    return axes


@pytest.mark.timeout(60)
@pytest.mark.parametrize("name", MADE)
def test_a_curve_has_a_heading_units_and_a_legend_outside(name):
    result = MADE[name]()
    assert isinstance(result, Drawn)
    axes = drawn(result)
    assert axes.lines and all(np.isfinite(line.get_ydata()).any() for line in axes.lines)
    assert re.sub(r"\s+", " ", axes.get_title()) == re.sub(r"\s+", " ", result._heading())
    assert axes.get_xlabel() and axes.get_ylabel()
    legend = axes.get_legend()
    if legend is not None:
        assert legend.get_window_extent().y0 >= axes.get_window_extent().y1 - 1
        title = axes.title.get_window_extent()
        assert title.y0 >= legend.get_window_extent().y1 - 3 and title.y1 <= axes.figure.bbox.y1 + 1
    assert axes.figure.bbox.x0 <= axes.get_tightbbox().x0 and axes.get_tightbbox().x1 <= axes.figure.bbox.x1 + 1
    assert faults(axes.figure) == []  # no ticks over ticks, no legend over data, nothing empty or cut off


def test_panels_have_room_and_the_style_of_all_pictures():
    n = np.arange(30)
    noise = 1e-3 * np.random.default_rng(0).standard_normal(30)
    decay = {"n": n, "x": (-1.0) ** n * 0.95**n + noise}
    answer = asy.identify(decay, laws=["1", "2", "1+2"], bootstrap=False)
    figure = answer.plot().figure
    assert len(figure.axes) == 4 and faults(figure) == []
    assert not any(axes.spines["top"].get_visible() or axes.get_legend().get_frame_on() for axes in figure.axes)
    cramped = mpl.pyplot.subplots(figsize=(6.4, 4), layout="constrained")[1]
    answer.plot(cramped, panels=True)  # a heading that the edge cuts is noticed
    assert any("cut off" in fault for fault in faults(cramped.figure))
    over = mpl.pyplot.subplots(1, 2, figsize=(4, 2))[1]
    over[0].plot([0, 1], [0, 1], label="a legend that is much wider than its axes")
    over[0].legend(loc="lower left")
    over[1].plot([0, 1], [0, 1])
    assert any("lies over" in fault for fault in faults(over[0].figure))
    mpl.pyplot.close("all")


def test_turning_points_are_counted_in_whole_numbers_and_no_line_of_a_heading_ends_in_an_equation():
    axes = asy.turning_points(asy.Oscillator({"3/2": "1/10"}, mass="3/2", stiffness=30, x0="1/5"), 4).plot()
    axes.figure.draw_without_rendering()
    assert all(float(tick).is_integer() for tick in axes.get_xticks())
    lines = axes.get_title().split("\n")
    assert len(lines) > 1 and lines[-1] == "x'(0) = 0"


def test_the_best_law_is_not_hidden_by_its_rivals():
    n = np.arange(30)
    noise = 1e-3 * np.random.default_rng(0).standard_normal(30)
    answer = asy.identify({"n": n, "x": (-1.0) ** n * 0.95**n + noise}, laws=["1", "2"], bootstrap=False)
    axes = plt.subplots()[1]
    draw_decrements(axes, [found.law for found in answer.laws], "")  # laws that coincide are one band
    best, rival = (line for line in axes.get_lines() if line.get_linestyle() != "None")
    assert best.get_label() == "1" and best.get_zorder() > rival.get_zorder()
    assert best.get_linestyle() == "-" != rival.get_linestyle()


def test_units_are_those_of_the_result():
    assert (drawn(asy.motion(OSC)).get_xlabel(), drawn(asy.motion(OSC)).get_ylabel()) == ("t (s)", "x (m)")
    alone = drawn(asy.motion(LAW))
    assert (alone.get_xlabel(), alone.get_ylabel()) == (r"$\tau = \omega_0 t$", "x")


def test_the_curve_is_the_motion():
    motion = asy.motion(OSC, order=2)
    line = drawn(motion, until=3, color="black", linewidth=3).lines[0]
    assert line.get_color() == "black" and line.get_linewidth() == 3
    assert np.array_equal(line.get_ydata(), motion.sample(line.get_xdata()).x) and line.get_xdata()[-1] == 3


def test_errors_and_velocity_stand_below():
    axes = drawn(asy.motion(LAW, order=2), until=6, errors=True)
    upper, lower = axes.figure.axes
    assert axes is upper and lower.get_yscale() == "log" and max(lower.lines[0].get_ydata()) < 1e-3
    assert upper.get_window_extent().y0 > lower.get_window_extent().y1
    with_speed = drawn(asy.reference(LAW), until=6, velocity=True).figure.axes[1].lines[0]
    assert with_speed.get_ydata()[0] == 0 and min(with_speed.get_ydata()) < -0.5


def test_several_laws_in_one_call():
    axes = asy.plot(asy.motion(LAW), asy.motion({1: "1/10"}), until=20)
    labels = [text.get_text() for text in axes.get_legend().get_texts()]
    assert [("x'|x'|" in label, "order 3" in label) for label in labels if label != "±A"] == [
        (True, True),
        (False, True),
    ]
    assert labels.count("±A") == 1 and axes.get_title() == ""
    mpl.pyplot.close(axes.figure)
    with pytest.raises(InputError, match="has no curve"):
        asy.plot(asy.moment(2))
    with pytest.raises(InputError, match="nothing to draw"):
        asy.plot()


def test_a_second_result_on_the_same_axes_adds_its_heading():
    axes = asy.motion(LAW).plot(until=20)
    asy.reference(LAW).plot(axes, until=20)
    assert axes.get_title().splitlines()[0].endswith("turning-point gauge") and "reference" in axes.get_title()
    mpl.pyplot.close(axes.figure)


@pytest.mark.parametrize(
    "call",
    [
        lambda m: m.plot("axes"),
        lambda m: m.plot(no_such_style=1),
        lambda m: m.plot(color="no colour"),
        lambda m: m.plot(until=-1),
        lambda m: m.picture("bmp"),
        lambda m: m.picture("png", size=(0.01, 5)),
        lambda m: m.picture("png", size="large"),
        lambda m: m.picture("png", dpi=5),
        lambda m: asy.solution(2, order=2).plot(),
    ],
)
def test_bad_requests_are_refused_by_name(call):
    with pytest.raises(InputError):
        call(asy.motion(LAW, order=1))


class Faulty(Drawn):
    """Its own fault, whatever the style is."""

    def _heading(self):
        return "a fault"

    def _curve(self, axes, **style):
        axes.plot([0, 1], [0, 1], **style)
        axes.plot([0, 1, 2], [0, 1])  # Matplotlib raises ValueError for what we have done


class Needing(Faulty):
    """It is drawn up to a time that must be said."""

    def _curve(self, axes, **style):
        if "until" not in style:
            raise InputError("until", "missing", "a time")
        axes.plot([0, style.pop("until")], [0, 1], **style)


@pytest.mark.parametrize("style", [{}, {"color": "red"}, {"label": "ours"}])
def test_a_fault_of_our_own_is_not_told_as_one_of_the_style(style):
    """Failed before: any fault while drawing was told as argument style."""
    with pytest.raises(ValueError, match="same first dimension") as caught:
        Faulty().picture("svg", **style)
    assert not isinstance(caught.value, InputError)
    with pytest.raises(InputError, match="argument style"):  # near miss: what the style has caused
        asy.motion(LAW, order=1).picture("svg", until=9, no_such_style=1)
    with pytest.raises(InputError, match="argument style"):  # and of a curve that cannot be drawn without an option
        Needing().picture("svg", until=9, no_such_style=1)


def test_files_say_what_they_show_and_are_the_same_each_time():
    motion = asy.motion(LAW, order=1)
    svg = motion.picture("svg", until=10)
    assert b"<title>x'' + x + 1/10 x'|x'| = 0" in svg and svg == motion.picture("svg", until=10)
    assert motion.picture("pdf", until=10) == motion.picture("pdf", until=10)
    png = motion.picture("png", until=10, size=(5, 3), dpi=100)
    assert (int.from_bytes(png[16:20]), int.from_bytes(png[20:24])) == (500, 300)


COMMANDS = {
    "motion --alpha 2 --epsilon 1/10 --time 9 --order 2": lambda: asy.motion(LAW, order=2).picture(
        "svg", size=(6.4, 5.2), until=9, errors=True
    ),
    "envelope --alpha 2 --epsilon 1/10 --time 9": lambda: asy.envelope(LAW).picture("svg", until=9),
    "solution --alpha 2 --epsilon 1/10 --order 2 --time 9": lambda: asy.solution(LAW, order=2).picture("svg", until=9),
    "turning-points --alpha 2 --epsilon 1/10 --count 5 --digits 9": lambda: MADE["turning points"]().picture("svg"),
    "half-swing --alpha 2 --order 3 --digits 9": lambda: MADE["half-swing"]().picture("svg"),
    "limit-cycle --law 1:-1 --law 1,2:1 --order 4 --digits 9": lambda: MADE["limit cycle"]().picture("svg"),
    "stokes --alpha 2 --digits 6": lambda: MADE["stokes"]().picture("svg"),
    "table smith2012.table1 --digits 9": lambda: MADE["table"]().picture("svg"),
}


@pytest.mark.timeout(60)
@pytest.mark.parametrize("line", COMMANDS)
def test_the_picture_of_the_command_is_that_of_python(line, tmp_path, capsys):
    target = tmp_path / "picture.svg"
    assert main([*line.split(), "--plot", str(target)]) == 0
    assert str(target) in capsys.readouterr().out
    assert target.read_bytes() == COMMANDS[line]()


def test_overlay_size_and_resolution_from_the_shell(tmp_path, capsys):
    target = tmp_path / "laws.png"
    line = ["motion", "--alpha", "2", "--epsilon", "1/10", "--time", "9", "--order", "1", "--plot", str(target)]
    assert main([*line, "--overlay", "1:1/10", "--overlay", "0:1/50+1:1/20", "--size", "8x4", "--dpi", "50"]) == 0
    made = target.read_bytes()
    assert (int.from_bytes(made[16:20]), int.from_bytes(made[20:24])) == (400, 200)
    assert main([*line[:-2], "--size", "8x4"]) == 2
    assert "--size" in capsys.readouterr().err
    assert main([*line, "--size", "8"]) == 2
    assert main([*line, "--overlay", "nonsense"]) == 2


@pytest.mark.slow
def test_a_pendulum_is_told_in_radians_everywhere():
    pendulum = asy.Oscillator(asy.Law({2: "1/10"}, spring="pendulum"), x0=1)
    points, motion = asy.turning_points(pendulum, 2, digits=6), asy.motion(pendulum)
    reference, envelope = asy.reference(pendulum), asy.envelope(pendulum)
    heads = [
        *points.to_dataframe().columns,
        *reference.sample([0.0]).header(),
        *reference.events(5).to_dataframe().columns,
        *motion.sample([0.0]).header(),
    ]
    said = [
        str(points),
        str(points.points[1]),
        str(reference.at(1, digits=5)),
        str(motion.at(1)),
        points._repr_latex_(),
        *heads,
    ]
    said += [motion.at(1)._repr_latex_(), str(motion), str(reference)]
    said += [drawn(found).get_ylabel() for found in (points, reference, envelope, motion)] + envelope.sample(
        [0.0]
    ).header()
    assert not [text for text in said if re.search(r"\bm\b", text)]
    assert sum("rad" in text for text in said) >= 12
    assert points.to_dict()["units"] == {"x": "rad", "t": "s"}


@pytest.mark.parametrize("columns", [2, 3])
def test_legends_of_axes_side_by_side_are_no_wider_than_their_place(columns):
    """Failed before: names like 0+1+pendulum stood in three columns over the neighbour, and over the edge."""
    figure, row = plt.subplots(1, columns, figsize=(10, 3.5), layout="constrained")
    for axes in row:
        for i, name in enumerate(["0+1+pendulum and 0+2+pendulum (coincide)", "0+3+pendulum", "before any law"]):
            axes.plot([0, 1], [i, i + 1], label=name)
        head(axes, ["decrement against amplitude"])
    assert faults(figure) == []
    assert all(axes.get_legend()._ncols < 3 for axes in row)
    alone = plt.subplots(layout="constrained")[1]
    for name in ("0+1+pendulum", "0+2+pendulum", "before any law"):
        alone.plot([0, 1], [0, 1], label=name)
    head(alone, ["one"])
    assert alone.get_legend()._ncols == 3  # near miss: axes that stand alone have room
    plt.close("all")
