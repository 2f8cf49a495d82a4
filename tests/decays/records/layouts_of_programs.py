"""Files that programs write and no editor shows: JSON, MATLAB, NumPy, spreadsheets, parquet, sounds, TDMS, HDF5."""

import json
from importlib import import_module

import numpy as np

from tests.decays.records.layouts import N, T, Written, stamps


def _mat(**variables):
    return lambda path: import_module("scipy.io").savemat(path, variables)


def _npz(*arrays, **named):
    return lambda path: np.savez(path, *arrays, **named)


def _array(values):
    return lambda path: np.save(path, values)


def _wav(values):
    return lambda path: import_module("scipy.io.wavfile").write(path, 25, values.astype(np.int16))


def _hdf5(head=b""):
    def write(path):
        # MATLAB writes a block of its own before the file of HDF5.
        with import_module("h5py").File(path, "w", **({"userblock_size": 512} if head else {})) as file:
            file["run/t"], file["run/x"] = T[None], N[None]
        with path.open("r+b") as stream:
            stream.write(head)

    return write


def _tdms(path):
    nptdms = import_module("nptdms")
    with nptdms.TdmsWriter(path) as file:
        clock = {"wf_increment": 0.04, "wf_start_offset": 0.0}
        file.write_segment([nptdms.ChannelObject("run", "angle (deg)", 20 * N, properties=clock)])


def _frame(**columns):
    return import_module("pandas").DataFrame(columns)


def _sheets(**sheets):
    def write(path):
        with import_module("pandas").ExcelWriter(path) as book:
            for name, (frame, where) in sheets.items():
                frame.to_excel(book, sheet_name=name, index=False, **where)

    return write


def _dates(path):
    dates = import_module("pandas").to_datetime(stamps("%Y-%m-%dT%H:%M:%S.%f"))
    _sheets(run=(_frame(time=dates, **{"x (cm)": 5 * N}), {}))(path)


def _parquet(path):
    _frame(**{"x (cm)": 5 * N}).set_axis(T, axis="index").rename_axis("t (s)").to_parquet(path)


ROWS = [{"time_s": t, "angle_deg": x} for t, x in zip(T.tolist(), (20 * N).tolist())]
LISTS = {"meta": {"who": "N. N."}, "data": {"t": T.tolist(), "x": N.tolist()}}
MEASURED = _frame(**{"t (s)": T, "x (cm)": 5 * N})
RESULTS = _frame(n=range(9), A=range(9))
STRUCT = {"run": {"out": {"time": T, "angle": N}, "note": "a", "peaks": np.arange(7.0)}}
FILES = {
    "JSON, a list for each column": Written(json.dumps(LISTS), suffix=".json"),
    "JSON, an object for each row": Written(json.dumps(ROWS), 20, "deg", suffix=".json"),
    "JSON, an object in each line": Written("\n".join(map(json.dumps, ROWS)), 20, "deg", suffix=".jsonl"),
    "JSON, samples and a rate": Written(json.dumps({"sample_rate": 25, "x": N.tolist()}), suffix=".json"),
    "MATLAB, structs within structs": Written(_mat(**STRUCT), suffix=".mat"),
    "MATLAB, samples and fs": Written(_mat(y=N, fs=25.0), suffix=".mat"),
    "MATLAB, version 7.3": Written(_hdf5(b"MATLAB 7.3 MAT-file"), suffix=".mat"),
    "NumPy, arrays with names": Written(_npz(t=T, x=N), suffix=".npz"),
    "NumPy, arrays without names": Written(_npz(T, N), suffix=".npz"),
    "NumPy, one array of two columns": Written(_array(np.column_stack([T, N])), suffix=".npy"),
    "NumPy, one array of two rows": Written(_array(np.stack([T, N])), suffix=".npy"),
    "NumPy, a structured array": Written(_array(np.rec.fromarrays([T, N], names="t,x")), suffix=".npy"),
    "NumPy, samples alone": Written(_array(N), asked="--rate", suffix=".npy"),
    "a workbook with results and raw data": Written(
        _sheets(Results=(RESULTS, {}), Raw=(MEASURED, {})), 5, "cm", suffix=".xlsx"),
    "a workbook with two runs": Written(
        _sheets(a=(MEASURED, {}), b=(MEASURED, {})), asked="--sheet", suffix=".xlsx"),
    "a table in the middle of a sheet": Written(
        _sheets(a=(MEASURED, {"startrow": 4, "startcol": 2})), 5, "cm", suffix=".xlsx"),
    "dates of a spreadsheet": Written(_dates, 5, "cm", suffix=".xlsx"),
    "parquet, the time as index": Written(_parquet, 5, "cm", suffix=".parquet"),
    "a sound": Written(_wav(30_000 * N), 30_000, suffix=".wav"),
    "a sound of two channels": Written(
        _wav(np.stack([0 * N, 30_000 * N], axis=1)), 30_000, suffix=".wav"),
    "TDMS with the clock of a wave form": Written(_tdms, 20, "deg", suffix=".tdms"),
    "HDF5": Written(_hdf5(), suffix=".h5"),
}  # fmt: skip
