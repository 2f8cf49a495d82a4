"""expand prints equations, and says which local strength belongs to which force."""

import subprocess
import sys

from asymptotics.cli.main import main

SUM = """\
gauge turning-point, exact; formal (no bound on the remainder)
dA/dtau = -A (p_0,1 delta_2 + p_1,0 delta_1)
dpsi/dtau = 1 + Omega_0,2 delta_2^2 + Omega_1,1 delta_1 delta_2 + Omega_2,0 delta_1^2
delta_1 = 1/10 for x'
delta_2 = 3 A for x'|x'|
"""


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
    code = "import sys; from asymptotics.cli.main import main; main(sys.argv[1:])"
    code += "; print({'numpy', 'scipy'} & {*sys.modules})"
    line = ["expand", "--alpha", "3/2", "--order", "4"]
    found = subprocess.run([sys.executable, "-c", code, *line], capture_output=True, text=True, check=True)
    assert found.stdout.splitlines()[-1] == "set()"
