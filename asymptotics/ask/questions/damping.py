"""zeta, Q, decrement, energy loss, c_eq and half-life of a law at amplitudes."""

import argparse
from collections.abc import Mapping, Sequence, Set
from itertools import islice
from typing import Annotated, Any, cast

from asymptotics.ask.answers import Again, Offers, Request
from asymptotics.ask.forces import law_pairs
from asymptotics.ask.kinds import COMPUTED, FLAG, SECONDS, Kind, Option, digits, whole
from asymptotics.ask.laws import LAW_FEEDS, SYMBOLIC, law_options, start_options, unit_options
from asymptotics.ask.moving import read_oscillator, unit_pairs
from asymptotics.ask.pairs import excludes, needs
from asymptotics.ask.question import question
from asymptotics.ask.questions._damping_law import damping_law
from asymptotics.equivalent.at_amplitudes import damping_at
from asymptotics.equivalent.result import EquivalentDamping
from asymptotics.equivalent.rows import DRAWN
from asymptotics.equivalent.symbolic import symbolic_exponent
from asymptotics.errors import InputError, LimitError
from asymptotics.frames import BARE
from asymptotics.law import LawLike, Oscillator, SpringLike
from asymptotics.law_given import Given, given_of, law_of
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import Number, exact_number

# 100 digits leave thirty of the 130 that pi has in the units of angles; 12 is the order of the bounds
# (``bounds.uniform``), and a thousand certified swings are the work of minutes.  Refusals.
MAX_DIGITS, MAX_ORDER, MAX_AMPLITUDES = 100, 12, 1000


def _losing(value: Any, _name: str, spring: Any = None) -> Given | str:
    """An oscillator in SI, the same of epsilons, or SYMBOLIC."""
    if isinstance(value, str) and value == SYMBOLIC:
        return SYMBOLIC
    if isinstance(value, Oscillator):
        if spring is not None:
            raise InputError("spring", "it belongs to the oscillator", "Oscillator(..., spring=)")
        return given_of(value)
    return Given(Oscillator(law_of(value), spring=spring))


def _losing_of_options(options: argparse.Namespace) -> Given | str:
    if options.alpha == SYMBOLIC:
        return SYMBOLIC
    return read_oscillator(options, "epsilon")


LOSING = Kind(
    "LAW", _losing, beside=("spring",), assemble=_losing_of_options, feeds=LAW_FEEDS, group="the law", word="alpha",
    pairs=(*unit_pairs(), *law_pairs("epsilon", "damping")),
    options=(*law_options("its strength at A = 1, where m = k = 1"), *unit_options(), *start_options("x0")),
)  # fmt: skip


def _amplitudes(value: Any, name: str) -> tuple[ExactReal, ...]:
    """One amplitude > 0 or several: a text with commas, a list, an array."""
    given = value.split(",") if isinstance(value, str) else value
    try:
        # An exact number is one amplitude, though it may have a length; an array without dimensions has the method and
        # refuses it, hence the TypeError below.
        # Bytes, sets and mappings have a length too, and are no list of numbers: b"1" would be the amplitude 49.
        one = isinstance(given, ExactReal | bytes | bytearray | Set | Mapping) or not hasattr(given, "__len__")
        values = [given] if one else [*islice(given, MAX_AMPLITUDES + 1)]
    except TypeError:
        values = [given]
    if not values:
        raise InputError(name, "there is none", "a number > 0 or a list of them")
    if len(values) > MAX_AMPLITUDES:
        raise LimitError(name, "they are too many", f"at most {MAX_AMPLITUDES}")
    numbers = tuple(exact_number(a, name) for a in values)
    for a in numbers:
        if not a > 0:
            raise InputError(name, f"{a} is not positive", "amplitudes > 0")
    return numbers


AMPLITUDES = Kind("A,A,...", _amplitudes, group="the data")
UNIT = Kind("U", lambda unit, _: unit, words=True, group="the data")


