"""The page to play with, in a real browser: its numbers are those that the commands it shows prove, or nearly so."""

import json
import re
import shlex
import sys
from math import log, pi
from pathlib import Path

import pytest
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from asymptotics.expansions.normal_form.coefficients import expansion_coefficients
from asymptotics.numbers.exact import parse_real
from asymptotics.shell.main import main
from paper_checks.report.play import PRESETS, play_page

sys.path.insert(0, str(Path(__file__).parent))  # the module beside this one

from drawing import missing

pytestmark = pytest.mark.skipif(bool(missing("chromium")), reason="needs Debian's chromium and chromium-driver")

LINKS = (("The papers, checked", "index.html"),)
GRID = (
    "alpha=0&epsilon=0.03&time=20",
    "alpha=0.5&epsilon=0.3&time=12",
    "alpha=1&epsilon=0.4&x0=3&time=25",
    "alpha=1.5&epsilon=0.1&time=10",
    "alpha=2&epsilon=0.5&x0=0.7&time=20",
    "alpha=3.35&epsilon=1&x0=2&time=15",
    "alpha=5&epsilon=0.02&x0=1.5&time=5",
    "alpha=1&epsilon=0.05&alpha2=0&epsilon2=0.02&time=20",
    "alpha=2&epsilon=0.2&alpha2=0.75&epsilon2=0.04&x0=2&time=9",
)
NEAR = 2e-9
"""How far a number of the page may be from the proved one, in units of the start."""
MISSES = (
    ("676.5203681218851", "676.5203691"),
    ("44 / 45", "43 / 45"),
    ("11 / 84]]", "11.001 / 84]]"),
    ("mean(law.alpha + 1)", "mean(law.alpha + 1.0001)"),
    ("Math.pow(2, -p / 2)", "Math.pow(2, -p / 2.0001)"),
    ("[v, -q - side * loss(", "[v, -q - 1.000001 * side * loss("),
    ("const y = 1 + 2 * u,", "const y = 1 + 2.000001 * u,"),
    ("3 * a + 1) / (6", "3 * a + 1.0001) / (6"),
    ("Q: 2 * Math.PI / (1 - (x / amplitude) ** 2)", "Q: 2 * Math.PI / (1 - (x / amplitude))"),
)


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    path = tmp_path_factory.mktemp("play") / "play.html"
    path.write_text(play_page(LINKS), encoding="utf-8")
    return path


def answer(capsys, command):
    """What the command line that the page shows prints."""
    words = shlex.split(command)
    assert words[0] == "asymptotics"
    assert main([*words[1:], "--json", "--quiet"]) == 0
    return json.loads(capsys.readouterr().out)


def proved(capsys, command):
    """The numbers of all commands shown, all certified."""
    motion, points, mean, squared = (
        answer(capsys, command[f"command-{name}"]) for name in ("motion", "points", "envelope", "squaring")
    )
    assert motion["certified"] and points["certified"] and mean["certified"] and squared["certified"]
    rows = [(int(p["n"]), float(p["x"]), float(p["t"])) for p in points["points"]]
    return float(motion["x"]), float(motion["v"]), rows, float(mean["amplitude"]), float(squared["amplitude"])


def shown(browser, page, state):
    """What the page shows: doubles by the ids of their cells, rows of turning points, commands."""
    browser.get("about:blank")
    browser.get(f"{page.as_uri()}#{state}")
    assert browser.get_log("browser") == []
    values = browser.execute_script(
        "return Object.fromEntries([...document.querySelectorAll('td[id]')].map(c => [c.id, Number(c.dataset.value)]))"
    )
    rows = browser.execute_script(
        "return [...document.querySelectorAll('#points tr')].map(r => [...r.cells].map(c => Number(c.dataset.value)))"
    )
    commands = {c.get_attribute("id"): c.text for c in browser.find_elements(By.CSS_SELECTOR, "code[id]")}
    return values, rows, commands


def wrong(values, rows, truth, x0):
    """The numbers of the page that are not near the proved ones."""
    x, v, points, mean, squared = truth
    pairs = {"x-truth": x, "v-truth": v, "A-lancaster": mean, "A-lelas": squared}
    if len(points) > 2:
        ratio = points[2][1] / points[0][1]
        pairs |= {"decrement-truth": -log(ratio), "Q-truth": 2 * pi / (1 - ratio**2)}
    slack = {name: NEAR * max(x0, abs(value)) * (100 if name == "Q-truth" else 1) for name, value in pairs.items()}
    found = [name for name, value in pairs.items() if not abs(values[name] - value) <= slack[name]]
    for row, (n, place, time) in zip(rows, points):
        found += [f"x_{n}"] if not abs(row[1] - place) <= NEAR * x0 else []
        found += [f"t_{n}"] if not abs(row[2] - time) <= 20 * NEAR * max(1, time) else []
        found += [f"Smith {n}"] if len(row) > 6 and not abs(row[6] - place) <= NEAR * x0 else []
    return found


