"""The one reader of forces: the grammar of --law and --spring, keys in the order given, and what is refused by name."""

from asymptotics.shell.main import main
from tests.each import each
from tests.shell.answers import answer


def test_losses_come_first_then_springs_in_the_order_given(capsys):
    data = answer(capsys, "expand --spring 3:1 --law 1,2:1 --law 1:-1 --order 1 --digits 6")
    assert [(t["kind"], t["velocity"], t["position"]) for t in data["terms"]] == [
        ("loss", "1", 2), ("loss", "1", 0), ("spring", "0", 3),
    ]  # fmt: skip
    assert data["amplitude"]["1,0,0"]["exact"] == "1/8"
    assert data["amplitude"]["0,1,0"]["exact"] == "1/2"
    assert data["frequency"]["0,0,1"]["exact"] == "3/8"


def test_strengths_may_be_left_out_where_they_do_not_matter(capsys):
    assert answer(capsys, "half-swing --alpha 2 --spring pendulum --order 2")["duration"]["0,1"]["exact"] == "pi/16"
    assert answer(capsys, "expand --law 3/2,1 --spring 2,1/2 --order 1")["arithmetic"] == "certified"


@each(
    ("line", "named"),
    [
        ("expand --alpha 1 --law 2", "--alpha"),
        ("expand --law 1,1/2", "--law"),
        ("expand --law 1,-1", "--law"),
        ("expand --spring 1/2", "--spring"),
        ("expand --spring 5/2", "--spring"),
        ("expand --spring pendulums", "--spring"),
        ("expand --alpha 3/2 --spring 3 --exact", "--exact"),
        ("expand --alpha symbolic --spring 3 --order 3", "--order"),
        ("turning-points --law 2:1 --spring 3 --count 2", "--spring"),
        ("turning-points --law 2:-1 --spring 3:1 --count 2", "--law"),
        ("limit-cycle --law 1:1", "--law"),
    ],
)
def test_what_is_wrong_is_named_in_one_line(capsys, line, named):
    assert main(line.split()) == 2
    error = capsys.readouterr().err
    assert named in error
    assert error.count("\n") == 1
