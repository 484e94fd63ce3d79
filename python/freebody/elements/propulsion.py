"""Propulsion: thrusters, the tanks that feed them, and what the flow between them does to the body."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from freebody import _check
from freebody.elements.tanks import Tank
from freebody.elements.thrusters import Thruster
from freebody.environment import Environment, checked_environment
from freebody.errors import InputError
from freebody.tracing import ContentsLaw, EventLaw, ForceLaw, mass_properties, wrench

__all__ = ["Propulsion"]


class Propulsion(ForceLaw):
    """Thrusters and tanks as one force: thrust, the mass that flows, and the reactions of the flow.

    With m_e the flow out of thruster e at r_e, drawn from tanks whose propellant comes from a = d(m r)/dm,
    its wrench about the origin is

        force   thrust - 2 omega x h
        moment  sum of r_e x thrust_e - J' omega - sum of m_e r_e x (omega x r_e) - omega x k

    where h = sum of m_e (r_e - a) is the momentum and k = sum of m_e a x r_e the angular momentum of the
    flow relative to the body, on a straight way from a to r_e, and J' the rate of the inertia of all
    propellant about the origin. Thomson, Introduction to Space Dynamics (1961), chapter 7; Meirovitch,
    General Motion of a Variable-Mass Flexible Rocket with Internal Flow, J. Spacecraft 7 (1970) 186-195.
    The flow is taken as steady: h' and k' are left out. The same holds about every origin.

    Mass, mass centre and inertia of the propellant are joined to the body's at every moment. Its masses are
    states, called `<tank>_mass`, and signals that other laws read.

    A tank that runs dry takes the thrust with it, softly, over its `tail_off`; the outcome of a run says when
    that begins, and when a tank holds more than its tables go to, whose last rows hold then.

    Parameters
    ----------
    thrusters, tanks
        Their names differ.
    environment
        Whose air presses on the exit areas; none where no thruster has one.

    Parameters of the law: those of the thrusters.
    """

    def __init__(
        self,
        thrusters: Iterable[Thruster],
        tanks: Iterable[Tank] = (),
        environment: Environment | None = None,
        *,
        name: str | None = None,
    ) -> None:
        if environment is not None:
            checked_environment(environment)
        jets = _listed("thrusters", thrusters, Thruster)
        store = {tank.name: tank for tank in _listed("tanks", tanks, Tank)}
        for thruster in jets:
            for missing in thruster.shares.keys() - store.keys():
                raise InputError(
                    f"{thruster.name}: tanks: {missing!r} is none of the tanks, "
                    f"{', '.join(map(repr, store)) or 'for there are none'}"
                )
            if thruster.feels_pressure and environment is None:
                raise InputError(f"{thruster.name}: exit_area: needs an environment, whose air presses on it")

        def propulsion(s: Any, p: Any) -> Any:
            omega = s.angular_velocity_body
            masses = {key: s.states[tank.state] for key, tank in store.items()}
            available = {key: tank.available(masses[key]) for key, tank in store.items()}
            sources = {key: tank.source(masses[key]) for key, tank in store.items()}
            outflow: dict[str, Any] = dict.fromkeys(store, 0.0)
            force, moment, levels = np.zeros(3), np.zeros(3), {}
            for thruster in jets:
                share = np.prod(np.stack([1.0, *(available[key] for key in thruster.shares)]))
                jet = thruster.jet(s, p, share, _pressure(environment, thruster, s, p))
                force = force + jet.force
                moment = moment + np.cross(thruster.at, jet.force)
                levels |= dict.fromkeys(thruster.states, jet.level_rate)
                if not thruster.shares:
                    continue
                source = sum(part * sources[key] for key, part in thruster.shares.items())
                momentum = jet.flow * (thruster.at - source)
                turning = jet.flow * np.cross(source, thruster.at)
                force = force - 2.0 * np.cross(omega, momentum)
                moment = moment - jet.flow * thruster.carried(omega) - np.cross(omega, turning)
                for key, part in thruster.shares.items():
                    outflow[key] = outflow[key] + part * jet.flow
            for key, tank in store.items():
                moment = moment + outflow[key] * (tank.inertia_slope(masses[key]) @ omega)
            rates = {tank.state: -outflow[key] for key, tank in store.items()} | levels
            return (wrench(force, moment), rates) if rates else wrench(force, moment)

        parameters: dict[str, tuple[float | str, str]] = {}
        inputs: dict[str, str] = {}
        states: dict[str, tuple[float | str, str]] = {
            tank.state: (tank.mass, "kg") for tank in store.values()
        }
        for thruster in jets:
            parameters |= thruster.parameters
            inputs |= thruster.inputs
            states |= thruster.states
        if environment is not None:
            parameters |= environment.parameters
            inputs |= environment.inputs
        super().__init__(propulsion, parameters, inputs, states, "propulsion" if name is None else name)
        self.publishes = tuple(tank.state for tank in store.values())
        self.contents = tuple(_contents(tank) for tank in store.values())
        drawn = {key for thruster in jets for key in thruster.shares}
        told = () if environment is None else environment.notices
        overfull = (_overfull(tank) for tank in store.values() if tank.tabulated)
        self.notices = (*told, *(_dry(store[key]) for key in store if key in drawn), *overfull)


def _listed(what: str, given: Any, kind: type[Any]) -> list[Any]:
    try:
        found = list(given)
    except TypeError:
        raise InputError(f"{what}: got {_check.shown(given)}; give a list") from None
    names: set[str] = set()
    for i, each in enumerate(found):
        if not isinstance(each, kind):
            raise InputError(f"{what}[{i}]: got {_check.shown(each)}; give a {kind.__name__}")
        if each.name in names:
            raise InputError(f"{what}[{i}]: a second one called {each.name!r}; give each its own name=")
        names.add(each.name)
    return found


def _pressure(environment: Environment | None, thruster: Thruster, s: Any, p: Any) -> Any:
    if environment is None or not thruster.feels_pressure:
        return 0.0
    # Without its unit: what an atmosphere computes by formulas and tables has none that is known.
    return 1.0 * environment.flow(s, p, thruster.at).air.pressure


def _contents(tank: Tank) -> ContentsLaw:
    def propellant(s: Any) -> Any:
        m = s.inputs[tank.state]
        return mass_properties(mass=m, com=tank.com(m), inertia_about_com=tank.inertia_about_com(m))

    return ContentsLaw(propellant, inputs={tank.state: "kg"}, name=tank.name)


def _dry(tank: Tank) -> EventLaw:
    def runs_dry(s: Any) -> Any:
        return s.inputs[tank.state] - tank.tail_off

    told = f"the tank {tank.name!r} runs dry: its flow and its thrust fade"
    return EventLaw(runs_dry, False, "falling", inputs={tank.state: "kg"}, name=told)


def _overfull(tank: Tank) -> EventLaw:
    # What starts full is not overfull for its rounding.
    most = tank.capacity * (1.0 + 1e-9)

    def holds_more(s: Any) -> Any:
        return most - 1.0 * s.inputs[tank.state]

    told = f"the tank {tank.name!r} holds more than {tank.capacity:.6g} kg, the last rows of its tables hold"
    return EventLaw(holds_more, False, "falling", inputs={tank.state: "kg"}, name=told)
