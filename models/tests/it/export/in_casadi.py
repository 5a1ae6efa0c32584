"""The same equations as functions of CasADi, beside the numbers of the program (argument: a JSON file), and their derivatives."""
import json
import sys

import casadi
import in_sympy
import sympy


def function(symbols, entries):
    """Expressions of SymPy as a function of CasADi."""
    arguments = [casadi.SX.sym(symbol.name) for symbol in symbols]
    values = sympy.lambdify([symbols], entries, modules=[casadi.__dict__], cse=True)(arguments)
    return casadi.Function("equations", [casadi.vertcat(*arguments)], [casadi.vertcat(*values)])


class Model(in_sympy.Model):
    def evaluated(self, key, entries, values):
        if key not in self.kept:
            self.kept[key] = function(list(values), list(entries))
        numbers = [float(value) for value in values.values()]
        return [in_sympy.mpmath.mpf(float(value)) for value in self.kept[key](numbers).elements()]


def inertia(model, case):
    """The second derivatives of the kinetic energy by the rates are the mass matrix, by CasADi's own differentiation."""
    m, values = model.module, model.numbers(case)
    symbols = list(values)
    energy, x = function(symbols, [m.kinetic]), casadi.SX.sym("x", len(symbols))
    rates = [symbols.index(rate) for rate in m.rates]
    second = casadi.Function("second", [x], [casadi.hessian(energy(x), x)[0][rates, rates]])
    found = casadi.densify(second([float(value) for value in values.values()])).elements()
    return in_sympy.off(found, model.evaluated("inertia", list(m.mass_matrix), values))


if __name__ == "__main__":
    in_sympy.Model = Model
    for entry in json.load(open(sys.argv[1])):
        worst, _ = in_sympy.checked(entry["file"], entry["parameters"], entry["cases"], bound=1e-11)
        model = Model(entry["file"], entry["parameters"])
        second = max(inertia(model, case) for case in entry["cases"])
        assert second < 1e-13, (entry["name"], second)
        print(f"{entry['name']}: {len(entry['cases'])} states, errors {float(worst):.1e}, of derivatives {float(second):.1e}")
