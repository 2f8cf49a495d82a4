"""No text that a user typed is ever evaluated: a walk over the syntax tree of everything that is run.

SymPy's ``sympify``, ``S(...)``, ``parse_expr`` and ``nsimplify`` evaluate text as Python, and so does whatever calls
them on its arguments (``subs``, ``solve``, ``lambdify`` with strings).  None of them may be called, by any name, and
nothing that executes code may be imported.  What reads text is ``numbers.exact``, a regular expression.
"""

import ast
from collections.abc import Iterable
from pathlib import Path

import pytest

from tests.each import each
from tests.sources import nodes

ROOT = Path(__file__).parents[1]
FILES = [p for top in ("asymptotics", "derivations", "paper_checks") for p in sorted((ROOT / top).rglob("*.py"))]
CALLS = {
    "eval", "exec", "compile", "sympify", "_sympify", "parse_expr", "nsimplify", "parse_latex", "parse_mathematica",
    "execfile", "system", "popen", "spawnl", "loads_pickle", "load_module", "run_path", "run_module", "safe_load",
}  # fmt: skip
MODULES = {"pickle", "cPickle", "marshal", "shelve", "dill", "cloudpickle", "yaml", "code", "codeop", "runpy", "joblib"}
ON_TEXT = {"subs", "replace", "solve", "lambdify", "diff", "limit", "series", "S"}


def _name(call: ast.Call) -> str:
    return getattr(call.func, "id", getattr(call.func, "attr", ""))


def faults(parts: Iterable[ast.AST]) -> list[str]:
    """What the walk objects to."""
    found = []
    for node in parts:
        if isinstance(node, ast.Import):
            found += [f"imports {a.name}" for a in node.names if a.name.split(".")[0] in MODULES]
        if isinstance(node, ast.ImportFrom):
            found += [f"imports {node.module}"] if (node.module or "").split(".")[0] in MODULES else []
            found += [f"imports {a.name}" for a in node.names if a.name in CALLS and a.name != "compile"]
        if isinstance(node, ast.Call):
            name, owner = _name(node), getattr(getattr(node.func, "value", None), "id", "")
            if name in CALLS and (name, owner) != ("compile", "re"):
                found.append(f"calls {name}")
            if name == "__import__" or (owner == "builtins" and name in CALLS):
                found.append(f"calls {name}")
            if name in ON_TEXT and owner in ("sympy", "sp") and any(_is_text(a) for a in node.args):
                found.append(f"calls sympy.{name} on text")
            found += ["runs a shell" for k in node.keywords if k.arg == "shell" and getattr(k.value, "value", True)]
    return found


def _is_text(argument: ast.expr) -> bool:
    """An f-string: text made at run time; a constant of ours is no user's."""
    return isinstance(argument, ast.JoinedStr)


def test_nothing_evaluates_text():
    assert {path: found for path in FILES if (found := faults(nodes(path)))} == {}


@each("text", [
    "eval(x)", "import pickle", "from pickle import loads", "sympy.sympify(x)", "from sympy import sympify",
    "sympy.S(f'{x}')", "sympy.lambdify(a, f'{b}')", "subprocess.run(x, shell=True)", "__import__('os')",
    "builtins.exec(x)", "os.system(x)", "from sympy.parsing.sympy_parser import parse_expr",
    "compile(x, 'f', 'eval')", "runpy.run_path(x)",
])  # fmt: skip
def test_the_walk_finds_what_it_looks_for(text: str):
    assert faults(ast.walk(ast.parse(text)))


def test_harmless_code_passes():
    harmless = "re.compile(x); sympy.Rational(1, 3); f.subs(a, b); subprocess.run(x, shell=False)"
    assert faults(ast.walk(ast.parse(harmless))) == []


NASTY = ["__import__('os').mkdir('owned')", "open('owned', 'w')", "(lambda: open('owned','w'))()", "exec('x')"]
OPTIONS = [
    "moment --p {}", "expand --alpha {}", "expand --law {}:1", "half-swing --law 1:{}", "motion --alpha 2 --damping {} "
    "--x0 1 --time 1", "motion --alpha 2 --damping 1 --x0 {} --time 1", "envelope --alpha 2 --epsilon 1 --time {}",
    "multiple-scales --alpha {}", "turning-points --alpha 2 --epsilon 1 --count {}", "smith g --i {}", "table {}",
]  # fmt: skip


@pytest.mark.parametrize("option", OPTIONS)
def test_code_in_an_option_is_text(option: str, tmp_path, monkeypatch, capsys):
    from asymptotics.shell.main import main  # noqa: PLC0415 (the walk above needs no library)

    monkeypatch.chdir(tmp_path)
    for nasty in NASTY:
        assert main([word.format(nasty) for word in option.split()]) == 2
        assert capsys.readouterr().err.count("\n") == 1
    assert list(tmp_path.iterdir()) == []
