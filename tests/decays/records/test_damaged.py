"""Files that are damaged, that claim more than they hold, whose suffix is in capitals, whose name is too long."""

import random
import zipfile

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.records import sizes
from asymptotics.decays.records.table import read_table
from asymptotics.errors import InputError, LimitError
from asymptotics.shell.main import main

T = np.arange(0, 30, 0.02)
X = np.exp(-0.02 * T) * np.cos(5 * T)


def _npz(path):
    np.savez_compressed(path, t=T, x=X)


def _npy(path):
    np.save(path, np.column_stack([T, X]))


def _mat(path):
    from scipy.io import savemat  # noqa: PLC0415

    savemat(path, {"t": T, "x": X, "about": {"who": "me"}, "names": np.array(["a", "b"], dtype=object)})


def _matz(path):
    from scipy.io import savemat  # noqa: PLC0415

    savemat(path, {"t": T, "x": X}, do_compression=True)


def _h5(path):
    h5py = pytest.importorskip("h5py")
    with h5py.File(path, "w") as file:
        file["t"], file["x"], file["names"] = T, X, [b"a", b"b"]


def _tdms(path):
    nptdms = pytest.importorskip("nptdms")
    with nptdms.TdmsWriter(path) as file:
        file.write_segment([nptdms.ChannelObject("run", "time (s)", T), nptdms.ChannelObject("run", "x (m)", X)])


def _parquet(path):
    _frame().to_parquet(path)


def _xlsx(path):
    pytest.importorskip("openpyxl")
    _frame().head(200).to_excel(path, index=False)


def _frame():
    return pytest.importorskip("pandas").DataFrame({"time (s)": T, "x (m)": X})


def _ole(path):
    """The head of an OLE file, the container of old spreadsheets, and nothing that it promises."""
    pytest.importorskip("xlrd")
    path.write_bytes(bytes.fromhex("d0cf11e0a1b11ae1") + bytes(16) + b"\x3e\0\x03\0\xfe\xff\x09\0" + bytes(480) * 3)


FORMATS = {
    "a.npz": _npz, "a.npy": _npy, "a.mat": _mat, "z.mat": _matz, "a.h5": _h5, "a.tdms": _tdms, "a.parquet": _parquet,
    "a.xlsx": _xlsx, "a.xls": _ole,
}  # fmt: skip


def damaged(data, seed):
    """Cut, overwritten in places, or with a stretch of another value: what disks, mails and interrupts leave."""
    chance, made = random.Random(seed), bytearray(data)
    kind = seed % 4
    if kind == 0:
        return bytes(made[: chance.randrange(len(made))])
    if kind == 1:
        for _ in range(chance.choice([1, 3, 30])):
            made[chance.randrange(len(made))] = chance.randrange(256)
        return bytes(made)
    low = chance.randrange(min(len(made), 400) if kind == 2 else len(made))  # the head decides most
    high = min(len(made), low + chance.choice([1, 4, 60]))
    made[low:high] = bytes([chance.choice([0, 255, 65])]) * (high - low)
    return bytes(made)


@pytest.mark.filterwarnings("ignore")  # of the libraries, about what they find
@pytest.mark.parametrize("name", FORMATS)
def test_a_damaged_file_is_read_or_refused(name, tmp_path):
    """Failed before by SyntaxError, AssertionError, struct.error, RuntimeError and others, which no list had."""
    path = tmp_path / name
    FORMATS[name](path)
    whole, refused = path.read_bytes(), 0
    for seed in range(60):
        path.write_bytes(damaged(whole, seed))
        try:
            read_table(path)
        except InputError as error:
            assert "unsafe" not in str(error)
            refused += 1
    assert refused >= 15


@pytest.mark.parametrize(
    "kind", [SyntaxError, AssertionError, RuntimeError, AttributeError, IndexError, RecursionError]
)
@pytest.mark.parametrize("name", ["a.npz", "a.mat", "a.h5", "a.parquet", "a.xlsx", "a.tdms"])
def test_whatever_a_library_raises_is_a_refusal_of_the_file(name, kind, tmp_path, monkeypatch):
    path = tmp_path / name
    FORMATS[name](path)

    def broken(*_, **__):
        raise kind("of a library")

    places = {
        "npz": "numpy.load", "mat": "scipy.io.loadmat", "h5": "h5py.File.visititems", "tdms": "nptdms.TdmsFile.read",
        "parquet": "pandas.read_parquet", "xlsx": "pandas.read_excel",
    }  # fmt: skip
    monkeypatch.setattr(places[path.suffix[1:]], broken)
    with pytest.raises(InputError, match=f"cannot read {name}: of a library"):
        read_table(path)


def test_memory_that_is_not_there_is_no_fault_of_the_file(tmp_path, monkeypatch):
    _npz(tmp_path / "a.npz")

    def full(*_, **__):
        raise MemoryError

    monkeypatch.setattr("numpy.load", full)
    with pytest.raises(MemoryError):
        read_table(tmp_path / "a.npz")


