"""What of a model can be dispersed, and that it enters where it belongs."""

import pickle
from typing import Any

import numpy as np
import pytest

import freebody as fb
from freebody.ensembles.law_parameters import parameters, with_parameters

from .scene import BODY, dispersions, everything, model, state

LAWS = [*model().forces, model().control]


def test_parameters_fill_the_places_that_the_core_has_for_a_law():
    """Each number of the core once; what is kept as it is not dispersed: where gravity points, laws' own."""
    for (start, end), law in zip(model().parameter_places(), LAWS, strict=False):
        assert law is not None
        places = sorted(place for p in parameters(law) for place in p.places)
        assert places == list(range(end - start)), law


@pytest.mark.parametrize("law", LAWS, ids=lambda law: law.name)
def test_a_law_with_its_nominal_values_is_itself(law: Any):
    nominal = {p.attribute: p.nominal for p in parameters(law)}
    again = with_parameters(law, nominal)
    assert type(again) is type(law)
    assert again.name == law.name
    for name, value in nominal.items():
        of = again.parameters if isinstance(law, fb.ForceLaw | fb.ControlLaw) else vars(again)
        assert np.array_equal(np.ravel(of[name]), value)


@pytest.mark.parametrize("name", [n for n in dispersions() if "." in n and n != "fin.servo"])
def test_a_parameter_in_the_core_is_that_of_a_model_made_with_it(name: str):
    """The core is told where a number goes; a model of laws with other numbers moves the same."""
    base = model()
    ensemble = base.ensemble(state(base), {name: dispersions()[name]}, n=5, seed=2)
    runs = ensemble.run((0.0, 1.0), rtol=1e-8)
    for r in range(5):
        alone = ensemble.trajectory(r, (0.0, 1.0), rtol=1e-8)
        assert (alone.outcome.state == runs.final[r]).all()
    assert (runs.final != base.simulate(state(base), (0.0, 1.0), rtol=1e-8).outcome.state).any()


def test_names_units_and_nominal_values_stand_by_the_columns():
    ensemble = everything()
    about = dict(zip(ensemble.names, zip(ensemble.units, ensemble.nominal, strict=True), strict=True))
    assert ensemble.sample(0, 3).dispersed.shape == (3, len(ensemble.names))
    assert about["position_y"] == ("m", 2.0)
    assert about["attitude_z"] == ("rad", 0.0)
    assert about["angular_velocity_body_z"] == ("rad/s", pytest.approx(1.7, abs=1e-15))
    assert about["fin.servo"] == ("rad", 0.05)
    assert about["yaw_rate"] == ("rad/s", 0.0)
    assert about["mass"] == ("kg", 12.5)
    assert about["inertia"] == ("1", 1.0)
    assert about["drag.coefficients_2_5"] == ("N s", pytest.approx(0.1))
    assert about["drag.coefficients_5_5"] == ("N m s", pytest.approx(6.4))
    assert about["square.coefficients_2"] == ("N s^2/m^2", 0.3)
    assert about["UniformGravity.acceleration"] == ("m/s^2", 9.81)
    assert about["fin.slope"] == ("N s/m", 5.0)
    assert about["moon.mu"] == ("m^3/s^2", 50.0)
    assert about["damper.gain"] == ("s", 0.4)


def test_offsets_and_factors_are_about_the_nominal_value():
    base = model()
    u = fb.Uniform(-0.5, 0.5)
    columns = [
        base.ensemble(state(base), {"com": given}, n=50, seed=1).sample().dispersed
        for given in (u, fb.Offset(u), fb.Factor(u))
    ]
    assert (columns[1] == BODY.com + columns[0]).all()
    assert (columns[2] == BODY.com * columns[0]).all()


