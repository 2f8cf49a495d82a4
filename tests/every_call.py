"""Every public function, constructor and method of a result, with usual arguments, as tests of all calls ask for them.

A function has those of the example in its docstring; what an example leaves out is found by the name of the parameter.
"""

import inspect
from collections.abc import Callable, Iterator
from functools import cache
from itertools import product
from typing import Any

import sympy

import asymptotics as asy
from asymptotics.errors import InputError, UndecidedError
from asymptotics.frames import frame_of
from tests.every_question import usual
from tests.present.every_type import made
from tests.worlds import OSCILLATOR as OSC

PENDULUM = asy.Oscillator({2: "1/20"}, spring="pendulum", x0=3)
Call = Callable[..., Any]
MADE_BY_US = {"DampingLaw", "Equations", "EquivalentDamping", "Events", "Identification", "PaperStatement",
              "TurningPoints"}  # fmt: skip
"""Classes that are public for type hints and ``isinstance``: nobody makes one by hand."""
CALLS = tuple(
    name for name in asy.__all__ if callable(getattr(asy, name)) and name not in MADE_BY_US
    and not (isinstance(getattr(asy, name), type) and issubclass(getattr(asy, name), Exception))
)  # fmt: skip
"""Every public function, and every class that is called by hand."""
CHEAP = {"workers": 1, "bootstrap": False, "motion": False}
"""What is always given where there is such a parameter."""
NO_VALUES = {"Frame", "Interval", "Units"}
"""Parts of results whose methods are given words and floats of our own."""


@cache
def _usual() -> dict[str, tuple[Any, ...]]:
    """A parameter -> what it may usually be; the first that is answered is taken."""
    return {
        "A": (1, [0.5]), "amplitude": ("1/10", 1), "answer": (made()["answer"],), "averaging": ("mean",),
        "coefficient": (1,), "command": ("moment",), "delta": ("1/20", "1/5"), "delta_0": ("1/10",), "digits": (8,),
        "expression": (None,), "f": (sympy.Symbol("a"),), "found": (sympy.Symbol("epsilon"),),
        "frame": (frame_of(OSC),), "gauge": ("turning-point",), "i": (2, 0), "id": ("smith2012:43",), "j": (1,),
        "k": (1,), "key": (1,), "law": ({2: "1/10"}, PENDULUM), "n": (3, 1), "name": ("kappa_1", "amplitude", "1"),
        "notes": ((),), "options": ({"p": "1"},), "order": (2,), "oscillator": (OSC,),
        "other": (OSC.law.terms[0], asy.expand({3: "1/10"})), "phase": (sympy.Symbol("p"),), "place": (0,),
        "points": ([{"x": "1"}],), "psi": (1, [1]), "purpose": ("x",), "results": ([made()["motion"]],),
        "scales": (asy.multiple_scales(2, order=1),), "static": (None,), "t": (1,), "tau": (1,), "task": (dict,),
        "terms": (OSC.law.terms,), "text": ("1",), "time": (1,), "times": ([0.0, 1.0],), "u": ("1/4",),
        "until": (2,), "value": ("1", {2: 1}), "w": ("1/2",), "within": ("1/10",), "y": ([1.0, 0.0],),
    }  # fmt: skip


def parameters(call: Call) -> dict[str, inspect.Parameter]:
    """Those that have a name of their own."""
    named = inspect.signature(call).parameters
    return {name: p for name, p in named.items() if p.kind not in (p.VAR_KEYWORD, p.VAR_POSITIONAL)}


def answered(call: Call, **given: Any) -> dict[str, Any] | None:
    """The first usual arguments with which it answers; None without any.  ``given``: more of them."""
    own = parameters(call)
    example = {} if isinstance(call, type) else usual(call) or {}
    fixed = {name: value for name, value in {**CHEAP, **given, **example}.items() if name in own}
    open_ = [name for name, p in own.items() if p.default is p.empty and name not in fixed]
    for values in product(*(_usual()[name] for name in open_)):
        found = {**fixed, **dict(zip(open_, values, strict=True))}
        try:
            call(**found)
        except (InputError, UndecidedError):
            continue
        return found
    return None


def methods() -> Iterator[tuple[str, list[Call]]]:
    """Every public method of a type of result, and it of all results that have it: one that several share is one."""
    every: dict[Any, tuple[str, list[Call]]] = {}
    for thing in made().values():
        for name in (n for n in dir(type(thing)) if n in ("__call__", "__getitem__") or not n.startswith("_")):
            what = getattr(type(thing), name)
            what = getattr(what, "__func__", what)
            ours = inspect.isfunction(what) and inspect.unwrap(what).__module__.startswith("asymptotics")
            if ours and type(thing).__name__ not in NO_VALUES:
                every.setdefault(what, (f"{type(thing).__name__}.{name}", []))[1].append(getattr(thing, name))
    return ((label, bound[::-1]) for label, bound in every.values())  # the variants are the cheaper ones
