"""Pinocchio: the articulated-body algorithm and its derivatives for a free-flyer; it has no integrators."""
# pyright: reportMissingImports=false

from collections.abc import Iterable

import numpy as np
import pinocchio as pin

import case
import truth
from way import Nothing, Way, difference

WRENCH = np.concatenate([case.FORCE, case.MOMENT])


class Pinocchio(Nothing):
    name = "Pinocchio"

    def __init__(self) -> None:
        self.version = pin.__version__
        self.model = pin.Model()
        joint = self.model.addJoint(0, pin.JointModelFreeFlyer(), pin.SE3.Identity(), "free")
        inertia = pin.Inertia(case.MASS, case.COM, case.INERTIA)
        self.model.appendBodyToJoint(joint, inertia, pin.SE3.Identity())
        self.model.gravity.linear = np.array([0.0, 0.0, case.GRAVITY])
        self.data = self.model.createData()
        x = truth.start()
        self.q = np.concatenate([x[:3], x[4:7], x[3:4]])
        self.twist = x[7:].copy()

    def derivative(self) -> Iterable[Way]:
        names = {"f": pin.aba, "model": self.model, "data": self.data, "q": self.q, "v": self.twist}
        right = truth.derivative(truth.start()[:, None])[7:, 0]
        error = difference(right, lambda: np.array(self.data.ddq))
        names |= {"w": WRENCH, "d": case.DAMPING}
        yield Way("aba, accelerations alone", "f(model, data, q, v, w - d * v)", names, error)

    def jacobian(self) -> Iterable[Way]:
        """By six tangent directions instead of position and quaternion, without the damping."""
        tau = WRENCH - case.DAMPING * self.twist
        names = {"f": pin.computeABADerivatives, "model": self.model, "data": self.data}
        names |= {"q": self.q, "v": self.twist, "tau": tau}
        w, *vector = truth.start()[3:7]
        r = np.array(vector)
        turn = 0.5 * np.vstack([-r, w * np.eye(3) + np.cross(np.eye(3), r)])
        full = truth.jacobian()[7:]
        right = np.hstack([np.zeros((6, 3)), full[:, 3:7] @ turn, full[:, 7:13], full[:, 13:]])

        def given() -> np.ndarray:
            by_input = np.array(self.data.Minv)
            by_twist = self.data.ddq_dv - by_input * case.DAMPING
            return np.hstack([self.data.ddq_dq, by_twist, by_input])

        statement = "f(model, data, q, v, tau)"
        yield Way("computeABADerivatives, 6 x 18", statement, names, difference(right, given))
