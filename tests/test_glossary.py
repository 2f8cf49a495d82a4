"""Every sign that a command prints stands in the glossary of the docs."""

import re
import shlex
from pathlib import Path

import pytest

from asymptotics.shell.main import main

PAGE = (Path(__file__).parents[1] / "docs/symbols.md").read_text(encoding="utf-8")
KNOWN = {
    sign
    for line in PAGE.partition("## Names in the code")[0].splitlines()
    if line.startswith("| `")
    for sign in re.findall(r"`([^`]+)`", line.split("|")[1])
}
LINES = (
    "expand --alpha 2 --order 4",
    "expand --law 1 --law 3/2 --order 2",
    "half-swing --alpha 2 --order 4",
    "half-swing --alpha 3/2 --delta 1/10 --digits 10",
    "stokes --alpha 2",
    "limit-cycle --law 1:-1 --law 1,2:1 --order 4",
    "envelope --alpha 2 --epsilon 1/10 --time 3",
    "solution --alpha 2 --order 3",
    "motion --alpha 2 --epsilon 1/10 --time 3",
    "multiple-scales --alpha 3 --order 1",
    "moment --p 5/2",
    "smith g --i 2",
    "smith f --n 3",
    "smith c --n 5 --i 1",
    "table smith2012.table1 --digits 6",
    "turning-points --alpha 3/2 --damping 1/10 --mass 2 --stiffness 3 --x0 1/5 --count 2 --digits 9 --times",
    "damping --alpha 2 --epsilon 1/10 --amplitudes 1 --order 2",
    "limit-cycle --law 1:-1 --law 1,2:1 --order 2 --mu 1/2",
    "envelope --law 2:1/20 --spring pendulum --x0 3 --time 4",
    "expand --alpha 2 --order 2 --bound",
)


def signs(text):
    """What stands like a sign: a letter or a Greek name, alone or with an index, and names of functions."""
    greek = (
        "alpha|beta|gamma|delta|epsilon|kappa|lambda|mu|nu|psi|phi|tau|theta|omega|Omega|sigma|chi|xi|zeta|eta|rho|pi"
    )
    found = re.findall(rf"(?<![\w-])(d?(?:{greek})|d?[A-Za-z]|S_hat)(?:_\d+(?:,\d+)*)?(?:\^\d+)?(?![\w-])", text)
    found += re.findall(r"\b([a-zA-Z]+)\(", text)
    return set(found)


def lacking(text, known=frozenset(KNOWN)):
    """The signs of a text that are not explained."""
    spelled = {part for sign in known for part in (sign, sign.partition("_")[0])}
    return {sign for sign in signs(text) if sign not in spelled and sign.lower() not in WORDS}


WORDS = {"a", "at", "in", "series", "equation", "through", "table", "i"}
"""Words of sentences that look like signs."""


@pytest.mark.parametrize("line", LINES)
def test_every_sign_that_is_printed_is_explained(capsys, line):
    assert main(shlex.split(line)) == 0
    assert lacking(capsys.readouterr().out) == set()


def test_what_is_said_of_data_is_explained(capsys, tmp_path):
    path = tmp_path / "decay.csv"
    rows = [f"{n},{(-1) ** n * 0.95**n * (1 + 1e-3 * (n * 7 % 5 - 2))}" for n in range(24)]
    path.write_text("\n".join(["n,x", *rows]))
    for line in (f"identify {path} --laws 1 2 1+2", f"compare {path} --alpha 1 --epsilon 1/30"):
        assert main(shlex.split(line)) == 0
        assert lacking(capsys.readouterr().out) == set()


def test_a_sign_that_is_not_explained_is_noticed():
    assert lacking("Omega_2 = 1, chi_3 = 2, foo(x)") == {"chi", "foo"}
    assert lacking("kappa_1 delta^2", frozenset(KNOWN - {"kappa"})) == {"kappa"}
    assert len(KNOWN) > 60
