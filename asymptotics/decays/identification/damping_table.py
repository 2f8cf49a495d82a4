"""From a table (A, zeta), (A, Q), (A, decrement) or (A, force) with resolutions to laws with intervals.

A linear inverse problem: least squares with strengths >= 0 and profile intervals (``identification.inverse_damping``).

>>> A = ["0.1", "0.2", "0.4", "0.8"]
>>> zeta = [0.0120, 0.0141, 0.0178, 0.0261]
>>> found = law_of_table({"A": A, "zeta": zeta}, resolution=exact_number("0.0002", "resolution"))
>>> print(found.verdict.text)
viscous drag and drag in v^2: consistent; epsilon_1 = ...; the table cannot tell dry friction below ... from none
>>> found.law("2").grade
'refuted'
"""

from collections.abc import Sequence
from dataclasses import replace
from math import inf, nan
from typing import Any

import numpy as np

from asymptotics.decays.identification.between_amplitudes import pairs
from asymptotics.decays.identification.damping_columns import CLOCKS, PHASE, Columns, read_columns
from asymptotics.decays.identification.found_law import UNIT_OF_X, UNTESTED, DampingLaw
from asymptotics.decays.identification.inverse_damping import DampingCandidate, Problem, fitted, weighted
from asymptotics.decays.identification.resonance_table import as_losses, beyond_first_order
from asymptotics.equivalent.rows import OF_MOTION, row_at
from asymptotics.errors import InputError, LimitError, UndecidedError
from asymptotics.frames import BARE, Frame
from asymptotics.law import Oscillator, SpringLike
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.policy import double_of, exact_double, exact_number
from asymptotics.numbers.quantities import ANGLES
from asymptotics.present.counts import many
from asymptotics.present.percent import percent
from asymptotics.terms import terms_of
from asymptotics.terms_given import PENDULUM

# The exponents that have names (dry friction, viscous, air, cubic) and the sums of them that are met in practice; a law
# that is not among them is asked for by ``laws``.
DEFAULT = ("0", "1", "2", "3", "0+1", "1+2", "0+2", "1+3", "0+1+2")
# They bound the work: a profile is many least squares over all rows, for every strength of every candidate.
MAX_POINTS, MAX_TERMS = 1000, 4


def _require_doubles(**given: ExactReal | None) -> None:
    """All that follows is in doubles; a mass and a stiffness stand together."""
    for name, other in (("mass", "stiffness"), ("stiffness", "mass")):
        if given[name] is None and given[other] is not None:
            raise InputError(name, "is missing", "both, or neither")
    for name, number in given.items():
        if number is not None:
            exact_double(number, name)


