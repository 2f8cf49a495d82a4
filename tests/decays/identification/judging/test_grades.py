"""What a law leaves of the loss, and the one grammar of laws."""

import numpy as np
import pytest

import asymptotics as asy
from asymptotics.decays.identification.forward.candidates import default_candidates, read_candidate
from asymptotics.decays.identification.judging.comparison import heads_of
from asymptotics.decays.identification.judging.grades import open_share
from asymptotics.decays.identification.synthetic import observed
from asymptotics.errors import InputError
from asymptotics.shell.main import main


def test_a_law_that_lacks_a_small_term_is_adequate_and_one_that_lacks_much_refuted():
    answer = asy.identify(observed("1+2", [0.04, 0.004], 60, 2e-5, seed=3), laws=["1", "2"], bootstrap=False)
    linear, quadratic = answer.law("1").law, answer.law("2").law
    assert (linear.verdict, linear.grade, quadratic.grade) == ("refuted", "adequate", "refuted")
    # 2 carries at most 8.5 % of the loss at the first amplitude, and linear loss takes its mean over
    assert 0.01 < linear.evidence.unexplained.share < 0.085 < 0.3 < quadratic.evidence.unexplained.share
    assert answer.verdict.kind == "none fits" and "1 is adequate to " in answer.verdict.text
    assert answer.to_dict()["laws"][0]["grade"] == "adequate"


def test_the_share_is_that_of_the_loss():
    s = np.linspace(0, -2, 80)
    assert open_share(np.exp(s), 0.05 * np.sin(2 * s)).share == pytest.approx(0.1 / np.sqrt(2), rel=0.1)
    assert open_share(np.exp(s), 0.01 * np.ones(80)).share < 1e-9


@pytest.mark.parametrize(
    ("old", "new"), [("1,2", "1+2"), ("0,1x2", "0+1,2:"), ("1x2", "1,2:"), ("free,s3", "free+s3"), ("1,2+s3", "1+2")]
)
def test_the_old_spelling_is_refused_with_the_new_one(old, new):
    with pytest.raises(InputError) as caught:
        read_candidate(old)
    assert new in caught.value.accepted


def test_a_token_means_the_same_in_law_and_laws(capsys):
    assert read_candidate("1,2:").formula() == "x'' + x + e1 x^2 x' = 0"
    assert main(["half-swing", "--law", "1,2", "--order", "1"]) == 0
    assert "x^2 x'" in capsys.readouterr().out
    with pytest.raises(InputError, match="has a strength"):
        read_candidate("1,2:0.1")


def test_the_largest_law_of_each_spring_is_fitted_first():
    heads = [str(c) for c in heads_of(default_candidates(True, angles=True))]
    assert heads == ["0+1+2+3", "0+1+2+3+s3", "0+1+2+3+s3+s5", "0+1+2+3+pendulum"]
    assert heads_of([read_candidate(t) for t in ("1", "2", "1+2")]) == []
