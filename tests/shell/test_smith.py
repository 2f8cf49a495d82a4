"""The command smith: rational coefficients, radii, closed forms."""

from tests.shell.test_cli import answer


def test_smith(capsys):
    assert answer(capsys, "smith", "f", "--n", "7")["coefficients"] == {
        "0": "-1/7", "2": "272/189", "4": "-1856/1155", "6": "1024/3003"  # (60g)
    }  # fmt: skip
    assert answer(capsys, "smith", "c", "--n", "4", "--i", "3")["value"] == "16/35"  # (60d)
    zero = answer(capsys, "smith", "c", "--n", "4", "--i", "2")
    assert zero["value"] == "0"
    assert "parity" in zero["note"]
    radii = answer(capsys, "smith", "r", "--w", "1/2", "--digits", "8")
    assert 0 < float(radii["rho"]) <= float(radii["R"]) < 1 and radii["certified"] is True
    g = answer(capsys, "smith", "g", "--i", "0")
    assert (g["expression"], g["limit"]) == ("atan(z)", "pi")
