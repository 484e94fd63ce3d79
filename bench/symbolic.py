"""The same case by scalars: numbers, or the expressions of any program that knows + - * of its own."""

import numpy as np

import case

DAMPING = tuple(float(d) for d in case.DAMPING)
WRENCH = (*(float(f) for f in case.FORCE), *(float(m) for m in case.MOMENT))
GRAVITY = case.GRAVITY
BODY = 16  # numbers of a body: 1/m, the mass centre, six of the inertia about it, six of its inverse


def body_numbers(bodies: case.Bodies) -> np.ndarray:
    """(16, n): what `rates` reads of a body."""
    six = ((0, 0, 0, 1, 1, 2), (0, 1, 2, 1, 2, 2))
    return np.concatenate(
        [1.0 / bodies.mass[None], bodies.com, bodies.inertia[six], bodies.inverse_inertia()[six]]
    )


def rates(state, body, wrench):
    """The thirteen rates, from the states, the numbers of a body and a wrench about the origin."""
    _, _, _, qw, qx, qy, qz, vx, vy, vz, wx, wy, wz = state
    im, cx, cy, cz, jxx, jxy, jxz, jyy, jyz, jzz, ixx, ixy, ixz, iyy, iyz, izz = body
    fx, fy, fz, mx, my, mz = wrench

    xx, yy, zz, xy, xz, yz = qx * qx, qy * qy, qz * qz, qx * qy, qx * qz, qy * qz
    sx, sy, sz = qw * qx, qw * qy, qw * qz
    rxx, rxy, rxz = 1.0 - 2.0 * (yy + zz), 2.0 * (xy - sz), 2.0 * (xz + sy)
    ryx, ryy, ryz = 2.0 * (xy + sz), 1.0 - 2.0 * (xx + zz), 2.0 * (yz - sx)
    rzx, rzy, rzz = 2.0 * (xz - sy), 2.0 * (yz + sx), 1.0 - 2.0 * (xx + yy)

    # All but the weight, which acts at the mass centre.
    fx, fy, fz = fx - DAMPING[0] * vx, fy - DAMPING[1] * vy, fz - DAMPING[2] * vz
    hx, hy, hz = (
        jxx * wx + jxy * wy + jxz * wz,
        jxy * wx + jyy * wy + jyz * wz,
        jxz * wx + jyz * wy + jzz * wz,
    )
    tx = mx - DAMPING[3] * wx - (cy * fz - cz * fy) - (wy * hz - wz * hy)
    ty = my - DAMPING[4] * wy - (cz * fx - cx * fz) - (wz * hx - wx * hz)
    tz = mz - DAMPING[5] * wz - (cx * fy - cy * fx) - (wx * hy - wy * hx)
    ax, ay, az = (
        ixx * tx + ixy * ty + ixz * tz,
        ixy * tx + iyy * ty + iyz * tz,
        ixz * tx + iyz * ty + izz * tz,
    )

    ux, uy, uz = vx + wy * cz - wz * cy, vy + wz * cx - wx * cz, vz + wx * cy - wy * cx
    return (
        rxx * vx + rxy * vy + rxz * vz,
        ryx * vx + ryy * vy + ryz * vz,
        rzx * vx + rzy * vy + rzz * vz,
        -0.5 * (qx * wx + qy * wy + qz * wz),
        0.5 * (qw * wx + qy * wz - qz * wy),
        0.5 * (qw * wy + qz * wx - qx * wz),
        0.5 * (qw * wz + qx * wy - qy * wx),
        im * fx + GRAVITY * rzx - (wy * uz - wz * uy) - (ay * cz - az * cy),
        im * fy + GRAVITY * rzy - (wz * ux - wx * uz) - (az * cx - ax * cz),
        im * fz + GRAVITY * rzz - (wx * uy - wy * ux) - (ax * cy - ay * cx),
        ax,
        ay,
        az,
    )