def law_of_table(
    table: Any,
    *,
    resolution: ExactReal | None = None,
    laws: str | Sequence[str] | None = None,
    spring: SpringLike | None = None,
    mass: ExactReal | None = None,
    stiffness: ExactReal | None = None,
    omega_0: ExactReal | None = None,
    unit: str = "",
) -> DampingLaw:
    """The candidates with grades and intervals, of a file, a data frame or a mapping of columns.

    ``omega_0`` in the place of the mass and the stiffness tells b/m; ``unit``: of A, of the time, or of both, where the
    columns have none.  InputError by name for what cannot be used.
    """
    if omega_0 is not None:
        if mass is not None or stiffness is not None:
            raise InputError("omega_0", "it stands next to the mass or the stiffness", "either, not both")
        mass, stiffness = exact_number(1, "mass"), omega_0 * omega_0
    _require_doubles(resolution=resolution, mass=mass, stiffness=stiffness)
    read = read_columns(table, unit)
    columns, quantity, notes = read.values, read.quantity, read.notes
    known = _known(read, resolution)
    spread = None if known is None else _positive(known, "resolution")
    given = _positive(columns["amplitude"], "A")
    ends, between = (float(given.min()), float(given.max())), quantity in CLOCKS
    driven = quantity == "force"
    used = {"A": given.tolist(), quantity: columns[quantity].tolist()}
    if driven:
        columns |= {name: _positive(columns[name], name) for name in ("force", "omega") if name in columns}
        columns, said = _with_phase(columns, spread is not None)
        notes = (*notes, *said)
        used |= {name: columns[name].tolist() for name in ("omega", *PHASE) if name in columns}
    used |= {} if spread is None else {"resolution": spread.tolist()}
    if spring is not None and (between or driven):
        what = "amplitudes at times are" if between else "a driven table is"
        raise InputError("spring", f"{what} read with a linear one", "a table of zeta, Q, decrement")
    if between:
        places, values, spread, said = _losses(columns, quantity, spread, mass, stiffness)
        quantity, notes = "decrement", (*notes, *said)
    elif driven:
        places, values, spread, said = as_losses(columns, spread, mass, stiffness)
        quantity, notes = "zeta", (*notes, *said)
    else:
        places, values = given, _positive(columns[quantity], quantity)
    # One row more than strengths, or chi^2 has no degree of freedom and every candidate fits; two amplitudes alone give
    # the strength of each law of one term, and test none.
    candidates, skipped = _candidates(laws, len(values) if between and len(values) == 1 else len(values) - 1)
    if quantity == "zeta" and not float(values.min()) < 1:
        reason = f"the smallest is {values.min():g}: from 1 on nothing swings"
        raise InputError("zeta", reason, "a ratio below 1, or per cent in a column zeta [%]")
    # m = k = 1 without them: b is epsilon then, in the unit of the amplitudes.
    problem = Problem(quantity, candidates, mass or 1, stiffness or 1, spring, between)
    table_of = places.tolist(), values.tolist(), None if spread is None else spread.tolist()
    if driven:
        table_of, said = _corrected(columns, fitted(*table_of, problem)[0], known, mass, stiffness)
        notes += said
    found, (zeta, s) = fitted(*table_of, problem), weighted(*table_of, problem)
    if len(values) == 1:
        notes += ("one loss and one strength: each law of one term has its own, and none is tested",)
        found = tuple(replace(c, grade=UNTESTED) for c in found)
    if spread is None and len(values) == 1:
        notes += ("no resolution: no intervals",)
        found = tuple(replace(c, strengths=tuple(replace(e, low=nan, high=nan) for e in c.strengths)) for c in found)
    elif spread is None:
        notes += ("no resolutions: taken equal, as large as the best candidate needs, so none is refuted by chance",)
    turning = spring == PENDULUM or read.unit in ANGLES
    # Of amplitudes without a unit b/m is told in their own.
    length = "rad" if turning else "m" if read.unit or omega_0 is None else UNIT_OF_X
    frame = BARE if mass is None else Frame(length, "s")
    off = None if driven else _neglected(problem, found[0], ends)
    relative = inf if spread is None and len(values) == 1 else float(np.median(s / zeta))
    notes = (*notes, *skipped)
    return DampingLaw(problem, found, len(given), ends, off, relative, frame, notes, used, per_mass=omega_0 is not None)


def _known(read: Columns, resolution: ExactReal | None) -> Any:
    """The errors of what is measured: of the column, or the one that is said; None without any."""
    known = read.values.get("resolution")
    if resolution is None:
        return known
    if known is not None:
        raise InputError("resolution", "the table has a column of that name", "one of the two")
    # In the unit in which the file has the quantity.
    return np.full(len(read.values["amplitude"]), read.size * double_of(resolution))


def _with_phase(columns: dict[str, Any], known: bool) -> tuple[dict[str, Any], tuple[str, ...]]:
    """The columns without a phase that cannot be weighed: beside amplitudes of known errors one needs its own."""
    if "phase_resolution" in columns and not ("phase" in columns and known):
        less = {name: column for name, column in columns.items() if name != "phase_resolution"}
        return less, ("not used: phase_resolution, beside which no phase or no resolution of A stands",)
    if "phase" not in columns or not known:
        return columns, ()
    if "phase_resolution" in columns:
        return {**columns, "phase_resolution": _positive(columns["phase_resolution"], "phase_resolution")}, ()
    return {name: column for name, column in columns.items() if name != "phase"}, (
        "not used: phase, beside which no phase_resolution stands",
    )


def _corrected(
    columns: dict[str, Any], best: DampingCandidate, spread: Any, mass: ExactReal | None, stiffness: ExactReal | None
) -> tuple[tuple[Any, Any, Any], tuple[str, ...]]:
    """The table with its amplitudes brought to first order, by the next harmonics of the best law."""
    off = beyond_first_order(columns, {s.alpha: s.estimate for s in best.strengths}, mass, stiffness)
    nearer = {name: columns[name] - by for name, by in off.items() if name in columns}
    places, values, error, _ = as_losses({**columns, **nearer}, spread, mass, stiffness)
    share = float(np.max(abs(off["amplitude"] / columns["amplitude"])))
    told = f"amplitudes less what the next harmonics of {best.name} add, {percent(share)} at most (an estimate)"
    return (places.tolist(), values.tolist(), None if error is None else error.tolist()), (told,)


