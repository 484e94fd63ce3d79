"""A random body, a random motion, fifty digits: what every section of the paper is tested on."""

from collections.abc import Iterator

import mpmath as mp
import numpy as np
import pytest

from freebody import RigidBody, forms
from freebody.verify.point_masses import Cloud, Motion

from .reference import DIGITS

MOTIONS = 6


@pytest.fixture(autouse=True)
def fifty_digits() -> Iterator[None]:
    with mp.workdps(DIGITS):
        yield


@pytest.fixture
def rng() -> np.random.Generator:
    return np.random.default_rng(1984)


@pytest.fixture(params=forms.SEQUENCES)
def angles(request: pytest.FixtureRequest) -> str:
    return request.param


@pytest.fixture
def cloud(rng: np.random.Generator) -> Cloud:
    """Eight point masses, their centre off the origin of a random body frame."""
    return Cloud.random(rng)


@pytest.fixture
def body(cloud: Cloud) -> RigidBody:
    return cloud.body


@pytest.fixture
def motion(rng: np.random.Generator, angles: str) -> Motion:
    """Six random motions at random places, away from the chart's singularity."""
    return Motion.random(rng, angles, (MOTIONS,))
