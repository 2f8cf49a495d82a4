"""Files that a library reads: Excel and OpenDocument sheets, parquet, LabVIEW, and arrays of NumPy, MATLAB and HDF5.

Each comes as a data frame with names, or (a sheet) as text for ``layout``; the libraries are extras, and one that is
not there is asked for by name.
"""

import io
from collections.abc import Iterator
from contextlib import contextmanager
from datetime import datetime, time
from importlib import import_module
from math import isfinite
from pathlib import Path
from typing import Any

import numpy as np

from asymptotics.decays.records.cells import number
from asymptotics.decays.records.columns import quantity
from asymptotics.decays.records.json_columns import arrays_of_json
from asymptotics.decays.records.rates import rate_in
from asymptotics.decays.records.sizes import (
    MAX_CELLS,
    readable_of_mat,
    require_few_values,
    require_small_arrays,
    require_small_sheet,
)
from asymptotics.decays.records.stamps import is_stamp
from asymptotics.errors import InputError

SHEETS = (".xlsx", ".xls", ".ods", ".xlsm")
_SAMPLES, _TIMES = 50, 8
"""Rows that a sheet of samples has at least, and in how many times more than any other, to be taken unasked."""
FRAMES = (".parquet", ".npz", ".npy", ".mat", ".h5", ".hdf5", ".tdms", ".json", ".jsonl", ".wav")


@contextmanager
def _reading(path: Path, extra: str, accepted: str) -> Iterator[None]:
    """Whatever a library raises inside is a refusal of the file: what a damaged one makes of it nobody can list."""
    try:
        yield
    except (InputError, MemoryError):  # ours, and what is no fault of the file
        raise
    except ImportError as error:
        said = f"{_suffix(path)} files are read by a library that is not installed ({error.name or 'see pandas'})"
        raise InputError("FILE", said, f"pip install '.[{extra}]' in a clone, or the table as CSV") from error
    except Exception as error:
        said = " ".join(str(error).split())[:120] or type(error).__name__
        raise InputError("FILE", f"cannot read {path.name}: {said}", accepted) from error


def _suffix(path: Path) -> str:
    """What says the format, in small letters: instruments and old systems write it in capitals."""
    return path.suffix.lower()


def sheet_lines(path: Path, sheet: str | None) -> tuple[list[str], tuple[str, ...]]:
    """The rows of a sheet as lines with tabs, and which one it is where there are several; InputError if several may be
    the data and none is named."""
    import pandas  # noqa: PLC0415 (an extra)

    with _reading(path, "files", "a whole spreadsheet"):
        require_small_sheet(path)
        with pandas.ExcelFile(path) as book:
            names = [str(n) for n in book.sheet_names]
            if sheet is not None and sheet not in names:
                raise InputError("sheet", f"{path.name} has no sheet {sheet[:40]!r}", ", ".join(names)[:200])
            tables = {
                # As objects: a column of numbers with a header would be cast to text or dates.
                n: pandas.read_excel(book, sheet_name=n, header=None, dtype=object)
                for n in ([sheet] if sheet else names)
            }
    # Sheets of remarks and pictures are no candidates.
    rows = {n: _rows_of_numbers(t) for n, t in tables.items()}
    filled = {n: t for n, t in tables.items() if rows[n] >= 2}
    told: tuple[str, ...] = ()
    # A sheet of samples has many times the rows of one with results.
    longest = sorted(filled, key=lambda n: -rows[n])[:2]
    if len(longest) == 2 and rows[longest[0]] >= max(_SAMPLES, _TIMES * rows[longest[1]]):
        told = (f"of {len(filled)} sheets with numbers the longest, {longest[0]!r}: --sheet overrules",)
        filled = {longest[0]: filled[longest[0]]}
    if len(filled) != 1:
        reason = f"{path.name} has {len(filled)} sheets with numbers: {', '.join(filled or names)[:100]}"
        raise InputError("FILE", reason, "--sheet NAME" if filled else "a sheet with a table of numbers")
    table = next(iter(filled.values()))
    return ["\t".join(_text(cell) for cell in row) for row in table.itertuples(index=False)], told


