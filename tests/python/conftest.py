"""What tests of commands share."""

import sys

import pytest

from freebody.cli import main


@pytest.fixture
def freebody(tmp_path, monkeypatch, capsys):
    """Runs a command line in an empty folder: (exit status, standard output, standard error)."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("COLUMNS", "120")

    def run(*arguments):
        monkeypatch.setattr(sys, "argv", ["freebody", *map(str, arguments)])
        with pytest.raises(SystemExit) as ending:
            main()
        printed = capsys.readouterr()
        return ending.value.code or 0, printed.out, printed.err

    return run