@pytest.mark.parametrize("state", GRID)
def test_the_numbers_of_the_page_are_the_proved_ones(browser, page, capsys, state):
    values, rows, commands = shown(browser, page, state)
    truth = proved(capsys, commands)
    x0, until = (float(dict(part.split("=") for part in state.split("&")).get(k, "1")) for k in ("x0", "time"))
    assert wrong(values, rows, truth, x0) == []
    assert len(rows) == sum(time <= until for _, _, time in truth[2])


@pytest.mark.slow
def test_a_wrong_coefficient_in_the_page_is_noticed(browser, page, capsys, tmp_path):
    state, text = "alpha=2&epsilon=0.5&time=9", page.read_text(encoding="utf-8")
    values, rows, commands = shown(browser, page, state)
    truth = proved(capsys, commands)
    assert wrong(values, rows, truth, 1) == [] and unlike(browser) == []
    for right, other in MISSES:
        assert text.count(right) == 1, right
        changed = tmp_path / "changed.html"
        changed.write_text(text.replace(right, other), encoding="utf-8")
        values, rows, _ = shown(browser, changed, state)
        assert wrong(values, rows, truth, 1) or unlike(browser), right


def unlike(browser):
    """The coefficients of third order in the page that are not the engine's."""
    found = []
    for alpha in ("1/2", "3/2", "2", "3"):
        own = expansion_coefficients([parse_real(alpha, "alpha")], 3, 15)
        other = browser.execute_script(f"return third({alpha})")
        wanted = {"p1": own.amplitude["1"], "p3": own.amplitude["3"], "omega2": own.frequency["2"]}
        found += [f"{name} at {alpha}" for name, c in wanted.items() if not abs(other[name] - float(c.value)) <= 1e-14]
    return found


def test_the_decrement_of_third_order_errs_by_the_fifth_power(browser, page):
    shown(browser, page, GRID[3])
    gaps = [
        browser.execute_script(
            "const law = {alpha: 2, epsilon: arguments[0]};"
            "return Math.abs(thirdDecrement(law, 1) - swing([law], 1).decrement)",
            epsilon,
        )
        for epsilon in (0.1, 0.05)
    ]
    assert 4.4 < log(gaps[0] / gaps[1], 2) < 5.7


def test_sliders_buttons_and_the_second_law_redraw_the_page(browser, page):
    shown(browser, page, "alpha=1")
    before = browser.find_element(By.ID, "x-truth").text
    browser.execute_script("const s = arguments[0]; s.value = 2.5; s.dispatchEvent(new Event('input'))",
                           browser.find_element(By.ID, "alpha-slider"))  # fmt: skip
    assert "--law 2.5:0.1 " in browser.find_element(By.ID, "command-motion").text
    assert browser.find_element(By.ID, "x-truth").text != before
    assert not browser.find_element(By.ID, "alpha2").is_displayed()
    browser.find_element(By.ID, "second").click()
    assert browser.find_element(By.ID, "alpha2").is_displayed()
    assert "--law 1:0.01 " in browser.find_element(By.ID, "command-points").text
    for button, (_, state) in zip(browser.find_elements(By.CSS_SELECTOR, "button.preset"), PRESETS):
        button.click()
        assert state.split("&")[0] in browser.current_url
    assert browser.get_log("browser") == []


