"""A table becomes runs: a sampled motion is cleaned and cut at its releases, turning points are checked row by row."""

from dataclasses import replace
from typing import Any

import numpy as np

from asymptotics.decays.identification.fitting.printed import Decrements
from asymptotics.decays.identification.forward.coefficients import Array
from asymptotics.decays.identification.measuring.at_rest import moving
from asymptotics.decays.identification.measuring.extraction import observations_of_record
from asymptotics.decays.identification.measuring.few_swings import of_a_short_record
from asymptotics.decays.identification.measuring.main_frequency import dominant_period
from asymptotics.decays.identification.measuring.mode_beside import with_mode_beside
from asymptotics.decays.identification.measuring.near_modes import near_modes
from asymptotics.decays.identification.measuring.observations import Observations
from asymptotics.decays.identification.measuring.ringdown import observations_of_envelope
from asymptotics.decays.identification.measuring.sampled import LEAST_SAMPLES, observations_of_motion
from asymptotics.decays.identification.measuring.second_mode import without_second_modes
from asymptotics.decays.identification.measuring.sensors import sensor_notes
from asymptotics.decays.identification.measuring.slow_base_line import SlowBaseLine, slow_base_line
from asymptotics.decays.identification.measuring.steady_start import steady_start
from asymptotics.decays.records.clock import runs_of, straightened
from asymptotics.decays.records.repairs import releases, spikes
from asymptotics.decays.records.rows import RowPlaces
from asymptotics.decays.records.sources import How
from asymptotics.decays.records.table import RecordTable, read_table
from asymptotics.errors import InputError, LimitError
from asymptotics.present.counts import many

LEAST_POINTS, _FEWEST_POINTS = 4, 2
"""First amplitude and a strength leave two data of four: fewer turning points tell no law from another; two tell Q."""
MAX_SWINGS = 1_000_000
"""Half-swings from the first to the last turning point: every one is computed for every law, in half a minute each."""
Run = Observations | Decrements


def load(
    source: Any,
    kind: str | None = None,
    unit: str = "",
    how: How | None = None,
    omega_0: float | None = None,
    modes: int = 1,
) -> list[Run]:
    """The runs of a source, one if its clock never starts again; InputError for what cannot be used.

    ``omega_0``, in rad/s, is the frequency of amplitudes that are sampled alone, where the file does not say it;
    ``modes``: 2 for a second mode that is fitted beside the motion.
    """
    if modes > 1 and isinstance(source, Observations | Decrements):
        raise InputError("modes", "turning points show no second mode", "1, or the samples of a motion")
    if isinstance(source, Observations | Decrements):
        if isinstance(source, Observations):
            _require_few(source.last, source.name or "n")
        return [source]
    table = read_table(source, kind, unit, how, None if omega_0 is None else omega_0 / (2 * np.pi))
    try:
        if modes > 1 and table.kind in ("decrement", "turning-points", "envelope"):
            raise InputError("modes", f"{table.kind} show no second mode", "1, or the samples of a motion")
        if table.kind == "decrement":
            return [_decrements(table)]
        if table.kind == "envelope":
            found: list[Observations] = [_ringdown(table.whole(), omega_0)]
        else:
            found = [_turning_points(table)] if table.kind == "turning-points" else _motions(table.whole(), modes)
        return [replace(run, time_unit=table.clock, written=table.written) for run in found]
    except InputError as error:
        # A column that was taken wrongly may be why: the refusal names it, and those that swing more.
        if not error.argument.startswith("FILE"):
            raise
        told = table.read_as()
        # Of two or three amplitudes only the loss between them can be told.
        few = len(next(iter(table.columns.values()))) < LEAST_POINTS
        peaks = "; peaks: a column 'amplitude'; two amplitudes and a time: --kind damping"
        accepted = error.accepted + (peaks if few else "")
        raise type(error)("FILE", f"{error.reason}; {told}" if told else error.reason, accepted) from None


