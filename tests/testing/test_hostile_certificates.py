"""Files that mean harm, and a thousand that are damaged: the checker answers, and accepts nothing that is false."""

import copy
import json
import random
import subprocess
import sys
from pathlib import Path

import pytest

from asymptotics.testing import check_certificate
from asymptotics.testing.check_certificate import RefusedError, check, read, told
from tests.certificates import examples
from tests.certificates.truth import false_claims
from tests.each import each
from tests.testing.damage import damaged, leaves, put

CHECKER = Path(check_certificate.__file__)
SAMPLES = {  # what makes one, when a test asks for it
    "3/2": lambda: examples.turning("three halves"),
    "friction": lambda: examples.turning("friction", count=3),
    "sum": lambda: examples.turning("sum"),
    "in motion": lambda: examples.turning("in motion"),
    "units": lambda: examples.state("units", "1/3", "1"),
    "held": lambda: examples.turning("held", 3, 3),
}


@each(
    "data",
    [
        b"",
        b"\xff\xfe",
        b"[" * 200_000,
        b'{"law":' * 100_000,
        b"NaN",
        b"1" * 1_000_000,
        b'{"bits": 1e400}',
        b'{"bits": 1}' * 2,
        b"null",
        b'"..\\u0000/etc/passwd"',
        b'{"__class__": "os.system"}',
        b"[]",
        b"[[]]",
        b"[{}]",
        b"[" + b"{}," * 1000 + b"{}]",
    ],
)
def test_a_file_that_is_none_is_refused(tmp_path, data):
    path = tmp_path / "a.json"
    path.write_bytes(data)
    with pytest.raises(RefusedError):
        told(read(path))


def test_neither_a_folder_nor_nothing_is_read(tmp_path):
    for path in (tmp_path, tmp_path / "none"):
        ran = subprocess.run([sys.executable, CHECKER, path], capture_output=True, text=True)
        assert (ran.returncode, ran.stderr) == (1, "") and ran.stdout.startswith("refused: the file cannot be read")
    ran = subprocess.run([sys.executable, CHECKER], capture_output=True, text=True)
    assert (ran.returncode, ran.stderr) == (1, "") and "usage" in ran.stdout


WRONG = [
    None,
    True,
    1.5,
    float("nan"),
    "",
    "x",
    "1e5",
    "-1",
    "1/0",
    "0",
    "9" * 5000,
    10**8,
    -1,
    [],
    {},
    [[0, "1"]],
    ["1"],
]


@pytest.mark.parametrize("name", ["3/2", "friction", "units", "held"])
def test_anything_in_any_place_is_answered(name):
    """Each place of a file in turn holds each of some objects that do not belong there."""
    rng, sample = random.Random(36), SAMPLES[name]()
    places = list(leaves(sample, inner=True))
    for place in places if len(places) < 80 else rng.sample(places, 80):
        for wrong in rng.sample(WRONG, 6):
            content = put(copy.deepcopy(sample), place, wrong)
            try:
                check(content)
            except RefusedError:
                continue
            assert not false_claims(content), (place, wrong)


def test_a_large_exponent_or_a_long_file_is_refused_before_the_work():
    content = examples.turning("sum")
    long = [[n, "1"] for n in range(20_000)]
    content["pieces"][1:4] = [{**p, "y": long, "powers": [None, long]} for p in content["pieces"][1:4]]
    with pytest.raises(RefusedError, match=r"the work would take \d+ s"):
        check(content)


def accepted(content):
    try:
        check(content)
    except RefusedError:
        return False
    return True


@pytest.mark.parametrize("seed", range(4))
def test_damaged_certificates_claim_nothing_false(seed):
    """250 for each seed, 100 in `make test`: one to three places of a good one are changed, a coefficient as a rule."""
    rng, taken = random.Random(seed), 0
    many = 100 if seed == 3 else 250
    for _ in range(many):
        sample = rng.choice([*SAMPLES.values()])()
        content = damaged(sample, rng)
        if accepted(content):
            taken += 1
            # What was claimed of the same motion is as true as it was.
            same = all(content[key] == sample[key] for key in ("law", "start", "stiffness", "claims"))
            assert same or not false_claims(content)
    assert 0 < taken < many


def test_a_half_swing_left_out_or_doubled_a_shifted_index_and_a_swapped_sign_are_refused():
    sample = examples.turning("three halves", count=4)
    ends = [i for i, p in enumerate(sample["pieces"]) if p["kind"] == "arrive"]
    first, second = slice(0, ends[0] + 1), slice(ends[0] + 1, ends[1] + 1)
    pieces, claims = sample["pieces"], sample["claims"]
    assert accepted(sample)
    wrong = [
        {**sample, "pieces": pieces[ends[0] + 1 :]},
        {**sample, "pieces": pieces[second.stop :]},
        {**sample, "pieces": pieces[first] + pieces[second.stop :]},
        {**sample, "pieces": pieces[first] + pieces},
        {**sample, "claims": [{**c, "number": c["number"] + 1} for c in claims[:-1]]},
        {**sample, "claims": [{**c, "number": c["number"] - 1} for c in claims[1:]]},
        {**sample, "claims": [{**c, "x": c["x"].lstrip("-")} for c in claims]},
        {**sample, "start": ["-1", "0"]},
        {**sample, "law": [["3/2", "-1/5"]]},
        {**sample, "law": [["3/2", "1/5"], ["2", "1/1000000"]]},
        {**sample, "law": [["5/2", "1/5"]]},
        {**sample, "root": 4},
    ]
    for content in wrong:
        assert not accepted(json.loads(json.dumps(content)))
