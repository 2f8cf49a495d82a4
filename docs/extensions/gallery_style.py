"""The pictures of the gallery look like those of the program."""

import matplotlib
import matplotlib.pyplot as plt
from picture_faults import faults
from sphinx_gallery.scrapers import matplotlib_scraper

from asymptotics.present.figures import STYLE


def reset(gallery_conf, fname):
    """Called by sphinx-gallery before each page."""
    matplotlib.rcParams.update({k: v for k, v in STYLE.items() if k != "svg.hashsalt"})
    matplotlib.rcParams["figure.figsize"] = (6.4, 3.8)
    matplotlib.rcParams["figure.constrained_layout.use"] = True


def looked_at(block, block_vars, gallery_conf, **options):
    """Sphinx-gallery's scraper, for pictures without faults: empty axes, ticks over ticks, a legend over data."""
    for number in plt.get_fignums():
        found = faults(plt.figure(number))
        if found:
            raise ValueError(f"{block_vars['src_file']}: {'; '.join(found)}")
    return matplotlib_scraper(block, block_vars, gallery_conf, **options)


def setup(app):
    """Nothing to register."""
    return {"parallel_read_safe": True, "parallel_write_safe": True}