def test_inputs_are_dispersed_as_constants_and_beside_a_table():
    base = model()
    given = {"yaw_rate": fb.Uniform(-0.1, 0.1)}
    constant = base.ensemble(state(base), given, n=4, inputs=[0.3])
    assert constant.nominal.tolist() == [0.3]
    assert (constant.sample().inputs == constant.sample().dispersed).all()
    table = fb.InputTable([0.0, 1.0], [[0.1], [0.2]])
    added = base.ensemble(state(base), given, n=4, inputs=table)
    assert added.nominal.tolist() == [0.0]
    own = added.inputs(2)
    assert isinstance(own, fb.InputTable)
    assert (own.values == table.values + added.sample().inputs[2]).all()
    runs = added.run((0.0, 2.0), rtol=1e-8)
    alone = added.trajectory(2, (0.0, 2.0), rtol=1e-8)
    # The core adds to what it looked up, a table of one's own is looked up after: rounding apart.
    np.testing.assert_allclose(runs.final[2], alone.outcome.state, rtol=1e-9, atol=1e-9)


def test_inputs_that_are_not_dispersed_are_one_row():
    base = model()
    ensemble = base.ensemble(state(base), {"mass": fb.Uniform(1.0, 2.0)}, n=4, inputs=[0.3])
    assert ensemble.sample().inputs.tolist() == [[0.3]]
    assert ensemble.inputs(1) == pytest.approx([0.3])


@pytest.mark.parametrize("sampling", ["random", "latin_hypercube", "sobol"])
def test_a_run_has_its_draws_whatever_is_asked_for(sampling: Any):
    """All quantities at once, to the last bit."""
    whole = everything(sampling=sampling).sample()
    for first, count in ((0, 1), (123, 1), (499, 1), (7, 100), (250, 250)):
        part = everything(sampling=sampling).sample(first, count)
        rows = slice(first, first + count)
        assert (part.x0 == whole.x0[rows]).all()
        assert (part.dispersed == whole.dispersed[rows]).all()
        assert (part.inputs == whole.inputs[rows]).all()
        assert part.bodies is not None
        assert whole.bodies is not None
        assert all((a == b[rows]).all() for a, b in zip(part.bodies, whole.bodies, strict=True))
        assert part.parameters is not None
        assert whole.parameters is not None
        assert (part.parameters[0] == whole.parameters[0]).all()
        assert (part.parameters[1] == whole.parameters[1][rows]).all()


def test_an_ensemble_pickles():
    """As clusters need it: small, and with the same draws."""
    ensemble = everything(sampling="latin_hypercube", n=2000)
    draws = ensemble.sample(10, 20)
    stored = pickle.dumps(ensemble)
    assert len(stored) < 40_000  # the 2000 given values are 16 kB of it
    again = pickle.loads(stored).sample(10, 20)
    assert (again.x0 == draws.x0).all()
    assert (again.dispersed == draws.dispersed).all()


def test_a_callback_has_nothing_to_disperse():
    given = fb.callback(lambda s: fb.wrench(force=np.zeros((len(s.time), 3))), name="slow")
    assert list(parameters(given)) == []


def test_the_model_of_a_run_has_its_dispersed_numbers():
    ensemble = everything(20)
    values = dict(zip(ensemble.names, ensemble.sample(11, 1).dispersed[0].tolist(), strict=True))
    own = ensemble.model(11)
    gravity, drag, fin, push, *_ = own.forces
    assert own.body.mass == values["mass"]
    assert own.body.com.tolist() == [values[f"com_{axis}"] for axis in "xyz"]
    assert isinstance(gravity, fb.UniformGravity)
    assert gravity.acceleration == values["UniformGravity.acceleration"]
    assert isinstance(drag, fb.LinearDamping)
    assert drag.coefficients[1, 4] == values["drag.coefficients_2_5"]
    assert isinstance(fin, fb.ForceLaw)
    assert fin.parameters["slope"] == values["fin.slope"]
    assert isinstance(push, fb.ConstantWrench)
    assert push.at[2] == values["push.at_z"]
    assert isinstance(own.control, fb.ControlLaw)
    assert own.control.parameters["gain"] == values["damper.gain"]
    assert ensemble.inputs(11) == values["yaw_rate"]
    # The second moments in principal axes: the trace is that of the tensor, by the common factor.
    second = sum(values[f"second_moments_{axis}"] for axis in "xyz")
    trace = values["inertia"] * 2.0 * second
    assert np.trace(own.body.inertia_about_com) == pytest.approx(trace, rel=1e-14)
    # What the model was made of stays.
    assert ensemble.base.forces[0].acceleration == 9.81  # type: ignore[attr-defined]
