"""A question: a typed function, declared once, from which shell, Python, sweeps, headers and the schema follow.

    @question(Offers(table="k, c_k, d_k"), swept=True, example="--alpha 0", rests="balls")
    def stokes(alpha: Annotated[Number, REAL], *, count: Annotated[int, whole(1, 9, "K")] = 1, ...) -> StokesConstants:
        \"\"\"What it is, in a line.  (Then what the page of --help says, examples of the shell among it.)

        Parameters
        ----------
        alpha
            the exponent
        \"\"\"

The annotations are the kinds of the parameters (``kinds``), the lines under Parameters the help of the options, the
text before them the page of --help.  What is called is the function itself, its values read by their kinds in the
order in which they are declared: no value is used that was not read, in the shell and in Python.
"""

import argparse
import functools
import inspect
import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass, is_dataclass, replace
from functools import cached_property
from typing import Any, ParamSpec, TypeVar, cast, get_type_hints

from asymptotics.ask.answers import FLAGS, Offers
from asymptotics.ask.kinds import SECONDS, Kind, Option
from asymptotics.ask.pairs import Pair, pairs_in_help, require, typed_value
from asymptotics.errors import InputError
from asymptotics.numbers.policy import float_notes
from asymptotics.running.budget import DEFAULT_SECONDS, Unasked
from asymptotics.running.public import public, public_beside_others
from asymptotics.running.signature import readable

P = ParamSpec("P")
T = TypeVar("T")
GROUPS = ("the law", "the start", "the data", "what to compute", "output", "limits")
_PARAMETERS = "Parameters\n----------\n"
_HELP = re.compile(r"^(\w+)\n((?:    .*\n?)+)", re.MULTILINE)


@dataclass(frozen=True)
class Asked:
    """One parameter of a question."""

    name: str
    kind: Kind
    default: Any
    help: str

    @property
    def required(self) -> bool:
        """Whether the shell demands it."""
        return self.default is inspect.Parameter.empty or self.kind.needed

    @property
    def option(self) -> Option:
        """The one option of the shell that sets it."""
        kind, told = self.kind, self.help + self.kind.suffix
        unsaid = self.default is None or self.default is False or self.default in (inspect.Parameter.empty, "", ())
        default = kind.default or ("" if unsaid or kind.needed else self.default)
        if told.count("(") > told.count(")"):
            told += f"; default {default})" if default != "" else ")"
        elif default != "":
            told += f" (default {default})"
        name = kind.option or self.name.replace("_", "-")
        return Option(
            name, kind.letter, told, kind.group, several=kind.several, place=kind.place, needed=self.required,
            dest=self.name, words=tuple(kind.schema.get("enum", ())),
        )  # fmt: skip

    @property
    def left_out(self) -> Any:
        """The value where none is given: of a time, one that nobody asked for."""
        timed = self.name == "max_seconds" and self.default is not None
        return Unasked(self.default) if timed else self.default

    @property
    def is_one_option(self) -> bool:
        """Whether the parameter of Python says the same as one option of the shell."""
        return all(o.key == self.name for o in self.kind.options)

    @property
    def options(self) -> tuple[Option, ...]:
        """All options that set it."""
        return self.kind.options or ((self.option,) if self.kind.in_shell else ())