def _rows_of_numbers(table: Any) -> int:
    if table.size > MAX_CELLS:
        raise InputError("FILE", f"the sheet has {table.size} cells", f"at most {MAX_CELLS}")
    return int((table.map(_is_a_number).sum(axis=1) >= 2).sum())


def _is_a_number(cell: Any) -> bool:
    """A number, a time, or a text that is one of them."""
    if isinstance(cell, str):
        values = [number(cell, mark) for mark in ",."]
        return is_stamp(cell) or any(value is not None and isfinite(value) for value in values)
    return isinstance(cell, int | float | datetime | time) and cell == cell and not isinstance(cell, bool)


def _text(cell: Any) -> str:
    if cell is None or cell != cell:
        return ""
    # repr, so that the double comes back as it was.
    return repr(float(cell)) if isinstance(cell, float) else " ".join(str(cell).split())


def frame_of(path: Path) -> Any:
    """The columns of a parquet file, or of the arrays of one length in an npz, npy or mat file, as a data frame."""
    import pandas  # noqa: PLC0415 (an extra)

    extra = "laboratory" if _suffix(path) in (".h5", ".hdf5", ".tdms", ".mat") else "files"
    # Pickled objects are not loaded: they may run code.
    with _reading(path, extra, "a whole file without pickled objects"):
        if _suffix(path) == ".parquet":
            return _parquet(path)
        arrays = _arrays(path)
    columns: dict[str, Any] = {}
    for name, values in arrays.items():
        array = np.squeeze(np.asarray(values)) if not isinstance(values, str | list | None) else np.array(None)
        if array.ndim == 1 and array.dtype.kind in "fiu" and len(array) > 1:
            columns[name] = array.astype(float)
        elif array.ndim == 2 and array.dtype.kind in "fiu":
            # A decay has more rows than columns, whichever way the array was written.
            tall = array if array.shape[0] >= array.shape[1] else array.T
            columns |= {f"column {i + 1}" if len(arrays) == 1 else f"{name} {i + 1}": tall[:, i].astype(float)
                        for i in range(tall.shape[1])}  # fmt: skip
    columns = _of_one_length(columns)
    lengths = {len(v) for v in columns.values()}
    if len(lengths) != 1:
        listed = ", ".join(f"{n} ({len(v)})" for n, v in columns.items())[:150]
        raise InputError("FILE", f"{path.name} holds arrays of {len(lengths)} lengths: {listed}", "one length for all")
    frame = pandas.DataFrame(columns)
    # A rate beside the samples, as 1 x 1 arrays or scalars: the clock where there is no column of times.
    said = [f"{name} = {float(np.squeeze(v))!r}" for name, v in arrays.items() if np.size(v) == 1 and _is_number(v)]
    frame.attrs["rate"] = rate_in([line.rpartition("/")[2] for line in said])
    return frame


def _is_number(value: Any) -> bool:
    return np.asarray(value).dtype.kind in "fiu"


def _of_one_length(columns: dict[str, Any]) -> dict[str, Any]:
    """Of arrays of several lengths those as long as the only column of times, if something is measured beside it."""
    times = {len(v) for name, v in columns.items() if quantity(name) == "time"}
    kept = {name: v for name, v in columns.items() if len(v) in times}
    return kept if len(times) == 1 and len(kept) > 1 else columns


def _arrays(path: Path) -> dict[str, Any]:
    if _suffix(path) == ".mat":
        return _mat(path)
    if _suffix(path) in (".h5", ".hdf5"):
        return _hdf5(path)
    if _suffix(path) == ".tdms":
        return _tdms(path)
    if _suffix(path) == ".wav":
        return _wav(path)
    if _suffix(path) in (".json", ".jsonl"):
        return _short(arrays_of_json(path))
    require_small_arrays(path)
    loaded = np.load(path, allow_pickle=False)
    if _suffix(path) == ".npz":
        return {k: loaded[k] for k in loaded.files}
    # A structured array holds columns with names.
    return {"column": loaded} if loaded.dtype.names is None else {k: loaded[k] for k in loaded.dtype.names}


