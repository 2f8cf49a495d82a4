"""What a command loads: digits need no SymPy, mpmath or NumPy, each of which takes longer than the answer."""

import subprocess
import sys

import pytest

HEAVY = {"sympy", "mpmath", "numpy", "scipy", "matplotlib", "pandas"}
_ASK = """
import sys
from asymptotics.shell.main import main
for line in sys.argv[1:]:
    code = main(line.split())
    print(code, *sys.modules, file=sys.stderr)
"""


def loaded(*lines):
    """The heavy packages after each command line, all answered by one new process."""
    done = subprocess.run([sys.executable, "-c", _ASK, *lines], capture_output=True, text=True, check=True)
    answers = [line.split() for line in done.stderr.splitlines()]
    assert len(answers) == len(lines) and done.stdout and {code for code, *_ in answers} == {"0"}, done.stderr
    return [HEAVY & {*modules} for _, *modules in answers]


def test_digits_need_none_of_them(tmp_path):
    lines = (
        "turning-points --alpha 2 --epsilon 1/10 --count 3",
        "turning-points --alpha 3/2 --epsilon 1/10 --count 3 --times --json",
        "moment --p 5/2",
        "moment --p 7 --json",
        "moment --p 5/2 --latex",
        "expand --alpha 2",
        "expand --alpha 2 --order 6 --gauge averaging --exact --latex",
        "expand --alpha 3/2 --json",
        f"expand --law 0:1/10 --law 3/2:1/5 --order 3 --csv {tmp_path}/x.csv",
        "expand --alpha 1/2 --spring 3 --gauge no-first-harmonic --order 3",
        "expand --alpha 3/2 --damping 1/10 --mass 2 --stiffness 3",
        "half-swing --alpha 3/2 --latex",
        "stokes --alpha 2 --digits 8",
        "half-swing --law 1 --law 3/2 --order 3 --json",
    )
    assert {line: found for line, found in zip(lines, loaded(*lines), strict=True) if found} == {}


@pytest.mark.parametrize("line", ["moment --p sqrt(2)", "expand --alpha sqrt(2) --order 1", "expand --alpha symbolic"])
def test_a_closed_form_needs_sympy_and_what_is_loaded_is_seen(line):
    assert loaded(line) == [{"sympy", "mpmath"}]


def test_identify_loads_no_table_of_distributions():
    """``scipy.stats`` takes half a second; the few functions that are needed stand in ``scipy.special``."""
    code = "import sys, asymptotics.ask.questions.identify; print(*({'scipy.special', 'scipy.stats'} & {*sys.modules}))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["scipy.special"]
