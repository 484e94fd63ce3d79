"""The face that users see: the contract of the design, complete, documented, truly told to type checkers."""

import ast
import inspect
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

import freebody as fb
from freebody import _core, attitude, body, errors, forces

STUBS = ast.parse(Path(_core.__file__).with_name("_core.pyi").read_text(encoding="utf-8"))


def test_the_contract() -> None:
    inertia = np.diag([1.0, 1.4, 1.9])
    body = fb.RigidBody(mass=12.5, com=[0.12, -0.05, 0.08], inertia_about_com=inertia)
    assert body.spatial_inertia.shape == (6, 6)
    rotation = fb.Attitude.angles("zyx", [0.1, 0.2, 0.3]).as_rotation()
    assert isinstance(body.in_frame(origin=[1.0, 2.0, 3.0], rotation=rotation), fb.RigidBody)

    position, twist = [1.0, 2.0, 3.0], np.arange(6.0)
    assert fb.forms.wrench_transform(position, rotation).shape == (6, 6)
    assert fb.forms.force_cross(twist).shape == (6, 6)
    q, q_dot = np.array([1.0, 2.0, 3.0, 0.5, -0.2, 0.3]), np.arange(6.0)
    g = fb.forms.generalized(body, q, q_dot, angles="zyx")
    for matrix in (g.D, g.K, g.A1, g.B1, g.Phi1):
        assert matrix.shape == (6, 6)
    assert g.M0.shape == g.M0_dot.shape == (3, 3)
    lagrange = fb.forms.lagrange(body, q, q_dot, angles="zyx")
    assert lagrange.A.shape == lagrange.B.shape == lagrange.Phi_q.shape == (6, 6)
    assert lagrange.christoffel.shape == (6,)

    forces = [fb.UniformGravity(9.81), fb.LinearDamping([0.1, 0.1, 0.1, 0.2, 0.2, 0.2])]
    model = fb.Model(body, forces=forces, attitude="quaternion")
    x0 = model.state(
        position=[0.0, 0.0, -100.0],
        attitude=fb.Attitude.angles("zyx", [0.5, -0.2, 0.3]),
        velocity_body=[10.0, 0.0, 0.0],
        angular_velocity_body=[0.1, 0.2, 0.3],
    )
    t, u = 0.0, np.zeros(6)
    assert model.derivative(t, x0, u).shape == (13,)
    a, b = model.jacobian(t, x0, u)
    assert a.shape == (len(model.state_names), len(model.state_units)) == (13, 13)
    assert b.shape == (13, len(model.input_names)) == (13, 6)
    run = model.simulate(x0, (0.0, 10.0), rtol=1e-9, save_every=0.01)
    assert isinstance(run, fb.Trajectory)
    assert run.t.shape == run.energy.shape == (1001,)
    assert run.momentum_world.shape == (1001, 6)
    assert run.to_xarray().sizes["time"] == 1001
    assert run.outcome.ok


@pytest.mark.parametrize("attitude", ["zyx", "quaternion"])
@pytest.mark.parametrize("form", ["quasi_velocity", "generalized"])
def test_the_contract_in_every_form(attitude: str, form: str) -> None:
    body = fb.RigidBody(1.0, inertia_about_com=np.eye(3))
    model = fb.Model(body, forces=[fb.UniformGravity(9.81)], attitude=attitude, form=form)  # type: ignore[arg-type]
    assert model.simulate(model.state(), (0.0, 1.0)).ok


def public(of: type) -> Iterator[tuple[str, object]]:
    for name in dir(of):
        # What exceptions have is Python's own.
        if not name.startswith("_") and not hasattr(BaseException, name):
            yield name, inspect.getattr_static(of, name)


def documented() -> Iterator[tuple[str, object]]:
    """Every public thing with what its documentation is read from."""
    yield "freebody", fb
    for module in (fb, fb.forms):
        for name in module.__all__:
            thing = getattr(module, name)
            yield name, thing
            if inspect.isclass(thing) and not issubclass(thing, tuple):
                yield from ((f"{name}.{member}", getattr(thing, member)) for member, _ in public(thing))


def test_all_is_complete() -> None:
    for module in (fb, fb.forms):
        assert len(set(module.__all__)) == len(module.__all__)
        assert [name for name in module.__all__ if not hasattr(module, name)] == []
    # Whatever a method gives back, or a message names, can be imported from the top.
    for module in (errors, forces, body, attitude):
        assert set(module.__all__) <= set(fb.__all__), module.__name__
    assert {"Trajectory", "Outcome", "ChartChange", "Conserved", "Linearization", "InputTable"} <= set(
        fb.__all__
    )


def test_everything_public_is_documented() -> None:
    bare = [
        name
        for name, thing in documented()
        if (callable(thing) or inspect.ismodule(thing) or inspect.isdatadescriptor(thing))
        and not inspect.getdoc(thing)
    ]
    assert bare == []


def test_everything_public_is_annotated() -> None:
    """Functions and methods written in Python; those of the core are in the stubs."""
    bare = []
    for name, thing in documented():
        functions = [thing.__init__] if inspect.isclass(thing) else [getattr(thing, "__func__", thing)]  # type: ignore[misc]
        for function in filter(inspect.isfunction, functions):
            hints = function.__annotations__
            wanted = [p for p in inspect.signature(function).parameters if p not in {"self", "cls"}]
            bare += [f"{name}: {p}" for p in [*wanted, "return"] if p not in hints]
    assert bare == []


def test_the_units_of_what_bodies_hold_are_said() -> None:
    units = {"mass": "kg", "com": "m", "inertia_about_com": "kg m²", "principal_moments": "kg m²"}
    for name, unit in units.items():
        assert unit in (inspect.getdoc(getattr(fb.RigidBody, name)) or "")


def stub_functions(body: list[ast.stmt]) -> dict[str, list[str]]:
    """Names of the parameters of the functions of a stub file or class, without self and cls."""

    def names(given: ast.arguments) -> list[str]:
        several = [given.vararg] if given.vararg is not None else []
        return [a.arg for a in (*given.args, *several, *given.kwonlyargs) if a.arg not in {"self", "cls"}]

    return {node.name: names(node.args) for node in body if isinstance(node, ast.FunctionDef)}


def parameters(function: object) -> list[str]:
    return [p for p in inspect.signature(function).parameters if p != "self"]  # type: ignore[arg-type]


def test_stubs_name_what_the_core_holds() -> None:
    classes = {node.name: node for node in STUBS.body if isinstance(node, ast.ClassDef)}
    functions = stub_functions(STUBS.body)
    held = {name for name in dir(_core) if not name.startswith("_")}
    assert held == classes.keys() | functions.keys()
    assert isinstance(_core.__version__, str)
    for name, wanted in functions.items():
        assert parameters(getattr(_core, name)) == wanted, name
    for name, node in classes.items():
        cls, told = getattr(_core, name), stub_functions(node.body)
        assert {member for member in dir(cls) if not member.startswith("_")} == told.keys() - {"__new__"}, (
            name
        )
        for method, wanted in told.items():
            if method == "__new__":
                assert parameters(cls) == wanted, name
            elif callable(getattr(cls, method)):
                assert parameters(getattr(cls, method)) == wanted, f"{name}.{method}"


def test_versions_agree() -> None:
    assert fb.__version__ == _core.__version__
