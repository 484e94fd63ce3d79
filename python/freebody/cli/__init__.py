"""The command `freebody`; it needs the extras `cli`, `data` and `plot`."""

import sys

__all__ = ["main"]


def main() -> None:
    """Runs the command line; the exit status is 2 for bad input."""
    try:
        from .app import run_app  # noqa: PLC0415, only here can a missing extra be told

        run_app()
    except ModuleNotFoundError as error:
        if error.name is None or error.name.startswith("freebody"):
            raise
        sys.exit(f"freebody: the command line needs {error.name}: pip install 'freebody[cli,data,plot]'")
