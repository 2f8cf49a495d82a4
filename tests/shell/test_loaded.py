"""What a command loads: digits need no SymPy, mpmath or NumPy, each of which takes longer than the answer."""

import subprocess
import sys

import pytest

HEAVY = {"sympy", "mpmath", "numpy", "scipy", "matplotlib", "pandas"}
_ASK = """
import sys
from asymptotics.shell.main import main
code = main(sys.argv[1:])
print(code, *sys.modules, file=sys.stderr)
"""


def loaded(*words):
    """The heavy packages in a new process that has answered a command line."""
    done = subprocess.run([sys.executable, "-c", _ASK, *words], capture_output=True, text=True, check=True)
    code, *modules = done.stderr.split()
    assert code == "0" and done.stdout
    return HEAVY & set(modules)


@pytest.mark.parametrize(
    ("line", "needed"),
    [
        ("turning-points --alpha 2 --epsilon 1/10 --count 3", set()),
        ("turning-points --alpha 3/2 --epsilon 1/10 --count 3 --times --json", set()),
        ("moment --p 5/2", set()),
        ("moment --p 7 --json", set()),
        ("moment --p sqrt(2)", {"sympy", "mpmath"}),  # the closed form: what is loaded is seen
        ("moment --p 5/2 --latex", set()),
        ("expand --alpha 2", set()),
        ("expand --alpha 2 --order 6 --gauge averaging --exact --latex", set()),
        ("expand --alpha 3/2 --json", set()),
        ("expand --law 0:1/10 --law 3/2:1/5 --order 3 --csv {folder}/x.csv", set()),
        ("expand --alpha 1/2 --spring 3 --gauge no-first-harmonic --order 3", set()),
        ("expand --alpha 3/2 --damping 1/10 --mass 2 --stiffness 3", set()),
        ("half-swing --alpha 3/2 --latex", set()),
        ("stokes --alpha 2", set()),
        ("half-swing --law 1 --law 3/2 --order 3 --json", set()),
        ("expand --alpha sqrt(2) --order 1", {"sympy", "mpmath"}),
        ("expand --alpha symbolic --order 2", {"sympy", "mpmath"}),
    ],
)
def test_a_command_loads_what_its_answer_needs(line, needed, tmp_path):
    assert loaded(*line.format(folder=tmp_path).split()) == needed


def test_identify_loads_no_table_of_distributions():
    """``scipy.stats`` takes half a second; the few functions that are needed stand in ``scipy.special``."""
    code = "import sys, asymptotics.ask.questions.identify; print(*({'scipy.special', 'scipy.stats'} & {*sys.modules}))"
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["scipy.special"]