def _require_together(request: Request) -> None:
    """A word that is no quantity, and a law in SI without an amplitude, are refused."""
    quantity = request.typed("quantity")
    if quantity is not None and quantity not in DRAWN:
        raise InputError("--quantity", f"{quantity[:40]!r} is unknown", ", ".join(DRAWN))
    if request["law"] == SYMBOLIC:
        return
    if request["law"].frame and request["amplitudes"] is None and request.typed("x0") is None:
        raise InputError("--amplitudes", "is missing", "turning amplitudes in m (rad of a pendulum), such as 0.2,0.1")


def _named(found: EquivalentDamping, request: Request) -> tuple[Any, ...]:
    return found.conversions() if request.typed("conversions") else ()


def _data(found: EquivalentDamping, request: Request) -> dict[str, Any]:
    named = _named(found, request)
    return {**found.to_dict(), **({"conversions": [c.to_dict() for c in named]} if named else {})}


def _of_the_motion(rows: list[tuple[str, ...]], header: tuple[str, ...]) -> list[tuple[str, ...]]:
    """The rows of a series of order N hold what its bound leaves: right is the motion itself at that amplitude."""
    part = header.index("part")
    amplitude = next(i for i, name in enumerate(header) if name.split(" [")[0] == "amplitude")
    own = {row[amplitude]: row for row in rows if row[part] == "the motion itself"}
    return [
        (*own[row[amplitude]][:part], row[part], *own[row[amplitude]][part + 1 :])
        if row[part].startswith("order ") and row[amplitude] in own
        else row
        for row in rows
    ]


AGAIN = Again(
    keys=("part", "amplitude"), not_judged=frozenset(("remark", "bound of zeta log")), rows=_of_the_motion
)  # an amplitude is what a row is found by here, and a value to be judged elsewhere


def _missing(found: EquivalentDamping, request: Request) -> tuple[int, str]:
    texts = request.typed("amplitudes")
    asked = [] if texts is None else texts.split(",")[len(found.rows) :]
    return len(found.rows), f"amplitudes {','.join(asked)}" if asked else "the smaller amplitudes"


