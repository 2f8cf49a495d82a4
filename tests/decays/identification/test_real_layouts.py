"""Seven layouts of real files, with motions integrated here: the strengths that made them are found, without an option.

The layouts: peaks of one side, two pendulums in one file, dashes under the header, a struct of MATLAB, one column and a
rate, columns of uncertainties; levels in dBm are in ``measuring/test_ringdown.py``.
"""

import io

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.io import savemat

import asymptotics as asy

W = 2.76
"""rad/s: a pendulum of 1.29 m."""


def moved(t, x0, linear=0.0, square=0.0, pendulum=True):
    """x'' + sin x (or x) + linear x' + square x'|x'| = 0 from rest at x0, at the times t in s."""
    spring = np.sin if pendulum else np.asarray
    found = solve_ivp(
        lambda _, y: [y[1], -spring(y[0]) - linear * y[1] - square * y[1] * abs(y[1])], (0, W * t[-1]), [x0, 0.0],
        t_eval=W * t, method="DOP853", rtol=1e-10, atol=1e-12, dense_output=True,
    )  # fmt: skip
    return found.y[0], found.sol


def friction(t, x0, dry, linear):
    """x'' + x + dry sgn x' + linear x' = 0, exactly: damped cosines about +-dry, swing by swing."""
    mu, half = linear / 2, np.pi / np.sqrt(1 - linear**2 / 4)
    tau, x, place, side, start = W * t, np.zeros(len(t)), x0, 1.0, 0.0
    while start < tau[-1] and abs(place) > dry:
        s = tau - start
        here = (s >= 0) & (s <= half)
        wave = np.exp(-mu * s) * (np.cos(np.pi / half * s) + mu * half / np.pi * np.sin(np.pi / half * s))
        x[here] = (side * dry + (place - side * dry) * wave)[here]
        place = side * dry - (place - side * dry) * np.exp(-mu * half)
        start, side = start + half, -side
    x[tau > start] = place
    return x


def noise(count, size, seed=1):
    return size * np.random.default_rng(seed).standard_normal(count)


def asked(source, laws, **options):
    return asy.identify(source, laws=laws, bootstrap=False, **options)


def test_peaks_of_one_side_with_columns_of_errors():
    t = np.linspace(0, 150, 7_500)
    x, sol = moved(t, 0.57, 0.0026, 0.0126)
    turns = np.flatnonzero((x[1:-1] > x[:-2]) & (x[1:-1] >= x[2:])) + 1
    # The parabola through three samples has the peak to 1e-6.
    left, mid, right = x[turns - 1], x[turns], x[turns + 1]
    shift = (left - right) / (2 * (left - 2 * mid + right))
    peaks, times = mid - (left - right) * shift / 4, t[turns] + shift * (t[1] - t[0])
    rows = [
        f"{a:.6f} {b:.6f} 0.001 0.004"
        for a, b in zip([0.0, *times] + noise(len(peaks) + 1, 2e-3, 3), [0.57, *peaks] + noise(len(peaks) + 1, 8e-4))
    ]
    text = "\n".join(["t amplitude xerr yerr", *rows])
    answer = asked(io.StringIO(text), ["1+s3", "1+2+s3"])
    assert answer.runs[0].n[:3].tolist() == [0, 2, 4] and not answer.runs[0].unit
    # Without a unit it may be no angle; the first of the springs of a sine explains the times.
    assert answer.law("1+2+s3").law.verdict == "consistent" and answer.law("1+s3").law.verdict == "refuted"
    pendulum = asked(io.StringIO(text), ["1+2+pendulum", "1+2"], unit="rad")
    found = pendulum.law("1+2+pendulum").law
    assert found.verdict == "consistent" and pendulum.law("1+2").law.verdict == "refuted"
    assert found.epsilon[0].contains(0.0026) and found.epsilon[1].contains(0.0126)


def test_two_pendulums_in_one_file():
    t = np.arange(0, 29, 0.0525)
    x = np.round(440 + 190 * friction(t, 1.0, 0.004, 0.03) + noise(len(t), 1.0))
    still = np.round(450 + noise(len(t), 1.0, 2))
    rows = ["{:.3f}\t{:.0f}\t{:.3f}\t{:.0f}".format(*row) for row in zip(t + 0.02, x, t + 0.045, still)]
    head = "#Creator: recorder\n#Time A\tPos A\tTime B\tPos B\n#[s]\t[au]\t[s]\t[au]\n"
    answer = asked(io.StringIO(head + "\n".join(rows)), ["1", "0+1"])
    assert any("x: 'Pos A [au]'" in note for note in answer.notes)
    law = answer.law("0+1").law
    assert law.verdict == "consistent" and law.epsilon[0].contains(0.76) and law.epsilon[1].contains(0.03)


def test_dashes_and_a_clock_that_stands_still():
    t = np.arange(0, 14, 0.04)
    x = 31 * friction(t, 1.0, 0.006, 0.04) + noise(len(t), 0.02)
    rows = [f"15:50:{s:06.3f}, 812.040, {v:.2f}" for s, v in zip(t, x)]
    answer = asked(
        io.StringIO("\n".join(["Timestamp, Time_Elapsed(s), Angle(deg)", 30 * "-", *rows])), ["0", "1", "0+1"]
    )
    law = answer.law("0+1").law
    assert answer.units.unit == "deg" and law.verdict == "consistent" and answer.law("1").law.verdict == "refuted"
    assert law.epsilon[0].contains(31 * 0.006) and law.epsilon[1].contains(0.04)


