"""What Coq proves of certificates: compiled where it is installed, and never left out by mistake."""

import re
import shutil
import subprocess
from pathlib import Path
from runpy import run_path

import pytest

NO_COQ = shutil.which("coqc") is None or shutil.which("make") is None
ROOT = Path(__file__).parents[2]
COQ = ROOT / "derivations" / "coq"
AXIOMS = {"sig_not_dec", "sig_forall_dec", "functional_extensionality_dep", "classic"}
"""Of the real numbers of Coq's library, of functions, and of the excluded middle: nothing of ours."""


def test_every_proof_is_in_the_order_and_says_its_axioms():
    order = (COQ / "order.txt").read_text().split()
    assert sorted(order) == sorted(path.name for path in COQ.glob("*.v"))
    for name in order:
        text = (COQ / name).read_text()
        assert "Print Assumptions" in text
        assert not re.search(r"\b(Admitted|admit|Axiom|Parameter|Conjecture)\b", text), name


def test_the_instance_is_that_of_the_certificate():
    """Its coefficients and digits are the library's, as ``write_instance`` writes them."""
    written = run_path(str(COQ / "write_instance.py"))
    text = (COQ / "first_turning_point.v").read_text()
    assert text == written["text"](), "python derivations/coq/write_instance.py writes it again"
    claim = written["made"]().content[0]["claims"][1]
    assert f"Rabs (x z - ({claim['x']})) <= 5e-11 /\\ Rabs (z - {claim['t']}) <= 5e-10" in text
    assert (len(claim["x"].lstrip("-0.")), len(claim["t"].replace(".", ""))) == (10, 10)


@pytest.mark.slow
@pytest.mark.skipif(NO_COQ, reason="coqc or make is not installed")
def test_a_wrong_digit_or_coefficient_is_not_proved(tmp_path):
    for name in ("defect_bound.v", "landing.v", "polynomials.v", "half_swing.v"):
        shutil.copy(COQ / name, tmp_path)
        subprocess.run(["coqc", "-w", "none", name], cwd=tmp_path, check=True, capture_output=True)
    text = (COQ / "first_turning_point.v").read_text()
    wrong_digit = text.replace("-0.8994749838", "-0.8994749839").replace(
        "(-4497374919) # 5000000000", "(-8994749839) # 10000000000"
    )
    wrong_law = text.replace("(-154572546410610163712)", "(-154572546510610163712)")
    for wrong in (wrong_digit, wrong_law):
        assert wrong != text
        (tmp_path / "wrong.v").write_text(wrong)
        ran = subprocess.run(["coqc", "-w", "none", "wrong.v"], cwd=tmp_path, capture_output=True, text=True)
        assert ran.returncode != 0 and "Unable to unify" in ran.stderr


@pytest.mark.slow
@pytest.mark.skipif(NO_COQ, reason="coqc or make is not installed")
def test_the_proofs_compile_and_rest_on_the_axioms_of_the_real_numbers():
    ran = subprocess.run(["make", "proofs"], cwd=ROOT, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr[-2000:]
    axioms = re.findall(r"^(?:[A-Za-z_]+\.)*(\w+)(?: :|\n  :)", ran.stdout, re.MULTILINE)
    assert axioms and set(axioms) <= AXIOMS, set(axioms) - AXIOMS


@pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")
def test_without_coq_it_says_so():
    ran = subprocess.run(["make", "proofs", "COQC=no-coq-here"], cwd=ROOT, capture_output=True, text=True)
    assert ran.returncode == 0 and "is not installed" in ran.stdout
