"""What lies where in the store of a campaign: everything but the results of runs, as keys and bytes."""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import prod
from typing import Any, NamedTuple

import numpy as np
import zarr
from numpy.typing import NDArray
from zarr.codecs import Crc32cCodec, ZstdCodec

from freebody.ensembles import Ensemble
from freebody.ensembles.layout import Variable, coordinates, variables
from freebody.simulation import OUTCOMES, Settings

__all__ = ["DONE", "ROOT", "Layout", "bytes_of_a_run"]

ROOT = "zarr.json"
DONE = "runs_done"

# What stands where a run is not done yet; for all others NaN or zero.
_FILLS = {"outcome": OUTCOMES.index("not_run"), "culprit": -1, "stopped_by": -1}
# The checksums make a damaged file an error where it would be wrong numbers. Doubles that come out of runs do
# not become smaller by more than a fifth, and would take longer to compress than to compute.
_CHECKED = Crc32cCodec()
_COMPRESSED = ZstdCodec(level=1, checksum=True)

_RUN = Variable(("run",), "int64", {"long_name": "number of the run"})
_DONE = Variable(("chunk",), "uint32", {"long_name": "stored runs of each chunk, written last"})


class _Array(NamedTuple):
    variable: Variable
    shape: tuple[int, ...]
    chunks: tuple[int, ...]
    values: NDArray[Any] | None = None


@dataclass(frozen=True)
class Layout:
    """The arrays of a store.

    Attributes
    ----------
    ensemble, settings
        What its runs are.
    chunk
        Runs in one chunk of every array: two chunks have no file in common.
    attributes
        Of the store: text and numbers.
    """

    ensemble: Ensemble
    settings: Settings
    chunk: int
    attributes: Mapping[str, Any]

    def documents(self) -> dict[str, bytes]:
        """The keys and bytes of a store of which no run is done, the root first.

        They depend on nothing else, so that a store that has grown is the same as one made so large.
        """
        made: dict[str, Any] = {}
        labels = coordinates(self.ensemble, self.settings)
        beside = " ".join(name for name, (dimension, *_) in labels.items() if name != dimension)
        attributes = {**self.attributes, "n": self.ensemble.n, "chunk": self.chunk, "coordinates": beside}
        group = zarr.create_group(store=made, zarr_format=3, attributes=_plain(attributes))
        for name, array in self._arrays():
            _create(group, name, array)
        documents = {key: made[key].to_bytes() for key in sorted(made, key=lambda key: key != ROOT)}
        documents[ROOT] = _consolidated(documents)
        return documents

    def _arrays(self) -> Iterator[tuple[str, _Array]]:
        n, chunk = self.ensemble.n, self.chunk
        labels = coordinates(self.ensemble, self.settings)
        sizes = {name: len(values) for name, (dimension, values, _) in labels.items() if name == dimension}
        for name, variable in {"run": _RUN, **variables(self.ensemble, self.settings)}.items():
            others = tuple(sizes[dim] for dim in variable.dims[1:])
            yield name, _Array(variable, (n, *others), (chunk, *others))
        for name, (dimension, values, attributes) in labels.items():
            variable = Variable((dimension,), values.dtype.str, attributes)
            yield name, _Array(variable, values.shape, values.shape, values)
        yield DONE, _Array(_DONE, (-(-n // chunk),), (1,))


def bytes_of_a_run(ensemble: Ensemble, settings: Settings) -> int:
    """What one run takes in memory."""
    layout = Layout(ensemble, settings, 1, {})
    return sum(
        np.dtype(array.variable.dtype).itemsize * prod(array.chunks)
        for _, array in layout._arrays()
        if array.values is None
    )


def _create(group: zarr.Group, name: str, array: _Array) -> None:
    dims, dtype, attributes = array.variable
    kind = np.dtype(dtype).kind
    made = group.create_array(
        name,
        shape=array.shape,
        chunks=array.chunks,
        dtype=str if kind == "U" else dtype,
        fill_value="" if kind == "U" else _FILLS.get(name, np.nan if kind == "f" else 0),
        compressors=None if name == DONE else _CHECKED if kind == "f" else _COMPRESSED,
        dimension_names=dims,
        attributes=_plain(attributes),
    )
    if array.values is not None:
        made[...] = array.values.astype(np.dtypes.StringDType()) if kind == "U" else array.values


def _consolidated(documents: Mapping[str, bytes]) -> bytes:
    """The root with the metadata of all arrays inside: one request opens the store.

    zarr-python would write the same, with a warning that other libraries need not know this.
    """
    arrays = {
        key.removesuffix(f"/{ROOT}"): json.loads(value)
        for key, value in documents.items()
        if key.endswith(f"/{ROOT}")
    }
    root = json.loads(documents[ROOT])
    root["consolidated_metadata"] = {"kind": "inline", "must_understand": False, "metadata": arrays}
    return json.dumps(root, indent=2).encode()


def _plain(attributes: Mapping[str, Any]) -> dict[str, Any]:
    """Attributes as JSON has them."""
    return {
        key: value.tolist() if isinstance(value, np.ndarray | np.generic) else value
        for key, value in attributes.items()
    }