def _losses(
    columns: dict[str, Any], clock: str, spread: Any, mass: ExactReal | None, stiffness: ExactReal | None
) -> tuple[Any, Any, Any, tuple[str, ...]]:
    """Pairs of neighbouring amplitudes with the decrement of a cycle between them, its error, and what is told."""
    size, count = columns["amplitude"], columns[clock]
    omega = 1.0 if mass is None or stiffness is None else double_of(stiffness / mass) ** 0.5
    of_one = {"n": 0.5, "cycles": 1.0, "t": omega / (2 * np.pi)}[clock]
    both, values = pairs(size, of_one * count)
    named = {"n": "n counts half-swings", "cycles": "periods are counted", "t": "t in s"}[clock]
    if clock == "t" and mass is None:
        named = (
            "t is omega_0 t, for want of a mass and a stiffness; of t in s epsilon_1 is b/m in 1/s all the same, and "
            "mass 1 with stiffness (2 pi/period)^2 (identify: --omega0 2 pi/period) gives b/m of every law"
        )
    told: tuple[str, ...] = (named,)
    if len(values) == 1 and (clock != "t" or mass is not None):
        d = float(values[0])
        told += (f"between the two: decrement of a cycle {d:.4g}, zeta {d / (2 * np.pi):.4g}, Q {np.pi / d:.4g}",)
    if spread is None:
        return both, values, None, told
    # The errors of both amplitudes; that neighbours share one is neglected.
    error = np.hypot(spread[:-1] / size[:-1], spread[1:] / size[1:]) / (of_one * np.diff(count))
    return both, values, error, told


def _positive(values: Any, name: str) -> Any:
    if values.ndim != 1 or len(values) > MAX_POINTS:
        raise LimitError(name, f"its shape is {values.shape}", f"one column of at most {MAX_POINTS} rows")
    # NaN fails both comparisons.  The range keeps squares and quotients of the columns within doubles.
    bad = np.flatnonzero(~((values > 1e-100) & (values < 1e100)))
    if len(bad):
        raise InputError(name, f"{values[bad[0]]:g} in row {bad[0] + 1} is not positive", "numbers > 0")
    return values


def _candidates(laws: Any, most: int) -> tuple[tuple[tuple[str, ...], ...], tuple[str, ...]]:
    """Exponents as text, and what is skipped: laws of more than ``most`` strengths, and a free exponent.

    InputError for what is no exponent, twice the same or too many, and where nothing is left.
    """
    given = DEFAULT if laws is None else (laws,) if isinstance(laws, str) else laws
    if not isinstance(given, list | tuple) or not given:
        raise InputError("laws", "there is none", 'texts such as ["1", "1+2"]')
    made, left = [], []
    for law in given:
        if law == "free":
            left.append("free (the exponents of a table are given: try some)")
            continue
        alphas = [exact_number(part, "laws") for part in (terms_of(law, "laws") if isinstance(law, str) else [law])]
        if len(alphas) > MAX_TERMS or len({str(a) for a in alphas}) < len(alphas) or any(a < 0 for a in alphas):
            raise InputError(
                "laws", f"{str(law)[:40]!r} is no candidate", f"up to {MAX_TERMS} different exponents >= 0"
            )
        if len(alphas) > most:
            left.append(f"{'+'.join(map(str, alphas))} ({many(len(alphas), 'strength')})")
        else:
            made.append(tuple(str(a) for a in alphas))
    skipped = f"skipped: {', '.join(dict.fromkeys(left))}"
    if not made:
        raise InputError("table", f"too few rows: {skipped}", "a row more than strengths, and given exponents")
    return tuple(dict.fromkeys(made)), (skipped,) if left else ()


def _neglected(problem: Problem, best: DampingCandidate, ends: tuple[float, float]) -> float | None:
    """The largest relative difference of the motion from the first order at both ends, for the best law."""
    # A strength that the fit has put to 0 acts nowhere; without any there is no motion to compare with.
    strengths = {exact_number(s.alpha, "laws"): s.estimate for s in best.strengths if s.estimate > 0}
    if not strengths:
        return None
    law = Oscillator(strengths, mass=problem.mass, stiffness=problem.stiffness, spring=problem.spring)
    off = []
    for a in ends:
        try:
            # Six digits of the certified motion over one full swing: the difference is shown as a percentage.  A swing
            # that balls cannot decide, or that does not come back (dry friction holds it), says nothing, hence None.
            row = row_at(law, exact_number(a, "A"), 6, None)
        except UndecidedError:
            return None
        # The largest local strength, and with it what the first order leaves out, is at one of the ends: a sum of
        # powers of A is convex in ln A.
        first = getattr(row.first, problem.quantity)
        name = OF_MOTION.get(problem.quantity, problem.quantity)
        motion = None if row.motion is None else getattr(row.motion, name)
        if motion is None:
            return None
        off.append(abs(float(motion) / float(first) - 1))
    return max(off)