def _motions(table: RecordTable, modes: int = 1) -> list[Observations]:
    t = table.columns["t"]
    pieces = runs_of(t)
    found: list[Observations] = []
    for number, places in enumerate(pieces, start=1):
        run = table.kept(places) if len(pieces) > 1 else table
        if len(pieces) > 1:
            said = f"the clock starts again: run {number} of {len(pieces)}, from row {table.rows.row(int(places[0]))}"
            name = f"{table.rows.name} (run {number})"
            run = replace(run, notes=(*run.notes, said), rows=replace(run.rows, name=name))
        found += _decays(run, modes)
    return found


def _decays(run: RecordTable, modes: int = 1) -> list[Observations]:
    """Each release of a run, without the samples that are spikes."""
    column = "xva"[_order(run)]
    t, x, rows, notes = straightened(run.columns["t"], run.columns[column], run.rows)
    # Spikes go before the releases are sought: one of them would be the largest swing.
    wild = spikes(x)
    if wild.any():
        first = rows.where(int(np.argmax(wild)), column)
        notes = (*notes, f"{many(int(wild.sum()), 'sample')} far from their neighbours left out, the first is {first}")
        t, x, rows = t[~wild], x[~wild], rows.kept(np.flatnonzero(~wild))
    said = (*run.notes, *notes, *sensor_notes(t, x))
    parts, found = releases(t, x), list[Observations]()
    swinging = _swinging(t, x)  # at rest the swings are those of noise, which rise and fall
    beat = near_modes(t[swinging], x[swinging])
    if beat is not None:
        # A weaker one is measured and taken off, or stays in what the laws leave: the motion is one decay still.
        if modes == 1 and beat.is_strong:
            raise InputError("FILE", f"{rows.name} {beat.in_words}", "--modes 2, which fits both")
        said = said if modes > 1 else (*said, f"the record {beat.in_words}: --modes 2 fits both")
        parts = [np.arange(len(t))]
    for number, places in enumerate(parts, start=1):
        own, told = rows if len(places) == len(t) else rows.kept(places), said
        if len(places) < len(t):
            stretch = f"free decay from t = {t[places[0]]:.6g} to {t[places[-1]]:.6g}"
            told = (*said, f"{stretch}: the rest is held or touched")
        if len(parts) > 1:
            told = (*said, f"released again: run {number} of {len(parts)}, {stretch}; held or touched between")
            if number == 1 and places[0] > 0:
                told = (*told, f"what comes before t = {t[places[0]]:.6g} is held, or too short a release: not used")
            own = replace(own, name=f"{rows.name} (release {number})")
        steady = None if beat is not None else steady_start(t[places], x[places])
        if steady is not None:
            told = (*told, steady.in_words)
            free = t[places] >= steady.end
            places, own = (places[free], own.kept(free)) if steady.sure else (places, own)
        try:
            found.append(_decay(t[places], x[places], run, own, told, modes))
        # One release of several may be too short; the only one may not.
        except InputError as error:
            if len(parts) == 1:
                raise
            said = (*said, f"release {number} of {len(parts)} left out: {error.reason}")
    if not found:
        raise InputError("FILE", "; ".join([rows.name, *said[-len(parts) :]]), "a free decay")
    return found


def _ringdown(table: RecordTable, omega_0: float | None) -> Observations:
    """A sampled envelope, at the frequency that is said or that its file says, if any does."""
    frequency = table.frequency if omega_0 is None else omega_0 / (2 * np.pi)
    t, x, rows, notes = straightened(table.columns["t"], table.columns["x"], table.rows)
    return observations_of_envelope(
        t, x, frequency, relative=table.relative, unit=table.unit, name=rows.name, notes=(*table.notes, *notes)
    )


def _order(run: RecordTable) -> int:
    return ("record", "velocity", "acceleration").index(run.kind)


