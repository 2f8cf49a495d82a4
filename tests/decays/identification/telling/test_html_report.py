"""The page of an identification: whole, escaped, fetching nothing."""

import re
from xml.etree import ElementTree

import asymptotics as asy
from asymptotics.decays.identification.synthetic import observed
from asymptotics.decays.identification.telling.html_report import html_report
from asymptotics.shell.main import main


def test_the_page_is_whole_escapes_what_it_was_given_and_fetches_nothing(tmp_path):
    data = tmp_path / "<script>alert(1)</script>&.csv".replace("/", "_")
    seen = observed("1+2", [0.01, 0.02], 40, 1e-3, seed=1)
    data.write_text("n,x_mm\n" + "\n".join(f"{n},{x:.6f}" for n, x in zip(seen.n, seen.x)))
    page = tmp_path / "page.html"
    line = ["identify", str(data), "--laws", "1", "1+2", "--no-bootstrap", "--html", str(page)]
    assert main(line) == 0
    text = page.read_text()
    assert ElementTree.fromstring(text).tag == "html"  # well formed
    assert text.count("<svg") == 1
    assert not re.search(
        r"<script|<link|src=|@import|https?://(?!www\.w3\.org|purl\.org|creativecommons|matplotlib)", text
    )
    assert "&lt;script&gt;alert(1)&lt;_script&gt;&amp;.csv" in text
    for wanted in (
        "identified: 1+2",
        "ΔAICc",
        "SHA-256",
        "Froude",
        "41 turning points without times",
        "no_bootstrap: True",
    ):
        assert wanted in text, wanted
    assert main([*line[:-1], str(tmp_path / "page.txt")]) == 2
    assert main([*line[:-1], str(data)]) == 2


def test_a_page_of_printed_decrements_says_why_it_has_no_picture():
    table = {"amplitude": [1.0, 0.8, 0.6], "decrement": [0.1, 0.06, 0.04], "resolution": [0.005] * 3}
    text = html_report(asy.identify(table, laws=["1", "2"]))
    assert "No picture: there is no single run of turning points to draw" in text
    assert "3 decrements, mean amplitudes from 1 to 0.6" in text
