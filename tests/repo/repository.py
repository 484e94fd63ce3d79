"""The files of the repository, as the tests in this folder read them."""

import os
import re
from pathlib import Path

ROOT = Path(__file__).parents[2]
BUILT = {"target", "build", "out", "dist", "__pycache__", "_build"}
TEXT = {"", ".cff", ".css", ".html", ".lock", ".md", ".py", ".pyi", ".rs", ".sh", ".toml", ".txt", ".yml"}


def text_files() -> list[Path]:
    """Every hand-written text file: what is built, cached or hidden is left out (but not `.ci`)."""
    files: list[Path] = []
    for folder, subfolders, names in os.walk(ROOT):
        subfolders[:] = [d for d in subfolders if d not in BUILT and (d == ".ci" or not d.startswith("."))]
        paths = [Path(folder, name) for name in names]
        files += [path for path in paths if path.suffix in TEXT and not path.is_symlink()]
    return sorted(path for path in files if path.name != ".git")  # a file where a work tree is a linked one


def documents() -> list[Path]:
    """The Markdown pages."""
    return [path for path in text_files() if path.suffix == ".md"]


def blocks(page: Path, language: str) -> list[str]:
    """The fenced code blocks of one language on a page."""
    return re.findall(rf"^```{language}\n(.*?)^```", page.read_text(), re.DOTALL | re.MULTILINE)


def relative(path: Path) -> str:
    return path.relative_to(ROOT).as_posix()
