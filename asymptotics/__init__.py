"""Symbolic and certified asymptotics for oscillators with power-law damping and springs.

    m x'' + k x + sum_i b_i |x|^m_i x'|x'|^(alpha_i-1) + sum_j c_j x|x|^(p_j-1) |x'|^q_j = 0,    any real alpha_i >= 0

>>> import asymptotics as asy
>>> law = asy.Law({"3/2": "1/10"})                                    # exponent -> strength (epsilon)
>>> osc = asy.Oscillator(law, mass="3/2", stiffness=30, x0="1/5")     # the strengths read as b, SI units
>>> print(asy.expand("3/2", order=2))
dA/dtau   = -A (0.4576558581 d)
dpsi/dtau = 1 - 12/(25*pi) d^2
d = epsilon A^(1/2)
alpha = 3/2, gauge turning-point, order 2, certified coefficients; formal: no bound on the remainder
>>> asy.turning_points({2: 1}, 2, digits=12).points[1].x, asy.motion(osc).at(7).x
('-0.410719686061', '0.16385309')

Every name of ``__all__`` is loaded when it is first used.  The README and the docs have the map.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from asymptotics import testing
    from asymptotics.ask.questions._damping_law import damping_law
    from asymptotics.ask.questions.compare import compare
    from asymptotics.ask.questions.damping import damping
    from asymptotics.ask.questions.derive import derive
    from asymptotics.ask.questions.half_swing import half_swing
    from asymptotics.ask.questions.identify import identify
    from asymptotics.ask.questions.limit_cycle import limit_cycle
    from asymptotics.ask.questions.moment import moment
    from asymptotics.ask.questions.response import response
    from asymptotics.ask.questions.stokes import stokes
    from asymptotics.ask.questions.sweep import sweep_command
    from asymptotics.ask.questions.table import table
    from asymptotics.ask.questions.turning_points import turning_points
    from asymptotics.bounds.remainder import remainder
    from asymptotics.curves.events import Events
    from asymptotics.curves.motions import Motion, Reference, motion, reference
    from asymptotics.curves.pictures import plot
    from asymptotics.curves.slow import Envelope, envelope
    from asymptotics.curves.solve import solution
    from asymptotics.curves.waves import waveforms
    from asymptotics.decays.identification.found_law import DampingLaw
    from asymptotics.decays.identification.telling.html_report import html_report
    from asymptotics.decays.identification.telling.result import Identification
    from asymptotics.equivalent.result import EquivalentDamping
    from asymptotics.errors import InputError, LimitError, UndecidedError
    from asymptotics.expansions.equations.build import expand
    from asymptotics.expansions.equations.result import Equations
    from asymptotics.expansions.multiple_scales.hierarchy import any_start, map_of_gauges, multiple_scales
    from asymptotics.law import Law, Oscillator, PhysicalLaw
    from asymptotics.motions.invariants.constants import S, T, radii
    from asymptotics.motions.invariants.smith import C, G, f
    from asymptotics.numbers.exact import ExactReal
    from asymptotics.numbers.value import Coefficient
    from asymptotics.papers.lookup import paper, statements
    from asymptotics.papers.statement import PaperStatement
    from asymptotics.sweeps.run import sweep
    from asymptotics.tables.names import table_names
    from asymptotics.turning.result import TurningPoints

__version__ = "0.1.0"

# The same names once more: a type checker reads the imports above, Python this table.
_HOMES = {
    "motions.invariants.constants": ("S", "T", "radii"),
    "ask.questions._damping_law": ("damping_law",),
    "ask.questions.compare": ("compare",),
    "ask.questions.damping": ("damping",),
    "ask.questions.response": ("response",),
    "ask.questions.stokes": ("stokes",),
    "ask.questions.derive": ("derive",),
    "expansions.multiple_scales.hierarchy": ("any_start", "map_of_gauges", "multiple_scales"),
    "motions.invariants.smith": ("C", "G", "f"),
    "tables.names": ("table_names",),
    "ask.questions.sweep": ("sweep_command",),
    "ask.questions.table": ("table",),
    "ask.questions.moment": ("moment",),
    "ask.questions.half_swing": ("half_swing",),
    "ask.questions.identify": ("identify",),
    "ask.questions.limit_cycle": ("limit_cycle",),
    "curves.motions": ("Events", "Motion", "Reference", "motion", "reference"),
    "curves.pictures": ("plot",),
    "curves.slow": ("Envelope", "envelope"),
    "curves.solve": ("solution",),
    "curves.waves": ("waveforms",),
    "ask.questions.turning_points": ("turning_points",),
    "bounds.remainder": ("remainder",),
    "expansions.equations.build": ("expand",),
    "expansions.equations.result": ("Equations",),
    "decays.identification.found_law": ("DampingLaw",),
    "equivalent.result": ("EquivalentDamping",),
    "errors": ("InputError", "LimitError", "UndecidedError"),
    "decays.identification.telling.html_report": ("html_report",),
    "decays.identification.telling.result": ("Identification",),
    "law": ("Law", "Oscillator", "PhysicalLaw"),
    "numbers.exact": ("ExactReal",),
    "numbers.value": ("Coefficient",),
    "papers.lookup": ("paper", "statements"),
    "papers.statement": ("PaperStatement",),
    "sweeps.run": ("sweep",),
    "turning.result": ("TurningPoints",),
}
_RENAMED = {"OscillatorTurningPoints": "TurningPoints", "cut_short": "running.cut_short", "budget": "running.budget"}
_HOME = {name: module for module, names in _HOMES.items() for name in names}

__all__ = [
    "C",
    "Coefficient",
    "DampingLaw",
    "Envelope",
    "Equations",
    "EquivalentDamping",
    "Events",
    "ExactReal",
    "G",
    "Identification",
    "InputError",
    "Law",
    "LimitError",
    "Motion",
    "Oscillator",
    "PaperStatement",
    "PhysicalLaw",
    "Reference",
    "S",
    "T",
    "TurningPoints",
    "UndecidedError",
    "any_start",
    "compare",
    "damping",
    "damping_law",
    "derive",
    "envelope",
    "expand",
    "f",
    "half_swing",
    "html_report",
    "identify",
    "limit_cycle",
    "map_of_gauges",
    "moment",
    "motion",
    "multiple_scales",
    "paper",
    "plot",
    "radii",
    "reference",
    "remainder",
    "response",
    "solution",
    "statements",
    "stokes",
    "sweep",
    "sweep_command",
    "table",
    "table_names",
    "testing",
    "turning_points",
    "waveforms",
]


def __getattr__(name: str) -> Any:
    """A public name, from the module that owns it, on first use (PEP 562)."""
    if name == "testing":  # the one room that is public as it is
        return import_module("asymptotics.testing")
    if name not in _HOME:
        now = f": it is asymptotics.{_RENAMED[name]} now" if name in _RENAMED else ""
        raise AttributeError(f"module 'asymptotics' has no attribute {name!r}{now}")
    value = getattr(import_module(f"asymptotics.{_HOME[name]}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted([*__all__, "__version__"])