def test_a_struct_of_matlab(tmp_path):
    t = np.arange(0, 40, 0.05)
    x, sol = moved(t, 0.5, 0.03, 0.0, pendulum=False)
    y = sol(W * t)
    a = -y[0] - 0.03 * y[1] + noise(len(t), 1e-3)
    savemat(tmp_path / "run.mat", {"Fe": {"Out": {"Acc": np.stack([a, a]), "Time": t}, "In": {"Force": np.zeros(9)}}})
    answer = asked(str(tmp_path / "run.mat"), ["1", "2"])
    assert answer.runs[0].name == "run.mat" and answer.law("1").law.verdict == "consistent"
    assert answer.law("1").law.epsilon[0].contains(0.03) and answer.law("2").law.verdict == "refuted"


def test_one_column_and_a_rate_in_the_header():
    t = np.arange(0, 15, 0.005)
    x = np.degrees(moved(t, np.radians(31.5), 0.01, 0.05)[0]) + noise(len(t), 0.02)
    head = "trigger_start_deg, sample_rate, duration_sec\n90, 200, 15 \n"
    laws = ["1", "1+2+pendulum", "1+pendulum"]
    answer = asked(io.StringIO(head + "\n".join(f"{v:.2f}" for v in x)), laws, unit="deg")
    law = answer.law("1+2+pendulum").law
    assert law.verdict == "consistent" and answer.law("1").law.verdict == "refuted"
    assert law.epsilon[0].contains(0.01) and law.epsilon[1].contains(0.05 * np.pi / 180)
    # Near miss: at half the rate the frequency is half of what it is.
    slow = asked(io.StringIO("\n".join(f"{v:.2f}" for v in x)), ["1+2+pendulum"], unit="deg", rate=100)
    assert slow.units.omega_0 == pytest.approx(answer.units.omega_0 / 2, rel=1e-3)


def test_columns_of_uncertainties():
    t = np.arange(0, 60, 1 / 30)
    x = np.degrees(moved(t, np.radians(19.0), 0.004, 0.03)[0]) + noise(len(t), 0.03)
    rows = [f"{s:.6f}\t{v:.5f}\t0.008\t0.1" for s, v in zip(t, x)]
    head = "t (seconds)\tθ (degrees)\tuncertainty t (type b from 60fps)\tuncertainty θ (of the tracker)\n"
    answer = asked(io.StringIO(head + "\n".join(rows)), ["1+2+pendulum", "1+pendulum", "1+2"])
    law = answer.law("1+2+pendulum").law
    assert answer.units.unit == "deg" and law.verdict == "consistent"
    assert law.epsilon[0].contains(0.004) and law.epsilon[1].contains(0.03 * np.pi / 180)


def test_a_body_that_is_caught_and_let_go_again_is_several_runs_of_one_law():
    """Three releases without a hold, none higher than the last swing, in steps of 0.7 with 25 samples a period."""
    mu, step = 0.0158, 0.034
    parts = [
        size * np.exp(-mu * tau[:count]) * np.cos(tau[:count] + phase)
        for size, phase, count in ((16.8, 0.0, 77), (14.7, -0.1, 245), (3.8, 1.3, 295))
        for tau in [7.58 * step * np.arange(300)]
    ]
    x = np.round(np.concatenate(parts) / 0.7) * 0.7
    answer = asked((step * np.arange(len(x)), x), ["1", "0", "2", "1+s3"])
    assert len(answer.runs) == 2 and any("released again: run 1 of 2" in note for note in answer.notes)
    law = answer.law("1").law
    assert law.verdict == "consistent" and law.epsilon[0].estimate == pytest.approx(2 * mu, rel=0.04)
    assert {answer.law(text).law.verdict for text in ("0", "2")} == {"refuted"}


def test_a_place_that_is_called_an_acceleration():
    """Dry friction, exactly: (A - f) cos about f of either sign; an acceleration would jump where the motion turns."""
    t, f = np.arange(0, 10, 0.02), 0.02
    half = np.floor(t * W / np.pi)
    size = 0.55 - 2 * f * half
    x = np.where(size > f, (size - f) * np.cos(W * t) + f * (-1) ** half, np.nan)
    x = x[np.isfinite(x)] + noise(int(np.isfinite(x).sum()), 1e-4)
    data = {"t": t[: len(x)], "Acc": x}
    found = asked(data, ["0", "1"])
    # Failed before: none fits, and --kind record was asked for.
    assert found.law("0").law.epsilon[0].contains(f) and found.law("0").law.verdict == "consistent"
    assert "read as a place, which a law fits" in found.notes[0] and "--kind acceleration" in found.notes[0]
    # Near misses: what is said stands, and so does a unit; and no law fits it as a place either.
    wrong = asked(data, ["1"], kind="acceleration")
    assert wrong.verdict.kind == "none fits" and not any("read as a place" in note for note in wrong.notes)
    for column, law in (("Acc (m/s^2)", "0"), ("Acc", "3")):
        kept = asked({"t": data["t"], column: x}, [law])
        assert kept.runs[0].samples.derivative == 2 and not any("read as a place" in note for note in kept.notes)