@pytest.mark.parametrize("name", [name for name in FORMATS if name != "a.xls"])
def test_suffixes_in_capitals_are_the_same(name, tmp_path):
    """Failed before: .MAT and .H5 were refused as pickled objects, with the advice to load them unsafely."""
    small, large = tmp_path / name, tmp_path / name.upper()
    FORMATS[name](small)
    large.write_bytes(small.read_bytes())
    assert np.array_equal(read_table(large).columns["x"], read_table(small).columns["x"])


def _far_cell(path):
    openpyxl = pytest.importorskip("openpyxl")
    book = openpyxl.Workbook()
    for i in range(40):
        book.active.append([i / 10, 1 / (1 + i)])
    book.active["XFD1048576"] = 1
    book.save(path)


def _claims_of_h5(path):
    h5py = pytest.importorskip("h5py")
    with h5py.File(path, "w") as file:
        file.create_dataset("x", shape=(64 * 10**9,), dtype="f8", chunks=(1 << 20,))


def _claims_of_npz(path):
    head = "{'descr': '<f8', 'fortran_order': False, 'shape': (64000000000,), }".ljust(117) + "\n"
    data = b"\x93NUMPY\x01\x00" + len(head).to_bytes(2, "little") + head.encode()
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("x.npy", data)


def _claims_of_npy(path):
    _claims_of_npz(path.with_suffix(".zip"))
    with zipfile.ZipFile(path.with_suffix(".zip")) as archive:
        path.write_bytes(archive.read("x.npy"))


def _repeated_rows(path):
    table = "urn:oasis:names:tc:opendocument:xmlns:table:1.0"
    rows = '<t:table-row t:number-rows-repeated="1000000"><t:table-cell t:number-columns-repeated="900"><p>1</p>'
    with zipfile.ZipFile(path, "w") as archive:
        archive.writestr("content.xml", f'<t:table xmlns:t="{table}">{rows}</t:table-cell></t:table-row></t:table>')


def _repeated_values(path):
    pandas = pytest.importorskip("pandas")
    ones = np.ones(20_000)
    pandas.DataFrame({f"x{i}": ones for i in range(60)}).to_parquet(path, compression="zstd")


def _zeros_of_mat(path):
    from scipy.io import savemat  # noqa: PLC0415

    savemat(path, {"x": np.zeros(2_000_000)}, do_compression=True)


CLAIMS = {
    "far.xlsx": _far_cell, "claims.h5": _claims_of_h5, "claims.npz": _claims_of_npz, "claims.npy": _claims_of_npy,
    "rows.ods": _repeated_rows, "ones.parquet": _repeated_values, "zeros.mat": _zeros_of_mat,
}  # fmt: skip


@pytest.mark.parametrize("name", CLAIMS)
def test_the_size_is_asked_before_anything_is_read(name, tmp_path, monkeypatch):
    """Kilobytes that claim gigabytes: failed before by the end of the memory, or of the time."""
    path = tmp_path / name
    CLAIMS[name](path)
    if name in ("zeros.mat", "ones.parquet"):
        monkeypatch.setattr(sizes, "MAX_VALUES", 1_000_000)
    for reader in ("numpy.load", "scipy.io.loadmat", "pandas.read_parquet", "pandas.ExcelFile"):
        monkeypatch.setattr(reader, None)
    with pytest.raises(LimitError, match="claims .* values|has a sheet of .* cells"):
        read_table(path)


def test_a_sheet_that_ends_with_a_million_empty_rows_is_small(tmp_path):
    table, path = "urn:oasis:names:tc:opendocument:xmlns:table:1.0", tmp_path / "a.ods"
    filled = '<t:table-row><t:table-cell><p>1</p></t:table-cell><t:table-cell t:number-columns-repeated="16383"/>'
    empty = '<t:table-row t:number-rows-repeated="1048575"><t:table-cell t:number-columns-repeated="16384"/>'
    with zipfile.ZipFile(path, "w") as archive:
        rows = "".join(f"{row}</t:table-row>" for row in (filled, empty))
        archive.writestr("content.xml", f'<t:table xmlns:t="{table}">{rows}</t:table>')
    assert sizes.cells_of_sheet(path) == 1


@pytest.mark.parametrize("suffix", [".csv", ".xlsx", ".npz", ".h5", ".json", ".parquet"])
def test_a_name_that_is_too_long_is_refused(suffix, capsys):
    name = "a" * 300 + suffix
    with pytest.raises(InputError, match="cannot read"):
        asy.identify(name)
    law = ["--alpha", "2", "--epsilon", "1"]
    for words in (["identify", name], ["compare", name, *law], ["damping", "--from", name]):
        assert main(words) == 2
        assert "cannot read aaa" in capsys.readouterr().err
    assert main(["compare", name]) == 2
    assert "fault" not in capsys.readouterr().err
