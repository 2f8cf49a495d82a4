"""Formulas as a browser draws them, and as ziamath lays them out from the same font: ink, cell by cell.

Chromium is led by its driver; Firefox, which needs none for that, photographs a page by itself.
"""

import base64
import io
import re
import shutil
import subprocess
import warnings
from importlib import import_module
from pathlib import Path

import numpy as np
from matplotlib import image
from selenium import webdriver

SIZE, WIDTH, HEIGHT, COLUMNS = 40, 300, 160, 4
FLAGS = (
    "--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-component-update",
    "--disable-background-networking", "--disable-sync", "--window-size=390,844",
)  # fmt: skip
BROWSERS = {"chromium": ("chromium", "chromedriver"), "firefox": ("firefox-esr",)}


def missing(name):
    """Which of the programs for a browser are not installed."""
    return [program for program in BROWSERS[name] if shutil.which(program) is None]


def start(name, profile):
    """A browser without a window and without a network: Chromium led by its driver, Firefox as ``Camera``."""
    if name == "firefox":
        return Camera(Path(profile))
    program, driver = (shutil.which(each) for each in BROWSERS[name])
    options = webdriver.ChromeOptions()
    options.binary_location = program
    for flag in (*FLAGS, f"--user-data-dir={profile}"):
        options.add_argument(flag)
    return webdriver.Chrome(options, webdriver.ChromeService(driver))


class Camera:
    """Firefox, started for each picture, with a profile (a folder that is there) and a home of its own."""

    def __init__(self, profile):
        self.home = profile

    def quit(self):
        """Nothing runs between two pictures."""

    def photograph(self, page, width, height):
        """The page as pixels, from its left upper corner."""
        target = self.home / f"{page.stem}.png"
        words = ["--headless", "--no-remote", "--profile", self.home, f"--window-size={width},{height}"]
        surroundings = {"HOME": str(self.home), "PATH": "/usr/bin:/bin", "MOZ_DISABLE_CONTENT_SANDBOX": "1"}
        subprocess.run(
            [shutil.which("firefox-esr"), *words, "--screenshot", target, page.as_uri()],
            env=surroundings, check=True, capture_output=True, timeout=120,
        )  # fmt: skip
        return image.imread(target)


def reference(mathml):
    """The formula as paths: the layout is ziamath's, and no browser has a say in which glyphs there are."""
    plain = re.sub(r"(?<=>)-(?=</mo>)|&#x0002D;", "\u2212", mathml)
    return typesetter().Math(plain, size=SIZE).svg()


def typesetter():
    """ziamath: a second to load, in the one process of `make test` that draws."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of importlib.resources, which it asks for its font
        return import_module("ziamath")


def sheet(cells, css):
    """A page with one formula in each cell, all of one size, black on white."""
    grid = f"display:grid;grid-template-columns:repeat({COLUMNS},{WIDTH}px);grid-auto-rows:{HEIGHT}px"
    place = "display:flex;align-items:center;justify-content:center;overflow:hidden"
    own = f"body{{margin:0;background:#fff;color:#000}}.s{{{grid}}}.s>div{{{place}}}math{{font-size:{SIZE}px}}"
    own += "mtd{padding:2px .15em}"
    body = "".join(f"<div>{cell}</div>" for cell in cells)
    return f'<!doctype html><meta charset="utf-8"><style>{css}\n{own}</style><div class="s">{body}</div>'


def inks(browser, path, cells, css):
    """The ink of each cell, cut to its box: arrays of darkness between 0 and 1."""
    path.write_text(sheet(cells, css), encoding="utf-8")
    size = COLUMNS * WIDTH, -(-len(cells) // COLUMNS) * HEIGHT
    picture = browser.photograph(path, *size) if isinstance(browser, Camera) else _photograph(browser, path, *size)
    dark = 1 - picture[:, :, :3].mean(axis=2)
    found = []
    for i in range(len(cells)):
        top, left = i // COLUMNS * HEIGHT, i % COLUMNS * WIDTH
        found.append(cut(dark[top : top + HEIGHT, left : left + WIDTH]))
    return found


def _photograph(browser, page, width, height):
    browser.set_window_size(width + 40, height + 200)
    browser.get(page.as_uri())
    browser.execute_async_script("document.fonts.ready.then(arguments[0])")
    element = browser.find_element("css selector", ".s")
    return image.imread(io.BytesIO(base64.b64decode(element.screenshot_as_base64)), format="png")


def cut(ink):
    """The part of a picture that has ink."""
    rows, columns = (np.flatnonzero((ink > 0.3).any(axis=axis)) for axis in (1, 0))
    if not len(rows):
        return np.zeros((0, 0))
    return ink[rows[0] : rows[-1] + 1, columns[0] : columns[-1] + 1]


def room(browser, name):
    """How far boxes may differ, in pixels: 0.3 em; Firefox gives the limits of a big sum more room."""
    return (0.35 if isinstance(browser, Camera) and name == "munderover" else 0.3) * SIZE


def unlike(one, other, slack=0.3 * SIZE, share=0.2):
    """Why two inks are not one drawing, or an empty text: boxes to 0.3 em (spaces differ), ink to a fifth."""
    for axis, name in enumerate(("height", "width")):
        sizes = one.shape[axis], other.shape[axis]
        if abs(sizes[0] - sizes[1]) > slack:
            return f"{name} {sizes[0]} instead of {sizes[1]} pixels"
    amounts = one.sum(), other.sum()
    if abs(amounts[0] - amounts[1]) > share * max(amounts):
        return f"ink {amounts[0]:.0f} instead of {amounts[1]:.0f}"
    return ""
