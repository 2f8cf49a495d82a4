"""The driven response as correctly rounded decimals: first order in closed form, and the orbit itself, certified.

>>> from asymptotics.law import Oscillator
>>> found = respond(Drive.read(Oscillator({2: "1/10"}), "1/5", 1), 8)
>>> found.amplitude, found.x0, found.v0, found.phase, found.first_order.amplitude
('1.5355181', '-0.0043810046', '1.5341700', '1.5767567', '1.5349901')
"""

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any

from flint import acb, arb

from asymptotics.driven import first_order, linear
from asymptotics.driven.drive import Drive
from asymptotics.driven.first_numbers import MAX_BITS, FirstOrder, Value, first_order_of
from asymptotics.driven.orbit import MAX_BITS as ORBIT_BITS
from asymptotics.driven.orbit import bits_lost, free_harmonic, orbit
from asymptotics.driven.shown import ResponsePage
from asymptotics.errors import LimitError, UndecidedError
from asymptotics.frames import BARE, Frame
from asymptotics.law import Oscillator
from asymptotics.numbers.decimals import bits_for, certified_decimal, decimal_of
from asymptotics.numbers.exact import ExactReal
from asymptotics.numbers.precision import TooWideError, at_growing_precision

MAX_DIGITS = 200
HARMONICS = (1, 3)


@dataclass(frozen=True, repr=False)
class Response(ResponsePage):
    """The one periodic response: ``amplitude`` its largest |x|, ``x0`` and ``v0`` its state at t = 0, where the force
    is f; ``phase``: by how much its first harmonic lags behind the force; ``energy``: what it takes in a cycle;
    ``harmonics``: n -> amplitude and phase of A_n cos(n theta - phase_n); ``difference``: amplitude and phase less
    those of first order, the digits that are proved, three at most, beside the estimate ``first_order.error``.

    ``frame``: the units of the numbers.  Not ``certified``: these are None, ``notes`` say why, first order is there.
    """

    oscillator: Oscillator
    force: ExactReal
    omega: ExactReal
    digits: int
    first_order: FirstOrder
    amplitude: str | None = None
    x0: str | None = None
    v0: str | None = None
    phase: str | None = None
    energy: str | None = None
    harmonics: dict[str, dict[str, str]] | None = None
    difference: dict[str, str] | None = None
    certified: bool = False
    method: str = "first order alone"
    notes: tuple[str, ...] = ()
    frame: Frame = field(default=BARE, compare=False)

    def to_dict(self) -> dict[str, Any]:
        """JSON-ready: the contract of ``asymptotics response --json``."""
        names = ("amplitude", "x0", "v0", "phase", "energy", "harmonics", "difference")
        law = self.oscillator.law
        return {
            "law": str(law), "force": str(self.force), "omega": str(self.omega),
            **{name: getattr(self, name) for name in names}, "first_order": self.first_order.to_dict(),
            "digits": self.digits, "certified": self.certified, "method": self.method, "notes": list(self.notes),
            "units": self.frame.units,
        }  # fmt: skip


def respond(drive: Drive, digits: int) -> Response:
    """First order, and the response itself where it is served: sliding all along, one turn in half a period."""
    first, notes = first_order_of(drive, digits), drive.oscillator.notes
    asked = (drive.oscillator, drive.force, drive.omega, digits, first)
    if linear.is_linear(drive):
        return Response(*asked, **_linear(drive, digits), notes=notes)
    if (n := free_harmonic(drive)) is not None:
        reason = f"omega_0 is {n} Omega, and of a free motion at rest at each turn dry friction alone takes nothing"
        return Response(*asked, notes=(*notes, f"first order alone: {reason}"))
    bits = bits_for(digits, 48) + bits_lost(drive)
    if bits > ORBIT_BITS:
        reason = f"beside so weak a loss {digits} digits of the response need about {bits} bits, more than {ORBIT_BITS}"
        return Response(*asked, notes=(*notes, f"first order alone: {reason}"))
    steep = any(a < 1 for a in drive.alphas)
    try:
        # Where a mass may stick no precision helps.
        most = min(4 * bits, ORBIT_BITS) if steep else ORBIT_BITS
        told = at_growing_precision(lambda _: _orbit(drive, digits), digits, bits, max_bits=most)
    except LimitError as error:
        # The time of the request is no property of the response.
        if error.argument == "max_seconds":
            raise
        return Response(*asked, notes=(*notes, f"first order alone: {error.reason}"))
    except UndecidedError as error:
        if not steep:
            raise
        return Response(*asked, notes=(*notes, f"first order alone: {error}"))
    return Response(*asked, **told, notes=notes)


def _linear(drive: Drive, digits: int) -> dict[str, Any]:
    """The closed form: the response is its first harmonic."""

    def told(evaluate: Callable[[], Value]) -> str:
        return certified_decimal(evaluate, digits, max_bits=MAX_BITS)

    numbers = {
        "amplitude": told(lambda: linear.exact(drive).amplitude),
        "x0": told(lambda: linear.exact(drive).x0),
        "v0": told(lambda: linear.exact(drive).v0),
        "energy": told(lambda: _energy(drive, linear.coefficient(drive))),
    }
    phase = told(lambda: _lag(linear.coefficient(drive)))
    harmonics = {"1": {"amplitude": numbers["amplitude"], "phase": phase}}
    method = "closed form: viscous damping alone"
    difference = {"amplitude": "0", "phase": "0"}
    found = {**numbers, "phase": phase, "harmonics": harmonics, "difference": difference}
    return {**found, "certified": True, "method": method}


def _lag(C: acb) -> arb:
    return -C.arg()


def _energy(drive: Drive, C: acb) -> arb:
    """pi f times the part of x that goes with sin(theta)."""
    return -arb.pi() * drive.force.ball() * C.imag


def _orbit(drive: Drive, digits: int) -> dict[str, Any]:
    """The numbers of the orbit at the precision in force; TooWideError where one is not decided."""
    found = orbit(drive)
    x, v = found.state()
    waves = {n: found.harmonic(n) for n in HARMONICS}
    numbers = {
        "amplitude": found.amplitude(), "x0": x, "v0": v * drive.omega.ball(), "phase": _lag(waves[1]),
        "energy": _energy(drive, waves[1]),
    }  # fmt: skip
    told: dict[str, Any] = {name: _decided(value, digits, name) for name, value in numbers.items()}
    told["harmonics"] = {
        str(n): {
            "amplitude": _decided(abs(C), digits, f"harmonic {n}"),
            "phase": _decided(_lag(C), digits, f"the phase of harmonic {n}"),
        }
        for n, C in waves.items()
    }
    balls = drive.balls()
    A = first_order.amplitude(balls)
    beyond = {"amplitude": numbers["amplitude"] - A, "phase": numbers["phase"] - first_order.phase(balls, A)}
    proved = {
        name: next(filter(None, (decimal_of(value, d) for d in (3, 2, 1))), None) for name, value in beyond.items()
    }
    told["difference"] = {name: text for name, text in proved.items() if text is not None}
    return {**told, "certified": True, "method": "trial orbit in balls, contraction over half a period"}


def _decided(value: arb, digits: int, name: str) -> str:
    text = decimal_of(value, digits)
    if text is None:
        known = value.rel_accuracy_bits()
        lacking = bits_for(digits, 16) - known if known > 0 else None
        raise TooWideError(f"{name} is {value.str(5)}", lacking, of=name)
    return text
