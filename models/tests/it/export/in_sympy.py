"""Equations that `export --sympy` has written, in numbers of 40 digits, beside those of the program (argument: a JSON file)."""
import importlib.util
import json
import sys

import mpmath
import sympy

mpmath.mp.dps = 40


def loaded(path):
    spec = importlib.util.spec_from_file_location("equations", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


class Model:
    def __init__(self, path, parameters):
        self.module = loaded(path)
        self.parameters = parameters
        self.switches = self.named("switch_")
        self.senses = self.named("sigma_")
        self.kept = {}

    def named(self, prefix):
        return [value for name, value in vars(self.module).items() if name.startswith(prefix)]

    def numbers(self, case):
        m, n = self.module, len(self.module.coordinates)
        values = dict(zip(m.parameters, self.parameters))
        values.update(zip(m.coordinates + m.rates, case["state"]))
        values.update({switch: 1 for switch in self.switches})
        values.update({sense: 0 for sense in self.senses})
        values[m.t] = case["time"]
        values.update({getattr(m, "sigma_" + plain(label)): sense for label, sense in case["senses"].items()})
        return {symbol: mpmath.mpf(value) for symbol, value in values.items()}

    def evaluated(self, key, entries, values):
        """Entries compiled once, at these values."""
        if key not in self.kept:
            symbols = list(values)
            self.kept[key] = sympy.lambdify([symbols], list(entries), modules="mpmath", cse=True)
        return self.kept[key](list(values.values()))


def plain(label):
    return label.replace(", ", "_").replace(" ", "_").replace("(", "_").replace(")", "")


def off(computed, expected):
    scale = max([abs(value) for value in expected] + [1e-3])
    assert len(computed) == len(expected)
    return max([abs(a - b)/scale for a, b in zip(computed, expected)] + [0])


def solution(matrix, right):
    n = len(right)
    entries = mpmath.matrix(n, n)
    for k, entry in enumerate(matrix):
        entries[k // n, k % n] = entry
    return list(mpmath.lu_solve(entries, mpmath.matrix(right))), mpmath.mnorm(entries, 1)*mpmath.mnorm(entries**-1, 1)


def checked(path, parameters, cases, bound=1e-12):
    """Errors over what rounding of so badly conditioned equations may give; how many closed forms were met."""
    model, worst, closed_forms = Model(path, parameters), 0, 0
    m = model.module
    for case in cases:
        values = model.numbers(case)
        closed, sliding = tuple(case["closed"]), tuple(case["senses"])
        if (closed, sliding) not in model.kept:
            model.kept[closed, sliding] = m.augmented(closed, sliding)
        matrix, right, unknowns = model.kept[closed, sliding]
        key = (closed, sliding, "matrices")
        found = model.evaluated(key, list(matrix) + list(right), values)
        n = len(unknowns)
        solved, condition = solution(found[:n*n], found[n*n:])
        accelerations = solved[:len(m.coordinates)]
        error = off(accelerations, case["accelerations"])/max(1, condition/1e4)
        energies = model.evaluated("energies", [m.kinetic, m.potential], values)
        error = max(error, off(energies, case["energies"]))
        gaps = [row.gap for row in m.rows if row.kind == "contact"]
        error = max(error, off(model.evaluated("gaps", gaps, values), case["gaps"]))
        places = [place for point in m.points.values() for place in point]
        error = max(error, off(model.evaluated("points", places, values), case["points"]))
        if "reduced" in case:
            closed_forms += 1
            error = max(error, of_closed_form(model, case, values, (closed, sliding)))
        if error > bound:
            raise AssertionError(f"{path} {closed} {sliding}: {mpmath.nstr(error, 3)}")
        worst = max(worst, error)
    return worst, closed_forms


def of_closed_form(model, case, values, names):
    """That of a contact set in closed form: its full state, accelerations and reactions."""
    m, reduced = model.module, case["reduced"]
    found = m.contact_set(*names[0], sliding=names[1])
    values = {**values, **dict(zip(m.coordinates + m.rates, map(mpmath.mpf, reduced["state"])))}
    embedded = list(found.coordinates) + list(found.rates)
    error = off(model.evaluated((*names, "embedded"), embedded, values), reduced["state"])
    unknowns = found.moving + list(found.reactions) + list(found.friction)
    if not unknowns:
        return error
    key = (*names, "closed form")
    if key not in model.kept:
        # With the numbers of this state the equations stay linear in the unknowns.
        matrix, right = sympy.linear_eq_to_matrix(found.equations(), unknowns)
        model.kept[key] = True
        model.kept[(key, "entries")] = list(matrix) + list(right)
    n = len(unknowns)
    numbers = model.evaluated((key, "numbers"), model.kept[(key, "entries")], values)
    solved, condition = solution(numbers[:n*n], numbers[n*n:])
    expected = dict(zip(map(str, m.accelerations), reduced["accelerations"]))
    expected.update({f"N_{plain(label)}": value for label, value in reduced["reactions"].items()})
    expected.update({f"R_{plain(label)}": value for label, value in reduced["friction"].items()})
    pairs = [(value, expected[symbol.name]) for symbol, value in zip(unknowns, solved) if symbol.name in expected]
    assert len(pairs) >= len(found.moving)
    if not pairs:
        return error
    return max(error, off(*zip(*pairs))/max(1, condition/1e4))


# Lagrange's equations of a few models once more, from energies written down by hand.
def lagrange(kinetic, potential, q, forces=None):
    t = sympy.Symbol("t")
    functions = [sympy.Function(f"f{i}")(t) for i in range(len(q))]
    (coordinates, rates, accelerations) = zip(*q)
    inward = dict(zip(rates, [f.diff(t) for f in functions])) | dict(zip(coordinates, functions))
    outward = ([(f.diff(t, 2), a) for f, a in zip(functions, accelerations)]
               + [(f.diff(t), u) for f, u in zip(functions, rates)] + list(zip(functions, coordinates)))
    lagrangian = kinetic - potential
    return [lagrangian.diff(u).subs(inward).diff(t).subs(outward) - lagrangian.diff(x) - (forces or [0]*len(q))[i]
            for i, (x, u, _) in enumerate(q)]


def bar(m, l, x, y, angle, rates):
    """Energy of a uniform bar of this mass and length, of its centre and its angle."""
    rate = lambda f: sum(f.diff(q)*u for q, u in rates)
    return m*(rate(x)**2 + rate(y)**2)/2 + m*l**2/12*rate(angle)**2/2


def vanish(module, mine):
    """The difference of both sides, simplified."""
    n = len(module.coordinates)
    own = module.mass_matrix*sympy.Matrix(n, 1, module.accelerations) + module.velocity_terms - module.forces
    for a, b in zip(own, mine):
        assert sympy.simplify(sympy.expand(sympy.expand_trig(a - b))) == 0, (module.__doc__, a, b)


def triples(module):
    return list(zip(module.coordinates, module.rates, module.accelerations))


def double_pendulum(module):
    m, l, g = module.parameters
    q = triples(module)
    (p1, _, _), (p2, _, _) = q
    rates = [(x, u) for x, u, _ in q]
    sin, cos = sympy.sin, sympy.cos
    centres = [(l/2*sin(p1), -l/2*cos(p1)), (l*sin(p1) + l/2*sin(p2), -l*cos(p1) - l/2*cos(p2))]
    kinetic = sum(bar(m, l, x, y, p, rates) for (x, y), p in zip(centres, (p1, p2)))
    vanish(module, lagrange(kinetic, sum(m*g*y for _, y in centres), q))


def spring_pendulum(module):
    m, k, l, c, g = module.parameters
    q = triples(module)
    (x, xd, _), (y, yd, _) = q
    r = sympy.sqrt(x**2 + y**2)
    damping = -c*(x*xd + y*yd)/r
    vanish(module, lagrange(m*(xd**2 + yd**2)/2, -m*g*y + k*(r - l)**2/2, q, [damping*x/r, damping*y/r]))


def ladder(module):
    """With the floor and the wall as one coordinate."""
    m, l, g = module.parameters
    phi, x, y = module.coordinates
    u, a = module.rates[0], module.accelerations[0]
    sin, cos = sympy.sin, sympy.cos
    mine = lagrange(bar(m, l, l/2*cos(phi), l/2*sin(phi), phi, [(phi, u)]), m*g*l/2*sin(phi), [(phi, u, a)])[0]
    found = module.contact_set("A", "B")
    assert found.moving == [a]
    own = found.mass_matrix[0]*a + found.velocity_terms[0] - found.forces[0]
    assert sympy.simplify(own - mine) == 0
    # Newton: the floor bears the weight and what the centre's rise takes, the wall what its way out takes.
    inward = {phi: sympy.Function("f")(sympy.Symbol("t"))}
    t = sympy.Symbol("t")
    second = lambda s: s.subs(inward).diff(t, 2).subs([(inward[phi].diff(t, 2), a), (inward[phi].diff(t), u), (inward[phi], phi)])
    forces = {module.N_A: m*g + m*second(l/2*sin(phi)), module.N_B: m*second(l/2*cos(phi))}
    for symbol, force in forces.items():
        assert sympy.simplify(found.reactions[symbol] - force) == 0, symbol
    # And by the equations of any contact set.
    matrix, right, unknowns = module.augmented(("A", "B"))
    solved = dict(zip(unknowns, matrix.LUsolve(right)))
    there = {x: l*cos(phi), y: 0}
    motion = sympy.solve(mine, a)[0]
    assert sympy.simplify(solved[a].subs(there) - motion) == 0


def coordinates_as_functions(module):
    functions = module.motion()
    t = module.t
    phi = module.coordinates[0]
    assert functions[module.accelerations[0]] == functions[phi].diff(t, 2)
    assert module.kinetic.subs(functions).diff(t).has(functions[module.accelerations[0]])


BY_HAND = {"double-pendulum": double_pendulum, "spring-pendulum": spring_pendulum, "ladder": ladder}

if __name__ == "__main__":
    with open(sys.argv[1]) as file:
        models = json.load(file)
    for model in models:
        worst, closed_forms = checked(model["file"], model["parameters"], model["cases"])
        print(model["name"], mpmath.nstr(worst, 2), f"{closed_forms} of {len(model['cases'])} in closed form")
        if model["name"] in BY_HAND:
            BY_HAND[model["name"]](loaded(model["file"]))
            coordinates_as_functions(loaded(model["file"]))
            print(model["name"], "by Lagrange's equations too")
