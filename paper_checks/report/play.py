"""The page to play with: sliders, four pictures, numbers in doubles, and the commands that give the certified ones.

One file of HTML with its style and its script inside: nothing is fetched, nobody serves it.

>>> page = play_page((("Report", "index.html"),))
>>> page.count("<script>"), "http:" in page.replace("http://www.w3.org/2000/svg", "")
(1, False)
"""

from pathlib import Path

import jinja2
from markupsafe import Markup

from asymptotics import __version__
from paper_checks.registry import IDENTIFIERS

FOLDER = Path(__file__).parent
SCRIPTS = ("play_motion.js", "play_draw.js", "play_page.js")
CONTROLS = (
    ("alpha", "exponent α"),
    ("epsilon", "strength ε"),
    ("x0", "start x(0)"),
    ("time", "until t"),
    ("alpha2", "second exponent α₂"),
    ("epsilon2", "second strength ε₂"),
)
PRESETS = (
    ("dry friction", "alpha=0&epsilon=0.03&time=60"),
    ("viscous", "alpha=1&epsilon=0.1"),
    ("air", "alpha=2&epsilon=0.2&time=80"),
    ("creep", "alpha=0.5&epsilon=0.3&time=30"),
    ("oil and friction", "alpha=1&epsilon=0.05&alpha2=0&epsilon2=0.02&time=60"),
    ("strong cubic", "alpha=3&epsilon=1&x0=2&time=60"),
)
KEY = (
    ("truth", "the motion, integrated"),
    ("lancaster", "Lancaster (13): averaged loss"),
    ("lelas", "Lelas: squaring trick"),
    ("third", "third order, one law"),
)
COMMANDS = (
    ("motion", "x and x′"),
    ("points", "turning points"),
    ("envelope", "Lancaster’s A"),
    ("squaring", "Lelas’s A"),
)


def play_page(links: tuple[tuple[str, str], ...]) -> str:
    """The page; ``links`` are (name, address) of what stands beside it."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(FOLDER),
        autoescape=True,
        undefined=jinja2.StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    return environment.get_template("play.html.j2").render(
        version=__version__,
        links=links,
        style=Markup(_text("play.css")),
        script=Markup("\n".join(_text(name) for name in SCRIPTS)),
        control=_control,
        controls=CONTROLS,
        presets=PRESETS,
        key=KEY,
        commands=COMMANDS,
        papers=[(key[:-4].capitalize() + " " + key[-4:], known["doi"]) for key, known in IDENTIFIERS.items()],
        ways=("truth", "lancaster", "lelas", "third"),
    )


def _control(name: str, text: str) -> Markup:
    lowest, highest, step = ("0", "5", "0.05") if name.startswith("alpha") else ("0", "1000", "1")
    if name == "time":
        lowest, highest, step = "5", "200", "1"
    slider = f'<input type="range" id="{name}-slider" min="{lowest}" max="{highest}" step="{step}" aria-label="{text}">'
    box = f'<input type="text" inputmode="decimal" id="{name}" autocomplete="off">'
    wrong = f'<span class="wrong" id="{name}-wrong" role="alert"></span>'
    return Markup(f'<label for="{name}"><span>{text}</span>{slider}{box}{wrong}</label>\n')


def _text(name: str) -> str:
    return (FOLDER / name).read_text(encoding="utf-8").strip()
