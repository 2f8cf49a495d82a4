"""Sphinx: MyST pages, MathML without a network, executed code, a gallery that runs, warnings as errors."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "extensions"))

from asymptotics import __version__

project = "power-law-oscillator"
author = "The power-law-oscillator authors"
project_copyright = author
release = __version__

extensions = [
    "myst_parser",
    "sphinx.ext.doctest",
    "sphinx.ext.viewcode",
    "sphinx_gallery.gen_gallery",
    "offline_math",
    "reference",
    "gallery_style",
    "page_to_play",
    "math_font",
    "paper_links",
    "theory_figures",
    "common_options",
]
exclude_patterns = ["extensions", "gallery"]
myst_enable_extensions = ["dollarmath", "amsmath", "deflist", "colon_fence", "substitution"]
myst_substitutions = {"release": release}
myst_heading_anchors = 3
smartquotes = False  # --x0 is an option and x'' a derivative
html_theme = "furo"
html_static_path = ["_static"]
html_css_files = ["pages.css"]
html_search_scorer = str(Path(__file__).parent / "_static/scorer.js")
html_title = "power-law-oscillator"
html_math_renderer = "offline_mathml"
html_show_sphinx = False
html_copy_source = False
templates_path: list[str] = []
doctest_test_doctest_blocks = ""  # the examples of docstrings run with the tests, beside their own imports
doctest_global_setup = "import numpy as np\nimport sympy\nimport asymptotics as asy"
doctest_default_flags = 8 | 4  # ELLIPSIS, NORMALIZE_WHITESPACE
sphinx_gallery_conf = {
    "examples_dirs": "gallery",
    "gallery_dirs": "auto_gallery",
    "filename_pattern": "plot_",
    "capture_repr": ("_repr_html_",),  # the repr of a legend is no answer
    "download_all_examples": False,
    "show_memory": False,
    "show_signature": False,
    "abort_on_example_error": True,
    "plot_gallery": True,
    "reset_modules": ("gallery_style.reset",),
    "image_scrapers": ("gallery_style.looked_at",),
    "write_computation_times": False,
    "min_reported_time": 1000,
    "copyfile_regex": "",
    "within_subsection_order": "FileNameSortKey",
}
