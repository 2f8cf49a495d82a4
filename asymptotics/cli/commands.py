"""The commands: the questions, and the modules that are no question (yet); only what is asked for is loaded."""

from importlib import import_module
from typing import Any

from asymptotics.ask.registry import QUESTIONS, loaded, summary

MODULES = {
    "compare": "your own values beside certified ones: right digits, and what the errors look like",
    "sweep": "any of these commands at many points, resumable, from one core to a cluster",
}
COMMANDS = tuple(sorted((*MODULES, *QUESTIONS)))


def module_of(name: str) -> Any:
    """What serves a command: its question as a command, or its module."""
    if name in QUESTIONS:
        return import_module("asymptotics.cli.asked").Command(loaded(name))
    return import_module("asymptotics.cli." + name.replace("-", "_"))


def summary_of(name: str) -> str:
    """What a command is for, in a line."""
    return MODULES.get(name) or summary(name)