@dataclass(frozen=True)
class Question:
    """A declared question; ``name`` is that of its command.

    ``example``: a request in words of the shell that is answered at once, by which all tests of every command ask it;
    ``{data}`` stands for a file with columns n and x, ``{folder}`` for a new folder.  ``rests``: what an answer rests
    on where it has no certificate, a sentence of the ledger of trust.  ``own_pairs``: what cannot stand together.
    """

    name: str
    function: Callable[..., Any]
    asked: tuple[Asked, ...]
    offers: Offers
    page: str
    swept: bool = False
    example: str = ""
    rests: str = ""
    own_pairs: tuple[Pair, ...] = ()

    def __getitem__(self, name: str) -> Asked:
        """A parameter by its name."""
        return next(a for a in self.asked if a.name == name)

    @property
    def in_header(self) -> bool:
        """Whether the header of its table names the request."""
        again = self.offers.again
        own = again is not None and bool(self.offers.table or again.words)
        return own and not self.offers.oscillator_alone

    @property
    def options(self) -> tuple[Option, ...]:
        """Every option of the command, in the order of its help."""
        own = tuple(o for a in self.asked for o in a.options)
        known = {o.key for o in own}
        other = () if self.offers.inverse is None else self.offers.inverse.asked
        more = [replace(o, needed=False) for a in other for o in a.options if o.key not in known]
        return (*own, *more, *self.offers.options())

    @cached_property
    def pairs(self) -> tuple[Pair, ...]:
        """All pairs of options that are refused, or needed."""
        other = () if self.offers.inverse is None else self.offers.inverse.pairs
        all_pairs = (
            *(pair for a in self.asked for pair in a.kind.pairs),
            *self.own_pairs,
            *self.offers.pairs(),
            *other,
        )
        always = {o.name for a in self.asked for o in a.options if o.needed}
        return tuple(
            dict.fromkeys(
                p for p in all_pairs if not (p.needed and any(c.name in always and not c.words for c in p.others))
            )
        )

    def asked_by(self, options: argparse.Namespace) -> "Question":
        """The question that these options ask: this one, or the other one of the command."""
        other: Question | None = self.offers.inverse
        return self if other is None or getattr(options, other.asked[0].name) is None else other

    def add_to(self, parser: argparse.ArgumentParser, refuse: type[argparse.Action] | None = None) -> None:
        """Declare the options under their headings, then those that mean nothing here, hidden, each with its reason."""
        beside = {o.name: pairs_in_help(self.pairs, o.name, self._spelled_option) for o in self.options}
        options = tuple(replace(o, beside=beside[o.name]) for o in self.options)
        if any(o.rest for o in options):  # what is needed may stand among the rest: it is asked for when it is read
            options = tuple(replace(o, needed=o.needed and o.place) for o in options)
        for option in (o for o in options if o.place):
            option.add_to(parser)
        for title in GROUPS:
            group = parser.add_argument_group(title)
            for option in (o for o in options if o.group == title and not o.place):
                option.add_to(group)
        for a in self.asked:
            # The shell times a request before its values are read: a question with a time of its own says so here.
            if a.name == "max_seconds" and a.default not in (None, DEFAULT_SECONDS):
                parser.set_defaults(max_seconds=str(a.default))
        if refuse is not None:
            for name, reason in self.offers.lacks.items():
                count: Any = 0 if name in FLAGS else "?"
                parser.add_argument(f"--{name}", action=refuse, nargs=count, const=reason, help=argparse.SUPPRESS)

    def read(self, given: Mapping[str, Any], spelled: Callable[[str], str] = str) -> dict[str, Any]:
        """The values of texts or of objects, by one reader, in the declared order; ``spelled`` names the argument."""
        made, said = {}, self._said(given)
        for a in self.asked:
            require(a.kind.pairs, said, self._spelled_option)
            value = given.get(a.name, a.default)
            if a.kind.assemble is not None and isinstance(given.get(OPTIONS), argparse.Namespace):
                made[a.name] = a.kind.assemble(given[OPTIONS])
            elif value is inspect.Parameter.empty:
                raise InputError(spelled(a.name), "is missing", a.help)
            elif value is a.default:
                made[a.name] = a.left_out
            else:
                beside = {name: given[name] for name in a.kind.beside if name in given}
                made[a.name] = a.kind.read(value, spelled(a.name), **beside)
        require((*self.own_pairs, *self.offers.pairs()), said, self._spelled_option)
        return made

    def _said(self, given: Mapping[str, Any]) -> dict[str, Any]:
        """What was given, by the name of its option; None of what was not.  Python has not all that the shell has."""
        typed = given.get(OPTIONS)
        if isinstance(typed, argparse.Namespace):
            keys = {name.replace("_", "-"): name for name in vars(typed)} | self._keys
            return {name: typed_value(typed, key) for name, key in keys.items()}
        values = {a.name: v for a in self.asked if (v := given.get(a.name, a.default)) is not a.default}
        said = {a.option.name: values.get(a.name) for a in self.asked if a.is_one_option}
        said |= {name: given.get(name) for a in self.asked for name in a.kind.beside}
        words = {a.kind.word: values.get(a.name) for a in self.asked if a.kind.word}
        return said | {name: word if isinstance(word, str) else None for name, word in words.items()}

    @cached_property
    def _keys(self) -> dict[str, str]:
        return {o.name: o.key for o in self.options}

    def of_options(self, options: argparse.Namespace) -> dict[str, Any]:
        """The values of parsed options."""
        known = {a.name: getattr(options, a.name, None) for a in self.asked if not a.kind.options}
        given = {name: value for name, value in known.items() if value not in (None, False)}
        return self.read({**given, OPTIONS: options}, self.spelled)

    def spelled(self, name: str) -> str:
        """A parameter as the shell calls it."""
        option = self[name].option
        return option.letter if option.place else f"--{option.name}"

    def _spelled_option(self, name: str) -> str:
        """An option as the shell calls it, whichever parameter it sets."""
        place = next((o.letter for o in self.options if o.place and o.name == name), "")
        return place or f"--{name}"

    def words(self, options: argparse.Namespace) -> list[str]:
        """The request as the header of a file says it: the command, and the options that were given.

        Nothing where the oscillator says it all, which the header has then (``present.inputs``).
        """
        special = any(getattr(options, name, None) for name in ("spring", "v0", "delta"))
        # A loss that depends on the place, or a gain: ``compare`` of an oscillator alone reads losses of the velocity.
        strengths = [getattr(options, name, None) or "" for name in ("epsilon", "damping")]
        strengths += [text.partition(":")[2] for text in getattr(options, "law", None) or ()]
        special |= any(text.strip().startswith("-") for text in strengths)
        special |= any("," in text.partition(":")[0] for text in getattr(options, "law", None) or ())
        # In another gauge the numbers are others.
        usual = [a.default for a in self.asked if a.name == "gauge"]
        special |= bool(usual) and getattr(options, "gauge", None) not in (None, *usual)
        if self.offers.oscillator_alone or (self.offers.from_rest and not special):
            return []
        return self.as_typed(options)

    def as_typed(self, options: argparse.Namespace) -> list[str]:
        """The request in words: the command, and the options that were given."""
        told = [self.name]
        for option in self.header_options:
            value = getattr(options, option.key, None)
            each = value if isinstance(value, list) else [] if value is None or value is False else [value]
            lead = "" if option.place else f"--{option.name}"
            told += [v if option.place else lead if v is True else f"{lead}={v}" for v in each]
        return told

    @property
    def header_options(self) -> tuple[Option, ...]:
        """The options that the header of a file may have; of a curve also the points, behind the time they divide."""
        own = [o for a in self.asked for o in a.options if a.kind is not SECONDS and a.kind.in_header]
        points = [o for o in self.offers.options() if o.name == "points"]
        place = [o.name for o in own].index("time") + 1 if points else len(own)
        return (*own[:place], *points, *own[place:])

    def schema(self) -> dict[str, Any]:
        """What JSON Schema says of a request."""
        properties: dict[str, Any] = {}
        for a in self.asked:
            for o in a.options:
                one: Mapping[str, Any] = (
                    a.kind.schema if not a.kind.options else {"type": "string" if o.letter else "boolean"}
                )
                listed = o.repeated or o.several
                properties[o.name] = {"description": o.help, **({"type": "array", "items": one} if listed else one)}
                if not a.kind.options and isinstance(a.default, int | str) and a.default not in ("", False):
                    properties[o.name]["default"] = a.default if one.get("type") == "integer" else str(a.default)
        needed = [o.name for a in self.asked for o in a.options if o.needed]
        together = [one for pair in self.pairs for one in pair.schema(properties)]
        return {
            "$schema": "https://json-schema.org/draft/2020-12/schema", "title": self.name,
            "description": self.page.partition("\n")[0], "type": "object", "properties": properties,
            "required": needed, "additionalProperties": False, **({"allOf": together} if together else {}),
        }  # fmt: skip

    def in_python(self, error: InputError) -> InputError:
        """The same error with the shell's names of arguments (FILE, --count) turned into those of the parameters.

        In its reason and in what it accepts as well: ``--columns t=1,x=2`` is ``columns t=1,x=2``.
        """
        called = {self.spelled(a.name): a.name for a in self.asked if not a.kind.options}
        called |= {o.letter: a.name for a in self.asked for o in a.kind.options if o.place}
        called |= {f"--{a.kind.word}": a.name for a in self.asked if a.kind.word}
        argument = called.get(error.argument, _in_python(error.argument, called))
        texts = (argument, *(_in_python(text, called) for text in (error.reason, error.accepted)))
        if texts == (error.argument, error.reason, error.accepted):
            return error
        same = type(error)(*texts)
        return same.with_traceback(error.__traceback__)

    def feeds(self) -> dict[str, tuple[str, ...]]:
        """A parameter of the library -> the options that may have set it."""
        own = {a.name: (a.name,) for a in self.asked if not a.kind.options}
        return own | {name: keys for a in self.asked for name, keys in a.kind.feeds.items()}


