"""Expressions and statements that have a text and can be evaluated here: what evaluated_kernels.py and evaluated_pipelines.py share."""

MASK = (1 << 32) - 1


class State:
    """The variables of a body, and the log. Pairs and vectors are tuples, optionals None or a value."""

    def __init__(self):
        self.log, self.variables = 0, {}

    def note(self, number):
        self.log = (self.log * 31 + number) & MASK


class Expr:
    """An expression: its text, and a function of the state that evaluates it. `device`: its value lies on the device."""

    def __init__(self, text, run, device=False):
        self.text, self.run, self.device = text, run, device


class Stmt:
    """A statement: a text with `{}` for each of its blocks, and a function of the state that executes it."""

    def __init__(self, text, run, blocks=()):
        self.form, self.run, self.blocks = text, run, blocks

    def text(self):
        parts = self.form.split("{}") if self.blocks else [self.form]
        texts = [text_of(statements) for statements in self.blocks] + [""]
        return "".join(part + text for part, text in zip(parts, texts))


def text_of(statements):
    return "".join(statement.text() + "\n" for statement in statements)


def shrunk(body, fails):
    """Removes statements while fails() holds."""
    lists = [body]
    while lists:
        statements = lists.pop()
        for at in reversed(range(len(statements))):
            removed = statements.pop(at)
            if not fails():
                statements.insert(at, removed)
                lists += removed.blocks


def run_all(statements, state):
    for statement in statements:
        statement.run(state)


ARITHMETIC = {
    "+": lambda a, b: (a + b) & MASK,
    "-": lambda a, b: (a - b) & MASK,
    "*": lambda a, b: (a * b) & MASK,
    "/": lambda a, b: a // b if b else a,
    "%": lambda a, b: a % b if b else 0,
    "^": lambda a, b: a ^ b,
    "&": lambda a, b: a & b,
    "|": lambda a, b: a | b,
    "<<": lambda a, b: (a << (b % 32)) & MASK,
}
COMPARISONS = {
    "==": lambda a, b: a == b,
    "!=": lambda a, b: a != b,
    "<": lambda a, b: a < b,
    ">=": lambda a, b: a >= b,
}


class Maker:
    """Makes expressions. The methods for a type are in the table `productions`: (weight, method) pairs by type."""

    def __init__(self, random, name):
        self.random, self.name, self.numbers = random, name, 0

    def number(self):
        """A number for the log, another one in each call."""
        self.numbers += 1
        return self.numbers

    def literal(self):
        return self.random.below(6)

    def expr(self, kind, depth):
        leaves, inner = self.productions[kind]
        table = leaves if depth <= 0 or self.random.chance(12) else leaves + inner
        return self.random.weighted(table)(depth - 1)

    def of(self, kinds, depth, form, compute):
        """An operation on operands that are all evaluated, from left to right."""
        parts = [self.expr(kind, depth) for kind in kinds]
        return Expr(form.format(*(part.text for part in parts)), lambda s: compute(*[part.run(s) for part in parts]),
                    any(part.device for part in parts))

    def binary(self, kinds, table, depth):
        op = self.random.choice(list(table))
        return self.of(kinds, depth, "({} " + op + " {})", table[op])

    def logical(self, left, right, is_and):
        def run(state):
            value = left.run(state)
            if left.device:
                other = right.run(state)
                return (value and other) if is_and else (value or other)
            return (value and right.run(state)) if is_and else (value or right.run(state))
        return Expr(f"({left.text} {'&&' if is_and else '||'} {right.text})", run, left.device or right.device)

    def chosen(self, condition, yes, no):
        def run(state):
            which = condition.run(state)
            if condition.device:
                values = (yes.run(state), no.run(state))
                return values[0] if which else values[1]
            return yes.run(state) if which else no.run(state)
        form = "({} ? {} : {})" if self.random.chance(70) else "select({}, {}, {})"
        return Expr(form.format(condition.text, yes.text, no.text), run, condition.device or yes.device or no.device)
