"""Sphinx configuration: `make docs`."""

import tomllib
from pathlib import Path

ROOT = Path(__file__).parent.parent

project = "freebody"
author = "the freebody developers"
copyright = author
release = tomllib.loads((ROOT / "Cargo.toml").read_text())["workspace"]["package"]["version"]
extensions = ["myst_parser", "sphinx.ext.mathjax"]
myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 3
html_theme = "furo"
html_title = f"freebody {release}"
