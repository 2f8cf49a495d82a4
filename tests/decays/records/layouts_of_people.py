"""Layouts of text by what people would call them; ``layouts`` has the motion behind each."""

import numpy as np

from asymptotics.decays.records.sources import How
from tests.decays.records.layouts import (
    HERTZ,
    LATE,
    LEVEL,
    NOISE,
    OTHER,
    PEAKS,
    TURNS,
    A,
    N,
    T,
    V,
    Written,
    rows,
    stamps,
)

DEG = "Time (s),Angle (deg)\n" + rows(T, 20 * N)
CM = rows(T, 5 * N)
COUNT = list(range(len(PEAKS)))
MS = [round(1000 * t) for t in T]


def _peaks(head, *columns):
    return head + "\n" + rows(*columns)


LVM = """LabVIEW Measurement\t
Separator\tTab
Decimal_Separator\t,
X_Columns\tOne
***End_of_Header***\t
Channels\t1
X_Dimension\tTime
***End_of_Header***
X_Value\tUntitled\tComment
"""
TDS = [("Record Length", "600"), ("Sample Interval", "0.04"), ("Vertical Units", "V"), ("Horizontal Units", "s")]
AXES = ["Acceleration x (m/s^2)", "Acceleration y (m/s^2)", "Acceleration z (m/s^2)", "Absolute acceleration (m/s^2)"]
ERRORS = {
    "dt and dx": ("dt", "dx"),
    "u(t) and u(x)": ("u(t)", "u(x)"),
    "σt and σx": ("σt", "σx"),
    "err_x": ("t_err", "err_x"),
    "± behind each": ("±", "±"),
}
TEXTS = {
    # Tables of text.
    "semicolons and decimal commas": Written(
        "Zeit (s);Winkel (grad)\n" + rows(T, 20 * N, sep=";", mark=","), 20, "deg"
    ),
    "tabs": Written("t\tx\n" + rows(T, N, sep="\t")),
    "no names": Written(rows(T, N, sep="  ")),
    "header in two rows": Written("Time,Position\n(s),(cm)\n" + CM, 5, "cm"),
    "units without brackets in a second row": Written("Time,Position\nms,cm\n" + rows(1000 * T, 5 * N), 5, "cm"),
    "header glued to the first row": Written("Time (s),Position (cm)" + CM, 5, "cm"),
    "rule of dashes": Written("Time (s)  Position (cm)\n--------  ----------\n" + CM.replace(",", "  "), 5, "cm"),
    "table of Markdown": Written(
        "| t (s) | x (cm) |\n|---|---|\n" + rows(T, 5 * N, sep=" | ", before="| ", end=" |"), 5, "cm", suffix=".md"
    ),
    "remarks with a rate, one column": Written(
        "# pendulum 7\n# sample rate: 25 Hz\nangle (deg)\n" + rows(20 * N), 20, "deg"
    ),
    "lines of settings above": Written(
        "Operator: N. N.\nMass: 0.2 kg\n\nt [s],phi [deg]\n" + rows(T, 20 * N), 20, "deg"
    ),
    "frames of a video and their rate": Written("# fps: 25\nframe,x (px)\n" + rows(list(range(600)), 200 * N), 200),
    "units after a slash": Written("t/ms;x/cm\n" + rows(1000 * T, 5 * N, sep=";", mark=","), 5, "cm"),
    "units after `in`": Written("t in ms;x in cm\n" + rows(1000 * T, 5 * N, sep=";", mark=","), 5, "cm"),
    "units after a comma": Written('"Time, ms","Position, cm"\n' + rows(1000 * T, 5 * N), 5, "cm"),
    "names and units in each row": Written(
        rows(["time:"] * 600, MS, ["ms, angle:"] * 600, 20 * N, ["deg"] * 600, sep=" "), 20, "deg"
    ),
    "labels that touch their numbers": Written(rows(T, N, before="t:", sep=",x:"), asked="a row for each moment"),
    "numbers with ± in their cells": Written(rows(T, N, sep=";", end="±0.001"), asked="row|numbers"),
    "rows instead of columns": Written(
        "t," + ",".join(map(str, T)) + "\nx," + ",".join(map(str, N)) + "\n", asked="t,x"
    ),
    "commas that group thousands": Written(
        "t (ms),x (um)\n" + "".join(f'"{1000 * t:,.0f}","{5000 * x:,.1f}"\n' for t, x in zip(T, N)), 5000, "um"
    ),
    "apostrophes that group thousands": Written(
        "t (ms);x (um)\n" + "".join(f"{1000 * t:,.0f};{5000 * x:,.1f}\n".replace(",", "'") for t, x in zip(T, N)),
        5000,
        "um",
    ),
    "three decimals everywhere, one of them 0": Written("t;x\n" + rows(T, N, sep=";", mark=",", form="{:.3f}")),
    "three decimals everywhere, none below 1": Written(
        "t\tx\n" + rows(T + 1, 20 * N + 30, sep="\t", form="{:.3f}"), asked="--decimal"
    ),
    "BOM": Written(DEG, 20, "deg", encoding="utf-8-sig"),
    "UTF-16": Written(DEG, 20, "deg", encoding="utf-16"),
    "Latin letters of Windows": Written(DEG.replace("deg", "°"), 20, "deg", encoding="cp1252"),
    "ends of lines of Windows": Written(DEG.replace("\n", "\r\n"), 20, "deg"),
    "ends of lines of old Macs": Written(DEG.replace("\n", "\r"), 20, "deg"),
    # Clocks.
    "times of day past midnight": Written("Time,Angle (deg)\n" + rows(stamps("%H:%M:%S.%f"), 20 * N), 20, "deg"),
    "minutes and seconds": Written(
        "time,angle (deg)\n" + rows([f"{int(t // 60)}:{t % 60:05.2f}" for t in T], 20 * N), 20, "deg"
    ),
    "ISO stamps": Written(
        "timestamp,angle_deg\n" + rows([s + "Z" for s in stamps("%Y-%m-%dT%H:%M:%S.%f", -3)], 20 * N), 20, "deg"
    ),
    "German dates": Written(
        "Zeitstempel;Winkel (Grad)\n" + rows(stamps("%d.%m.%Y %H:%M:%S,%f"), 20 * N, sep=";", mark=","), 20, "deg"
    ),
    "American dates": Written("Timestamp,Angle (deg)\n" + rows(stamps("%m/%d/%Y %I:%M:%S.%f %p"), 20 * N), 20, "deg"),
    "British dates": Written("Timestamp,Angle (deg)\n" + rows(stamps("%d/%m/%Y %H:%M:%S.%f"), 20 * N), 20, "deg"),
    "a column for the date": Written(
        "Date,Time,Angle (deg)\n" + rows(["2024-03-01"] * 600, stamps("%H:%M:%S.%f"), 20 * N), 20, "deg"
    ),
    "milliseconds since 1970": Written(
        "timestamp,angle (deg)\n" + rows([1709290790000 + m for m in MS], 20 * N), 20, "deg"
    ),
    "stamps that come in bursts": Written(
        "time (s),angle (deg)\n" + rows(np.floor(T / 0.4 + 1e-9) * 0.4 + 1e-4 * (np.arange(600) % 10), 20 * N),
        20,
        "deg",
    ),
    "a number of the row, no clock": Written("sample,x\n" + rows(list(range(600)), N), asked="t,x"),
    # Programs and instruments.
    "phyphox, three axes": Written(
        ",".join(["Time (s)", *AXES])
        + "\n"
        + rows(T, 0.05 * A + NOISE, 0.3 * A + NOISE[::-1], 9.81 + NOISE, np.hypot(0.3 * A, 9.81)),
        0.3,
        "m",
    ),
    "Sensor Logger, by the name of the file": Written(
        "time,seconds_elapsed,z,y,x\n"
        + rows([(1709290790000 + m) * 10**6 for m in MS], T, NOISE, NOISE[::-1], 0.3 * V),
        0.3,
        stem="Gyroscope",
    ),
    "Sensor Logger under another name": Written(
        "time,seconds_elapsed,z,y,x\n" + rows(MS, T, NOISE, NOISE[::-1], 0.3 * V), asked="--kind velocity"
    ),
    "Arduino, six axes": Written(
        "millis,ax,ay,az,gx,gy,gz\n" + rows(MS, A, NOISE, 9.8 + NOISE, NOISE, 0.2 * V, NOISE[::-1]), 0.2
    ),
    "Arduino, serial monitor with stamps": Written(
        "".join(f"11:59:{t:06.3f} -> {512 + 400 * x:.2f}\n" for t, x in zip(T, N)), 400
    ),
    "Tracker": Written("mass A\t\t\nt\tx\ty\n" + rows(T, 0.3 * N, 0.01 * N**2 - 1, sep="\t", form="{:.6E}"), 0.3),
    "Logger Pro": Written(
        "Vernier Format 2\nrun.cmbl 3/1/2024\nRun 1\nTime\tPosition\tVelocity\nt\tx\tv\ns\tm\tm/s\n\n"
        + rows(T, 0.3 * N, 0.3 * V, sep="\t"),
        0.3,
        "m",
    ),
    "Graphical Analysis, a force beside": Written(
        "Data Set 1:Time(s),Data Set 1:Force(N),Data Set 1:Position(m)\n" + rows(T, 10 + 3 * N, 0.3 * N), 0.3, "m"
    ),
    "Tektronix, settings above": Written("Model,TBS1052B\nSample Interval,0.04\nTIME,CH1\n" + rows(T, 2 * N), 2),
    "Tektronix, settings beside": Written(
        "".join(f"{a},{b},,{t:.4f},{x:.5f},\n" for (a, b), t, x in zip(TDS + [("", "")] * 596, T - 12, 2 * N)), 2
    ),
    "Rigol": Written(
        "X,CH1,Start,Increment,\nSequence,Volt,-1.2e+01,4.0e-02\n" + rows(list(range(600)), 2 * N, end=",,"), 2
    ),
    "Keysight": Written("x-axis,1\nsecond,Volt\n" + rows(T - 12, 2 * N, form="{:+.8E}"), 2),
    "PicoScope": Written("Time,Channel A\n(ms),(mV)\n\n" + rows(1000 * (T - 12), 2 * N), 2),
    "LabVIEW, lvm": Written(LVM + rows(T, 2 * N, sep="\t", mark=","), 2, suffix=".lvm"),
    # Several columns.
    "an angle beside a place": Written(
        "t (s),angle (rad),x (m),y (m)\n" + rows(T, 0.3 * N, 0.9 * np.sin(0.3 * N), 1 - np.cos(0.3 * N)), 0.3, "rad"
    ),
    "a force beside an acceleration": Written("t (s),a (m/s^2),force (N)\n" + rows(T, 0.3 * A, 10 + 3 * A), 0.3, "m"),
    "a column of zeros": Written("t (s),x (cm),y (cm)\n" + rows(T, 0 * T, 5 * N), 5, "cm"),
    "two oscillators": Written("t (s),x1 (cm),x2 (cm)\n" + rows(T, 5 * N, 3 * OTHER), asked="--columns t=1,x=2"),
    "two oscillators, one said": Written(
        "t (s),x1 (cm),x2 (cm)\n" + rows(T, 5 * N, 3 * OTHER), 5, "cm", how=How(columns="t=1,x=2")
    ),
    "two oscillators, each with a clock": Written(
        "t1,x1,t2,x2\n" + rows(T, N, T + 0.01, OTHER), asked="--columns t=1,x=2"
    ),
    "a step dt beside the clock": Written("t,dt,x\n" + rows(T, 0 * T + 0.04, N)),
    # Peaks and envelopes.
    "peaks of one side": Written(_peaks("t (s),amplitude (deg)", TURNS[::2], 20 * PEAKS[::2]), 20, "deg"),
    "peaks of one side called A": Written(_peaks("t (s),A (cm)", TURNS[::2], 5 * PEAKS[::2]), 5, "cm"),
    "peaks of both sides": Written(_peaks("t (s),x (deg)", TURNS, 20 * PEAKS), 20, "deg"),
    "counted amplitudes": Written(_peaks("n,amplitude (deg)", COUNT, 20 * np.abs(PEAKS)), 20, "deg"),
    "amplitudes of counted cycles": Written(
        _peaks("cycle,A (deg)", COUNT[: len(PEAKS[::2])], 20 * PEAKS[::2]), 20, "deg"
    ),
    "peak to peak": Written(_peaks("t (s),peak-to-peak (mm)", TURNS[::2], 10 * PEAKS[::2]), 5, "mm"),
    **{
        f"errors called {name}": Written(
            _peaks(f"n,t (s),{of_t},x (cm),{of_x}", COUNT, TURNS, 0 * TURNS + 0.001, 5 * PEAKS, 0 * TURNS + 0.01),
            5,
            "cm",
        )
        for name, (of_t, of_x) in ERRORS.items()
    },
    "levels in dB and a frequency": Written(
        f"# f0 = {HERTZ} Hz\nt (s),level (dB)\n" + rows(LATE, LEVEL - 3), 10**-0.15
    ),
    "a power in dBm": Written(f"# Frequency [Hz]: {HERTZ}\nt (s),P (dBm)\n" + rows(LATE, LEVEL - 20), 0.1),
    "volts of a lock-in": Written(f"# frequency: {HERTZ} Hz\nt (s),R (V)\n" + rows(LATE, 10 ** (LEVEL / 20)), 1),
}
