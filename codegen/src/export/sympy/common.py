
class Row(NamedTuple):
    """A contact, a joint, or the slip of a contact: g' = jacobian*rates + drift, g'' = jacobian*accelerations + bias."""

    of: str  # the label of the contact, the name of the joint
    kind: str  # "contact", "joint" or "slip"
    multiplier: Expr
    gap: Expr  # g; 0 of a slip, which has velocities only
    jacobian: Matrix
    bias: Expr
    drift: Expr
    friction: Expr  # of a slip with friction sigma*mu, so that R = -sigma*mu*N where it slides; None of others
    always: bool  # whether it holds in every contact set: joints and guides


class ContactSet(NamedTuple):
    """The equations of a contact set in closed form: mass_matrix*a + velocity_terms = forces for the accelerations a of `moving`."""

    closed: tuple
    sliding: tuple  # those of them that slide
    kept: list  # coordinates that stay
    moving: list  # accelerations that stay
    coordinates: Matrix  # all, in terms of those kept
    rates: Matrix  # all
    accelerations: Matrix  # all, in terms of `moving`
    kinetic: Expr
    potential: Expr
    mass_matrix: Matrix
    velocity_terms: Matrix
    forces: Matrix
    reactions: dict  # in terms of `moving` and the forces of friction
    friction: dict  # those forces

    def equations(self):
        """Expressions that vanish."""
        motion = self.mass_matrix*Matrix(len(self.moving), 1, self.moving) + self.velocity_terms - self.forces
        laws = [force - law for force, law in {**self.reactions, **self.friction}.items()]
        return list(motion) + laws

    def solve(self):
        """The accelerations of `moving`, the reactions and the forces of friction."""
        unknowns = self.moving + list(self.reactions) + list(self.friction)
        return sympy.solve(self.equations(), unknowns, dict=True)[0]


def contact_set(*closed, sliding=()):
    """The closed form of this contact set."""
    for found in contact_sets:
        if set(found.closed) == set(closed) and set(found.sliding) == set(sliding):
            return found
    raise KeyError(f"no closed form of {closed}, sliding {sliding}; `augmented` has the equations of every contact set")


def augmented(closed=(), sliding=()):
    """Matrix, right side and unknowns of the linear equations of any contact set, closed form or not: accelerations, then the
    multipliers of the rows that hold; closed contacts with friction stick unless they slide."""
    strangers = set(closed).union(sliding) - {row.of for row in rows if row.kind == "contact"}
    if strangers:
        raise KeyError(f"no contacts {sorted(strangers)}")

    def holds(row):
        if row.kind == "slip":
            return (row.always or row.of in closed) and (row.friction is None or row.of not in sliding)
        return (row.always or row.of in closed) and any(row.jacobian)

    held = [row for row in rows if holds(row)]
    n = len(coordinates)
    matrix = zeros(n + len(held), n + len(held))
    matrix[:n, :n] = mass_matrix
    right = Matrix.vstack(forces - velocity_terms, Matrix(len(held), 1, [-row.bias for row in held]))
    for k, row in enumerate(held):
        matrix[n + k, :n] = row.jacobian
        matrix[:n, n + k] = -row.jacobian.T
    for slip in rows:
        if slip.kind == "slip" and slip.friction is not None and slip.of in sliding:
            normal = [k for k, row in enumerate(held) if row.kind == "contact" and row.of == slip.of]
            for k in normal:
                matrix[:n, n + k] += slip.friction*slip.jacobian.T
            if not normal:
                right[:n, :] += slip.multiplier*slip.jacobian.T
    return matrix, right, accelerations + [row.multiplier for row in held]


def motion():
    """The coordinates as functions of time: what to put in place of coordinates, rates and accelerations, `expression.subs`."""
    functions = [sympy.Function(symbol.name)(t) for symbol in coordinates]
    orders = zip((accelerations, rates, coordinates), (2, 1, 0))
    return {symbol: function.diff(t, order) if order else function
            for symbols, order in orders for symbol, function in zip(symbols, functions)}


