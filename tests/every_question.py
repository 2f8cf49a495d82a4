"""Every question, as tests of all commands ask it: its example in words of the shell, and its call from Python."""

import argparse
import ast
import doctest
import inspect
import shlex
from collections.abc import Callable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

import asymptotics as asy
from asymptotics.ask.registry import QUESTIONS, loaded
from asymptotics.shell.asked import command_of
from tests.worlds import EVERYDAY, WORLDS

ROWS = "n,x\n" + "".join(f"{n},{(-0.9) ** n}\n" for n in range(8))
"""What stands in the file of an example: turning points of a linear loss."""


def example(name: str, folder: Path, data: str | None = None) -> list[str]:
    """The command and the words of its example; its file is written into ``folder``, unless it is another one."""
    text = loaded(name).example
    if data is None and "{data}" in text:
        (folder / "data.csv").write_text(ROWS)
    return [name, *(w.format(data=data or folder / "data.csv", folder=folder / "store") for w in text.split())]


def in_world(name: str, folder: Path, world: str) -> list[str]:
    """The example of a command, its law and start those of a world."""
    return [*without_law(example(name, folder)), *shlex.split(WORLDS[world].words)]


def without_law(words: list[str]) -> list[str]:
    """The words of a request but those of its law."""
    law = ("--law", "--alpha", "--epsilon")
    return [w for w, before in zip(words, ["", *words]) if w not in law and before not in law]


def without_order(words: list[str]) -> list[str]:
    """The words of a request without an order, which a number at a strength has none of."""
    at = words.index("--order") if "--order" in words else len(words)
    return words[:at] + words[at + 2 :]


def worlds_of(name: str) -> Iterator[str]:
    """The everyday worlds that the options of a command can say."""
    for world, made in EVERYDAY.items() if {"--law", "--epsilon"} <= options_of(name).keys() else ():
        if {word for word in shlex.split(made.words) if word.startswith("--")} <= options_of(name).keys():
            yield world


@cache
def parser_of(name: str) -> argparse.ArgumentParser:
    """The parser of a command, with its hidden options."""
    parser = argparse.ArgumentParser(prog=name, add_help=False)
    command_of(name).configure(parser)
    return parser


def shown(name: str) -> Iterator[argparse.Action]:
    """What --help shows of a command: its options and its places."""
    return (a for a in parser_of(name)._actions if a.help != argparse.SUPPRESS)


def options_of(name: str) -> dict[str, argparse.Action]:
    """The options of a command, with their dashes."""
    return {option: action for action in shown(name) for option in action.option_strings}


TAKING = [(name, option) for name in QUESTIONS for option, action in options_of(name).items() if action.nargs != 0]
"""Every option of every command that takes a value."""


def call_of(name: str) -> Callable[..., Any] | None:
    """The public call that is this question; None where Python asks in another way."""
    call = getattr(asy, name.replace("-", "_"), None)
    return call if getattr(call, "__question__", None) is loaded(name) else None


IN_PYTHON = tuple(name for name in QUESTIONS if call_of(name) is not None)


def usual(call: Callable[..., Any]) -> dict[str, Any] | None:
    """The arguments of the first call of itself, with literal arguments, among the examples of its docstring."""
    plain = inspect.unwrap(call)
    for part in doctest.DocTestParser().get_examples(inspect.getdoc(plain) or ""):
        for node in ast.walk(ast.parse(part.source)):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") == plain.__name__:
                try:
                    values = [ast.literal_eval(v) for v in node.args]
                    named = {k.arg: ast.literal_eval(k.value) for k in node.keywords if k.arg}
                except ValueError:
                    continue
                return dict(inspect.signature(call).bind(*values, **named).arguments)
    return None
