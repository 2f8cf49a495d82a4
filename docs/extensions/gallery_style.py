"""The pictures of the gallery look like those of the program."""

import matplotlib

from asymptotics.present.figures import STYLE


def reset(gallery_conf, fname):
    """Called by sphinx-gallery before each page."""
    matplotlib.rcParams.update({k: v for k, v in STYLE.items() if k != "svg.hashsalt"})
    matplotlib.rcParams["figure.figsize"] = (6.4, 3.8)
    matplotlib.rcParams["figure.constrained_layout.use"] = True


def setup(app):
    """Nothing to register."""
    return {"parallel_read_safe": True, "parallel_write_safe": True}
