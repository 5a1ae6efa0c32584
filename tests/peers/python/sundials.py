"""CVODE and IDA of the library that scikit-sundae brings, called from C to C."""
import ctypes
import importlib.util
from ctypes import byref, c_double, c_int, c_int64, c_long, c_void_p
from pathlib import Path

import numpy as np

FOLDER = Path(importlib.util.find_spec("sksundae").origin).parent.parent / "scikit_sundae.libs"


def loaded(name):
    return ctypes.CDLL(str(next(FOLDER.glob(f"{name}-*"))), ctypes.RTLD_GLOBAL)


def typed(library, name, result, *arguments):
    call = getattr(library, name)
    call.restype, call.argtypes = result, arguments
    return call


import sksundae._cy_ida  # noqa: E402,F401  loads what the libraries stand on

CORE, SERIAL, MATRIX, LINEAR = (
    loaded(f"libsundials_{name}") for name in ("core", "nvecserial", "sunmatrixdense", "sunlinsoldense"))
CVODE, IDA = loaded("libsundials_cvode"), loaded("libsundials_ida")
CONTEXT = c_void_p()
typed(CORE, "SUNContext_Create", c_int, c_int, c_void_p)(0, byref(CONTEXT))
vector = typed(SERIAL, "N_VMake_Serial", c_void_p, c_int64, c_void_p, c_void_p)
matrix = typed(MATRIX, "SUNDenseMatrix", c_void_p, c_int64, c_int64, c_void_p)
linear = typed(LINEAR, "SUNLinSol_Dense", c_void_p, c_void_p, c_void_p, c_void_p)
fixed_point = typed(CVODE, "SUNNonlinSol_FixedPoint", c_void_p, c_void_p, c_int, c_void_p)


class Held:
    """A vector over an array of numpy's."""

    def __init__(self, values):
        self.values = np.array(values, dtype=float)
        self.vector = vector(len(self.values), self.values.ctypes.data, CONTEXT)


def checked(code, call):
    if code < 0:
        raise RuntimeError(f"{call}: {code}")


def cvode(problem, method, tolerance):
    """Of the equations solved for accelerations: Adams by fixed point, or BDF by Newton with difference quotients."""
    y, start = Held(problem.start), problem.start
    made = c_void_p(typed(CVODE, "CVodeCreate", c_void_p, c_int, c_void_p)({"adams": 1, "bdf": 2}[method], CONTEXT))
    given = [c_void_p, c_void_p, c_double, c_void_p]
    checked(typed(CVODE, "CVodeInit", c_int, *given)(made, problem.c.cvode_ode, 0.0, y.vector), "init")
    typed(CVODE, "CVodeSStolerances", c_int, c_void_p, c_double, c_double)(made, tolerance, tolerance)
    typed(CVODE, "CVodeSetMaxNumSteps", c_int, c_void_p, c_long)(made, 100_000)
    if method == "adams":
        typed(CVODE, "CVodeSetNonlinearSolver", c_int, c_void_p, c_void_p)(made, fixed_point(y.vector, 0, CONTEXT))
    else:
        a = matrix(len(start), len(start), CONTEXT)
        typed(CVODE, "CVodeSetLinearSolver", c_int, c_void_p, c_void_p, c_void_p)(made, linear(y.vector, a, CONTEXT), a)
    again = typed(CVODE, "CVodeReInit", c_int, c_void_p, c_double, c_void_p)
    stop = typed(CVODE, "CVodeSetStopTime", c_int, c_void_p, c_double)
    solve = typed(CVODE, "CVode", c_int, c_void_p, c_double, c_void_p, c_void_p, c_int)
    t = c_double()

    def run():
        y.values[:] = start
        again(made, 0.0, y.vector)
        stop(made, problem.end)
        checked(solve(made, problem.end, y.vector, byref(t), 1), "CVODE")
        return y.values

    return run


def ida(problem, form, tolerance):
    """Of the equations with multipliers, of index 1 or stabilised; multipliers are left out of the error test."""
    n, many = problem.n, problem.conditions * (1 if form == "index1" else 2)
    z = np.zeros(problem.conditions)
    problem.c.multipliers(0.0, problem.start.ctypes.data, z.ctypes.data)
    slopes = np.empty(2 * n)
    problem.c.ode(0.0, problem.start.ctypes.data, slopes.ctypes.data)
    start = np.concatenate([problem.start, z, np.zeros(many - len(z))])
    slope = np.concatenate([slopes, np.zeros(many)])
    y, v, kind = Held(start), Held(slope), Held([1.0] * (2 * n) + [0.0] * many)
    made = c_void_p(typed(IDA, "IDACreate", c_void_p, c_void_p)(CONTEXT))
    given = [c_void_p, c_void_p, c_double, c_void_p, c_void_p]
    checked(typed(IDA, "IDAInit", c_int, *given)(made, getattr(problem.c, f"ida_{form}"), 0.0, y.vector, v.vector), "init")
    typed(IDA, "IDASStolerances", c_int, c_void_p, c_double, c_double)(made, tolerance, tolerance)
    typed(IDA, "IDASetMaxNumSteps", c_int, c_void_p, c_long)(made, 100_000)
    typed(IDA, "IDASetId", c_int, c_void_p, c_void_p)(made, kind.vector)
    typed(IDA, "IDASetSuppressAlg", c_int, c_void_p, c_int)(made, 1)
    a = matrix(len(start), len(start), CONTEXT)
    typed(IDA, "IDASetLinearSolver", c_int, c_void_p, c_void_p, c_void_p)(made, linear(y.vector, a, CONTEXT), a)
    again = typed(IDA, "IDAReInit", c_int, c_void_p, c_double, c_void_p, c_void_p)
    stop = typed(IDA, "IDASetStopTime", c_int, c_void_p, c_double)
    solve = typed(IDA, "IDASolve", c_int, c_void_p, c_double, c_void_p, c_void_p, c_void_p, c_int)
    t = c_double()

    def run():
        y.values[:], v.values[:] = start, slope
        again(made, 0.0, y.vector, v.vector)
        stop(made, problem.end)
        checked(solve(made, problem.end, byref(t), y.vector, v.vector, 1), "IDA")
        return y.values

    return run
