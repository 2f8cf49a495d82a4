"""``identify`` beside other programs on the same decays of known laws: Q, strengths, wrong laws, failures, time.

The records are those of ``decays`` (eight classes that the others can be given), of a seed used for nothing else.  Q is
asked at the first amplitude, the last and their geometric mean, and judged by the first-order Q of the true law; a 95 %
interval holds it or not.  One exponential is A e^(-gt) cos(omega t + p) + c, begun near its optimum, with one Q =
omega/2g; kafe2 has so many rows that 400 to 800 remain, and a noise from fifth differences.  rolldecay-estimators fits
B1 and B2 to derivatives by NumPy, or to the motion from there.  The last program is told the right law, begins 20 %
from its strengths, and integrates the motion by DOP853.  *Wrong law*: records answered by a law that is not the true
one, without a word of it: ``identify`` that identifies another; a fixed law that is not refuted (by kafe2: p < 0.001;
the others have no such word).
"""

from collections.abc import Sequence
from math import comb, inf, pi
from time import process_time
from typing import Any

import numpy as np

import asymptotics as asy
from asymptotics.decays.identification.judging.judgement import rivals
from asymptotics.decays.identification.telling.envelope import envelope
from asymptotics.errors import InputError, LimitError
from benchmarks.decays import Array, Decay, decay, fall
from benchmarks.fit_programs import KAFE2_LINE, LMFIT_LAW, LMFIT_LINE, ROLLDECAY
from benchmarks.peers import ask
from benchmarks.table import Table, seconds_text

PEERS = ("lmfit", "scipy", "kafe2", "rolldecay-estimators")
KINDS = ("plain", "sparse", "drift", "coloured", "quantised", "strong", "short", "unquiet tail")
SIZE, SEED, PATIENCE = 120, 20261127_02, 600
PROGRAMS: tuple[tuple[str, str, dict[str, str], tuple[str, ...]], ...] = (
    ("lmfit, one exponential", LMFIT_LINE, {}, ("1",)),
    ("kafe2, one exponential", KAFE2_LINE, {}, ("1",)),
    ("rolldecay-estimators, derivation", ROLLDECAY, {"method": "derivation"}, ("1", "2", "1+2")),
    ("rolldecay-estimators, integration from there", ROLLDECAY, {"method": "integration"}, ("1", "2", "1+2")),
    ("lmfit, told the right law", LMFIT_LAW, {}, ()),
)
"""Name, code, what it is told beside the records, and the laws that its model can be; none: whichever is true."""
_HEAD = ("program", "answered", "error of Q", "Q held", "strengths held", "wrong law", "CPU s")
_DIFFERENCES = 5
"""So many differences leave 1e-4 of a wave of 40 samples a period, and of white noise sqrt(C(10, 5)) of it."""
Said = dict[str, Any]


def run(size: int = SIZE, seed: int = SEED) -> Table:
    """``size`` records, which go round the classes, and round the five laws."""
    made = [decay(KINDS[k % len(KINDS)], k, seed) for k in range(size)]
    ours = [_identified(one) for one in made]
    rows = [_row("identify, all candidates", made, ours, ours)]
    records = [_told(one, said["at"]) for one, said in zip(made, ours)]
    for name, code, more, laws in PROGRAMS:
        answer = ask(code, timeout=PATIENCE + 60 * size, records=records, **more)
        if "found" not in answer:
            rows.append((name, *"-----", seconds_text(answer["seconds"])))
            continue
        for one, said in zip(made, answer["found"]):
            said["wrong"] = bool(laws) and one.law not in laws and not said.get("refuted", False)
        rows.append(_row(name, made, answer["found"], ours))
    return Table(f"{size} decays of known laws, seed {seed}", _HEAD, tuple(rows))


