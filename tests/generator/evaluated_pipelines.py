"""Random pipelines whose operands log that they are evaluated: values of the host, and of the device."""
from evaluated import ARITHMETIC, COMPARISONS, MASK, Expr, Maker, State, Stmt, run_all, text_of


class PipelineMaker(Maker):
    """Variables: x, y: uint on the host; p: Pair on the host. A value of the kinds `any` and `truth` may lie on the device."""

    def __init__(self, random, name):
        super().__init__(random, name)
        self.productions = {
            "uint": ([(2, self.constant), (3, self.variable), (5, self.noted), (2, self.await_)],
                     [(5, lambda d: self.binary(("uint", "uint"), ARITHMETIC, d)), (3, lambda d: self.choice("bool", "uint", d)),
                      (2, lambda d: self.of(("pair",), d, "{}.y", lambda p: p[1])),
                      (3, lambda d: self.sum_of("uint", d)), (2, self.await_),
                      (1, lambda d: self.of(("bool",), d, "uint({})", int))]),
            "bool": ([(4, self.noted_bool)],
                     [(4, lambda d: self.binary(("uint", "uint"), COMPARISONS, d)),
                      (4, lambda d: self.binary(("pair", "pair"), {k: COMPARISONS[k] for k in ("==", "!=")}, d)),
                      (5, lambda d: self.logical(self.expr("bool", d), self.expr("bool", d), random.chance(50))),
                      (2, lambda d: self.choice("bool", "bool", d)), (1, lambda d: self.of(("bool",), d, "!{}", lambda a: not a))]),
            "pair": ([(2, lambda d: self.read("p"))],
                     [(3, lambda d: self.of(("uint", "uint"), d, "Pair({}, {})", lambda a, b: (a, b))),
                      (3, lambda d: self.of(("uint", "uint"), d, "Pair(y: {}, x: {})", lambda a, b: (b, a))),
                      (2, lambda d: self.choice("bool", "pair", d))]),
            "any": ([(1, lambda d: self.expr("uint", d)), (3, self.device)],
                    [(4, self.device), (4, lambda d: self.binary(("any", "any"), ARITHMETIC, d)),
                     (3, lambda d: self.choice("truth", "any", d)), (3, lambda d: self.sum_of("any", d)),
                     (1, lambda d: self.of(("any", "any"), d, "min({}, {})", min))]),
            "truth": ([(1, lambda d: self.expr("bool", d))],
                      [(4, lambda d: self.binary(("any", "any"), COMPARISONS, d)), (2, lambda d: self.expr("bool", d)),
                       (5, lambda d: self.logical(self.expr("truth", d), self.expr("truth", d), random.chance(50)))]),
        }
        self.body = self.statements(2) + self.statements(1)

    def constant(self, _depth):
        value = self.literal()
        return Expr(f"{value}u", lambda s: value)

    def variable(self, _depth):
        return self.read(self.random.choice(["x", "y"]))

    def read(self, name):
        return Expr(name, lambda s: s.variables[name])

    def logged(self, form, value, device=False):
        number = self.number()

        def run(state):
            state.note(number)
            return value
        return Expr(form.format(number), run, device)

    def noted(self, _depth):
        value = self.literal()
        return self.logged(f"host_uint(c, {{}}u, {value}u)", value)

    def noted_bool(self, _depth):
        value = self.random.chance(50)
        return self.logged(f"host_bool(c, {{}}u, {'true' if value else 'false'})", value)

    def device(self, _depth):
        """A value on the device."""
        if self.random.chance(35):
            return Expr("c[0]", lambda s: s.log, True)
        value = self.literal()
        return self.logged(f"device_uint(c, {{}}u, {value}u)", value, True)

    def await_(self, depth):
        if depth < 1 or self.random.chance(40):
            return Expr("await c[0]", lambda s: s.log)
        left, right = self.device(depth), self.expr("any", depth - 1)
        return Expr(f"(await ({left.text} + {right.text}))", lambda s: (left.run(s) + right.run(s)) & MASK)

    def choice(self, condition, kind, depth):
        return self.chosen(self.expr(condition, depth), self.expr(kind, depth), self.expr(kind, depth))

    def sum_of(self, kind, depth):
        return self.of((kind,) * 3, depth, "sum_of({}, {}, {})", lambda a, b, d: (a + 3 * b + 5 * d) & MASK)

    # statements

    def assign(self, _depth):
        name, value = self.random.choice(["x", "y"]), self.expr("uint", 3)

        def run(state):
            state.variables[name] = value.run(state)
        return Stmt(f"{name} = {value.text};", run)

    def compound(self, _depth):
        name, op, value = self.random.choice(["x", "y"]), self.random.choice(list(ARITHMETIC)), self.expr("uint", 3)

        def run(state):
            before = state.variables[name]
            state.variables[name] = ARITHMETIC[op](before, value.run(state))
        return Stmt(f"{name} {op}= {value.text};", run)

    def assign_pair(self, _depth):
        value = self.expr("pair", 3)

        def run(state):
            state.variables["p"] = value.run(state)
        return Stmt(f"p = {value.text};", run)

    def let(self, _depth):
        """A value on the device, which a kernel then logs."""
        value, name = self.expr("any", 3), f"d{self.number()}"

        def run(state):
            state.note(value.run(state))
        return Stmt(f"let {name} = {value.text};\nappend(c[0..1], c, {name});", run)

    def pass_(self, _depth):
        first, second = self.expr("any", 2), self.expr("any", 2)

        def run(state):
            values = [first.run(state), second.run(state)]
            for value in values:
                state.note(value)
        return Stmt(f"append_both(c[0..1], c, {first.text}, {second.text});", run)

    def pipeline(self, _depth):
        """Arguments of a pipeline that logs."""
        first, second, name = self.expr("uint", 2), self.expr("uint", 2), self.random.choice(["x", "y"])

        def run(state):
            number, value = first.run(state), second.run(state)
            state.note(number)
            state.variables[name] = value
        return Stmt(f"{name} = host_uint(c, {first.text}, {second.text});", run)

    def if_(self, depth):
        condition, yes, no = self.expr("bool", 3), self.statements(depth - 1), self.statements(depth - 1)
        return Stmt(f"if {condition.text} {{\n{{}}}} else {{\n{{}}}}", lambda s: run_all(yes if condition.run(s) else no, s), (yes, no))

    def while_(self, depth):
        condition, inner, name = self.expr("bool", 3), self.statements(depth - 1), f"t{self.number()}"

        def run(state):
            for _ in range(2):
                if not condition.run(state):
                    return
                run_all(inner, state)
        return Stmt(f"var {name} = 0u;\nwhile {name} < 2u && {condition.text} {{\n{name} += 1u;\n{{}}}}", run, (inner,))

    def for_(self, depth):
        first, last, inner = self.expr("uint", 2), self.expr("uint", 2), self.statements(depth - 1)

        def run(state):
            begin, end = first.run(state) % 2, last.run(state) % 3
            for _ in range(begin, end):
                run_all(inner, state)
        return Stmt(f"for _i{self.number()} in {first.text} % 2u..{last.text} % 3u {{\n{{}}}}", run, (inner,))

    def statements(self, depth):
        table = [(3, self.assign), (3, self.compound), (2, self.assign_pair), (4, self.let), (3, self.pass_), (2, self.pipeline)]
        if depth > 0:
            table += [(2, self.if_), (1, self.for_), (1, self.while_)]
        return [self.random.weighted(table)(depth) for _ in range(self.random.between(1, 2))]

    def text(self):
        state = State()
        state.variables = {"x": 3, "y": 4, "p": (1, 2)}
        run_all(self.body, state)
        v = state.variables
        digest = (v["x"] + 33 * v["y"] + 1089 * v["p"][0] + 35937 * v["p"][1]) & MASK
        return f"""

// {self.name}
pipeline {self.name}(c: Line) -> uint {{
var x = 3u;
var y = 4u;
var p = Pair(1u, 2u);
{text_of(self.body)}return x + 33u * y + 1089u * p.x + 35937u * p.y;
}}

test "{self.name}" {{
temp c = Line(1);
let digest = {self.name}(c);
expect(digest == {digest}u);
expect(await c[0] == {state.log}u);
}}"""
