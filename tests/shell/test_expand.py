"""The command expand: its JSON, its equations with the strength of each force, and refusals."""

import subprocess
import sys

from asymptotics.shell.main import main
from tests.each import each
from tests.shell.answers import answer, run

SUM = """\
gauge turning-point, exact; formal (no bound on the remainder)
dA/dtau = -A (p_0,1 delta_2 + p_1,0 delta_1)
dpsi/dtau = 1 + Omega_0,2 delta_2^2 + Omega_1,1 delta_1 delta_2 + Omega_2,0 delta_1^2
delta_1 = 1/10 for x'
delta_2 = 3 A for x'|x'|
"""


def test_expand(capsys):
    data = answer(capsys, "expand --alpha 3 --order 4 --digits 10 --exact")
    assert (data["alpha"], data["gauge"], data["order"]) == ("3", "turning-point", 4)
    assert set(data["amplitude"]) == {"1", "3"}
    assert set(data["frequency"]) == {"2", "4"}
    assert data["frequency"]["2"] == {"value": "-0.1757812500", "exact": "-45/256"}
    strong = answer(capsys, "expand --alpha 3 --epsilon 1/10 --order 4 --digits 10 --exact")
    assert (data["delta"][0]["value"], strong["delta"][0]["value"]) == ("epsilon A^2", "1/10 A^2")
    assert strong | {"delta": None} == data | {"delta": None}  # the coefficients hold for any strength
    assert answer(capsys, "expand --alpha 3/2 --order 3")["amplitude"]["3"]["exact"] is not None
    assert answer(capsys, "expand --alpha 3/2 --order 5")["amplitude"]["5"]["exact"] is None


def test_expand_a_sum_and_say_what_was_merged(capsys):
    data = answer(capsys, "expand --law 2:1/3 --law 1:1 --law 2:1 --order 2")
    assert data["alpha"] == ["2", "1"]
    assert "merged: alpha = 2" in data["notes"][0]
    assert set(data["frequency"]) == {"2,0", "1,1", "0,2"}


def test_expand_symbolic(capsys):
    data = answer(capsys, "expand --alpha symbolic --order 4")
    assert "I_4(alpha)" in data["frequency"]["4"]["exact"]
    assert data["integrals"]["I_4"]["values"]["1/2"].startswith("0.024213276")
    code, out, _ = run(capsys, "expand --alpha symbolic --order 2 --latex")
    assert code == 0
    assert r"\Gamma" in out


@each(
    ("line", "argument"),
    [
        ("half-swing --alpha symbolic --order 5", "--order"),
        ("half-swing --alpha symbolic --delta 1/10", "--delta"),
        ("half-swing --alpha symbolic --spring 3", "--spring"),
        ("half-swing --alpha symbolic --epsilon 1/10", "--epsilon"),
        ("moment --p -1", "--p"),
        ("moment --p nan", "--p"),
        ("moment --p 1e6", "--p"),
        ("moment", "--p"),
        ("moment --p 1 --digits 0", "--digits"),
        ("expand", "--alpha"),
        ("expand --alpha -1", "--alpha"),
        ("expand --alpha -1/2", "--alpha"),
        ("expand --alpha inf", "--alpha"),
        ("expand --alpha 1j", "--alpha"),
        ("expand --alpha __import__('os')", "--alpha"),
        ("expand --alpha 2000", "--alpha"),
        ("expand --alpha 2 --law 1:1", "--alpha"),
        ("expand --alpha 2 --epsilon x", "--epsilon"),
        ("expand --law 2:1 --epsilon 1", "--epsilon"),
        ("expand --law 1:x", "--law"),
        ("expand --law -1:1", "--law"),
        ("expand --law 1 --law 2 --law 3 --law 4 --law 5", "--law"),
        ("expand --alpha 2 --order 0", "--order"),
        ("expand --alpha 2 --order 1000000", "--order"),
        ("expand --alpha 3/2 --order 200 --digits 1000", "--max-seconds"),
        ("expand --alpha 2 --gauge energy", "--gauge"),
        ("expand --alpha 3/2 --exact", "--exact"),
        ("expand --alpha symbolic --order 5", "--order"),
        ("expand --alpha symbolic --order 4 --gauge averaging", "--order"),
        ("expand --alpha 2 --max-seconds 0", "--max-seconds"),
        ("half-swing --alpha 2 --digits 1000000", "--digits"),
        ("half-swing --alpha 2.5.5", "--alpha"),
    ],
)
def test_bad_input_is_one_line_that_names_the_argument(capsys, line, argument):
    code, out, err = run(capsys, line)
    assert (code, out, err.count("\n")) == (2, "", 1)
    assert argument in err


def test_a_sum_with_its_strengths(capsys):
    assert main(["expand", "--law", "1:1/10", "--law", "2:3", "--order", "2", "--digits", "10"]) == 0
    assert capsys.readouterr().out.startswith(SUM)


def test_without_strengths_the_letter_stays(capsys):
    assert main(["expand", "--law", "1/2", "--law", "5/2", "--order", "2", "--digits", "5"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[3:5] == [
        "delta_1 = epsilon_1 A^(-1/2) for x'|x'|^(-1/2)",
        "delta_2 = epsilon_2 A^(3/2) for x'|x'|^(3/2)",
    ]


def test_what_vanishes_is_left_out(capsys):
    """alpha = 1: p_3 = 0 by theorem, and delta is the strength for all time."""
    assert main(["expand", "--alpha", "1", "--epsilon", "1/10", "--order", "3"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[1:4] == ["dA/dtau = -A (p_1 delta)", "dpsi/dtau = 1 + Omega_2 delta^2", "delta = 1/10 for x'"]


def test_without_digits_a_motion_shows_what_its_error_leaves(capsys):
    line = "motion --alpha 3/2 --mass 3/2 --stiffness 30 --damping 1/10 --x0 1/5 --time 7"
    assert main(line.split()) == 0
    assert capsys.readouterr().out.splitlines()[0] == "x          0.16385309 m"  # error 1.2e-8


def test_equations_are_printed_without_numpy():
    """NumPy and SciPy would take a fifth of the time of the command."""
    code = "import sys; from asymptotics.shell.main import main; main(sys.argv[1:])"
    code += "; print({'numpy', 'scipy'} & {*sys.modules})"
    line = ["expand", "--alpha", "3/2", "--order", "4"]
    found = subprocess.run([sys.executable, "-c", code, *line], capture_output=True, text=True, check=True)
    assert found.stdout.splitlines()[-1] == "set()"


def test_strengths_of_merged_terms_are_their_sum_and_the_others_stay(capsys):
    line = "expand --law 2:1/20 --law 1:1/10 --law 2:1/20 --order 1 --digits 5"
    out = run(capsys, line)[1]
    assert "delta_1 = 1/10 A for x'|x'|" in out and "delta_2 = 1/10 for x'" in out and "merged: alpha = 2" in out
    # Two roots have no exact sum, and what has no strength is a letter.
    for other in ("2:sqrt(2)", "2"):
        assert "delta_1 = epsilon_1 A" in run(capsys, f"expand --law 2:sqrt(3) --law 1:1/10 --law {other} --order 1")[1]
