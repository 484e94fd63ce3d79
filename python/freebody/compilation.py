"""Derivatives in compiled C: the same answer, faster where a model has long laws of its own."""

from __future__ import annotations

import ctypes
import hashlib
import os
import platform
import shutil
import subprocess
import tempfile
from pathlib import Path

from freebody import _check, _core
from freebody.equations import equations
from freebody.errors import InputError
from freebody.model import Model

__all__ = ["compile"]

_FLAGS = ("-std=c99", "-O3", "-fPIC", "-shared", "-fno-math-errno", "-fno-trapping-math")


def compile(model: Model) -> Model:
    """The same model with its derivative compiled by the C compiler of this machine.

    The C code is that of `freebody.equations("3.2", model=model)` over many columns. It is built once and
    kept by its content in the user's cache (`$XDG_CACHE_HOME/freebody`, or `~/.cache/freebody`). Derivatives
    and runs use it; Jacobians stay with the duals. It rounds differently, and a pickled model is the one
    without it.

    Raises
    ------
    InputError
        No C compiler (the command in `$CC`, or `cc`), one that fails, or a force that is no expression.
    """
    if not isinstance(model, Model):
        raise InputError(f"model: got {_check.shown(model)}; give a freebody.Model")
    in_quaternions = Model(model.body, model.forces, "quaternion", model.form, control=model.control)
    return model.with_compiled(_core.Compiled(_built(model), _built(in_quaternions)))


def _built(model: Model) -> tuple[int, int, int]:
    """Address of the derivative, how many numbers it is given, how many it gives."""
    source, given, results = equations("3.2", model=model).block("derivative")
    library = ctypes.CDLL(str(_library(source)))
    address = ctypes.cast(library.derivative, ctypes.c_void_p).value
    assert address is not None
    return address, given, results


def _library(source: str) -> Path:
    """The library of a C source, from the cache or built."""
    command = os.environ.get("CC", "cc")
    compiler = shutil.which(command)
    if compiler is None:
        raise InputError(
            f"compile: there is no C compiler {command!r} here; install one, name it in $CC, or use the "
            "model as it is: its answers are the same"
        )
    content = "\0".join([source, compiler, *_FLAGS, platform.machine(), _processor()])
    home = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "freebody"
    library = home / f"{hashlib.sha256(content.encode()).hexdigest()[:32]}.so"
    if not library.exists():
        home.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=home) as folder:
            text, built = Path(folder, "derivative.c"), Path(folder, "derivative.so")
            text.write_text(source)
            _run([compiler, *_FLAGS, "-march=native", "-o", str(built), str(text), "-lm"])
            built.replace(library)  # in one step: another process may build the same
    return library


def _run(command: list[str]) -> None:
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise InputError(f"compile: {' '.join(command)} failed:\n{done.stderr.strip()}")


def _processor() -> str:
    """What tells processors apart that need different code: a cache may be shared by several machines."""
    try:
        lines = Path("/proc/cpuinfo").read_text().splitlines()
    except OSError:
        return platform.processor()
    return next((line for line in lines if line.startswith(("flags", "Features"))), platform.processor())
