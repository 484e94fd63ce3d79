"""Progress bars for what lasts."""

from __future__ import annotations

import time
from typing import Self

from rich.console import Console
from rich.progress import (
    BarColumn,
    MofNCompleteColumn,
    Progress,
    ProgressColumn,
    Task,
    TaskProgressColumn,
    TextColumn,
    TimeRemainingColumn,
)
from rich.text import Text

__all__ = ["CampaignProgress", "LongRunProgress"]

PATIENCE = 1.0  # seconds before the bar appears
SILENCE = 30.0  # seconds between two lines where there is no terminal


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


class CampaignProgress:
    """A bar with the runs done, their rate and the time left; a line now and then where no terminal is."""

    def __init__(self, console: Console, runs: int) -> None:
        columns = (BarColumn(), MofNCompleteColumn(), TextColumn("runs"), _Rate(), TimeRemainingColumn())
        self._console, self._runs = console, runs
        self._progress = Progress(*columns, console=console, transient=True, disable=not console.is_terminal)
        self._task = self._progress.add_task("runs", total=runs, start=False)
        self._began: tuple[float, float] | None = None
        self._told = time.monotonic()

    def update(self, fraction: float) -> None:
        """Shows that `fraction` of the runs is done; the first time, what was done before."""
        done, now = round(fraction * self._runs), time.monotonic()
        if self._began is None:
            self._began = (now, done)
            if done:
                self._console.print(f"{done} of {self._runs} runs were done before")
            self._progress.start()
            self._progress.start_task(self._task)
        self._progress.update(self._task, completed=done)
        if not self._console.is_terminal and now - self._told >= SILENCE:
            self._told = now
            began, before = self._began
            rate = (done - before) / (now - began)
            left = f", {(self._runs - done) / rate:.0f} s left" if rate else ""
            self._console.print(f"{done} of {self._runs} runs, {rate:.0f} runs/s{left}")

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *error: object) -> None:
        self._progress.stop()


class _Rate(ProgressColumn):
    def render(self, task: Task) -> Text:
        return Text("" if task.speed is None else f"{task.speed:.0f} runs/s")
