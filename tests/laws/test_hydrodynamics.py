"""What water takes: damping, cross-flow drag, lift and drag of hulls and fins."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, simpson

import freebody as fb
from freebody.elements import CrossFlowDrag, Fin, HullLiftDrag, HydrodynamicDamping, lift_slope

from .scenes import START, Array
from .waters import BODY, CURRENT, DENSITY, FAST, PLACE, RESISTANCE, TILT, in_water, water

RESISTS = ("damping", "cross flow", "hull", "fin")
# Sums of some ten products in another order.
ROUNDING = 1e-13


def wrench(element: fb.Force, twist: Any, u: Any = None) -> Array:
    model = fb.Model(BODY, [element])
    return model.wrench(0.0, model.state(velocity_body=twist[:3], angular_velocity_body=twist[3:]), u)


@pytest.mark.parametrize("which", RESISTS)
def test_water_takes_power(which: str, rng: np.random.Generator) -> None:
    """In still water no motion gains by it; in a current, none as the water sees it."""
    for current in (np.zeros(3), CURRENT):
        model = fb.Model(BODY, [in_water(water(current))[which]])
        for _ in range(100):
            twist = rng.normal(size=6)
            relative = twist - np.concatenate([current, np.zeros(3)])
            x = model.state(velocity_body=twist[:3], angular_velocity_body=twist[3:])
            assert model.wrench(0.0, x) @ relative <= ROUNDING


@pytest.mark.parametrize("which", RESISTS)
def test_a_body_that_drifts_with_the_current_meets_no_resistance(which: str) -> None:
    assert not wrench(in_water(water(CURRENT))[which], np.concatenate([CURRENT, np.zeros(3)])).any()


def test_motion_in_a_current_is_motion_in_still_water_carried_along() -> None:
    """Of everything in the water together."""
    turn = START["attitude"].as_rotation()
    faster = START | {"velocity_body": START["velocity_body"] + turn.T @ CURRENT}
    runs = []
    for current, start in ((np.zeros(3), START), (CURRENT, faster)):
        model = fb.Model(BODY, [fb.UniformGravity(), *in_water(water(current)).values()])
        runs.append(model.simulate(model.state(**start), (0.0, 5.0), rtol=1e-11, save_every=0.25))
    gap = runs[1].position_world - runs[0].position_world - runs[0].t[:, None] * CURRENT
    # Some hundred steps of 1e-11 in metres; corners of |v| v met with other steps.
    assert np.abs(gap).max() <= 1e-8
    assert np.abs(runs[1].world_from_body - runs[0].world_from_body).max() <= 1e-8


def test_damping_is_its_matrices_about_its_own_point(rng: np.random.Generator) -> None:
    fast = FAST + 0.1 * rng.uniform(size=(6, 6))
    element = HydrodynamicDamping(water(), RESISTANCE, fast, at=PLACE, axes=TILT)
    for _ in range(20):
        twist = rng.normal(size=6)
        v, w = twist[:3], twist[3:]
        own = np.concatenate([TILT.T @ (v + np.cross(w, PLACE)), TILT.T @ w])
        there = -RESISTANCE @ own - fast @ (np.abs(own) * own)
        force, moment = TILT @ there[:3], TILT @ there[3:]
        expected = np.concatenate([force, moment + np.cross(PLACE, force)])
        got = wrench(element, twist)
        np.testing.assert_allclose(got, expected, rtol=0, atol=ROUNDING * np.abs(expected).max())


def test_its_parameters_are_the_hydrodynamic_derivatives() -> None:
    quadratic = np.diag([1.0, 2.0, 3.0, 4.0, 5.0, 6.0])
    quadratic[1, 5] = 0.5
    element = HydrodynamicDamping(water(), [1.5, 0.0, 0.0, 0.0, 0.0, 0.3], quadratic)
    values, units = dict(element.parameters), dict(element.parameter_units)
    assert values["X_u"] == -1.5
    assert values["N_r"] == -0.3
    assert values["Y_rr"] == -0.5
    assert (units["X_u"], units["N_r"], units["X_uu"]) == ("N s/m", "N s m", "N s^2/m^2")
    own = [key for key in values if key[0] in "XYZKMN"]
    assert len(own) == 9
    twist = [1.0, 0.0, 0.0, 0.0, 0.0, 2.0]
    got = wrench(element(X_u=-2.0), twist)
    np.testing.assert_allclose(got, [-3.0, -2.0, 0.0, 0.0, 0.0, -24.6], rtol=1e-15)


def test_cross_flow_drag_is_the_integral_over_the_length(rng: np.random.Generator) -> None:
    length, height, breadth = 1.6, 0.19, 0.1
    element = CrossFlowDrag(water(), length, height, breadth, drag_coefficient=0.9, strips=64)
    for _ in range(5):
        twist = rng.normal(size=6)

        def side(x: float, lever: int, twist: Array = twist) -> float:
            v, w = twist[1] + x * twist[5], twist[2] - x * twist[4]
            return float(-0.5 * DENSITY * 0.9 * height * v * np.hypot(v, w) * x**lever)

        def lift(x: float, lever: int, twist: Array = twist) -> float:
            v, w = twist[1] + x * twist[5], twist[2] - x * twist[4]
            return float(-0.5 * DENSITY * 0.9 * breadth * w * np.hypot(v, w) * x**lever)

        whole = [quad(f, -0.8, 0.8, (k,), epsabs=1e-12)[0] for f in (side, lift) for k in (0, 1)]
        expected = [0.0, whole[0], whole[2], 0.0, -whole[3], whole[1]]
        # Gauss's rule over 64 strips, across the place where the body turns about.
        np.testing.assert_allclose(
            wrench(element, twist), expected, rtol=0, atol=1e-3 * max(np.abs(expected))
        )


@pytest.mark.parametrize("strips", [2, 5, 16])
def test_few_strips_are_exact_where_the_flow_keeps_its_side(strips: int) -> None:
    """A ship that turns slowly while it sways: the integral of (v + x r)² in closed form."""
    length, draught, v, r = 2.0, 0.2, 1.0, 0.6
    element = CrossFlowDrag(water(), length, draught, 0.0, strips=strips)
    q, h = 0.5 * DENSITY * 1.1 * draught, length / 2.0
    sway = -q * (2.0 * h * v**2 + 2.0 / 3.0 * h**3 * r**2)
    yaw = -q * 4.0 / 3.0 * h**3 * v * r
    # With heave and pitch, which a ship's strips do not see.
    got = wrench(element, [3.0, v, 0.4, 0.2, 0.3, r])
    np.testing.assert_allclose(got, [0.0, sway, 0.0, 0.0, 0.0, yaw], rtol=0, atol=1e-12 * abs(sway))


@pytest.mark.parametrize("alpha", np.radians([2.0, 20.0, 70.0, 90.0, 170.0]))
def test_lift_of_a_hull_stands_across_the_flow(alpha: float) -> None:
    area, slope, speed = 0.2, 1.2, 1.7
    element = HullLiftDrag(water(), area, 0.12, lift_slope=slope, induced_drag=0.5)
    v = speed * np.array([np.cos(alpha), 0.6 * np.sin(alpha), 0.8 * np.sin(alpha)])
    force = wrench(element, [*v, 0.0, 0.0, 0.0])[:3]
    pressure = 0.5 * DENSITY * speed**2 * area
    coefficient = slope * np.sin(alpha) * np.cos(alpha)
    drag, lift = -force @ v / speed, np.linalg.norm(force - (force @ v) * v / speed**2)
    assert drag == pytest.approx(pressure * (0.12 + 0.5 * coefficient**2), rel=1e-12)
    assert lift == pytest.approx(pressure * abs(coefficient), rel=1e-9, abs=1e-9)
    assert abs(force @ np.cross(v, [1.0, 0.0, 0.0])) <= ROUNDING * pressure
    if alpha < 1.0:
        assert force[2] < 0.0


FIN: dict[str, Any] = {"at": [-0.7, 0.0, 0.0], "span": [0.0, 1.0, 0.0], "slope": 3.0}


def test_a_stern_plane_steers_down_and_a_rudder_to_starboard() -> None:
    stern = Fin(water(), 0.02, **FIN, angle="stern")
    assert (stern.inputs[0].name, stern.inputs[0].unit) == ("stern", "rad")
    ahead = [2.0, 0.0, 0.0, 0.0, 0.0, 0.0]
    got = wrench(stern, ahead, [0.1])
    lift = 0.5 * DENSITY * 0.02 * 4.0 * 3.0 * 0.5 * np.sin(0.2)
    # The stall, at 0.35, is smooth: its factor at 0.1 is (1 + 0.3^8)^(-1/8).
    np.testing.assert_allclose(got, [0.0, 0.0, -lift, 0.0, -0.7 * lift, 0.0], rtol=1e-4, atol=1e-12)
    rudder = Fin(water(), 0.02, [-0.7, 0.0, 0.0], span=[0.0, 0.0, -1.0], slope=3.0, angle=0.1)
    np.testing.assert_allclose(wrench(rudder, ahead)[[1, 5]], [-lift, 0.7 * lift], rtol=1e-4)


def test_a_fin_behind_the_mass_centre_feathers() -> None:
    """Sideways flow and yaw alike meet a fin: it turns the bow into the flow and resists turning."""
    fin = Fin(water(), 0.02, [-0.7, 0.0, 0.0], span=[0.0, 0.0, 1.0], slope=3.0)
    assert wrench(fin, [2.0, 0.1, 0.0, 0.0, 0.0, 0.0])[5] > 0.0
    assert wrench(fin, [2.0, 0.0, 0.0, 0.0, 0.0, 0.1])[5] < 0.0
    # The same flow at the fin, whichever way it came about.
    a, b = (wrench(fin, [2.0, v, 0.0, 0.0, 0.0, r]) for v, r in ((0.07, 0.0), (0.0, -0.1)))
    np.testing.assert_allclose(a, b, rtol=1e-12, atol=1e-14)


def test_lift_of_a_fin_follows_its_curve_and_stays_at_stall() -> None:
    stall, slope = np.radians(15.0), 3.0
    fin = Fin(water(), 0.02, **FIN, angle="delta", stall=stall)

    def coefficient(angle: float) -> float:
        force = wrench(fin, [2.0, 0.0, 0.0, 0.0, 0.0, 0.0], [angle])[2]
        return float(-force / (0.5 * DENSITY * 0.02 * 4.0))

    limit = slope * 0.5 * np.sin(2.0 * stall)
    for angle in np.radians([-7.0, 1.0, 5.0, 7.0]):
        assert coefficient(angle) == pytest.approx(slope * 0.5 * np.sin(2.0 * angle), rel=6e-4)
    assert coefficient(stall) == pytest.approx(limit * 0.5**0.125, rel=1e-12)
    assert coefficient(np.radians(45.0)) == pytest.approx(limit, rel=2e-3)
    assert max(coefficient(a) for a in np.linspace(0.0, np.pi / 2.0, 50)) < limit


def test_the_lift_slope_of_low_and_high_aspect_ratios() -> None:
    # Jones's slender wing, π A/2, and Prandtl's ellipse in the limit, 2π, which this form reaches from below.
    assert lift_slope(1e-3) == pytest.approx(np.pi / 2.0 * 1e-3, rel=1e-6)
    assert lift_slope(1e6) == pytest.approx(2.0 * np.pi, rel=1e-5)
    fin = Fin(water(), 0.02, [0, 0, 0], span=[0, 1, 0], aspect_ratio=2.0)
    assert fin.parameters["slope"] == lift_slope(2.0)
    assert fin.parameters["induced_drag"] == pytest.approx(1.0 / (np.pi * 0.9 * 2.0))


def test_what_cannot_be_is_told() -> None:
    with pytest.raises(fb.InputError, match="linear, quadratic: neither came"):
        HydrodynamicDamping(water())
    with pytest.raises(fb.InputError, match="linear: its symmetric part has the eigenvalue -1"):
        HydrodynamicDamping(water(), [1, 1, -1, 1, 1, 1])
    with pytest.raises(fb.InputError, match="quadratic: a diagonal entry is negative"):
        HydrodynamicDamping(water(), quadratic=[1, 1, -1, 1, 1, 1])
    with pytest.raises(fb.InputError, match=r"height: got -0.1 m"):
        CrossFlowDrag(water(), 1.0, [0.1, -0.1])
    with pytest.raises(fb.InputError, match="aspect_ratio, slope: neither came"):
        Fin(water(), 0.02, [0, 0, 0], span=[0, 1, 0])
    with pytest.raises(fb.InputError, match="span, chord: they are parallel"):
        Fin(water(), 0.02, [0, 0, 0], span=[1, 0, 0], slope=1.0)
    with pytest.raises(fb.InputError, match="stall: got 1 rad"):
        Fin(water(), 0.02, [0, 0, 0], span=[0, 1, 0], slope=1.0, stall=1.0)


def test_the_energy_of_body_and_water_falls_by_what_is_taken() -> None:
    """dE/dt = Vᵀ F of the forces that take, along a run with everything in still water."""
    elements = in_water(water())
    model = fb.Model(BODY, [fb.UniformGravity(), *elements.values()])
    run = model.simulate(model.state(**START), (0.0, 4.0), rtol=1e-11, save_every=0.005)
    assert run.ok
    twist = np.hstack([run.velocity_body, run.angular_velocity_body])
    added = elements["added mass"].added_mass
    moving = 0.5 * np.einsum("ni,ij,nj->n", twist, BODY.spatial_inertia + np.asarray(added), twist)
    rise = run.point([0.03, 0.01, -0.02])[:, 2] - run.com_position_world[:, 2]
    energy = moving + BODY.mass * 9.80665 * rise
    resisting = fb.Model(BODY, [elements[which] for which in RESISTS])
    taken = [resisting.wrench(t, x) @ v for t, x, v in zip(run.t, run.x, twist, strict=True)]
    assert energy[0] - energy[-1] > 10.0
    # Simpson's rule over 5 ms, on powers that change within tenths of a second, with corners in their slope.
    lost: Any = [simpson(taken[: k + 1], dx=0.005) for k in range(0, len(taken), 2)]
    np.testing.assert_allclose(energy[::2] - energy[0], lost, rtol=0, atol=1e-6 * energy[0])
