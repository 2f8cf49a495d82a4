"""The build hook: a wheel and an sdist carry the commit they were built from, in ``asymptotics/built_from.txt``."""

import subprocess
import tempfile
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

NAME = "built_from.txt"
PACKAGES = ("asymptotics", "derivations", "paper_checks")


class BuiltFrom(BuildHookInterface):
    """A checkout is asked for its commit; an sdist, which has no history, already carries the file."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Add the file to the build; an editable installation is a checkout and needs none."""
        root = Path(self.root)
        if version == "editable" or not (root / ".git").exists():
            return
        self.folder = tempfile.TemporaryDirectory()
        written = Path(self.folder.name) / NAME
        written.write_text(_commit(root) + "\n", encoding="ascii")
        build_data["force_include"][str(written)] = f"asymptotics/{NAME}"

    def finalize(self, version: str, build_data: dict[str, Any], artifact_path: str) -> None:
        """Leave nothing behind."""
        if hasattr(self, "folder"):
            self.folder.cleanup()


def _commit(root: Path) -> str:
    head = _git(root, "rev-parse", "HEAD")
    return head + ("+changes" if _git(root, "status", "--porcelain", "--", *PACKAGES) else "")


def _git(root: Path, *arguments: str) -> str:
    command = ["git", "-C", str(root), *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout.strip()