@pytest.mark.parametrize(("field", "typed", "drawn", "leave"), [  # each key: drawn and refused
    ("alpha", "1,5", "--law 1.5:0.2 ", Keys.ENTER), ("alpha", "3/2", "--law 3/2:0.2 ", Keys.TAB),
    ("alpha", "12", None, Keys.ENTER), ("alpha", "12", None, Keys.TAB), ("epsilon", "100", None, Keys.TAB),
    ("epsilon", "7<script>", None, Keys.ENTER), ("epsilon", "1/8", "--law 2:1/8 ", Keys.TAB),
    ("time", "", None, Keys.ENTER), ("time", "", None, Keys.TAB), ("x0", "0,7", "--x0 0.7 ", Keys.ENTER),
    ("alpha", "1/0", None, Keys.TAB), ("alpha", "-1", None, Keys.ENTER),
    ("alpha", " 0.5 ", "--law 0.5:0.2 ", Keys.TAB),
])  # fmt: skip
def test_what_is_typed_is_drawn_or_said_to_be_wrong(browser, page, field, typed, drawn, leave):
    shown(browser, page, "alpha=2&epsilon=0.2")
    box, before = browser.find_element(By.ID, field), browser.find_element(By.ID, "x-truth").text
    box.clear()
    for letter in typed:  # nothing is judged before the whole is there
        box.send_keys(letter)
        assert browser.find_element(By.ID, "x-truth").text == before
    box.send_keys(leave)
    command, said = (browser.find_element(By.ID, name).text for name in ("command-motion", f"{field}-wrong"))
    if drawn is None:
        low, high = {"alpha": ("0", "5"), "epsilon": ("0.001", "1"), "time": ("5", "200")}[field]
        assert "--law 2:0.2 " in command and browser.find_element(By.ID, "x-truth").text == before
        assert f"{low} … {high}" in said and typed.strip() in said
        assert box.get_attribute("aria-invalid") == "true"
        red = [
            int(v)
            for v in re.findall(r"\d+", browser.find_element(By.ID, f"{field}-wrong").value_of_css_property("color"))
        ]
        assert red[0] > 2 * max(red[1:3])
    else:
        assert drawn in command and said == "" and box.get_attribute("aria-invalid") == "false"
        assert browser.find_element(By.ID, "x-truth").text != before


@pytest.mark.parametrize(
    "state", [state for _, state in PRESETS] + ["alpha=0.75&epsilon=0.8", "alpha=0.5&epsilon=0.83709"]
)
def test_the_pictures_of_a_preset_have_ticks_and_no_spikes(browser, page, state):
    shown(browser, page, state)
    for name in ("motion", "envelope", "decrement", "Q"):
        anchors = browser.execute_script(
            f"return [...document.querySelectorAll('#plot-{name} svg text')].map(t => t.getAttribute('text-anchor'))"
        )
        if anchors == ["middle"]:
            assert name in ("decrement", "Q") and "No full swing" in browser.find_element(By.ID, f"plot-{name}").text
            continue
        assert anchors.count("middle") - 1 >= 2 and anchors.count("end") >= 2, (name, anchors)
    dots = browser.execute_script(
        "return [...document.querySelectorAll('#plot-decrement circle')].map(c => +c.getAttribute('cy'))"
    )
    steps = [b - a for a, b in zip(dots, dots[1:])]
    assert all(step < 1e-6 for step in steps) or all(step > -1e-6 for step in steps)  # Lambda is monotone in A
    turns = browser.execute_script(
        "const m = motion(merged(laws()), number(state.x0), number(state.time));"
        "return m.points.map((p, i) => i > 1 && !rests(merged(laws()), p.x, number(state.x0)))"
    )
    assert len(dots) == sum(turns)


def test_dry_friction_is_written_with_the_sign(browser, page):
    shown(browser, page, "alpha=0&epsilon=0.03")
    assert "0.03 sgn x′ = 0" in browser.find_element(By.ID, "equation").text


@pytest.mark.parametrize("width", [390, 1400])
def test_every_picture_is_drawn_and_every_column_is_seen(browser, page, width):
    browser.set_window_size(width, 900)
    shown(browser, page, GRID[4])
    for name, least in (("motion", 4), ("envelope", 3), ("decrement", 4), ("Q", 4)):
        paths = browser.find_elements(By.CSS_SELECTOR, f"#plot-{name} svg path")
        assert len(paths) >= least and all("NaN" not in p.get_attribute("d") for p in paths)
        assert len(browser.find_elements(By.CSS_SELECTOR, f"#plot-{name} svg text")) >= 8
    overlaps = browser.execute_script("""
        const boxes = [...document.querySelectorAll('svg')].map(s => [...s.querySelectorAll('text')]
            .map(t => t.getBoundingClientRect()));
        return boxes.flatMap(b => b.flatMap((p, i) => b.slice(i + 1).filter(q =>
            p.left < q.right && q.left < p.right && p.top + 2 < q.bottom - 2 && q.top + 2 < p.bottom - 2))).length""")
    assert overlaps == 0
    hidden = browser.execute_script(
        "return [...document.querySelectorAll('.scroll')].filter(s => s.scrollWidth > s.clientWidth + 1).length"
    )
    assert hidden == 0


def test_the_page_is_one_file_that_asks_no_network(page):
    text = page.read_text()
    assert text.count("<script>") == 1 and "src=" not in text and "@import" not in text and "<link" not in text
    assert set(re.findall(r"https?://[^\"' ]*", text)) == {"http://www.w3.org/2000/svg"}
