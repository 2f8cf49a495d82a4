"""What Coq proves of certificates: compiled where it is installed, and never left out by mistake."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

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


@pytest.mark.slow
@pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed")
def test_the_proofs_compile_and_rest_on_the_axioms_of_the_real_numbers():
    ran = subprocess.run(["make", "proofs"], cwd=ROOT, capture_output=True, text=True)
    assert ran.returncode == 0, ran.stderr[-2000:]
    axioms = re.findall(r"^(?:[A-Za-z_]+\.)*(\w+)(?: :|\n  :)", ran.stdout, re.MULTILINE)
    assert axioms and set(axioms) <= AXIOMS, set(axioms) - AXIOMS


def test_without_coq_it_says_so():
    ran = subprocess.run(["make", "proofs", "COQC=no-coq-here"], cwd=ROOT, capture_output=True, text=True)
    assert ran.returncode == 0 and "is not installed" in ran.stdout
