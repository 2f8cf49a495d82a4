"""What a release would ship, tried as a stranger would: ``python -m tests.wheel DIR`` (``make wheel``).

Builds an sdist and a wheel into DIR, installs the wheel and the locked libraries into a fresh environment, and runs
there, from an empty folder, what the README shows: the version with its commit, expansions, derivations, checks of the
papers.  Then twine checks the metadata, and it is said whether the project tells where it lives.
"""

import os
import subprocess
import sys
import tempfile
import tomllib
import venv
from pathlib import Path

ROOT = Path(__file__).parents[1]
TRIED = (
    (("-m", "asymptotics", "--version"), "commit"),
    (("-m", "asymptotics", "expand", "--alpha", "3/2", "--order", "2", "--digits", "20"), "-12/(25*pi)"),
    (("-m", "asymptotics", "derive", "reversal-identity"), "="),
    (("-m", "asymptotics", "papers", "smith2012:62b", "--check"), "the verdicts are borne out"),
    (("-m", "paper_checks", "--id", "lelas2024:49"), "holds"),
    (("-m", "derivations"), "reversal-identity"),
    (("-c", "import asymptotics.made_by as m; print(len(m.commit().partition('+')[0]), m.__file__)"), "40"),
    (("-c", "import asymptotics as asy; print(asy.derive('reversal-identity').title)"), ""),
)
"""What is run in the fresh environment, and a word that it must print."""
URLS = {"Homepage", "Repository", "Source"}


def build(folder: Path) -> tuple[Path, Path]:
    """The wheel and the sdist, made by the build backend."""
    subprocess.run([sys.executable, "-m", "hatchling", "build", "-d", str(folder)], cwd=ROOT, check=True)
    (wheel,), (sdist,) = folder.glob("*.whl"), folder.glob("*.tar.gz")
    return wheel, sdist


def tried(python: Path | str, folder: Path, surroundings: dict[str, str] | None = None) -> list[str]:
    """What does not print what it must, run from an empty folder."""
    failed = []
    for words, wanted in TRIED:
        done = subprocess.run([str(python), "-P", *words], cwd=folder, env=surroundings, capture_output=True, text=True)
        if done.returncode or wanted not in done.stdout or str(ROOT) in done.stdout:
            failed.append(f"{' '.join(words)}: exit {done.returncode}: {done.stdout[-300:]}{done.stderr[-300:]}")
    return failed


def main(target: str) -> int:
    """Build, install, try, check; returns the exit code."""
    folder = Path(target).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    for old in [*folder.glob("*.whl"), *folder.glob("*.tar.gz")]:
        old.unlink()
    wheel, sdist = build(folder)
    with tempfile.TemporaryDirectory() as name:
        empty, place = Path(name) / "empty", Path(name) / "venv"
        empty.mkdir()
        venv.create(place, with_pip=True)
        python = place / ("Scripts" if os.name == "nt" else "bin") / "python"
        pip = [str(python), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        lock = ["--require-hashes", "--only-binary", ":all:", "-r", str(ROOT / "requirements/reproduce.txt")]
        subprocess.run([*pip, *lock], check=True)
        subprocess.run([*pip, "--no-deps", str(wheel)], check=True)
        failed = tried(python, empty)
        subprocess.run([*pip, "twine"], check=True)
        checked = [str(python), "-m", "twine", "check", "--strict", str(wheel), str(sdist)]
        failed += ["twine check"] * bool(subprocess.run(checked).returncode)
    print("\n".join(failed) or f"{wheel.name}: {len(TRIED)} commands tried in a fresh environment, metadata checked")
    urls = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["urls"]
    if not URLS & set(urls):
        print("not ready for an index: [project.urls] of pyproject.toml does not say where the project lives")
    return int(bool(failed))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
