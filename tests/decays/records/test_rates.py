"""How often a sensor was read, as people and programs write it above the numbers."""

import json

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.sources import load
from asymptotics.decays.records.rates import rate_in
from asymptotics.errors import InputError


@pytest.mark.parametrize(
    ("line", "rate"),
    [
        ("fs_hz = 100.0", 100),
        ("dt_ms: 4", 250),
        ("# video 60 fps", 60),
        ("recorded with 29.97 frames per second", 29.97),
        ("200 samples/s", 200),
        ("Sampling rate: 0,25 kHz", 250),
        ("Sample rate: 12,500.0", 12500),
        # One or a thousand: it was read as 1 Hz.
        ("Sample rate: 1,000 Hz", None),
        ("fs: 44,100 Hz", None),
        ("1,000 samples per second", None),
        ("fps", None),
        ("offsets 100", None),
    ],
)
def test_a_rate_is_read_or_asked_for(line, rate):
    assert rate_in([line]) == (rate if rate is None else pytest.approx(rate))


T = np.arange(0, 20, 0.01)
X = 5 * np.exp(-0.05 * T) * np.cos(9 * T) + 0.01 * np.random.default_rng(0).standard_normal(len(T))


def test_a_rate_with_its_unit_in_its_name_and_within_an_object_is_the_clock(tmp_path):
    path = tmp_path / "nested.json"
    path.write_text(json.dumps({"meta": {"fs_hz": 100}, "samples": X.tolist()}))
    (seen,) = load(path)
    assert 2 * np.pi / 9 == pytest.approx(2 * np.diff(seen.t).mean(), rel=1e-3)


def test_frames_of_a_video_of_60_fps(tmp_path):
    path = tmp_path / "video.csv"
    rows = [f"{i},{640 + 40 * x:.1f},{300 + 0.1 * x:.1f}" for i, x in enumerate(X)]
    path.write_text("\n".join(["# video 60 fps", "frame,x_px,y_px", *rows]))
    (seen,) = load(path)
    assert 2 * np.pi / 9 * 100 / 60 == pytest.approx(2 * np.diff(seen.t).mean(), rel=1e-3)


def test_a_stamp_is_a_time(tmp_path):
    path = tmp_path / "stamped.csv"
    stamps = np.datetime64("2026-03-29T01:59:40.000") + (1000 * T).round().astype("timedelta64[ms]")
    path.write_text("\n".join(["stamp;angle_rad", *(f"{s}+00:00;{x:.4f}" for s, x in zip(stamps, X))]))
    (seen,) = load(path)
    assert 2 * np.pi / 9 == pytest.approx(2 * np.diff(seen.t).mean(), rel=1e-3)


def test_a_rate_that_may_be_a_thousand_is_asked_for(tmp_path):
    path = tmp_path / "thousand.txt"
    path.write_text("\n".join(["Sample rate: 1,000 Hz", *(f"{x:.4f}" for x in X)]))
    with pytest.raises(InputError, match="rate HZ"):
        asy.identify(path, laws=["1"])
