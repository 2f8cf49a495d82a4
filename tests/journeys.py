"""Three requests followed through the house: the files whose functions run, in the page for maintainers.

python -m tests.journeys          rewrites the lists and the table of routes in docs/maintainers/architecture.md, and
                                  docs/maintainers/files.md: each file, its arithmetic and its first sentence
"""

import ast
import re
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from types import FrameType

import asymptotics as asy
from asymptotics.motions.reference import ROUTES as STATES
from asymptotics.shell.main import run
from asymptotics.turning.routes import ROUTES
from benchmarks.bound_sites import arithmetic_of
from tests.sources import tree

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "maintainers" / "architecture.md"
FILES = PAGE.with_name("files.md")
ROOM = str(ROOT / "asymptotics") + "/"


def turning_point() -> None:
    """The third turning point of (1, 3/2) beside a pendulum, from the shell to the ball and back."""
    line = "turning-points --law 1:1/10 --law 3/2:1/10 --spring pendulum --x0 1 --start 3 --count 1 --digits 15"
    assert run(line.split()) == 0


def moment_of_motion() -> None:
    """x(t) from asy.motion."""
    asy.motion(asy.Oscillator({"3/2": "1/10"}, x0="1/5"), order=3).at(7)


def verdict() -> None:
    """Rows of a CSV file to a verdict on the law."""
    rows = "\n".join(f"{n},{0.2 * 0.9**n:.9f}" for n in range(12))
    path = Path(sys.argv[2]) / "decay.csv"
    path.write_text(f"n,x [m]\n{rows}\n")
    asy.identify(str(path), laws=["1", "2"])


JOURNEYS: dict[str, Callable[[], None]] = {"turning-point": turning_point, "motion": moment_of_motion, "csv": verdict}


def visited(work: Callable[[], None]) -> list[str]:
    """The files of the library in which a function runs during ``work``; what an import runs does not count."""
    seen: set[str] = set()
    loading = 0

    def look(frame: FrameType, event: str, _argument: object) -> None:
        nonlocal loading
        name, code = frame.f_code.co_filename, frame.f_code.co_name
        if code == "<module>":
            loading += (event == "call") - (event == "return")
        elif event == "call" and loading == 0 and name.startswith(ROOM):
            seen.add(name.removeprefix(ROOM))

    # The alarm of a public call rings on a slow machine alone: what it calls is no step of the journey.
    signal.setitimer = lambda *_: (0.0, 0.0)  # type: ignore[assignment]
    sys.setprofile(look)
    try:
        work()
    finally:
        sys.setprofile(None)
    return sorted(seen)


def traced(name: str, folder: Path) -> list[str]:
    """The files of a journey, in a process of its own: what is kept from earlier requests does not hide any."""
    command = [sys.executable, "-m", "tests.journeys", name, str(folder)]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    return done.stdout.rpartition("journey:")[2].split()


def listed(files: list[str]) -> str:
    """Files by room, one line a room."""
    rooms: dict[str, list[str]] = {}
    for file in files:
        room, _, rest = file.partition("/")
        rooms.setdefault(f"{room}/" if rest else "at the top", []).append(rest or room)
    count = f"{len(files)} files in {len(rooms)} places.\n\n"
    return count + "\n".join(f"* `{room}`: {', '.join(f'`{f}`' for f in names)}" for room, names in rooms.items())


def routes() -> str:
    """The table of routes."""
    states = {n: f"`{r.state.__module__.removeprefix('asymptotics.')}`" for r in STATES for n in r.names}
    rows = [f"| `{r.name}` | {r.domain} | {r.way} | {states.get(r.name, '')} |" for r in ROUTES]
    return "\n".join(["| route | serves | by | x(t) the same way |", "|---|---|---|---|", *rows])


def first_sentence(path: Path) -> str:
    """The first sentence of a file's docstring, on one line."""
    text = ast.get_docstring(tree(path)) or ""
    first = " ".join(text.partition("\n\n")[0].split())
    return re.sub(r"([|<*])", r"\\\1", first.partition(". ")[0].rstrip(".: ").replace("``", "`"))


def map_of_files() -> str:
    """The page of files: a room, and a line for each file in it."""
    root, parts = (
        ROOT / "asymptotics",
        ["# Every file in one line", "Made by `python -m tests.journeys`; {doc}`architecture` has the wings."],
    )
    rooms = sorted({path.parent for path in root.rglob("*.py")})
    for room in rooms:
        name = f"`{room.relative_to(root)}/`" if room != root else "At the top"
        modules = [path for path in sorted(room.glob("*.py")) if not path.name.startswith("__")]
        rows = [f"| `{m.name}` | {arithmetic_of(str(m.relative_to(ROOT)))} | {first_sentence(m)} |" for m in modules]
        parts += [f"## {name}", first_sentence(room / "__init__.py") + "."]
        parts += ["\n".join(["| file | arithmetic | |", "|---|---|---|", *rows])] if rows else []
    return "\n\n".join(parts) + "\n"


def block(name: str, text: str) -> str:
    """What stands in the page under that name."""
    return f"<!-- {name} -->\n{text}\n<!-- end of {name} -->"


def told(name: str) -> str:
    """The block as the page has it."""
    found = re.search(rf"<!-- {name} -->\n(.*?)\n<!-- end of {name} -->", PAGE.read_text(encoding="utf-8"), re.DOTALL)
    assert found is not None, name
    return found[1]


def main() -> None:
    """Rewrite the page, or print the files of one journey."""
    if len(sys.argv) > 1:
        files = visited(JOURNEYS[sys.argv[1]])
        print("journey:", *files)
        return
    page = PAGE.read_text(encoding="utf-8")
    made = {"routes": routes()} | {name: listed(traced(name, Path(tempfile.mkdtemp()))) for name in JOURNEYS}
    for name, text in made.items():
        page = page.replace(block(name, told(name)), block(name, text))
    PAGE.write_text(page, encoding="utf-8")
    FILES.write_text(map_of_files(), encoding="utf-8")


if __name__ == "__main__":
    main()
