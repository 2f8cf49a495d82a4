"""Files that a library reads: Excel and OpenDocument sheets, parquet, LabVIEW, and arrays of NumPy, MATLAB and HDF5.

Each comes as a data frame with names, or (a sheet) as text for ``layout``; the libraries are extras, and one that is
not there is asked for by name.
"""

import io
import zipfile
from pathlib import Path
from typing import Any

import numpy as np

from asymptotics.errors import InputError

SHEETS = (".xlsx", ".xls", ".ods", ".xlsm")
FRAMES = (".parquet", ".npz", ".npy", ".mat", ".h5", ".hdf5", ".tdms")
_MAX_CELLS = 20_000_000
"""A sheet is held as Python objects, tens of bytes a cell: beyond this it would take the memory of a small machine."""


def sheet_lines(path: Path, sheet: str | None) -> list[str]:
    """The rows of a sheet as lines with tabs; InputError if there are several sheets with numbers and none is named."""
    import pandas  # noqa: PLC0415 (an extra)

    try:
        with pandas.ExcelFile(path) as book:
            names = [str(n) for n in book.sheet_names]
            if sheet is not None and sheet not in names:
                raise InputError("sheet", f"{path.name} has no sheet {sheet[:40]!r}", ", ".join(names)[:200])
            tables = {
                # As objects: a column of numbers with a header would be cast to text or dates.
                n: pandas.read_excel(book, sheet_name=n, header=None, dtype=object)
                for n in ([sheet] if sheet else names)
            }
    except ImportError as error:
        said = f"{path.suffix} files are read by a library that is not installed ({error.name or 'see pandas'})"
        raise InputError("FILE", said, "pip install '.[files]' in a clone, or the table as CSV") from error
    except (ValueError, KeyError, OSError, zipfile.BadZipFile) as error:
        raise InputError("FILE", f"cannot read {path.name}: {error}", "a whole spreadsheet") from error
    # Sheets of remarks and pictures are no candidates.
    filled = {n: t for n, t in tables.items() if _rows_of_numbers(t) >= 2}
    if len(filled) != 1:
        reason = f"{path.name} has {len(filled)} sheets with numbers: {', '.join(filled or names)[:100]}"
        raise InputError("FILE", reason, "--sheet NAME" if filled else "a sheet with a table of numbers")
    table = next(iter(filled.values()))
    return ["\t".join(_text(cell) for cell in row) for row in table.itertuples(index=False)]


def _rows_of_numbers(table: Any) -> int:
    numbers = table.map(lambda c: isinstance(c, int | float) and c == c and not isinstance(c, bool))
    if table.size > _MAX_CELLS:
        raise InputError("FILE", f"the sheet has {table.size} cells", f"at most {_MAX_CELLS}")
    # Without numbers three rows of two cells may still be a table, whose numbers stand as text.
    return int((numbers.sum(axis=1) >= 2).sum()) or int((table.notna().sum(axis=1) >= 2).sum() >= 3)


def _text(cell: Any) -> str:
    if cell is None or cell != cell:
        return ""
    # repr, so that the double comes back as it was.
    return repr(float(cell)) if isinstance(cell, float) else " ".join(str(cell).split())


def frame_of(path: Path) -> Any:
    """The columns of a parquet file, or of the arrays of one length in an npz, npy or mat file, as a data frame."""
    import pandas  # noqa: PLC0415 (an extra)

    try:
        if path.suffix == ".parquet":
            return pandas.read_parquet(path)
        arrays = _arrays(path)
    except ImportError as error:
        said = f"{path.suffix} files are read by a library that is not installed ({error.name})"
        extra = "laboratory" if path.suffix in (".h5", ".hdf5", ".tdms") else "files"
        raise InputError("FILE", said, f"pip install '.[{extra}]' in a clone, or the table as CSV") from error
    # What the libraries raise for a damaged file, and for pickled objects, which are not loaded: they may run code.
    except (OSError, ValueError, KeyError, TypeError, NotImplementedError, zipfile.BadZipFile, EOFError) as error:
        said = " ".join(str(error).split())[:120]
        raise InputError("FILE", f"cannot read {path.name}: {said}", "a whole file without pickled objects") from error
    columns: dict[str, Any] = {}
    for name, values in arrays.items():
        array = np.squeeze(np.asarray(values))
        if array.ndim == 1 and array.dtype.kind in "fiu" and len(array) > 1:
            columns[name] = array.astype(float)
        elif array.ndim == 2 and array.dtype.kind in "fiu":
            # A decay has more rows than columns, whichever way the array was written.
            tall = array if array.shape[0] >= array.shape[1] else array.T
            columns |= {f"column {i + 1}" if len(arrays) == 1 else f"{name} {i + 1}": tall[:, i].astype(float)
                        for i in range(tall.shape[1])}  # fmt: skip
    lengths = {len(v) for v in columns.values()}
    if len(lengths) != 1:
        listed = ", ".join(f"{n} ({len(v)})" for n, v in columns.items())[:150]
        raise InputError("FILE", f"{path.name} holds arrays of {len(lengths)} lengths: {listed}", "one length for all")
    return pandas.DataFrame(columns)


def _arrays(path: Path) -> dict[str, Any]:
    if path.suffix == ".mat":
        from scipy.io import loadmat  # noqa: PLC0415 (slow to load, for one format)

        # From memory, so that scipy adds no .mat to the name and looks for no other file.
        found = loadmat(io.BytesIO(path.read_bytes()), struct_as_record=True)
        return {k: v for k, v in found.items() if not k.startswith("__")}
    if path.suffix in (".h5", ".hdf5"):
        return _hdf5(path)
    if path.suffix == ".tdms":
        return _tdms(path)
    loaded = np.load(path, allow_pickle=False)
    return {"column": loaded} if path.suffix == ".npy" else {k: loaded[k] for k in loaded.files}


def _hdf5(path: Path) -> dict[str, Any]:
    """The data sets of numbers, by the last part of their name where that is one's own."""
    import h5py  # noqa: PLC0415 (an extra)

    found: dict[str, Any] = {}
    with h5py.File(path, "r") as file:
        file.visititems(
            lambda name, item: found.update({name: item[()]}) if isinstance(item, h5py.Dataset) and item.ndim else None
        )
    return _short(found)


def _tdms(path: Path) -> dict[str, Any]:
    """The channels, and the clock of a wave form where its channels carry one instead of a column of times."""
    from nptdms import TdmsFile  # noqa: PLC0415 (an extra)

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