def _decay(
    t: Array, x: Array, run: RecordTable, rows: RowPlaces, notes: tuple[str, ...], modes: int = 1
) -> Observations:
    if modes > 1 and len(t) >= LEAST_SAMPLES and np.ptp(x) > 0:
        kept = _swinging(t, x)
        return with_mode_beside(t[kept], x[kept], unit=run.unit, name=rows.name, notes=notes, derivative=_order(run))
    # Within each release: a line has its own phase and size in each of them.
    whole = t
    # What never changes has no period, which the search for a second mode asks for.
    if len(x) > 1 and not np.ptp(x) > 0:
        raise InputError("FILE", f"{rows.name}, column {'xva'[_order(run)]}: all values are {x[0]:g}", "a motion")
    slow = slow_base_line(t, x)
    if slow is not None:
        x, notes = x - slow.values, (*notes, slow.in_words)
    elif len(t) >= LEAST_SAMPLES:
        short = of_a_short_record(t, x, unit=run.unit, name=rows.name, notes=notes, derivative=_order(run))
        if short is not None:
            return short
    x, lines = without_second_modes(t, x)
    notes = (*notes, *lines)
    swinging = _swinging(t, x)
    rows, t, x = rows.kept(np.arange(len(t))[swinging]), t[swinging], x[swinging]
    if _order(run) == 0:
        seen = _beside(slow, observations_of_record(t, x, unit=run.unit, rows=rows, whole_motion=slow is not None))
        return replace(seen, notes=(*notes, *seen.notes, *_tail(whole, seen)))
    if len(t) < LEAST_SAMPLES:
        raise InputError(
            "FILE", f"{rows.name} has {many(len(t), 'row')} with numbers that change", f"{LEAST_SAMPLES} samples"
        )
    seen = _beside(
        slow, observations_of_motion(t, x, unit=run.unit, name=rows.name, notes=notes, derivative=_order(run))
    )
    return replace(seen, notes=(*seen.notes, *_tail(whole, seen)))


def _swinging(t: Array, x: Array) -> slice:
    """The samples before the rest; all of few samples and of one value."""
    some = len(t) >= LEAST_SAMPLES and np.ptp(x) > 0
    kept = moving(t, x, dominant_period(t, x)) if some else slice(None)
    return kept if len(t[kept]) >= LEAST_SAMPLES else slice(None)


def _beside(slow: SlowBaseLine | None, seen: Observations) -> Observations:
    """The base line that was taken off is fitted once more beside every law: what it costs the intervals is in them."""
    if slow is None or seen.samples is None:
        return seen
    columns, size = slow.columns(seen.samples.t), float(np.abs(slow.values).max())
    return replace(seen, samples=replace(seen.samples, slow=columns, wander=size))


def _tail(t: Array, seen: Observations) -> list[str]:
    """What of the end of the record is not used, where it is more than a period."""
    used = float((seen.t if seen.samples is None else seen.samples.t)[-1])
    period = 2 * float(np.median(np.diff(seen.t) / np.diff(seen.n)))
    beyond = (float(t[-1]) - used) / period
    return [f"the last {beyond:.2g} periods, after t = {used:.6g}, are not used"] if beyond > 1 else []


def require_increasing(values: Array, column: str, rows: RowPlaces) -> None:
    """InputError with the row at which ``values`` does not increase."""
    wrong = np.flatnonzero(np.diff(values) <= 0)
    if len(wrong):
        row = int(wrong[0]) + 1
        reason = f"{rows.where(row, column)}: {values[row]:g} after {values[row - 1]:g}"
        raise InputError("FILE", reason, "increasing values")


