"""The acados model of arm.json: names, sizes, ranges of inputs from limits of actuators. limits.py DIRECTORY"""

import os
import sys
import types

import numpy as np

casadi, template = types.ModuleType("casadi"), types.ModuleType("acados_template")


class Symbol(str):
    """Stands for an expression of CasADi."""

    def __sub__(self, other):
        return Symbol("%s - %s" % (self, other))


class Matrix:
    """Stands for a DM: a column of numbers."""

    def __init__(self, numbers):
        self.numbers = np.array(numbers, dtype=float).reshape((-1, 1))

    def full(self):
        return self.numbers


casadi.MX = types.SimpleNamespace(sym=lambda name, size=1: Symbol("%s%d" % (name, size)))
casadi.DM = Matrix
casadi.external = lambda name, path: lambda *arguments: Symbol("%s(%s)" % (name, ", ".join(arguments)))
template.AcadosModel = types.SimpleNamespace
sys.modules.update(casadi=casadi, acados_template=template)
sys.path.insert(0, sys.argv[1])
import arm_acados

ocp = types.SimpleNamespace(constraints=types.SimpleNamespace(), solver_options=types.SimpleNamespace())
outputs = arm_acados.add_to(ocp)
assert outputs == "arm_h(x10, u3, p1)" and ocp.model.f_expl_expr == "arm_f(x10, u3, p1)"
assert ocp.model.f_impl_expr == "xdot10 - arm_f(x10, u3, p1)" and ocp.model.name == "arm"
assert ocp.model.x_labels[:3] == ["z.shoulder [rad]", "z.elbow [rad]", "z.hook_rz [rad]"], ocp.model.x_labels
assert ocp.model.u_labels == ["wind [N]", "shoulder [N m]", "elbow [N m]"], ocp.model.u_labels
assert ocp.constraints.idxbu.tolist() == [0, 1, 2]
assert ocp.constraints.lbu.tolist() == [-3, -90, -0.8] and ocp.constraints.ubu.tolist() == [4, 90, 0.8]
assert ocp.constraints.x0.shape == (10,) and ocp.parameter_values.tolist() == [2]
assert ocp.solver_options.model_external_shared_lib_name == "arm_casadi"
assert os.path.samefile(ocp.solver_options.model_external_shared_lib_dir, sys.argv[1])
