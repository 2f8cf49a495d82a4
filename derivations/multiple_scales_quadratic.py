"""Air, X'' + X + eps X'|X'| = 0, by multiple scales to fourth order in full, in the turning-point gauge.

On 0 < psi < pi the velocity is negative, so the force is -eps X'^2, a polynomial.  Nothing is known but the ansatz:
each order inserts it, solves by variation of constants and takes D_n a and D_n psi from the next turning point.

>>> [str(rate) for rate in rates[3]], [str(rate) for rate in rates[4]]
(['-2*a**4/(135*pi)', '0'], ['0', '-7*a**4/432'])
"""

import sympy
from sympy import cos, pi, sin

from derivations.steps import At, Derivation, defined, named

a = sympy.Symbol("a", positive=True)
psi, eps, f, g = sympy.symbols("psi epsilon f g", real=True)
R = sympy.Rational
Field = tuple[sympy.Expr, sympy.Expr]

derivation = Derivation(
    "multiple-scales-quadratic",
    "Multiple scales for air drag to fourth order",
    source="turning-point gauge; Lancaster 2020, (13) is the first order, Smith 2012 has the half-swing",
)
step = derivation.step


def D(field: Field, h: sympy.Expr) -> sympy.Expr:
    """f dh/da + g dh/dpsi."""
    return sympy.expand(field[0] * sympy.diff(h, a) + field[1] * sympy.diff(h, psi))


