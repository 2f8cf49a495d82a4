r"""How the formulas of the papers are read: what stands for a letter of the form, and what stands beside it.

A form often holds a part of its equation only, or writes a letter for |sin omega_0 t|.  A ``Reading`` says so, in
LaTeX: ``letters`` are replacements, made from left to right before anything is read; ``unit`` divides what has been
read; ``parts`` names the places of a form that the formula prints, where the others are premises of the check; with
``hats`` an S of the form is the paper's S with a hat, with ``differentials`` dx and dv stand in the form; ``names`` are
(letter of the form, what it is called in print), its index included.  A
replacement by ``\int`` marks a factor: what stands beside it and what does not are then two expressions.
"""

from dataclasses import dataclass

import sympy

Letters = tuple[tuple[str, str], ...]
SAME = {"M": "m", "E": "E_n", "K": "kappa", "fdot": "f'"}  # names of letters in the code and in print


@dataclass(frozen=True)
class Reading:
    """How one formula is read."""

    letters: Letters = ()
    unit: str = ""
    parts: tuple[int, ...] = ()
    hats: bool = False
    differentials: bool = False
    names: Letters = ()

    def name(self, symbol: sympy.Symbol) -> str:
        """What a letter of the code is called in print."""
        name = str(symbol)
        printed = dict(self.names) | ({name: "hat" + name} if self.hats and name.startswith("S") else {})
        return printed.get(name, SAME.get(name, name))


PAPERS: dict[str, Letters] = {
    "lancaster2020": ((r"f_{\alpha}(\dot{x})", "f"), (r"\dot{x}", "v")),
    "lelas2024": (
        (r"\frac{df}{dt}", "f'"), (r"\dot f", "f'"), (r"\abs{\sin(\omega_0t)}", "s"),
        (r"\abs{\cos(\omega_0t)}", r"\sqrt{1-s^2}"),
    ),
    "smith2012": ((r"\dot{x}", "v"), ("T(x, v; t)", "T"), ("T(x,v;t)", "T")),
}  # fmt: skip

THETA = (r"\omega_0 t", r"\theta")
SECOND, FIRST, TIME = Reading(parts=(1,)), Reading(parts=(0,)), (r"\omega_0 t", "T")
PAIR_1, PAIR_2 = Reading(names=(("v", "v_1"),)), Reading(names=(("v", "v_2"),))
FORCE = ((r"f(x, v)", "F"), (r"f^2(x, v)", "F^2"), (r"\frac{df}{dv}", "F_v "),
         (r"\frac{\partial f}{\partial x}", "f_x"),
         (r"\frac{\partial f}{\partial v}", "f_v"), (r"\frac{dx}{dv}", r"\dxdv"),
         (r"\frac{dv}{v}", r"\frac{1}{v}"))  # fmt: skip
PLACE = ((r"v(x)", "v"), (r"v^2(x)", "v^2"), (r"\frac{dv}{dx}", "v_x"), (r"\frac{dv/dt}{dx/dt}", r"\frac{a}{\xdot}"),
         (r"xf(x, v)", "xa"), (r"mv^3(x)", "v^3"))  # fmt: skip
TERMS = ((r"\left(\frac{\omega v}{\gamma v^2-\omega^2 x}\right)^n", ""),
         (r"- \omega\sum_{n=2}^{\infty}", r"= -\omega"),
         (r"- \omega\sum_{n=0}^{\infty}", r"= -\omega"), (r"\left(\frac{\gamma v}{\omega}\right)f'_{n+1}", "wg_{n+1}"),
         (r"+ 2\omega\left(\frac{\gamma v}{\omega}\right)\sum_{n=1}^{\infty}", r"= 2\omega w"))  # fmt: skip
SLOPES = ((r"f_1'", "g_1"), (r"f_2'", "g_2"), (r"f_n'", "g_n"), (r"(w^nf_n)'", "(w^ng_n+nw^{n-1}f_n)"))

