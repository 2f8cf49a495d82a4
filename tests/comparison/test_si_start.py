"""A file in SI that begins at t = 0, from an amplitude that is no binary fraction."""

from asymptotics.comparison.run import compare_file
from asymptotics.law import Oscillator


def test_a_record_in_si_may_begin_at_the_start(tmp_path):
    path = tmp_path / "lab.csv"
    path.write_text("t,x\n0,0.2\n0.1,0.18\n")
    found = compare_file(path, Oscillator({2: "1/10"}, mass="3/2", stiffness=30, x0="1/5"), si=True)
    assert found.certified
    assert found.rows[0].digits == "20.00"
