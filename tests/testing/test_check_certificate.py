"""The checker of certificates as its enemies meet it: each line is needed, and no file makes it stumble."""

import ast
from pathlib import Path

import pytest

from asymptotics.testing import check_certificate
from tests.certificates.truth import false_claims
from tests.testing.attacks import ATTACKS

TEXT = Path(check_certificate.__file__).read_text()


def checker(line="", weakened="", limits=()):
    """The checker's page with one line weakened, and other limits."""
    text = TEXT.replace(line, weakened) if line else TEXT
    page = {"__name__": "weakened"}
    exec(compile(text, "weakened", "exec"), page)
    page.update(limits)
    return page


def verdict(page, certificate, path):
    """None if it is accepted, the reason, or the name of an exception that should not be."""
    try:
        if isinstance(certificate, str):
            path.write_text(certificate)
            certificate = page["read"](path)
        page["told"](certificate)
    except page["RefusedError"] as reason:
        return str(reason)
    except Exception as fault:
        return f"fault {type(fault).__name__}"
    return None


@pytest.mark.parametrize("attack", ATTACKS, ids=lambda attack: attack.name)
def test_each_line_is_needed(attack, tmp_path):
    assert TEXT.count(attack.line) == 1
    content = attack.certificate()
    refused = verdict(checker(limits=attack.limits), content, tmp_path / "a.json")
    assert refused is not None and not refused.startswith("fault")
    without = verdict(checker(attack.line, attack.weakened, attack.limits), content, tmp_path / "b.json")
    assert without is None if attack.wrong != "fault" else without.startswith("fault"), without


GAINS = "gains"  # the one law with which energy grows: the library has no motion of it


@pytest.mark.parametrize("attack", [a for a in ATTACKS if a.wrong == "false" and a.name != GAINS], ids=lambda a: a.name)
def test_what_they_claim_is_false(attack):
    assert false_claims(attack.certificate())


def test_every_condition_of_the_page_is_attacked():
    attacked = [range(TEXT.index(a.line), TEXT.index(a.line) + len(a.line)) for a in ATTACKS]
    lines = TEXT.splitlines(keepends=True)
    starts = [sum(map(len, lines[:i])) for i in range(len(lines) + 1)]
    left = []
    for node in ast.walk(ast.parse(TEXT)):
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") == "need":
            here = range(starts[node.lineno - 1] + node.col_offset, starts[node.end_lineno - 1] + node.end_col_offset)
            if not any(r.start < here.stop and here.start < r.stop for r in attacked):
                left.append(ast.unparse(node))
    assert left == ["need(len(sys.argv) == 2, 'usage: python check_certificate.py FILE')"]