READINGS: dict[str, Reading] = {
    "lancaster2020:1": Reading(((r"\ddot{x}", r"\int"),)),
    "lancaster2020:3": Reading(((r"\gamma", r"\frac{b}{2m}"),), unit=r"\cos(\omega_0t)"),
    "lancaster2020:5": Reading(((r"\dot{A}", "r"), ("A", "a"), THETA)),
    "lancaster2020:6": Reading(unit="kA^2"),
    "lancaster2020:7": Reading(unit="fv"),
    "lancaster2020:8": Reading((("f v", r"kA\dot{A}"), (r"\dot{A}", "r"), THETA), unit="kAr"),
    "lancaster2020:9": Reading(unit=r"A\omega_0\sin(\omega_0t)"),
    "lancaster2020:10": Reading(((r"\abs{\sin^{1+\alpha}(\omega_0 t')}dt'", ""),)),
    "lancaster2020:12": Reading(unit="t"),
    "lancaster2020:14": Reading(((r"\abs", ""),)),
    "lancaster2020:15": Reading(((r"(\alpha-1)", "q"), TIME)),
    "lancaster2020:16": Reading(((r"F_{\text{friction}}", "F_1"), (r"F_{\text{spring}}^{(\text{max})}", "F_2"))),
    "lancaster2020:19": Reading(((r"\abs{\sin^{\alpha+1}(\omega_0 t)}", r"s^{\alpha+1}"),
                                 (r"\abs{\sin^{\alpha'+1}(\omega_0 t)}", r"s^{\alpha'+1}"))),
    "lancaster2020:20": Reading(unit="-t"),
    "lancaster2020:fn22": Reading(((r"\frac{dx}", r"\frac{dt}"), ("x", "X")), parts=(0,)),
    "lancaster2020:21": Reading(((r"\lambda", r"\frac{x_0}{c+c'x_0}"),)),
    **dict.fromkeys((f"lelas2024:value.{name}-{panel}" for name in ("tau", "tau-tilde", "tau-exact") for panel in "ab"),
                    Reading(((r"\,\mathrm{s}", ""),), parts=(0,))),
    **dict.fromkeys((f"lelas2024:value.rest-{panel}" for panel in "ab"), Reading((("x_0", ""), ("+", "")), parts=(0,))),
    **dict.fromkeys((f"lancaster2020:claim.kappa-fig{n}" for n in (1, 2)),
                    Reading(((r"\quad (", r"\qquad ("),), parts=(0,))),
    "lelas2024:2": FIRST, "lelas2024:3": FIRST, "lelas2024:5": FIRST,
    "lelas2024:10": SECOND, "lelas2024:11": SECOND, "lelas2024:16": SECOND, "lelas2024:17": SECOND,
    "lelas2024:18": SECOND, "lelas2024:19": SECOND, "lelas2024:28": SECOND, "lelas2024:29": SECOND,
    "lelas2024:40": SECOND, "lelas2024:41": SECOND,
    "lelas2024:22": PAIR_1, "lelas2024:23": PAIR_2, "lelas2024:34": PAIR_1, "lelas2024:35": PAIR_2,
    "lelas2024:49": Reading(((r"\cos(\omega_0t)", r"\int"), (r"(-1)^n", r"\sigma"))),
    "smith2012:20a": Reading(PLACE), "smith2012:20b": Reading(PLACE), "smith2012:20c": Reading(PLACE),
    "smith2012:20d": Reading(PLACE), "smith2012:27a": Reading(PLACE), "smith2012:27b": Reading(PLACE),
    "smith2012:23": Reading(FORCE), "smith2012:24a": Reading(FORCE), "smith2012:24b": Reading(FORCE),
    "smith2012:9": Reading(((r"f(x, v)", "f"),), unit="m"),
    "smith2012:11": Reading(((r"= f(x, v)\,dx", "- f"), (r"\,dv", r"\int"))),
    "smith2012:12": Reading(((r"f(x, v)\,dx", "f"), (r"\,dv", r"\int"))),
    "smith2012:17": Reading(((r"\tilde{T}(x, v)", "T"),)),
    "smith2012:24c": Reading(((r"+ \frac{mv^2}{2}\frac{1}{f^2(x, v)}", r"=\frac{mv^2}{2}="), (r"{f}", "{F}"), *FORCE),
                             parts=(0, 1)),
    "smith2012:24d": Reading(((r"-\int_{v_0}^v\frac{mv^2}{2}\frac{d}{dv}\left[\frac{1}{f^2(x, v)}",
                               r"-\frac{mv^2}{2}="),
                              (r"\right]dv", ""), (r"{f}", "{F}"), *FORCE), parts=(1, 2)),
    "smith2012:37": Reading(((r"\frac{\partial\mu}{\partial x}", r"\mu_x"), (r"v\mu", r"v\mu]"),
                             (r"v = \frac{\partial\mu}{\partial v}", r"v - [\mu_v"))),
    **dict.fromkeys(("smith2012:56a", "smith2012:56b", "smith2012:56d"), Reading(differentials=True)),
    "smith2012:57": Reading(((r"f_n\left(\frac{\gamma v}{\omega}\right)\left(", "= ("), (r"\right)^n", ")"))),
    "smith2012:58": Reading(TERMS, unit=r"\omega"),
    "smith2012:60h": Reading(((r"\sum_{i=0}^{n-1}", "= n-1 ="),)),
    "smith2012:61": Reading(((r"\sum_{n=i+1}^{\infty}", "= i+1 ="),), parts=(0,)),
    "smith2012:71": Reading((("x_n(0)", "X_n"), (r"x([n-1]\pi/\omega)", "[n-1]"), (r"x(n\pi/\omega)", "n"))),
    "smith2012:19": Reading(PLACE), "smith2012:25": Reading(unit="m"), "smith2012:35": Reading(unit="m"),
    "smith2012:32": FIRST, "smith2012:33": FIRST,
    "smith2012:34": Reading(((r"\omega = \sqrt", r"\omega^2 = "),), parts=(1,)),
    "smith2012:36": Reading(((r"\,dv", r"\int"), (r"\,dx", ""))),
    "smith2012:38a": Reading(((r"\,dv", r"\int"), (r"\,dx", ""))),
    "smith2012:46b": Reading(((r"\ddot{x}", "a"),)),
    "smith2012:47": Reading(hats=True), "smith2012:50": Reading(hats=True), "smith2012:52c": Reading(hats=True),
    "smith2012:52a": Reading((("u_{2n+1}", "u_1"), ("u_{2n}", "u_0"), ("n_{2n}", "u_0"))),
    "smith2012:52b": Reading((("u_{2n+2}", "u_2"), ("u_{2n+1}", "u_1"), ("n_{2n+1}", "u_1"))),
    "smith2012:53": Reading(((r"(\hat{S}-\hat{S}_n)", ""),)),
    "smith2012:59b": Reading(SLOPES), "smith2012:59c": Reading(SLOPES), "smith2012:59d": Reading(SLOPES),
    "smith2012:62a": Reading(((r"C_{i-1}^{n-1}", r"\int"), (r"C_i^{n-2}", ""))),
    "smith2012:62b": Reading(((r"\sum_{k=1}^{\frac{n-i+1}{2}}", r"\frac{n-i+1}{2} ="), (r"C_{i-1}^{n+1-2k}", ""))),
    "smith2012:63": Reading((("C_0^{2m+1}", "2m+1"), ("C_0^n", "n"), ("C_0^{n-2}", ""), ("C_0^{n-4}", ""))),
    "smith2012:65": Reading((("C_0^{n-1}", ""), ("C_1^{n-2}", r"\int"))),
    "smith2012:69": Reading(((r"\omega t", r"\int"),)),
    "smith2012:70": Reading(unit=r"\frac{1}{\omega}"),
    "smith2012:72": Reading(((r"\omega t_n", ""), (r"\tan^{-1}", r"\int")), unit="-1"),
}  # fmt: skip