OPTIONS = "the options of the shell"  # no name of a parameter
_SPELLED = re.compile(r"(?<![\w-])(?:--[a-z][a-z0-9-]*|[A-Z]{4,})(?![\w-])")


def _in_python(text: str, called: Mapping[str, str]) -> str:
    """Words of the shell in a text as Python has them: options without their dashes, FILE by its parameter."""

    def name(found: re.Match[str]) -> str:
        word = found[0]
        return called.get(word, word[2:].replace("-", "_") if word.startswith("--") else word)

    return _SPELLED.sub(name, text)


def question(
    offers: Offers,
    *,
    example: str = "",
    rests: str = "",
    name: str = "",
    swept: bool = False,
    alone: bool = True,
    pairs: tuple[Pair, ...] = (),
) -> Callable[[Callable[P, T]], Callable[P, T]]:
    """Declare a question: the public call that reads its values and has its time, with the ``Question`` beside it.

    ``example``, ``rests``: see ``Question``.  ``swept``: it answers one set of values with one record.  ``alone``:
    whether it computes in balls itself.  ``pairs``: options that cannot stand together, or need another one.
    """

    def declared(function: Callable[P, T]) -> Callable[P, T]:
        made = replace(_question(function, offers, name), swept=swept, example=example, rests=rests, own_pairs=pairs)
        compute = cast("Any", function)
        signature = inspect.signature(function)

        @functools.wraps(function)
        def ask(*args: Any, **rest: Any) -> Any:
            bound = signature.bind(*args, **rest)
            bound.apply_defaults()
            given = bound.arguments
            try:
                values = made.read(given)
                rest = {n: v for n, v in given.items() if n not in values}
                return with_notes(compute(**values, **rest), _floats(made, given))
            except InputError as error:
                raise made.in_python(error) from error

        called: Any = ask
        called.__kwdefaults__ = compute.__kwdefaults__
        timed: Any = (public if alone else public_beside_others)(called)
        timed.__signature__ = readable(function, get_type_hints(function))
        timed.__question__ = made
        return cast("Callable[P, T]", timed)

    return declared


