"""LaTeX to MathML, for pages that need no network and no script.

>>> to_mathml("x^2")
'<math ...><msup><mi>x</mi><mn>2</mn></msup></mrow></math>'
"""

from latex2mathml.converter import convert


def to_mathml(latex: str, *, display: bool = False) -> str:
    """The formula as a MathML element."""
    return str(convert(latex, display="block" if display else "inline"))
