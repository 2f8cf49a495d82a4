"""The duration of a half-swing for alpha = 2, enclosed: a quadrature with its end point singularities removed exactly.

Every step is in the derivation ``quadratic-trapezoid``.
With p = 2|u_n|, q = F(p) and t = p - 2u running from 0 to t* = p + q, the first integral gives the speed

    2 w^2 = (1+p)(1 - e^(-t)) - t = 2 t (t* - t) K(t),
    K(t) = (1+p)/2 * (E(t) - E(t*)) / (t* - t),      E(t) = (1 - e^(-t)) / t,

because 1 = (1+p) E(t*).  Then t = t* (1 - cos chi)/2 turns T = integral |du/w| into an integral without singularities,

    T = 1/2 * integral over 0 <= chi <= pi of K(t(chi))^(-1/2).

**Why K never vanishes.**  K(t) = (1+p)/2 * int_0^1 int_0^1 l e^(-l ((1-m) t + m t*)) dm dl, hence Re K > 0 and
|K(t)| >= cos(Im t) K(Re t) for |Im t| < pi/2, and K decreases along the real axis.

**Trapezoidal rule.**  The integrand is 2 pi-periodic and even in chi and analytic for |Im chi| <= a when
(t*/2) sinh a = b < pi/2.  There |K^(-1/2)| <= M = (cos b * K(t_max))^(-1/2), t_max = (t*/2)(1 + cosh a).  With N nodes
the error of T is at most pi M / (e^(aN) - 1) (Trefethen and Weideman, SIAM Rev. 56 (2014), Theorem 3.2).

**Part of a half-swing.**  The same samples give the cosine coefficients of the integrand f, |a_k| <= 2 M e^(-a k), and
with them the time from the turning point to any chi.  With m = N/2 samples, a_k for k < m is known up to its aliases
a_(2ml -+ k), and the k >= m are dropped; on [0, pi] both together cost at most

    pi M e^(-a m) (1/(1 - e^(-a)) + 2 / ((e^a - 1)(1 - e^(-2am)))).

>>> from asymptotics.turning.quadratic_map import next_amplitude
>>> duration(arb(2), next_amplitude(arb(2)))      # u_0 = 1
[3.380971060... +/- ...]
"""

from math import asinh, ceil, log

from flint import acb, arb

from asymptotics.numbers.context import ctx, lru_cache

# Nearer to pi/2 = 1.5708 the strip is hardly wider, but 1/cos b, 14 at 1.5, grows beyond all bounds.
_HEIGHT = 1.5  # b, below pi/2


def duration(p: arb, q: arb) -> arb:
    """The half-swing from 2|u| = p to the next turning point 2|u| = q = F(p), in units of 1/omega_0."""
    t_end, bits = p + q, ctx.prec
    nodes = node_count(float(t_end.mid()), bits)
    with ctx.workprec(_sampling_bits(t_end, nodes)):
        samples = _samples(t_end, p, nodes)
        strip, bound = _strip(t_end, p)
        # Trefethen and Weideman, theorem 3.2, half of the period and the factor 1/2 of T included.
        error = arb.pi() * bound / ((strip * nodes).exp() - 1)
        value = arb.pi() * _sum(samples) / nodes + arb(0, error.upper())
    return +value


def elapsed(p: arb, q: arb, chi: arb) -> arb:
    """The time from the turning point 2|u| = p to 2u = p - (p+q)(1 - cos chi)/2 on the same half-swing, 0 <= chi <= pi.

    >>> from asymptotics.turning.quadratic_map import next_amplitude
    >>> p, q = arb(2), next_amplitude(arb(2))
    >>> elapsed(p, q, arb.pi()).overlaps(duration(p, q))
    True
    """
    t_end, bits = p + q, ctx.prec
    m = node_count(float(t_end.mid()), bits)  # twice the samples: here the error is e^(-a N / 2)
    with ctx.workprec(_sampling_bits(t_end, 2 * m)):
        samples = _samples(t_end, p, 2 * m)
        strip, bound = _strip(t_end, p)
        # chi + 2 sum_(k<m) sin(k chi)/k cos(k x_j) at the midpoints x_j = pi (2j + 1)/(2m): one Fourier transform.
        waves = [acb(arb(-k) / (2 * m)).exp_pi_i() * (k * chi).sin() / k for k in range(1, m)]
        weights = [chi + 2 * w.real for w in acb.dft([0, *waves, *[0] * m])[:m]]
        growth = strip.exp()
        # Dropped coefficients and aliases, in the formula of the module's docstring.
        error = 1 / (1 - 1 / growth) + 2 / ((growth - 1) * (1 - growth ** (-2 * m)))
        error *= arb.pi() * bound * growth**-m
        value = _sum([w * f for w, f in zip(weights, samples)]) / (2 * m) + arb(0, error.upper())
    return +value


def node_count(t_end: float, bits: int) -> int:
    """An even number of nodes that makes the error about 2^-bits; only a choice, the bound does not rely on it."""
    width = asinh(2 * _HEIGHT / t_end)
    # e^-(a N) = 2^-bits with six units of the exponent for M; a double names the number, the bound is computed from it.
    return 2 * ceil((bits * log(2) + 6 + width) / width / 2)


def _sampling_bits(t_end: arb, nodes: int) -> int:
    """The working precision plus what the differences in K lose when t* is small and next to t = t*."""
    # K is a difference of nearly equal means over t* - t: next to t*, at chi = pi (1 - 1/nodes), it loses 2 log2(nodes)
    # bits, and for small t* as many as 2 log2(1/t*).
    return ctx.prec + 20 + 2 * nodes.bit_length() + 2 * max(0, ceil(-log(float(t_end.mid()), 2)))


def _samples(t_end: arb, p: arb, nodes: int) -> list[arb]:
    """K^(-1/2) at the midpoints of [0, pi] cut into nodes/2 parts."""
    return [_kernel(t_end * versine, t_end, p).rsqrt() for versine in _versines(nodes // 2, ctx.prec)]


@lru_cache(maxsize=32)
def _versines(m: int, bits: int) -> tuple[arb, ...]:
    """(1 - cos chi)/2 = sin^2(chi/2) at the m midpoints; the same for all half-swings, hence remembered."""
    with ctx.workprec(bits):
        return tuple((chi / 2).sin() ** 2 for chi in _midpoints(m))


def _midpoints(m: int) -> list[arb]:
    return [arb.pi() * (2 * k + 1) / (2 * m) for k in range(m)]


def _strip(t_end: arb, p: arb) -> tuple[arb, arb]:
    """The half-width a of the strip and the bound M of |K^(-1/2)| on it."""
    a = (2 * arb(_HEIGHT) / t_end).asinh()
    t_max = t_end / 2 * (1 + a.cosh())
    return a, (arb(_HEIGHT).cos() * _kernel(t_max, t_end, p)).rsqrt()


def _kernel(t: arb, t_end: arb, p: arb) -> arb:
    """K(t) for t != 0, t*."""
    return (1 + p) / 2 * (_mean_exponential(t) - _mean_exponential(t_end)) / (t_end - t)


def _mean_exponential(t: arb) -> arb:
    """E(t) = (1 - e^(-t)) / t."""
    return -((-t).expm1()) / t


def _sum(terms: list[arb]) -> arb:
    return sum(terms, arb(0))
