"""A double may choose a size or a route; what it chose may not enter as if it were exact: a walk over the choices.

Found is every min, max, sorted, sort, argmin and argmax in the certified rooms whose key is made of doubles.  Where the
numbers differ by less than a double shows, such a choice is wrong, so each is listed with the reason why any
choice would do.
"""

import ast
import re
from collections.abc import Iterable, Iterator
from pathlib import Path

from tests.sources import nodes

ROOT = Path(__file__).parents[1] / "asymptotics"
ROOMS = (
    "bounds",
    "envelopes",
    "expansions",
    "flow",
    "decays/identification",
    "limit_cycles",
    "motions",
    "numbers",
    "return_map",
)


ROOMS += ("turning",)


IN_DOUBLES = re.compile(r"float|_double|\.sizes|\.seconds|size_of|np\.")
ANY_WILL_DO = {  # how many choices in the file, and why each of them may be wrong
    "expansions/divergence/petal.py": (1, "each petal has bounds of its own, proved: the smallest of a few"),
    "decays/identification/measuring/damped_cosine.py": (
        1,
        "where a search begins; all there is an estimate in doubles",
    ),
    "envelopes/large.py": (3, "where the tail begins, and where Newton's method starts: any place serves"),
    "limit_cycles/series.py": (2, "the cycle nearest to a guess, which is a double itself"),
    "flow/slow_manifold/attraction.py": (1, "Newton's method starts at one of several places"),
    "turning/abel.py": (1, "each circle or polydisc has a bound of its own: the least of them is sought"),
    "turning/jump.py": (1, "the cheaper of several routes"),
}


def choices(parts: Iterable[ast.AST]) -> Iterator[str]:
    """The calls that choose by a key in which doubles are read."""
    for node in parts:
        if isinstance(node, ast.Call):
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            keys = [k.value for k in node.keywords if k.arg == "key"]
            if name in ("min", "max", "sorted", "sort") and any(IN_DOUBLES.search(ast.unparse(k)) for k in keys):
                yield ast.unparse(node)


def test_no_double_chooses_what_counts_as_exact():
    paths = [path for room in ROOMS for path in (ROOT / room).rglob("*.py")]
    found = {str(path.relative_to(ROOT)): sum(1 for _ in choices(nodes(path))) for path in paths}
    assert {name: n for name, n in found.items() if n} == {name: n for name, (n, _) in ANY_WILL_DO.items()}


def test_the_walk_finds_one():
    def chosen(text):
        return list(choices(ast.walk(ast.parse(text))))

    assert chosen("least = min(range(3), key=lambda i: damping.sizes[i][1])")
    assert chosen("w = max(weights, key=float)") and not chosen("w = max(alphas)")
