"""Options that cannot stand together, and options that need another one: declared beside the question.

    excludes("bound", "reference", "the reference motion is certified by itself", "--bound with --order N")
    excludes("csv", "alpha=symbolic", "a symbolic exponent has no numbers", "an exponent instead of --alpha symbolic")
    needs("size dpi", "plot", "there is no picture", "--plot FILE with it")

First what is refused, then what it is refused beside, or without; ``name=word|word`` is an option with one of these
values.  ``{other}`` in a reason is the other option, with its value where that matters, ``{value}`` the value alone.
The refusal in shell and Python, "not with --reference" in --help, the schema and the tests
(``tests/ask/test_pairs.py``) follow.

>>> typed = {"csv": "a.csv", "alpha": "symbolic"}
>>> require((excludes("csv", "alpha=symbolic", "{other} has no numbers", "an exponent"),), typed)
Traceback (most recent call last):
    ...
asymptotics.errors.InputError: argument --csv: --alpha symbolic has no numbers (accepted: an exponent)
"""

import argparse
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from asymptotics.errors import InputError

_TOLD = 4  # a longer list is told in the help of each of its options, not in that of the other


@dataclass(frozen=True)
class Condition:
    """That an option is given; with ``words``, that its value is one of them."""

    name: str
    words: tuple[str, ...] = ()

    @classmethod
    def several(cls, text: str) -> tuple["Condition", ...]:
        """The conditions of a declaration."""
        parts = (part.partition("=") for part in text.split())
        return tuple(cls(name, tuple(words.split("|")) if words else ()) for name, _, words in parts)

    def holds(self, said: Mapping[str, Any]) -> bool:
        """Whether it does, of the values by the names of options (None: not given)."""
        value = said.get(self.name)
        return value is not None and (not self.words or str(value).strip() in self.words)

    def in_words(self, spelled: Callable[[str], str]) -> str:
        """As one types it."""
        return " ".join([spelled(self.name), *([" or ".join(self.words)] if self.words else [])])

    def schema(self) -> dict[str, Any]:
        """As JSON Schema."""
        values = {"properties": {self.name: {"enum": [*self.words]}}} if self.words else {}
        return {"required": [self.name], **values}


@dataclass(frozen=True)
class Pair:
    """Each of ``options`` is refused beside any of ``others``; if these are ``needed``, where none of them is given.

    ``missing``: the error names the option that is not there.
    """

    options: tuple[Condition, ...]
    others: tuple[Condition, ...]
    reason: str
    accepted: str
    needed: bool = False
    missing: bool = False

    @property
    def names(self) -> set[str]:
        """All options that it speaks of."""
        return {c.name for c in (*self.options, *self.others)}

    def error(self, option: Condition, other: Condition, value: Any, spelled: Callable[[str], str]) -> InputError:
        """The refusal of one option beside, or without, another."""
        typed = " ".join([spelled(other.name), *([str(value).strip()] if other.words else [])])
        reason = self.reason.format(other=typed, value=value)
        return InputError(spelled((other if self.missing else option).name), reason, self.accepted)

    def beside(self, name: str) -> tuple[Condition, ...]:
        """What the help of an option says of it; of an option with a value it is said at the others alone."""
        if Condition(name) in self.options:
            return self.others
        few = Condition(name) in self.others and not self.needed and len(self.options) <= _TOLD
        return self.options if few else ()

    def schema(self, known: Iterable[str]) -> Iterator[dict[str, Any]]:
        """What JSON Schema says, of options that are properties there."""
        others = [c.schema() for c in self.others if c.name in known]
        for option in (c.schema() for c in self.options if c.name in known):
            if not self.needed:
                yield from ({"not": {"allOf": [option, other]}} for other in others)
            elif len(others) == len(self.others):
                yield {"if": option, "then": {"anyOf": others}}


def excludes(
    options: str, others: str, reason: str = "cannot be combined with {other}", accepted: str = "either"
) -> Pair:
    """Each of the options is refused beside any of the others."""
    return Pair(Condition.several(options), Condition.several(others), reason, accepted)


def needs(options: str, others: str, reason: str, accepted: str) -> Pair:
    """Each of the options is refused where none of the others is given."""
    return Pair(Condition.several(options), Condition.several(others), reason, accepted, needed=True)


def demands(options: str, others: str, accepted: str, reason: str = "is missing") -> Pair:
    """The same where the error names the (first) other one, which is missing."""
    return Pair(Condition.several(options), Condition.several(others), reason, accepted, needed=True, missing=True)


def require(pairs: Iterable[Pair], said: Mapping[str, Any], spelled: Callable[[str], str] = "--{}".format) -> None:
    """InputError for the first pair that is refused; ``said``: what can be said, by option, None where it is not.

    What needs an option that cannot be said (in Python, a part of a law) is not judged here.
    """
    for pair in pairs:
        if pair.needed and not all(other.name in said for other in pair.others):
            continue
        for option in (c for c in pair.options if c.holds(said)):
            met = [other for other in pair.others if other.holds(said)]
            if bool(met) is not pair.needed:
                other = (met or pair.others)[0]
                raise pair.error(option, other, said.get(other.name), spelled)


def pairs_in_help(pairs: Iterable[Pair], name: str, spelled: Callable[[str], str]) -> str:
    """What the help of an option says of its pairs: ``; needs --plot; not with --reference``."""
    texts = []
    for needed, lead, joint in ((True, "needs", " or "), (False, "not with", ", ")):
        others = [c.in_words(spelled) for pair in pairs if pair.needed is needed for c in pair.beside(name)]
        texts += [f"; {lead} {joint.join(dict.fromkeys(others))}"] if others else []
    return "".join(texts)


def typed_value(options: argparse.Namespace, key: str) -> Any:
    """A parsed option as it was typed; None where it was not."""
    value = getattr(options, key, None)
    return None if value is False or value == [] else value
