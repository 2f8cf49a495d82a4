"""What a file of values is held against: what was said of it, its own request, its own oscillator, a table.

From what is most certain to what is asked: the head of a table names itself and its inputs; a header names its whole
request; coefficients are known by their columns; a header names an oscillator; the asker says it.  What is asked goes
before what the file says.
"""

import argparse
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path
from typing import Any

from asymptotics.ask.again import compare_again, names_its_request, told_request
from asymptotics.ask.forces import law_pairs, read_law
from asymptotics.ask.kinds import Kind
from asymptotics.ask.laws import LAW_FEEDS, law_options, start_options, unit_options
from asymptotics.ask.moving import PHYSICAL, read_oscillator, unit_pairs, without_units
from asymptotics.ask.pairs import excludes, require
from asymptotics.decays.comparison.reading import rows_of_file
from asymptotics.decays.comparison.run import Comparison, compare_file
from asymptotics.decays.comparison.stated import stated
from asymptotics.decays.comparison.tabled import compare_table, series_table
from asymptotics.decays.records.exports import require_data
from asymptotics.errors import InputError
from asymptotics.frames import frame_of
from asymptotics.law import Law, LawLike
from asymptotics.law_given import Given, given_of
from asymptotics.present.inputs import INPUTS, stated_inputs
from asymptotics.sweeps.grid import values
from asymptotics.tables.inputs import Inputs
from asymptotics.tables.registry import names

_SAID = (*PHYSICAL, "alpha", "epsilon", "law", "x0", "v0")
OWN_UNITS = excludes(
    "damping mass stiffness x0 v0", "table", "a table has its own units", "no such option with a table"
)


@dataclass(frozen=True)
class GivenInputs:
    """A law and its oscillator, or the inputs of a table, as an object, or as options (also those of a header).

    ``called``: from Python, where no options are.
    """

    law: LawLike | None = None
    options: argparse.Namespace = field(default_factory=lambda: argparse.Namespace(**dict.fromkeys(INPUTS)))
    alpha: Any = None
    epsilon: Any = None
    called: bool = False

    @property
    def anything(self) -> bool:
        """Whether anything was said."""
        typed = any(getattr(self.options, name, None) is not None for name in _SAID)
        return typed or any(given is not None for given in (self.law, self.alpha, self.epsilon))

    def moving(self) -> Given:
        """The oscillator, in its frame if x has a unit of its own."""
        for name, value in (("alpha", self.alpha), ("epsilon", self.epsilon)):
            if value is not None:
                raise InputError(name, "there is no table", f"{name} with table, or the law")
        if self.law is not None:
            return given_of(self.law)
        if self.called and not self.anything:
            raise InputError("law", "is missing", "a mapping exponent -> strength, a Law or an Oscillator")
        given = read_oscillator(self.options, "epsilon")
        # A start that was given makes x a length of its own; otherwise x is in units of x0, as the law alone has it.
        started = any(getattr(self.options, name, None) is not None for name in ("x0", "v0"))
        return replace(given, frame=frame_of(given.oscillator)) if started else given

    def inputs(self, table: str, *, needed: bool) -> Inputs:
        """The inputs of a table; ``needed``: coefficients alone do not say of which law they are."""
        options = self.options
        require((OWN_UNITS,), {**vars(options), "table": table})  # also of one that is known by its columns
        if needed and not (options.alpha or options.law or self.law or self.alpha):
            reason = "is missing: coefficients alone do not say of which law"
            raise InputError("alpha", reason, "an exponent, or a law")
        if options.alpha is None and options.epsilon is None and not options.law:
            return Inputs.read(self.alpha, self.epsilon, self.law)
        return Inputs.read(
            None if options.alpha is None else values(options.alpha, "--alpha"),
            None if options.epsilon is None else values(options.epsilon, "--epsilon"),
            _sum(options.law) if options.law else None,
        )


def _sum(laws: list[str]) -> Law:
    return read_law(argparse.Namespace(alpha=None, epsilon=None, law=laws), "epsilon")