def reduced(h: sympy.Expr) -> sympy.Expr:
    """sin^2 psi -> 1 - cos^2 psi."""
    s = sympy.Symbol("s")
    parts = sympy.Poly(sympy.expand(h).subs(sin(psi), s), s)
    squared = 1 - cos(psi) ** 2
    return sympy.expand(sum(c * squared ** (n // 2) * sin(psi) ** (n % 2) for (n,), c in parts.terms()))


def mean_part(m: int) -> sympy.Expr:
    """int cos^m psi dpsi: (1/m) sin cos^(m-1) + ((m-1)/m) int cos^(m-2)."""
    if m == 0:
        return psi
    rest = mean_part(m - 2) * R(m - 1, m) if m >= 2 else sympy.S.Zero
    return sin(psi) * cos(psi) ** (m - 1) / m + rest


def primitive(h: sympy.Expr) -> sympy.Expr:
    """int_0^psi of a polynomial in psi, sin psi, cos psi: psi^n u' = (psi^n u)' - n psi^(n-1) u, from the highest n."""
    total, work, s, c = sympy.S.Zero, reduced(h), sympy.Symbol("s"), sympy.Symbol("c")
    while work != 0:
        terms = sympy.Poly(work.subs({sin(psi): s, cos(psi): c}), psi, s, c).terms()
        n = max(terms)[0][0]
        secular = waves = work = sympy.S.Zero
        for (k, odd, m), q in terms:
            if k < n:
                work += q * psi**k * sin(psi) ** odd * cos(psi) ** m
                continue
            inner = sympy.expand(-(cos(psi) ** (m + 1)) / (m + 1) if odd else mean_part(m))
            secular += q * inner.coeff(psi, 1)
            waves += q * (inner - inner.coeff(psi, 1) * psi)
        total += psi**n * waves + secular * psi ** (n + 1) / (n + 1)
        work = reduced(work - n * psi ** (n - 1) * waves)
    total = reduced(total)
    return sympy.expand(total - total.subs(psi, 0))


rates: list[Field] = [(sympy.S.Zero, sympy.S.One)]
X, V = [a * cos(psi)], [-a * sin(psi)]


def slow(parts: list[sympy.Expr], n: int) -> sympy.Expr:
    """sum_(0<j<n) D_j of the part of order n - j."""
    return sympy.expand(sum((D(rates[j], parts[n - j]) for j in range(1, n)), sympy.S.Zero))


def force(n: int) -> sympy.Expr:
    """The part of order n of -eps V^2."""
    return -sympy.expand(sum((V[j] * V[n - 1 - j] for j in range(n)), sympy.S.Zero))


step("Order 0: X_0 = a cos psi", sympy.Derivative(X[0], psi, 2) + X[0], sympy.S.Zero)
u, w, K, L = (sympy.Function(letter)(psi) for letter in "uwKL")
x, v = cos(psi) * u + sin(psi) * w, cos(psi) * w - sin(psi) * u
u_prime = -f + sin(psi) * L - cos(psi) * K
w_prime = a * g - sin(psi) * K - cos(psi) * L
given = {sympy.Derivative(u, psi): u_prime, sympy.Derivative(w, psi): w_prime}
step(
    "X_n = cos psi u + sin psi w and V_n = cos psi w - sin psi u, with u' = -f + sin psi L - cos psi K and"
    " w' = a g - sin psi K - cos psi L, solve V_n = X_n' + K + D_n X_0, D_n = f d/da + g d/dpsi",
    At(sympy.Derivative(x, psi).doit(), given) + K + f * cos(psi) - a * g * sin(psi),
    v,
)
step(
    "and V_n' + X_n + L + D_n V_0 = 0",
    At(sympy.Derivative(v, psi).doit(), given) + x + L - f * sin(psi) - a * g * cos(psi),
    sympy.S.Zero,
)

for n in range(1, 5):
    k, l = slow(X, n), sympy.expand(slow(V, n) + force(n))  # noqa: E741 (the letters of the page)
    waves, speeds = (
        [named(f"{letter}_{j}", part) for j, part in enumerate(parts)] for letter, parts in (("X", X), ("V", V))
    )
    drag = [named(f"V_{j}", V[j]) for j in range(n)]
    pairs = sum((drag[j] * drag[n - 1 - j] for j in range(n)), sympy.S.Zero)
    where = ": it is L_1, and K_1 = 0" if n == 1 else ""
    step(f"Order {n}, the force of the ansatz, eps^{n} in -eps V^2{where}", -pairs, sympy.collect(force(n), a))
    if n > 1:
        slopes = [defined(f"D_{j}", lambda h, j=j: D(rates[j], h)) for j in range(1, n)]
        step(f"K_{n} = sum D_j X_({n}-j)", sum(s(waves[n - 1 - j]) for j, s in enumerate(slopes)), k)
        left = sum(s(speeds[n - 1 - j]) for j, s in enumerate(slopes)) - pairs
        step(f"L_{n} = sum D_j V_({n}-j) + the force", left, l)
    up, down = reduced(sin(psi) * l - cos(psi) * k), reduced(sin(psi) * k + cos(psi) * l)
    lifted, turned = primitive(up), primitive(down)
    K_n, L_n = named(f"K_{n}", k), named(f"L_{n}", l)
    f_n = sympy.expand(lifted.subs(psi, pi) / pi)
    g_n = sympy.expand(turned.subs(psi, pi) / (pi * a))
    step(
        f"X_{n}(pi) = 0: pi D_{n} a is",
        sympy.Integral(sin(psi) * L_n - cos(psi) * K_n, (psi, 0, pi)),
        pi * f_n,
    )
    step(
        f"V_{n}(pi) = 0: pi a D_{n} psi is",
        sympy.Integral(sin(psi) * K_n + cos(psi) * L_n, (psi, 0, pi)),
        pi * a * g_n,
    )
    rates.append((f_n, g_n))
    U, W = lifted - f_n * psi, a * g_n * psi - turned
    X.append(reduced(cos(psi) * U + sin(psi) * W))
    V.append(reduced(cos(psi) * W - sin(psi) * U))
    D_n = defined(f"D_{n}", lambda h, n=n: D(rates[n], h))
    X_n = named(f"X_{n}", X[n])
    step(
        f"The wave X_{n} solves its equation",
        sympy.Derivative(X_n, psi) + K_n + D_n(waves[0]),
        V[n],
    )
    step(f"X_{n} is this on 0 < psi < pi, X(psi + pi) = -X(psi), and vanishes at psi = pi", At(X[n], {psi: pi}), 0)

step("p_1 = 4/(3 pi), Lancaster's", -named("D_1(a)", rates[1][0]) / a**2, R(4, 3) / pi)
step("Omega_2 = -1/6", named("D_2(psi)", rates[2][1]) / a**2, -R(1, 6))
step("p_3", -named("D_3(a)", rates[3][0]) / a**4, R(2, 135) / pi)
step("Omega_4", named("D_4(psi)", rates[4][1]) / a**4, -R(7, 432))


def residual(third: sympy.Expr) -> sympy.Expr:
    """eps^3 of V = D X and D V + X - eps V^2 with D_3 a = ``third``: the second equation, V from the first."""
    fields = [*rates[:3], (third, rates[3][1])]

    def along(parts: list[sympy.Expr], top: int) -> sympy.Expr:
        return sum((D(fields[j], parts[top - j]) for j in range(top + 1)), sympy.S.Zero)

    speeds = [along(X, j) for j in range(4)]
    drag = sum((speeds[j] * speeds[2 - j] for j in range(3)), sympy.S.Zero)
    return reduced(along(speeds, 3) + X[3] - drag)


defect = defined("R", residual)
step("Without any hierarchy: the residual R(D_3 a) of X in the equation at eps^3", defect(rates[3][0]), 0)
wrong = -R(1, 135) * a**4 / pi
step("Near miss: with half of it, it is not zero", defect(wrong), -R(2, 135) * a**4 * sin(psi) / pi)
