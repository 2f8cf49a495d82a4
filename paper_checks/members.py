r"""What a printed formula says beside its form: the other members, the limits, the words and the relation signs.

A form often holds one side of its equation.  A formula is *wholly read* if what is not in the form is listed here, in
the reader's notation: ``also`` are members (names, left sides) compared as expressions, ``beside`` limits,
differentials, words and conditions compared letter by letter.  That is enough for a chain of equalities, whose order
says nothing.  A formula with another sign, with cases, or with names for its double signs is given as the ``display``
that is expected, member by member: ``#1`` is the first expression of the form, ``#12`` are the first and the second
in one member, ``#`` is a printed number; two lines are what the upper and the lower signs say.  "ID corrected" is the
formula that is true instead, where more or less than in the printed one stands beside it.

>>> MEMBERS["smith2012:19"].beside, MEMBERS["lelas2024:21"].display
(('\\int_{x_0}^x', 'dx'), ('b \\ll #1',))
"""

from dataclasses import dataclass


@dataclass(frozen=True)
class Members:
    """What stands beside a form, in any order, or the whole display in its own."""

    also: tuple[str, ...] = ()
    beside: tuple[str, ...] = ()
    display: tuple[str, ...] = ()


def _shown(*display: str) -> Members:
    return Members(display=display)


def _cases(left: str, *cases: str) -> str:
    """The display ``left = { ... , & condition``, as the papers set it."""
    return left + r" = \begin{cases} " + r" \\ ".join(cases) + r" \end{cases}"


def _names(paper: str, **numbers: str) -> dict[str, Members]:
    """Equations whose left side is a name."""
    return {f"{paper}:{number[1:]}": Members((name,)) for number, name in numbers.items()}


POWER_1, POWER_2, SLOPE = "P_{d1}", "P_{d2}", "f'"
X_LIMITS, V_LIMITS, AT_X, AT_V = r"\int_{x_0}^x", r"\int_{v_0}^v", r"\Big|_{x_0}^x", r"\bigg|_{v_0}^v"
DX, DV = (X_LIMITS, "dx"), (V_LIMITS, "dv")
TIME = "t - t_0"

