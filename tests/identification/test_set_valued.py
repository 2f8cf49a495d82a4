"""Printed decrements: the certified set holds the truth, is not much larger than it must be, and can be empty."""

import json

import numpy as np
import pytest
from flint import arb, ctx

import asymptotics as asy
from asymptotics.cli.main import main
from asymptotics.errors import UndecidedError
from asymptotics.identification.certified_ratio import CertifiedRatio
from asymptotics.identification.coefficients import loss
from asymptotics.identification.printed import DecrementModel, Decrements
from asymptotics.identification.set_valued import strengths_that_fit
from asymptotics.identification.swing import Swing
from asymptotics.numbers.exact import parse_real


def exponents(law):
    return tuple(parse_real(a, "alpha") for a in law.split(","))


def printed(law, strengths, digits, rows=12):
    a = np.round(np.linspace(1.0, 0.3, rows), 4)
    model = DecrementModel(Swing([loss(float(x)) for x in law.split(",")]), Decrements(a, a))
    D = model.predict(np.array(strengths, dtype=float))[0]  # the reference amplitude is 1
    return Decrements(a, np.round(D, digits), np.full(rows, 0.5 * 10.0**-digits))


@pytest.mark.parametrize(
    ("law", "strengths"), [("1", [0.02]), ("2", [0.03]), ("0,1", [0.004, 0.01]), ("1,2", [0.01, 0.03])]
)
@pytest.mark.parametrize("digits", [3, 4])
def test_the_set_holds_the_truth_and_shrinks_with_the_digits(law, strengths, digits):
    found = strengths_that_fit(exponents(law), printed(law, strengths, digits))
    assert found.verdict == "consistent"
    for interval, true in zip(found.epsilon, strengths, strict=True):
        assert interval.low <= true <= interval.high
        assert interval.high - interval.low < (60 if "," in law else 6) * 10.0**-digits


def test_the_ends_of_the_set_are_attained():
    table = printed("1", [0.02], 3)
    found = strengths_that_fit(exponents("1"), table).epsilon[0]
    model = DecrementModel(Swing([loss(1.0)]), table)

    def met(epsilon):
        return (np.abs(model.predict(np.array([epsilon]))[0] - table.decrement) <= table.resolution).all()

    width = found.high - found.low
    assert met(found.low + 0.01 * width)
    assert met(found.high - 0.01 * width)
    assert not met(found.low - 0.01 * width)
    assert not met(found.high + 0.01 * width)


def test_a_wrong_law_is_refuted_by_proof_and_a_wrong_digit_too():
    table = printed("1,2", [0.01, 0.03], 4)
    assert strengths_that_fit(exponents("1"), table).verdict == "refuted"
    assert strengths_that_fit(exponents("2"), table).verdict == "refuted"
    wrong = Decrements(table.amplitude, table.decrement + 2e-4 * (np.arange(12) == 5), table.resolution)
    assert strengths_that_fit(exponents("1,2"), wrong).verdict == "refuted"


def test_the_tail_of_the_series_is_an_enclosure_that_bites():
    # viscous: L = -pi (d/2)/sqrt(1 - d^2/4), known in closed form
    with ctx.workprec(80):
        ratio = CertifiedRatio.of(exponents("1"))
        d = arb("0.08")
        true = -arb.pi() * (d / 2) / (1 - d**2 / 4).sqrt()
        assert ratio.at([d]).contains(true)
        short = CertifiedRatio(ratio.weights, {k: c for k, c in ratio.coefficients.items() if sum(k) <= 3}, 3)
        assert short.at([d]).contains(true)
        assert not abs(short.polynomial([d]) - true) <= short.tail([d]) / 10**5  # the bound is not absurdly wide
        assert not short.polynomial([d]).overlaps(true)  # and without it the sum is wrong
        with pytest.raises(UndecidedError):
            ratio.tail([arb(1)])


def test_the_command_reads_resolutions(tmp_path, capsys):
    table = printed("1,2", [0.01, 0.03], 4)
    rows = [f"{a},{d:.4f},0.00005" for a, d in zip(table.amplitude, table.decrement)]
    path = tmp_path / "decrements.csv"
    path.write_text("amplitude,decrement,resolution\n" + "\n".join(rows) + "\n")
    assert main(["identify", str(path), "--laws", "1", "1,2", "--json"]) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["verdict"].startswith("identified: 1,2")
    laws = {",".join(law["alphas"]): law for law in answer["laws"]}
    assert laws["1"]["verdict"] == "refuted"
    assert laws["1,2"]["intervals"] == "certified set"
    assert float(laws["1,2"]["epsilon"][0]["low"]) <= 0.01 <= float(laws["1,2"]["epsilon"][0]["high"])


def test_decrements_without_resolution_have_statistical_intervals():
    table = printed("1,2", [0.01, 0.03], 5, rows=30)
    noisy = table.decrement + 1e-5 * np.random.default_rng(1).standard_normal(30)
    answer = asy.identify({"amplitude": table.amplitude, "decrement": noisy}, laws=["1", "1,2"])
    assert answer.law("1,2").law.epsilon[1].contains(0.03)
    assert answer.law("1").law.verdict == "refuted"