def _question(function: Callable[..., Any], offers: Offers, name: str) -> Question:
    hints, doc = get_type_hints(function, include_extras=True), inspect.getdoc(function) or ""
    page, _, rest = doc.partition(_PARAMETERS)
    told = {n: " ".join(text.split()) for n, text in _HELP.findall(rest.partition("\n\n")[0] + "\n")}
    asked = tuple(
        Asked(n, hints[n].__metadata__[0], p.default, told.get(n, ""))
        for n, p in inspect.signature(function).parameters.items()
        if hasattr(hints.get(n), "__metadata__")
    )
    # What no kind reads would be taken as it is, or not at all: a spring was lost so.
    read = {a.name for a in asked}.union(*(a.kind.beside for a in asked))
    if unread := set(inspect.signature(function).parameters) - read:
        raise TypeError(f"no kind reads {', '.join(sorted(unread))} of {function.__name__}")
    called = name or function.__name__.replace("_", "-")
    return Question(called, function, asked, offers, page.rstrip())


def _floats(made: Question, given: Mapping[str, Any]) -> tuple[str, ...]:
    # Measured data are doubles: that they are read as such needs no note.
    values = {a.name: given[a.name] for a in made.asked if not (a.kind.options or a.kind.words)}
    values = {name: v.tolist() if hasattr(v, "tolist") else v for name, v in values.items()}  # an array, a NumPy number
    several = {name: v if isinstance(v, list | tuple) else [v] for name, v in values.items()}
    return tuple(note for name, each in several.items() for v in each for note in float_notes(**{name: v}))


def with_notes(found: Any, notes: tuple[str, ...]) -> Any:
    """The result with the notes of what was read besides its own, where it has any."""
    if not notes or not is_dataclass(found) or not hasattr(found, "notes"):
        return found
    return replace(cast("Any", found), notes=tuple(dict.fromkeys((*notes, *found.notes))))