MEMBERS: dict[str, Members] = {
    "lancaster2020:1": Members(("m", "kx - f", "0")),
    **_names("lancaster2020", _2="x", _4="E", _5="E", _13="A"),
    "lancaster2020:3": _shown(r"x \simeq #1 \qquad (\frac{b}{2m} \ll \omega_0)"),
    "lancaster2020:6": _shown(r"E \simeq #1"),
    "lancaster2020:7": Members((r"\dotE", r"v(m\ddotx + kx)")),
    "lancaster2020:8 corrected": _shown(
        r"#1 \simeq kAr \text{for} x = A\cos\theta; \quad kAr = kAr \text{for} A = \sqrt{2E/k}"),
    "lancaster2020:9": _shown(r"v \approx #1"),
    "lancaster2020:10": Members(
        (r"\frac{x_0^{1-\alpha} - A^{1-\alpha}}{\alpha-1}",), (r"\int_0^t", r"\qquad(\alpha\neq1)")
    ),
    "lancaster2020:12": _shown(r"\int_0^t \abs{\sin(\omega t')^{\alpha+1}} dt' \simeq #1"),
    "lancaster2020:14": _shown(r"\frac{\dot{A}}{A} = #1 \ll \omega_0"),
    "lancaster2020:15": _shown(r"\frac{\abs{\dot{A}}}{A} \xrightarrow{#1 \gg 1} \frac{1}{qt} \ll \omega_0"),
    "lancaster2020:15 corrected": _shown(
        r"\frac{\abs{\dot{A}}}{A} < \frac{1}{qt} \text{always}; \quad"
        r" \frac{\abs{\dot{A}}}{A} \to \frac{1}{qt} \text{for} #1 \gg 1"),
    "lancaster2020:16": _shown(r"#1 = \frac{F_1}{F_2} \ll 1"),
    "lancaster2020:18": Members((r"kA\dotA",)),
    "lancaster2020:19": _shown(r"kA\dotA \simeq #1"),
    "lancaster2020:20": _shown(r"\int_{x_0}^{A} \frac{dA}{cA^\alpha + c'A^{\alpha'}} \simeq #1"),
    "lancaster2020:fn22": Members((r"\frac{1}{cX^{\alpha} + c'X^{\alpha'}}",), ("dt",)),
    "lancaster2020:fn22 corrected": Members(
        (r"\frac{1}{cX^{\alpha} + c'X^{\alpha'}}",),
        ("dt", r",\quad\frac{\alpha'-1}{\alpha'-\alpha}\neq0,-1,-2,\ldots"),
    ),
    "lancaster2020:22": _shown(r"A \xrightarrow{#2 \gg 1} #1"),
    "lancaster2020:21": _shown(r"A \simeq #1"),
    **_names("lelas2024", _1="ma", _2="F_d", _3="F_d", _5="F_d", _6="E", _8="x_1", _9="x_2",
             _10="v_1", _11="v_2", _12="v_1", _13="v_2", _18=SLOPE, _19=SLOPE, _20=SLOPE, _26=SLOPE, _27=SLOPE,
             _31=SLOPE, _43=SLOPE, _28="f'^2", _29="f'^2", _30="f'^2", _38="-f'", _39="-f'", _32="f", _45="f",
             _40=r"(-f')^{\frac{2}{3}}", _41=r"(-f')^{\frac{2}{3}}", _42=r"(-f')^{\frac{2}{3}}",
             _47="x", _48=r"\tildex", _49="x_{ex}", _51="x", _52=r"\tildex"),
    **{f"lelas2024:value.{name}-{panel}": _shown(rf"{sign} = #") for panel in "ab"
       for name, sign in (("tau", r"\tau"), ("tau-tilde", r"\tilde\tau"), ("tau-exact", r"\tau_{ex}"))},
    **{f"lelas2024:value.rest-{panel}": _shown("#") for panel in "ab"},
    "lancaster2020:claim.c-viscous": Members(("c",)), "lancaster2020:claim.c-quadratic": Members(("c'",)),
    "lancaster2020:claim.kappa-scaling": _shown(r"\kappa \sim #1"),
    "lancaster2020:claim.friction-coefficient": Members((r"\mu_s", r"\mu_k")),
    "lancaster2020:claim.velocity-sign": _shown(r"v \simeq #1"), "lancaster2020:fn23": _shown(r"b' \to #1"),
    "lelas2024:claim.exponential-decay": Members(("f",)), "lelas2024:claim.stop-time-section-3": Members((r"\tau",)),
    "smith2012:claim.standard-motion": Members(("x",)), "smith2012:claim.integrating-factors": Members((r"\mu",)),
    "lancaster2020:claim.kappa-fig1": _shown(r"\kappa \approx # \qquad (\alpha = 0)"),
    "lancaster2020:claim.kappa-fig2": _shown(r"\kappa \approx # \qquad (\alpha = \tfrac{3}{2})"),
    "lelas2024:14": Members(("E_1", "E_2")),
    "lelas2024:7": Members((r"\frac{dE}{1}",), ("dt",)),
    "lelas2024:15": Members((r"\frac{dE_1}{1}", r"\frac{dE_2}{1}"), ("dt", "dt")),
    **{f"lelas2024:{number}": Members((POWER_1,)) for number in (16, 22, 24, 34, 36)},
    **{f"lelas2024:{number}": Members((POWER_2,)) for number in (17, 23, 25, 35, 37)},
    "lelas2024:21": _shown(r"b \ll #1"),
    "lelas2024:33": _shown(r"\mu \ll #1"), "lelas2024:50": _shown(r"\mu \ll #"),
    "lelas2024:44": Members((r"\frac{d}{f}t't'",), (r"\int_0^t", r"\int_0^t", "dt'")),
    "lelas2024:46": _shown(r"C \ll #1"),
    "lelas2024:53": _shown(r"C \ll 21.21\frac{Ns^2}{m^2}"),
    **_names("smith2012", _9=r"m\dotv", _17="T", _25=r"m\dotv", _32="S", _33="T", _39a="w", _39b="u",
             _42=r"\hatS_{minus}",
             _44="e^{-2u_0}(2u_0+1)", _45="w", _46a=r"2\gamma S_{minus}e^{2\gamma x}", _46c="u_f", _47=r"\hatS_{minus}",
             _48=r"\hatS_{plus}", _49=r"\hatS_1", _51=r"\hatS - \hatS_1",
             _52a=r"\hatS - \hatS_{2n}", _52b=r"\hatS - \hatS_{2n+1}", _53="E_n", _60a="f_1",
             _60b="f_2", _60c="f_3", _60d="f_4", _60e="f_5", _60f="f_6", _60g="f_7", _62a="C_i^n", _64="g_0",
             _66="C_1^{n-2}", _67="C_1^n", _68="g_1", _70=r"\tau", _59b="0", _59c="0", _59d="0"),
    "smith2012:12": Members(("0", "dS")),
    "smith2012:18b": Members((r"v\frac{T}{x} + \frac{f}{m}\frac{T}{v}",)),
    "smith2012:19": Members((TIME,), DX),
    "smith2012:20a": Members((TIME,), (AT_X, *DX)),
    **{f"smith2012:20{letter}": Members((), (AT_X, *DX)) for letter in "bcd"},
    "smith2012:23": Members((TIME,), (V_LIMITS, *DV)),
    "smith2012:24a": Members((TIME,), (AT_V, *DV)),
    "smith2012:24b": Members((), (AT_V, *DV)),
    "smith2012:26": Members((r"\frac{m}{2}v_0^2 + \frac{m}{2}\omega^2x_0^2", "S")),
    "smith2012:27a": Members((TIME,), (AT_X, *DX)),
    "smith2012:28": Members(("T", r"\omega t_0 - \tan^{-1}(\frac{\omega x_0}{v_0})")),
    "smith2012:29": Members((r"\omega t_+ - \omega t_-", r"\frac{\omega\tau}{2}", r"\frac{\pi}{2}+\frac{\pi}{2}")),
    "smith2012:30": Members(("T", r"\omega t_0 + \tan^{-1}(\frac{v_0}{\omega x_0})")),
    "smith2012:40": _shown(*(
        rf"\hatS_{{{branch}}} = \frac{{\gamma^2}}{{\omega^2}}S_{{{branch}}} = #{number}"
        for number, branch in ((1, "minus"), (2, "plus")))),
    "smith2012:24c": Members((r"v\frac{m}{F}",), (r"\Big|_{v_0}^v", r"\Big|_{v_0}^v")),
    "smith2012:27b": Members((), (AT_X, AT_X, *DX)),
    "smith2012:34": Members((r"\omega^2",)),
    "smith2012:35": _shown(_cases(r"m\ddotx", "#2 , & v > 0,", "#1 , & v < 0")),
    "smith2012:36": _shown(_cases("0 = dA", "#21 , & v < 0,", "#43 , & v > 0")),
    "smith2012:38a": _shown(r"\mu dA = dS_{minus} = #21", r"\mu dA = dS_{plus} = #43"),
    "smith2012:38b": _shown("S_{minus} = #1", "S_{plus} = #2"),
    "smith2012:50": _shown(_cases(r"\hatS = #1", r"#2 , & 0 \le \theta < \pi,", r"#3 , & \pi \le \theta < 2\pi")),
    "smith2012:52c": _shown(_cases(r"\hatS = #1", r"#2 , & 2n\pi \le \theta < (2n+1)\pi,",
                                   r"#3 , & (2n+1)\pi \le \theta < (2n+2)\pi")),
    "smith2012:54": Members((), ("dt", "dx")),
    "smith2012:55": Members((r"\frac{1}{2}\tau",), (r"\int_{x_{\min}}^{x_{\max}}", "dx")),
    "smith2012:56a": Members((r"\omega t - \omega t_0",), (r"\int_{v_0}^{v}",)),
    "smith2012:56b": Members((), (r"\int_{v_0}^{v}",)),
    "smith2012:56b corrected": Members((), (r"\right|_{v_0}^{v}", r"\int_{v_0}^{v}")),
    "smith2012:56d": Members((), (r"\right|_{v_0}^{v}",) * 3 + (r"\int_{v_0}^{v}",) * 2),
    "smith2012:57": Members(("T", r"\omega t", "-1"), (r"\sum_{n=1}^{\infty}",)),
    "smith2012:58": Members(("0", r"\omega")),
    "smith2012:59a": Members(("w",)),
    "smith2012:60h": Members(("f_n", r"C_i^n(\frac{\gamma v}{\omega})^i")),
    "smith2012:61": Members(
        ("T", r"\omega t", r"-(\frac{\gamma v}{\omega})^i", r"C_i^n(\frac{\omega v}{\gamma v^2 - \omega^2x})^n"),
        (r"\sum_{i=0}^{\infty}",),
    ),
    "smith2012:63": _shown(_cases("#1", r"-\frac{n-2}{n} = \frac{n-4}{n} = #2 , & n = \text{odd},",
                                  r"0 , & n = \text{even}")),
    "smith2012:65": _shown(_cases("C_1^n", r"#13 = #23 , & n = \text{even},", r"0 , & n = \text{odd}")),
    "smith2012:69": Members(
        (r"-\tan^{-1}(\frac{\omega v}{\gamma v^2 - \omega^2x})"
         r" - \frac{2\omega\gamma v^3}{3\omega^2v^2 + 3(\gamma v^2 - \omega^2x)^2}", "0"),
    ),
    "smith2012:71": Members(("X_n", r"x_{n-1}\frac{\pi}{\omega}")),
    "smith2012:72": Members(("0",), (r",\quad\frac{n\tau}{2}<t_n\le\frac{(n+1)\tau}{2}",)),
    "smith2012:72 corrected": Members(("0",)),
}  # fmt: skip
