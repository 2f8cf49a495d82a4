"""Writes ``first_turning_point.v`` from a certificate: python derivations/coq/write_instance.py

The first turning point of x'' + x + x'^3/10 = 0 from rest at 1, to ten digits, from the coefficients of the certificate
that the library makes of it; ``half_swing.v`` has the theorem that takes them.
"""

from fractions import Fraction
from pathlib import Path
from textwrap import fill
from typing import Any

from asymptotics.certificates.certificate import Certificate
from asymptotics.certificates.of_results import of_turning_points
from asymptotics.law import Law
from asymptotics.turning.choose import turning_points

FILE = Path(__file__).parent / "first_turning_point.v"
DIGITS = 10
TEXT = """\
(* The first turning point of x'' + x + x'^3/10 = 0 from rest at 1, to ten digits in place and time, of whatever motion
   solves the equation.  The lists are the coefficients of a certificate (docs/theory/certificates.md), over 2^{bits};
   derivations/coq/write_instance.py has written them. *)
From Coq Require Import Reals ZArith QArith Qreals List Lra.
From Coquelicot Require Import Coquelicot.
Require Import half_swing.
Import ListNotations.

Definition one : positive := {one}.
{definitions}
Definition passing := [{passes}].
Open Scope R_scope.

Theorem first_turning_point (x v : R -> R) :
  (forall t, 0 <= t -> is_derive x t (v t)) -> (forall t, 0 <= t -> is_derive v t (- x t - v t ^ 3 / 10)) ->
  x 0 = 1 -> v 0 = 0 ->
  exists z, 0 < z /\\ v z = 0 /\\ (forall t, 0 < t < z -> v t < 0) /\\
    Rabs (x z - ({x})) <= {x_half} /\\ Rabs (z - {t}) <= {t_half}.
Proof.
  intros hx hv h0 h1.
  destruct (turning_point one x v hx hv leave passing arrive
    ({x_q}) ({x_half_q}) ({t_q}) ({t_half_q}) h0 h1)
    as (z & hz & hvz & hdown & hplace & htime); [vm_compute; reflexivity |].
  exists z. refine (conj hz (conj hvz (conj hdown (conj _ _)))).
  - replace ({x}) with (Q2R ({x_q})) by (unfold Q2R; simpl; lra).
    replace ({x_half}) with (Q2R ({x_half_q})) by (unfold Q2R; simpl; lra). exact hplace.
  - replace ({t}) with (Q2R ({t_q})) by (unfold Q2R; simpl; lra).
    replace ({t_half}) with (Q2R ({t_half_q})) by (unfold Q2R; simpl; lra). exact htime.
Qed.

Print Assumptions first_turning_point.
"""


def made() -> Certificate:
    """The certificate of the first turning point with its time."""
    law = Law({3: "1/10"})
    return of_turning_points(law, turning_points(law, 2, DIGITS, times=True))


def text() -> str:
    """The file, from the certificate."""
    (content,) = made().content
    claim = content["claims"][1]
    first, *passes, last = content["pieces"]
    named = {"leave": first, **{f"pass_{i}": p for i, p in enumerate(passes)}, "arrive": last}
    x, t = Fraction(claim["x"]), Fraction(claim["t"])
    return TEXT.format(
        bits=content["bits"],
        one=1 << content["bits"],
        definitions="\n".join(_piece(name, p) for name, p in named.items()),
        passes="; ".join(f"pass_{i}" for i in range(len(passes))),
        x=claim["x"], t=claim["t"], x_half=f"5e-{_place(x)}", t_half=f"5e-{_place(t)}",
        x_q=_rational(x), t_q=_rational(t), x_half_q=f"5 # {10 ** _place(x)}", t_half_q=f"5 # {10 ** _place(t)}",
    )  # fmt: skip


def _piece(name: str, piece: dict[str, Any]) -> str:
    """(coefficients, scale), the scale negative where the time runs backwards."""
    powers = {n: int(c) for n, c in piece["y"]}
    numbers = "; ".join(f"({c})" if c < 0 else str(c) for c in (powers.get(n, 0) for n in range(max(powers) + 1)))
    scale = Fraction(piece["scale"]) * (-1 if piece["kind"] == "arrive" else 1)
    shown = f"({scale.numerator})" if scale < 0 else str(scale.numerator)
    text = f"Definition {name} : list Z * Q := ([{numbers}]%Z, {shown} # {scale.denominator})."
    return fill(text, 118, subsequent_indent="  ", break_long_words=False, break_on_hyphens=False)


def _place(number: Fraction) -> int:
    """The decimal place of half a unit of the last digit."""
    return DIGITS + 1 - (len(str(int(abs(number)))) if abs(number) >= 1 else 0)


def _rational(number: Fraction) -> str:
    return f"({number.numerator}) # {number.denominator}"


if __name__ == "__main__":
    FILE.write_text(text(), encoding="utf-8")