def _identified(one: Decay) -> Said:
    """What ``identify`` says of a record, in the words of the other programs, and ``at``, its three amplitudes."""
    start, said = process_time(), Said(at=[])
    try:
        answer: Any = asy.identify(one.data, **one.said, max_seconds=PATIENCE)
    except (InputError, LimitError) as error:
        return said | {"seconds": process_time() - start, "failed": str(error)}
    said["seconds"] = process_time() - start
    bare = envelope(answer.runs[0])
    quality = () if bare is None else bare.quality
    said["at"] = [row["amplitude"] for row in quality]
    said["quality"] = [[row["low"], row["estimate"], row["high"]] for row in quality]
    said["strengths"] = [[e.low, e.high] for e in answer.law(one.law).law.epsilon]
    named = [str(law.candidate) for law in rivals([entry.law for entry in answer.laws])[0]]
    said["wrong"] = answer.verdict.kind == "identified" and named != [one.law]
    return said


def _told(one: Decay, at: Sequence[float]) -> Said:
    """A record as the other programs are given it."""
    t, x = one.data["t"], one.data["x"]
    noise = float(np.std(np.diff(x, _DIFFERENCES)) / np.sqrt(comb(2 * _DIFFERENCES, _DIFFERENCES)))
    alphas = [float(alpha) for alpha in one.law.split("+")]
    return {
        "t": t.tolist(), "x": x.tolist(), "line": _line(t - t[0], x), "noise": noise, "law": alphas,
        "strengths": one.strengths, "at": list(at),
    }  # fmt: skip


def _line(t: Array, x: Array) -> list[float]:
    """(A, g, omega, p, c) of one exponential near the best: the best of a grid of g and omega."""
    best, found = inf, [0.0] * 5
    crossings = np.count_nonzero(np.diff(np.sign(x - x.mean())))
    for omega in pi * crossings / t[-1] * np.linspace(0.9, 1.1, 81):
        for g in omega / 2 / np.geomspace(3.0, 300.0, 12):
            size = np.exp(-g * t)
            columns = np.stack([size * np.cos(omega * t), size * np.sin(omega * t), np.ones(len(t))], axis=1)
            (a, b, c), *_ = np.linalg.lstsq(columns, x, rcond=None)
            left = float(((x - columns @ [a, b, c]) ** 2).sum())
            if left < best:
                best, found = left, [float(np.hypot(a, b)), g, omega, float(np.arctan2(-b, a)), float(c)]
    return found


def true_quality(one: Decay, amplitude: float) -> float:
    """pi/2 over what ln A falls by in a half-swing, to first order.

    >>> round(true_quality(Decay("plain", "1", (0.02,), {}), 3.0), 9)
    50.0
    """
    alphas = [float(alpha) for alpha in one.law.split("+")]
    return pi / 2 / float(sum(fall(a) * e * amplitude ** (a - 1) for a, e in zip(alphas, one.strengths)))


def _row(name: str, made: Sequence[Decay], said: Sequence[Said], ours: Sequence[Said]) -> tuple[str, ...]:
    """One program: shares of what it answered."""
    errors, quality, strengths = [], [], []
    for one, each, first in zip(made, said, ours):
        for (low, estimate, high), amplitude in zip(each.get("quality", ()), first["at"]):
            true = true_quality(one, amplitude)
            errors.append(abs(estimate / true - 1))
            if (low, high) != (None, None):
                quality.append((-inf if low is None else low) <= true <= (inf if high is None else high))
        for (low, high), true in zip(each.get("strengths", ()), one.strengths):
            strengths.append((low is None or low <= true) and (high is None or true <= high))
    times = [seconds_text(float(np.quantile([each["seconds"] for each in said], q))) for q in (0.5, 0.9)]
    wide = " / ".join(f"{100 * np.quantile(errors, q):.2g} %" for q in (0.5, 0.9)) if errors else "-"
    answered = sum("failed" not in each for each in said)
    wrong = sum(each.get("wrong", False) for each in said)
    return (
        name, f"{answered} of {len(said)}", wide, _held(quality), _held(strengths), f"{wrong}", " / ".join(times),
    )  # fmt: skip


def _held(each: Sequence[bool]) -> str:
    return f"{sum(each)} of {len(each)}" if each else "-"
