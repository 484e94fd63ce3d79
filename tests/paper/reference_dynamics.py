"""x' = f(x, u) in mpmath from Newton and Euler about the mass centre, in every chart and both states."""

from dataclasses import dataclass

import mpmath as mp

from .reference import (
    Matrix,
    Number,
    Vector,
    add,
    apply,
    cross,
    dot,
    quaternion_product,
    rates_matrix,
    rotation,
    rotation_of_quaternion,
    scaled,
    solve,
    vector_derivative,
)


@dataclass(frozen=True)
class Dynamics:
    """A body under gravity, a constant world force at a point, linear damping and an input wrench u."""

    attitude: str
    form: str
    mass: Number
    com: Vector
    inertia_about_com: Matrix
    gravity: Vector
    world_force: Vector
    at: Vector
    damping: Matrix

    def derivative(self, x: Vector, u: Vector) -> Vector:
        split = 7 if self.attitude == "quaternion" else 6
        attitude, rates = x[3:split], x[split:]
        turn = self._rotation(attitude)
        if self.form == "quasi_velocity":
            velocity, omega = rates[:3], rates[3:]
            acceleration, omega_dot = self._accelerations(turn, velocity, omega, u)
            components = add(acceleration, cross(omega, velocity), -1)
            return apply(turn, velocity) + self._attitude_rate(attitude, omega) + components + omega_dot
        velocity, omega = apply(turn.T, rates[:3]), self._omega(attitude, rates[3:])
        acceleration, omega_dot = self._accelerations(turn, velocity, omega, u)
        second = self._attitude_second(attitude, rates[3:], omega, omega_dot)
        return rates + apply(turn, acceleration) + second

    def _accelerations(self, turn: Matrix, v: Vector, omega: Vector, u: Vector) -> tuple[Vector, Vector]:
        """Acceleration of the body origin and angular acceleration, body axes."""
        damping = apply(self.damping, v + omega)
        weight = scaled(apply(turn.T, self.gravity), self.mass)
        push = apply(turn.T, self.world_force)
        force = add(add(add(u[:3], damping[:3], -1), weight), push)
        moment = add(add(u[3:], damping[3:], -1), cross(self.at, push))
        moment_about_com = add(add(moment, cross(self.com, weight)), cross(self.com, force), -1)
        gyroscopic = cross(omega, apply(self.inertia_about_com, omega))
        omega_dot = solve(self.inertia_about_com, add(moment_about_com, gyroscopic, -1))
        from_com = add(cross(omega_dot, self.com), cross(omega, cross(omega, self.com)))
        return add(scaled(force, 1 / self.mass), from_com, -1), omega_dot

    def _rotation(self, attitude: Vector) -> Matrix:
        if self.attitude == "quaternion":
            return rotation_of_quaternion(attitude)
        return rotation(self.attitude, attitude)

    def _attitude_rate(self, attitude: Vector, omega: Vector) -> Vector:
        if self.attitude == "quaternion":
            return scaled(quaternion_product(attitude, [mp.mpf(0), *omega]), mp.mpf(1) / 2)
        return solve(rates_matrix(self.attitude, attitude, world=False), omega)

    def _omega(self, attitude: Vector, rate: Vector) -> Vector:
        if self.attitude == "quaternion":
            conjugate = [attitude[0], *scaled(attitude[1:], -1)]
            return scaled(quaternion_product(conjugate, rate)[1:], 2 / dot(attitude, attitude))
        return apply(rates_matrix(self.attitude, attitude, world=False), rate)

    def _attitude_second(self, attitude: Vector, rate: Vector, omega: Vector, omega_dot: Vector) -> Vector:
        if self.attitude == "quaternion":
            first = quaternion_product(rate, [mp.mpf(0), *omega])
            return scaled(add(first, quaternion_product(attitude, [mp.mpf(0), *omega_dot])), mp.mpf(1) / 2)
        at_rest = vector_derivative(lambda t: self._omega(add(attitude, rate, t), rate))
        return solve(rates_matrix(self.attitude, attitude, world=False), add(omega_dot, at_rest, -1))
