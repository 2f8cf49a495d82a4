"""Another distribution installs a package of our name: what it does to our first file is said in one line."""

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]


@pytest.mark.parametrize(
    "content, said", [(None, "is missing"), ("", "is another's"), ("__version__ = '9'\n", "is another's")]
)
@pytest.mark.parametrize("line", ["moment --p 2", "--version", "--help"])
def test_a_first_file_that_is_gone_or_foreign_is_said_in_one_line(content, said, line, tmp_path):
    """Failed before: two lines about a fault of the program, exit code 70."""
    shutil.copytree(ROOT / "asymptotics", tmp_path / "asymptotics", ignore=shutil.ignore_patterns("__pycache__"))
    first = tmp_path / "asymptotics" / "__init__.py"
    first.unlink()
    if content is not None:
        first.write_text(content)
    path = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); "
    script = path + "from asymptotics.shell.entry import main; sys.exit(main())"
    done = subprocess.run(
        [sys.executable, "-I", "-S", "-c", script, *line.split()],
        cwd=tmp_path,
        capture_output=True,
        text=True,
        timeout=60,
    )
    assert (done.returncode, done.stdout, done.stderr.count("\n")) == (2, "", 1)
    assert f"__init__.py {said}" in done.stderr and "pip uninstall asymptotics" in done.stderr
