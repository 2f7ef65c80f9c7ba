"""The crank of a four-bar turns by half a turn in 0.5 s with the least torque: direct multiple shooting in CasADi.

    mbgen generate models/four_bar.json --casadi --states crank_pin --out four_bar
    cmake -S four_bar -B four_bar/build && cmake --build four_bar/build --target four_bar_casadi
    pip install casadi
    python3 examples/casadi/four_bar_turn.py four_bar/build/libfour_bar_casadi.so

CasADi is no package of Debian, so mbgen's tests call the same functions by stand-ins (tests/system/casadi) and do not run
this script.
"""

import sys

import casadi as ca

library = sys.argv[1]
f = ca.external("four_bar_f", library)  # xdot = f(x, u, p): angle and rate of the crank, torque, stiffness

STEPS, DURATION, STIFFNESS = 50, 0.5, 1200.0
step = DURATION / STEPS

# One step of the classical Runge-Kutta method.
x, u = ca.MX.sym("x", 2), ca.MX.sym("u", 1)
k1 = f(x, u, STIFFNESS)
k2 = f(x + step / 2 * k1, u, STIFFNESS)
k3 = f(x + step / 2 * k2, u, STIFFNESS)
k4 = f(x + step * k3, u, STIFFNESS)
advance = ca.Function("advance", [x, u], [x + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)])

problem = ca.Opti()
states, torque = problem.variable(2, STEPS + 1), problem.variable(1, STEPS)
for i in range(STEPS):
    problem.subject_to(states[:, i + 1] == advance(states[:, i], torque[:, i]))
problem.subject_to(states[:, 0] == [0, 0])  # at rest at the reference
problem.subject_to(states[:, STEPS] == [ca.pi, 0])
problem.subject_to(problem.bounded(-30, torque, 30))
problem.minimize(ca.sumsqr(torque))
# Derivatives are of first order: the Hessian is approximated.
problem.solver("ipopt", {}, {"hessian_approximation": "limited-memory"})
problem.set_initial(states, ca.vertcat(ca.linspace(0, ca.pi, STEPS + 1).T, ca.DM.zeros(1, STEPS + 1)))
solution = problem.solve()
print("torque [N m]:", solution.value(torque))
