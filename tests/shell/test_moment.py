"""The command moment."""

from tests.shell.answers import answer


def test_moment(capsys):
    assert answer(capsys, "moment --p 3 --digits 10")["exact"] == "4/(3*pi)"
    assert answer(capsys, "moment --p 4")["value"].rstrip("0") == "0.375"
    assert answer(capsys, "moment --p -1/2 --digits 6")["value"] == "1.66925"  # 3.625610/(1.772454 * 1.225417)
    assert answer(capsys, "moment --p sqrt(2)")["p"] == "sqrt(2)"
