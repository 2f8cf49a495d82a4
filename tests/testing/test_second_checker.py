"""Two checkers that share a page of the docs and nothing else agree: this one's Python and another one's JavaScript."""

import json
import random
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

from asymptotics.testing.check_certificate import RefusedError, read, told
from tests.certificates import examples
from tests.testing.attacks import ATTACKS
from tests.testing.damage import damaged

SECOND = Path(__file__).parents[1] / "second_route" / "check_certificate.js"
NODE = shutil.which("node")
pytestmark = pytest.mark.skipif(NODE is None, reason="node is not installed: the second checker is JavaScript")


FEW = ("quadratic", "friction", "units")
ALL = tuple(examples.OSCILLATORS)


@cache
def good(names=FEW):
    """Certificates that hold."""
    return [
        *(examples.turning(name) for name in names),
        *(examples.state(name, "1/3", "1") for name in names),
        examples.turning("held", 3, 3),
        [examples.turning("sum"), examples.state("quadratic", "1")],
    ]


def verdicts(contents, folder):
    """(whether the first checker accepts it, whether the second one does) of each, a text or an object."""
    paths, first = [], []
    for i, content in enumerate(contents):
        path = folder / f"{i}.json"
        path.write_text(content if isinstance(content, str) else json.dumps(content))
        paths.append(path)
        try:
            told(read(path))
            first.append(True)
        except RefusedError:
            first.append(False)
    ran = subprocess.run([NODE, SECOND, *paths], capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr
    return first, [line == "accepted" for line in ran.stdout.splitlines()]


@pytest.mark.parametrize("names", [FEW, pytest.param(ALL, marks=pytest.mark.slow)], ids=["few", "all"])
def test_good_ones_are_accepted_by_both(tmp_path, names):
    assert verdicts(good(names), tmp_path) == ([True] * len(good(names)), [True] * len(good(names)))


@pytest.mark.parametrize("each", [3, pytest.param(1, marks=pytest.mark.slow)])
def test_forged_ones_are_refused_by_both(tmp_path, each):
    """All but those that are refused for a limit that the test sets lower; every third in ``make test``."""
    forged = [a.certificate() for a in ATTACKS if not a.limits][::each]
    assert verdicts(forged, tmp_path) == ([False] * len(forged), [False] * len(forged))


def test_damaged_ones_are_judged_alike(tmp_path):
    rng = random.Random(1000)
    contents = [damaged(rng.choice(good()[:-1]), rng) for _ in range(12)]
    contents += [[good()[0], content] for content in contents[:5]]
    first, second = verdicts(contents, tmp_path)
    assert first == second and {True, False} == set(first)


@pytest.mark.slow
@pytest.mark.parametrize("seed", range(8))
def test_a_thousand_damaged_ones_are_judged_alike(tmp_path, seed):
    rng = random.Random(2000 + seed)
    contents = [damaged(rng.choice(good(ALL)[:-1]), rng) for _ in range(125)]
    first, second = verdicts(contents, tmp_path)
    assert first == second