def _wav(path: Path) -> dict[str, Any]:
    """The channels of a sound, and their rate."""
    from scipy.io import wavfile  # noqa: PLC0415 (slow to load, for one format)

    require_few_values([(path.stat().st_size,)], path.name)
    rate, samples = wavfile.read(path)
    return {"channel": samples.astype(float), "sample_rate": float(rate)}


def _parquet(path: Path) -> Any:
    import pandas  # noqa: PLC0415 (an extra)

    # By its name, as ``sweeps.export`` has it: an extra, without types.
    said = import_module("pyarrow.parquet").read_metadata(path)
    require_few_values([(said.num_rows, said.num_columns)], path.name)
    return pandas.read_parquet(path)


def _mat(path: Path) -> dict[str, Any]:
    """The variables and the fields of structs; what is no array of numbers is not read, and stands as None."""
    from scipy.io import loadmat  # noqa: PLC0415 (slow to load, for one format)

    # From memory, so that scipy adds no .mat to the name and looks for no other file.
    data = path.read_bytes()
    # Version 7.3 is HDF5 under another name.
    if data.startswith((b"MATLAB 7.3", b"\x89HDF")):
        return _hdf5(path)
    variables = readable_of_mat(data, path.name)
    wanted = [name for name, readable in variables if readable]
    found = loadmat(io.BytesIO(data), variable_names=wanted, simplify_cells=True) if wanted else {}
    return _short(flattened({name: found.get(name) for name, _ in variables}))


def flattened(found: dict[str, Any], before: str = "") -> dict[str, Any]:
    """The fields of structs within structs under their paths.

    >>> flattened({"Run": {"Out": {"Time": [0, 1]}, "Note": "a"}, "fs": 100})
    {'Run/Out/Time': [0, 1], 'Run/Note': 'a', 'fs': 100}
    """
    flat: dict[str, Any] = {}
    for name, value in found.items():
        # Structs in an array or a cell are numbered.
        listed = isinstance(value, list) or (isinstance(value, np.ndarray) and value.dtype.kind == "O")
        inner = {str(i + 1): v for i, v in enumerate(value)} if listed and not _is_plain(value) else value
        flat |= flattened(inner, f"{before}{name}/") if isinstance(inner, dict) else {before + name: value}
    return flat


def _is_plain(values: Any) -> bool:
    return not any(isinstance(value, dict | np.ndarray) for value in values)


def _hdf5(path: Path) -> dict[str, Any]:
    """The data sets of numbers, by the last part of their name where that is one's own."""
    import h5py  # noqa: PLC0415 (an extra)

    sets: dict[str, Any] = {}
    with h5py.File(path, "r") as file:
        file.visititems(
            lambda name, item: sets.update({name: item}) if isinstance(item, h5py.Dataset) and item.ndim else None
        )
        numeric = {name for name, item in sets.items() if item.dtype.kind in "fiu"}
        require_few_values([sets[name].shape for name in numeric], path.name)
        return _short({name: item[()] if name in numeric else None for name, item in sets.items()})


def _tdms(path: Path) -> dict[str, Any]:
    """The channels, and the clock of a wave form where its channels carry one instead of a column of times."""
    from nptdms import TdmsFile  # noqa: PLC0415 (an extra)

    said = TdmsFile.read_metadata(path)
    require_few_values([(len(channel),) for group in said.groups() for channel in group.channels()], path.name)
    channels = [channel for group in TdmsFile.read(path).groups() for channel in group.channels()]
    found = {f"{c.group_name}/{c.name}": c[:] for c in channels}
    clocks = {tuple(c.time_track()) for c in channels if "wf_increment" in c.properties}
    # Channels with different clocks have no common column of times.
    if len(clocks) == 1:
        found = {"Time (s)": np.array(next(iter(clocks)))} | found
    return _short(found)


def _short(found: dict[str, Any]) -> dict[str, Any]:
    """Without the folders of the names, where that leaves them different."""
    names = [name.rpartition("/")[2] if "(s)" not in name else name for name in found]
    return dict(zip(names, found.values())) if len(set(names)) == len(names) else found