# A table may have its strengths alone: what one law lacks is known where it is read.
_PAIRS = tuple(p for p in (*law_pairs("epsilon", "damping"), *unit_pairs("damping")) if not p.needed)
GIVEN_INPUTS = Kind(
    "LAW", lambda law, _, alpha=None, epsilon=None: GivenInputs(law, alpha=alpha, epsilon=epsilon),
    assemble=lambda options: GivenInputs(options=options), beside=("alpha", "epsilon"), group="the law",
    feeds={**LAW_FEEDS, "alpha": ("alpha", "law")}, pairs=_PAIRS,
    options=(
        *law_options("its dimensionless strength, b omega_0^alpha x0^(alpha-1) / k", springs=False),
        *unit_options(), *start_options("x0", "v0"),
    ),
)  # fmt: skip


@dataclass(frozen=True)
class Beside:
    """A comparison that is still to be made, and what the values are held against, in words."""

    description: str
    make: Callable[[], Comparison]


def beside(
    source: Path | Mapping[str, Any], said: GivenInputs, table: str | None, columns: str | None, digits: int | None
) -> Beside:
    """What ``source`` is held against."""
    path = source if isinstance(source, Path) else None
    own = table is None and not said.anything
    if path is not None and own:
        if (found := _by_its_head(path, columns, digits)) is not None:
            return found
        if names_its_request(path):
            if columns is not None:
                raise InputError("columns", "a file that names its own request has its own columns", "no columns")
            return Beside(told_request(path), partial(compare_again, path, digits))
    name = series_table(source) if table is None else table
    if path is not None and own:
        said = _of_its_header(path, series=name is not None)
    if name is None:
        if path is not None:
            require_data(rows_of_file(path)[1] or [], path.name)
        given = said.moving()
        description = str(given.oscillator if given.frame else given.oscillator.law)
        return Beside(description, partial(compare_file, source, given, columns=columns, digits=digits))
    inputs = said.inputs(name, needed=table is None)
    return Beside(name, partial(compare_table, source, name, inputs, columns=columns, digits=digits))


def _by_its_head(path: Path, columns: str | None, digits: int | None) -> Beside | None:
    """The table that the lines before the header name, with their inputs."""
    head = stated(path)
    if head is None or head.table not in names():
        return None
    law = list(head.law) or None
    inputs = Inputs.read(None, None, _sum(law)) if law else Inputs.of(head.alphas, None, head.epsilons)
    make = partial(compare_table, path, head.table, replace(inputs, rows=head.rows))
    return Beside(f"{head.table}, with the inputs of its head", partial(make, columns=columns, digits=digits))


def _of_its_header(path: Path, *, series: bool) -> GivenInputs:
    """The oscillator that the file's own header says; coefficients have their exponents alone."""
    inputs = stated_inputs(path)
    if "static" in inputs:
        law = "its law alone does not hold the mass where it turns"
        raise InputError("FILE", f"it is a motion with --static={inputs['static']}, and {law}", "one without --static")
    special = next((name for name in ("spring", "v0") if inputs.get(name, "0") != "0"), None)
    # Points and coefficients of such an oscillator depend on more than INPUTS: they need the request itself.
    if special and not _is_motion(path):
        reason = f"it is of an oscillator with --{special}, and its header does not name the request"
        raise InputError("FILE", reason, "a motion, or turning points written by --csv of this version")
    kept = {k: v for k, v in inputs.items() if k in ("alpha", "law") or not series}
    given = {**dict.fromkeys(INPUTS), **kept}
    require(GIVEN_INPUTS.pairs, given)  # a header is foreign text
    return GivenInputs(options=without_units(argparse.Namespace(**given)))


def _is_motion(path: Path) -> bool:
    """Whether its columns are times and places: the certified motion stands beside those, for any spring and start."""
    head = rows_of_file(path)[1] or [""]
    return head[0].split(" [")[0] in ("t", "tau") and any(name.split(" [")[0] == "x" for name in head)
