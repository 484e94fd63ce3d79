"""A progress bar for runs that last."""

from __future__ import annotations

import time
from typing import Self

from rich.console import Console
from rich.progress import BarColumn, Progress, TaskProgressColumn, TextColumn, TimeRemainingColumn

__all__ = ["LongRunProgress"]

PATIENCE = 1.0  # seconds before the bar appears


class LongRunProgress:
    """A bar on a terminal from the second second of a run on; elsewhere nothing."""

    def __init__(self, console: Console) -> None:
        columns = (TextColumn("simulating"), BarColumn(), TaskProgressColumn(), TimeRemainingColumn())
        self._progress = Progress(*columns, console=console, transient=True, disable=not console.is_terminal)
        self._task = self._progress.add_task("simulating", total=1.0)
        self._appears = time.monotonic() + PATIENCE
        self._shown = False

    def update(self, fraction: float) -> None:
        """Shows that `fraction` of the time span is done."""
        if not self._shown and time.monotonic() >= self._appears:
            self._progress.start()
            self._shown = True
        self._progress.update(self._task, completed=fraction)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        if self._shown:
            self._progress.stop()
