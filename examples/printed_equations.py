"""The equations of a symmetric body with its mass centre on the third axis: as LaTeX, as C, and checked."""

import ctypes
import subprocess
import tempfile
from pathlib import Path

import numpy as np

import freebody as fb

top = fb.SymbolicBody("m", com=(0, 0, "z_c"), inertia_about_com=("A", "A", "C"))
equations = fb.equations("2.8", angles="zxz", body=top)
print(equations.latex(common=True))
code = equations.c("top")
print(code)

# The kernel's motion of one such body, with a wrench on it.
m, z_c, A, C = 2.5, 0.3, 0.4, 0.7
model = fb.Model(
    fb.RigidBody(m, [0.0, 0.0, z_c], inertia_about_com=np.diag([A, A, C])), attitude="zxz", form="generalized"
)
q, q_dot = np.array([0.1, -0.2, 0.3, 0.5, 1.1, -0.7]), np.array([1.0, 0.5, -0.3, 0.8, -1.1, 1.7])
wrench = np.array([3.0, -1.0, 2.0, 0.5, 0.2, -0.4])
q_ddot = model.derivative(0.0, np.concatenate([q, q_dot]), wrench)[6:]

with tempfile.TemporaryDirectory() as folder:
    source, library = Path(folder, "top.c"), Path(folder, "top.so")
    source.write_text(code)
    command = ["cc", "-std=c99", "-O2", "-Wall", "-Wextra", "-Werror", "-shared", "-fPIC"]
    subprocess.run([*command, "-o", library, source, "-lm"], check=True)
    compiled = ctypes.CDLL(str(library)).top
left, right = np.zeros(6), np.zeros(6)
given = (q, q_dot, q_ddot, wrench, np.array([m, z_c, A, C]))
compiled(*(x.ctypes.data_as(ctypes.c_void_p) for x in (*given, left, right)))

print(f"the compiled sides of (2.8) differ by {np.abs(left - right).max():.1e} N, N m")
assert list(equations.arguments) == ["q", "q_dot", "q_ddot", "wrench", "body"]
assert equations.arguments["body"] == ("m", "z_c", "A", "C")
assert np.allclose(right, wrench, rtol=0.0, atol=0.0)
assert np.abs(left - right).max() < 1e-12
