"""A new command costs one file: the question of ``toy.py``, put beside those of the package, through all walks.

Its name in Python, ``asymptotics.toy``, is the one other place; the test gives it.
"""

import re
import sys
from pathlib import Path

import pytest

import asymptotics as asy
from asymptotics.ask import questions, registry, typed
from asymptotics.shell import main as shell
from tests import every_question, ledger
from tests.ask import test_asks_for_time, test_hostile, test_hostile_objects, test_pairs, test_questions
from tests.every_question import call_of, options_of, usual
from tests.present import test_parity_page
from tests.present.every_type import name_of, samples_of
from tests.shell import test_cli, test_files, test_groups
from tests.shell.test_common import test_each_common_option_is_there_or_says_why_not as common_option
from tests.test_made_by import KINDS
from tests.test_made_by import test_every_output_says_which_code_made_it as output_says
from tests.test_same_again import AGAIN, same

TOY = Path(__file__).with_name("toy.py")


def put(file, monkeypatch):
    """The question of a file, as if it stood in the folder of questions."""
    monkeypatch.setattr(questions, "__path__", [str(file.parent), *questions.__path__])
    monkeypatch.setitem(registry._FILES, "toy", file)
    for module in (registry, shell, ledger, every_question):
        monkeypatch.setattr(module, "QUESTIONS", tuple(sorted({*registry.QUESTIONS, "toy"})))
    monkeypatch.setattr(typed, "ANSWERING", (*typed.ANSWERING, "toy"))
    every_question.parser_of.cache_clear()
    typed.parser_of.cache_clear()
    monkeypatch.delitem(sys.modules, "asymptotics.ask.questions.toy", raising=False)
    found = registry.loaded("toy")
    monkeypatch.setattr(asy, "toy", sys.modules["asymptotics.ask.questions.toy"].toy, raising=False)
    return found


def test_a_new_command_is_walked_from_its_one_file(monkeypatch, tmp_path, capsys):
    put(TOY, monkeypatch)
    monkeypatch.chdir(tmp_path)
    assert call_of("toy") is asy.toy and "toy" in registry.QUESTIONS
    # What it says of itself, in --help, --schema, headers, axes, the pages.
    test_questions.test_a_question_says_all_that_others_need("toy")
    test_questions.test_the_schema_is_that_of_the_options(capsys, "toy")
    test_questions.test_the_words_of_a_header_are_read_back("toy")
    test_questions.test_the_axes_of_a_sweep_are_the_parameters("toy")
    test_cli.test_every_command_explains_itself(capsys, "toy")
    test_groups.test_every_option_stands_under_one_heading("toy")
    common_option("toy", capsys)
    assert test_pairs.walk("toy", tmp_path, capsys)[0] > 2
    assert test_asks_for_time.outcomes("toy", "", "", tmp_path, monkeypatch, capsys) == ["0", "0"]
    test_parity_page.test_every_option_has_its_call("toy")
    test_parity_page.test_the_example_says_the_same_from_python("toy", capsys, tmp_path)
    assert "toy --count 2 --digits 5" in ledger.groups()["Approximations"]
    assert "| `toy` | exact rational arithmetic |" in ledger.rows_of_rests()
    # Words and objects that mean harm, files, and what it answers.
    for flag in (o for o, action in options_of("toy").items() if action.nargs != 0):
        test_hostile.walk("toy", flag, test_hostile.SOME, tmp_path, capsys)
    test_hostile.test_a_hostile_object_is_refused_by_the_name_of_its_parameter("toy")
    assert test_hostile_objects.faults("toy", asy.toy, usual(asy.toy), test_hostile_objects.KINDS) == []
    test_files.test_a_file_that_is_not_there_is_named_by_its_option("toy", "--csv", tmp_path, monkeypatch, capsys)
    for kind, end in KINDS.items():
        if f"--{kind}" in options_of("toy"):
            output_says("toy", kind, end, tmp_path, capsys)
    (text,) = samples_of(asy.toy).values()
    one, other = (eval(text, {"asy": asy}) for _ in range(2))
    same(one, other)
    assert all(again(one) == one for again in AGAIN.values()) and name_of(type(one)) in samples_of(asy.toy)


LESS = {  # what a question may lack, and who says so
    r"    example=.*\n": test_questions.test_a_question_says_all_that_others_need,
    r"    count\n        how many\n": test_questions.test_a_question_says_all_that_others_need,
    r'"gauge": "a toy has no gauge",': lambda name: common_option(name, 0),
}


@pytest.mark.parametrize("left_out", LESS)
def test_what_a_new_question_lacks_is_noticed(left_out, monkeypatch, tmp_path):
    file = tmp_path / "toy.py"
    file.write_text(re.sub(left_out, "", TOY.read_text(encoding="utf-8"), count=1))
    put(file, monkeypatch)
    with pytest.raises(AssertionError):
        LESS[left_out]("toy")