def _turning_points(table: RecordTable) -> Observations:
    n = table.columns["n"]
    fraction = np.flatnonzero(~(np.isnan(n) | (n == np.round(n))))
    if len(fraction):
        reason = f"{table.rows.where(fraction[0], 'n')}: {n[fraction[0]]:g} is not a whole number"
        raise InputError("FILE", reason, "0, 1, 2, ...")
    table = table.whole()
    notes = table.notes
    rows, name, tau = table.rows, table.rows.name, table.columns.get("tau")
    n, x = table.columns["n"], table.columns["x"]
    _require_points(x, rows, notes[1:])
    require_increasing(n, "n", rows)
    _require_few(n[-1] - n[0], rows.where(len(n) - 1, "n"))
    if tau is not None:
        require_increasing(tau, "tau", rows)
    late = table.columns.get("sigma_t", ()) if tau is not None else ()
    seen = Observations.of(
        n.astype(int), x, () if tau is None else tau, sigma_x=table.columns.get("sigma_x", ()), sigma_t=late,
        unit=table.unit, name=name, notes=notes,
    )  # fmt: skip
    wrong = np.flatnonzero(seen.x * seen.sign < 0)
    # Noise may change the sign of the last points; more than a third is another numbering.
    if len(wrong) > max(2, len(x) // 3):
        reason = f"{rows.where(wrong[0], 'x')}: the signs do not alternate with n"
        raise InputError("FILE", reason, "x_n with alternating signs, or amplitudes of one sign")
    # What ends on the wrong side is no turning point of a swing: friction held it on its way, or it is noise.
    last = int(np.flatnonzero(seen.x * seen.sign >= 0)[-1])
    if last == len(x) - 1 or last < LEAST_POINTS - 1:
        return seen
    said = f"what follows turning point {seen.n[last]} is on the same side: at rest, or hidden by noise; left out"
    return replace(seen.up_to(int(seen.n[last])), notes=(*seen.notes, said))


def _require_few(swings: float, where: str) -> None:
    # A law of one loss asks for half a kilobyte for each half-swing, one of four for three times as much.
    if swings > MAX_SWINGS:
        reason = f"{where}: {swings:.3g} half-swings, computed for each law in about {swings * 5e-7:.3g} GB"
        raise LimitError("FILE", reason, f"at most {MAX_SWINGS} half-swings from the first to the last")


def _require_points(x: Array, rows: RowPlaces, notes: tuple[str, ...]) -> None:
    if len(x) < _FEWEST_POINTS:
        shown = many(len(x), "turning point")
        reason = "; ".join([f"{rows.name} has {shown}", *notes])
        raise InputError("FILE", reason, f"at least {_FEWEST_POINTS}")
    if not np.ptp(np.abs(x)) > 0:
        raise InputError("FILE", f"{rows.name}, column x: all values are {abs(x[0]):g}", "amplitudes that change")
    if not abs(x[0]) > 0:
        raise InputError("FILE", f"{rows.where(0, 'x')}: the first turning point is 0", "a number other than 0")


def _decrements(table: RecordTable) -> Decrements:
    table = table.whole()
    notes = (*table.notes, "decrements: A_n - A_(n+1) of half-swings (logarithmic ones: kind damping)")
    rows, columns = table.rows, table.columns
    amplitude, decrement, resolution = columns["amplitude"], columns["decrement"], columns.get("resolution")
    if len(amplitude) < 2:
        raise InputError("FILE", f"{rows.name} has {many(len(amplitude), 'row')} with numbers", "at least 2")
    # A decrement of twice the mean amplitude would end at 0 or beyond.
    checks = [("amplitude", amplitude <= 0, "is not positive"), ("decrement", decrement >= 2 * amplitude, "too large")]
    if resolution is not None:
        wide = np.abs(decrement) + resolution >= 2 * amplitude
        checks += [("resolution", resolution < 0, "is negative"), ("resolution", wide, "leaves no limit in this row")]
    for column, wrong, reason in checks:
        if wrong.any():
            place = int(np.argmax(wrong))
            said = f"{rows.where(place, column)}: {columns[column][place]:g} {reason}"
            raise InputError("FILE", said, "amplitude > 0, resolution >= 0, decrement + resolution < 2 amplitude")
    return Decrements(amplitude, decrement, resolution, table.unit, rows.name, notes, table.written)