@question(
    Offers(
        latex="print the formulas as LaTeX",
        picture="the curve against the amplitude",
        table="all numbers, a row for each amplitude and order",
        more=(
            Option(
                "conversions", "",
                "b under the names of ITTC, IMO, OpenFAST, OrcaFlex and of dampers", COMPUTED,
            ),
            Option("quantity", "NAME", f"what --plot draws: {', '.join(DRAWN)} (default Q)", COMPUTED, words=DRAWN),
        ),
        data=_data,
        text=lambda found, request: "\n".join([str(found), *map(str, _named(found, request))]),
        style=lambda _, request: {"quantity": request.typed("quantity") or "Q"},
        typed=_require_together,
        missing=_missing,
        inverse=damping_law.__question__,  # type: ignore[attr-defined]
        again=AGAIN,
        lacks={"gauge": "what is observed is the same in every gauge", "points": "`--amplitudes` says which"},
    ),
    pairs=(
        needs("resolution laws", "from", "there is no table", "--from FILE with it"),
        needs("quantity", "plot", "there is no picture to draw it in", "--plot FILE with --quantity"),
        needs("conversions", "damping mass stiffness", "it has no units", "--damping, --mass or --stiffness with it"),
        excludes(
            "spring epsilon damping mass stiffness x0 amplitudes order digits unit csv plot", "alpha=symbolic",
            accepted="formulas of one law",
        ),
    ),
    example="--alpha 2 --epsilon 1/10 --amplitudes 1 --digits 5",
    rests="the energy of a half-swing, in balls, between certified turning points",
)  # fmt: skip
def damping(
    law: Annotated[LawLike | Oscillator | str, LOSING],
    amplitudes: Annotated[Number | Sequence[Number] | None, AMPLITUDES] = None,
    *,
    order: Annotated[int | None, whole(1, MAX_ORDER).called(suffix=f": 1 to {MAX_ORDER}")] = None,
    digits: Annotated[int, digits(MAX_DIGITS)] = 12,
    motion: Annotated[bool, FLAG.called(in_shell=False)] = True,
    spring: SpringLike | None = None,
    unit: Annotated[str, UNIT] = "",
    max_seconds: Annotated[Number, SECONDS] = 60,
) -> EquivalentDamping:
    """Equivalent damping of a law at amplitudes: zeta, Q, decrement, energy loss, c_eq, half-life, period, omega.

      asymptotics damping --alpha 2 --epsilon 1/10 --amplitudes 1/2,1
      asymptotics damping --law 1:0.1 --law 2:0.2 --mass 3/2 --stiffness 30 --amplitudes 0.2,0.1 --order 3
      asymptotics damping --law 1:1/50 --law 2:1/20 --spring pendulum --amplitudes 10,40 --unit deg --plot q.svg
      asymptotics damping --alpha symbolic
      asymptotics damping --from TABLE.csv --resolution 0.0002 --laws 1 2 1+2

    Formulas of first order (one cycle without loss: zeta = Delta E/(4 pi E), Q = 2 pi E/Delta E, decrement
    ln(A_n/A_(n+2)), c_eq = Delta E/closed integral of v dx, half-life from A to A/2), certified numbers of it, and of
    the motion itself over one full swing from rest at A, with zeta_log = d/sqrt(4 pi^2 + d^2) of its decrement d in the
    place of zeta; with --order N the series of these, each number with its proved bound.  The backbone: period T(A) and
    omega(A) = 2 pi/T of the cycle without loss, and of the full swing.
    --from FILE is the inverse: columns A and zeta, Q or decrement (and resolution), or A and n, cycles or t of a decay,
    to candidate laws with intervals.
    Units are SI when --damping, --mass or --stiffness is given; a pendulum's amplitudes are in rad.

    Parameters
    ----------
    law
        epsilons (A in their unit), an oscillator (A in m, answers in SI) or "symbolic"
    amplitudes
        turning amplitudes in m (rad of a pendulum), in the shell also "20 cm,10 cm", without SI units in the unit of
        the strengths; default: x0 and its half, quarter, eighth
    order
        the series of order N too, with its bound
    digits
        significant digits, correctly rounded
    motion
        whether the motion itself is told as well
    spring
        springs beside the linear one (those of the law in the shell)
    unit
        of the amplitudes: m, cm, mm, um, in, ft beside SI units; rad, deg, mrad, arcmin of a pendulum
    max_seconds
        the time the request may take, in seconds

    Raises
    ------
    InputError
        for a law without a loss, amplitudes <= 0 or outside the well
    LimitError
        after ``max_seconds``; ``asymptotics.running.cut_short.done(error)`` hands over the rows that were done

    Notes
    -----
    Equivalent linearisation by the energy of one cycle (Bogoliubov and Mitropolsky).  pi has 130 digits in the units of
    angles.  Source: derivation ``equivalent-damping``.

    Examples
    --------
    >>> air = damping({2: "1/10"}, ["1/2", 1], digits=6)
    >>> air.formulas["Q"], air.rows[0].first.Q, air.rows[1].motion.decrement
    (3*pi/(8*A*epsilon), '23.5619', '0.236684')
    >>> damping("symbolic").formulas["zeta"]
    A**(alpha - 1)*epsilon*gamma(alpha/2 + 1)/(sqrt(pi)*gamma(alpha/2 + 3/2))
    >>> swing = damping({1: "1/50", 2: "1/20"}, [10, 40], spring="pendulum", unit="deg", digits=4)
    >>> [(row.amplitude, row.first.Q) for row in swing.rows], swing.header()[1]
    ([('10', '36.47'), ('40', '20.12')], 'amplitude [deg]')
    """
    if isinstance(law, str):
        return EquivalentDamping(None, BARE, digits, None, symbolic_exponent(BARE), ())
    given = cast("Given", law)
    taken = cast("tuple[ExactReal, ...] | None", amplitudes)
    return damping_at(
        given.oscillator, taken, frame=given.frame, digits=digits, order=order, motion=motion, unit=unit
    )  # fmt: skip
