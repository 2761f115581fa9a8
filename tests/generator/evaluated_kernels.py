"""Random kernels whose operands log that they are evaluated."""
from evaluated import ARITHMETIC, COMPARISONS, MASK, Expr, Maker, State, Stmt, run_all, text_of

ITEMS = 4  # elements of the structure `items`, whose values are 10, 11 …


class KernelMaker(Maker):
    """Variables: x, y: uint; p: Pair; v: uint3; list: uint[3]; pairs: Pair[2]; o: uint?. With a group also n: shared uint[4]."""

    def __init__(self, random, name):
        super().__init__(random, name)
        self.is_grouped, self.loops = random.chance(25), 0
        self.productions = {
            "uint": ([(2, self.constant), (3, self.variable), (5, self.noted), (2, self.log)],
                      [(5, lambda d: self.binary(("uint", "uint"), ARITHMETIC, d)), (3, lambda d: self.choice("uint", d)),
                       (4, self.otherwise), (2, lambda d: self.of(("pair",), d, "{}.y", lambda p: p[1])),
                       (2, self.component), (2, self.element), (2, self.function), (2, self.braced),
                       (1, lambda d: self.of(("uint", "uint"), d, "min({}, {})", min)),
                       (1, lambda d: self.of(("bool",), d, "uint({})", int)),
                       (1, self.only), (3, self.item)] + ([(4, self.shared), (4, self.atomic)] if self.is_grouped else [])),
            "bool": ([(4, self.noted_bool)],
                      [(4, lambda d: self.binary(("uint", "uint"), COMPARISONS, d)),
                       (4, lambda d: self.binary(("pair", "pair"), {k: COMPARISONS[k] for k in ("==", "!=")}, d)),
                       (1, lambda d: self.binary(("vector", "vector"), {k: COMPARISONS[k] for k in ("==", "!=")}, d)),
                       (5, lambda d: self.logical(self.expr("bool", d), self.expr("bool", d), random.chance(50))),
                       (2, lambda d: self.choice("bool", d)), (1, lambda d: self.of(("bool",), d, "!{}", lambda a: not a)),
                       (1, lambda d: self.of(("uint",), d, "items.contains({})", lambda a: a < ITEMS))]),
            "pair": ([(2, lambda d: self.read("p")), (3, self.noted_pair)],
                      [(3, lambda d: self.of(("uint", "uint"), d, "Pair({}, {})", lambda a, b: (a, b))),
                       (3, lambda d: self.of(("uint", "uint"), d, "Pair(y: {}, x: {})", lambda a, b: (b, a))),
                       (2, lambda d: self.choice("pair", d)),
                       (2, lambda d: self.part("pairs", 2, d)), (2, self.otherwise_pair)]),
            "vector": ([(2, lambda d: self.read("v"))],
                        [(3, lambda d: self.of(("uint",) * 3, d, "uint3({}, {}, {})", lambda *a: a)),
                         (1, lambda d: self.of(("vector", "uint"), d, "({} + {})", lambda a, b: tuple((i + b) & MASK for i in a))),
                         (1, lambda d: self.of(("vector",), d, "{}.zxy", lambda a: (a[2], a[0], a[1]))),
                         (2, lambda d: self.choice("vector", d))]),
            "optional": ([(1, lambda d: self.read("o")), (4, self.noted_optional)],
                          [(2, lambda d: self.choice("optional", d)), (2, self.some_or_none),
                           (3, lambda d: self.of(("uint",), d, "items.find({})", lambda a: a + 10 if a < ITEMS else None))])}
        self.body = self.statements(2) + self.statements(2)

    def constant(self, _depth):
        value = self.literal()
        return Expr(f"{value}u", lambda s: value)

    def variable(self, _depth):
        return self.read(self.random.choice(["x", "y"]))

    def read(self, name):
        return Expr(name, lambda s: s.variables[name])

    def log(self, _depth):
        return Expr("c[0]", lambda s: s.log)

    def logged(self, form, compute):
        number = self.number()

        def run(state):
            state.note(number)
            return compute(number)
        return Expr(form.format(number), run)

    def noted(self, _depth):
        value = self.literal()
        return self.logged(f"note_uint(c, {{}}u, {value}u)", lambda n: value)

    def noted_bool(self, _depth):
        value = self.random.chance(50)
        return self.logged(f"note_bool(c, {{}}u, {'true' if value else 'false'})", lambda n: value)

    def noted_pair(self, _depth):
        value = self.literal()
        return self.logged(f"note_pair(c, {{}}u, {value}u)", lambda n: (value, n))

    def noted_optional(self, _depth):
        value, has = self.literal(), self.random.chance(50)
        return self.logged(f"note_optional(c, {{}}u, {'true' if has else 'false'}, {value}u)", lambda n: value if has else None)

    def choice(self, kind, depth):
        return self.chosen(self.expr("bool", depth), self.expr(kind, depth), self.expr(kind, depth))

    def some_or_none(self, depth):
        condition, value = self.expr("bool", depth), self.expr("uint", depth)
        return Expr(f"({condition.text} ? {value.text} : none)", lambda s: value.run(s) if condition.run(s) else None)

    def otherwise_of(self, optional, value):
        def run(state):
            found = optional.run(state)
            return value.run(state) if found is None else found
        return Expr(f"({optional.text} ?? {value.text})", run)

    def otherwise(self, depth):
        return self.otherwise_of(self.expr("optional", depth), self.expr("uint", depth))

    def otherwise_pair(self, depth):
        condition, value = self.expr("bool", depth), self.expr("pair", depth)
        optional = Expr(f"({condition.text} ? {value.text} : none)", lambda s: value.run(s) if condition.run(s) else None)
        return self.otherwise_of(optional, self.expr("pair", depth))

    def component(self, depth):
        return self.of(("vector", "uint"), depth, "{}[{} % 3u]", lambda v, i: v[i % 3])

    def part(self, name, count, depth):
        index = self.expr("uint", depth)
        return Expr(f"{name}[{index.text} % {count}u]", lambda s: s.variables[name][index.run(s) % count])

    def element(self, depth):
        return self.part("list", 3, depth)

    def only(self, depth):
        """The only component of a scalar, whose index has effects."""
        index = self.expr("uint", depth)
        if "(c, " not in index.text:
            return self.read("x")  # a constant index would be an error

        def run(state):
            index.run(state)
            return state.variables["x"]
        return Expr(f"x[{index.text}]", run)

    def function(self, depth):
        return self.of(("uint",) * 3, depth, "sum_of({}, {}, {})", lambda a, b, d: (a + 3 * b + 5 * d) & MASK)

    def braced(self, depth):
        return self.of(("uint",) * 3, depth, "sum_of_pair({{{}, {}}}, {})", lambda a, b, d: (a + 7 * b + 11 * d) & MASK)

    def item(self, depth):
        return self.of(("uint",), depth, "items[{}]", lambda a: a + 10 if a < ITEMS else 0)

    def shared(self, depth):
        index = self.expr("uint", depth - 1)

        def run(state):
            at = index.run(state) % 4
            return state.variables["n"][at]
        return Expr(f"n[{index.text} % 4u]", run)

    def atomic(self, depth):
        index, value = self.expr("uint", depth), self.expr("uint", depth)

        def run(state):
            at, added = index.run(state) % 4, value.run(state)
            before = state.variables["n"][at]
            state.variables["n"][at] = (before + added) & MASK
            return before
        return Expr(f"atomicAdd(n[{index.text} % 4u], {value.text})", run)

    # statements

    def target(self):
        """Of a place of type uint: its text, and a function of the state that evaluates its index and gives a getter and a setter."""
        def at(name, index, field=None):
            def get(state):
                part = state.variables[name] if index is None else state.variables[name][index]
                return part if field is None else part[field]

            def put(state, value):
                if field is not None:
                    part = list(state.variables[name] if index is None else state.variables[name][index])
                    part[field] = value
                    value = tuple(part)
                if index is None:
                    state.variables[name] = value
                    return
                whole = list(state.variables[name])
                whole[index] = value
                state.variables[name] = whole if isinstance(state.variables[name], list) else tuple(whole)
            return get, put
        kind = self.random.below(7 if self.is_grouped else 6)
        if kind == 0:
            name = self.random.choice(["x", "y"])
            return name, lambda s: at(name, None)
        if kind == 1:
            return "p.y", lambda s: at("p", None, 1)
        if kind == 2:
            return "v.z", lambda s: at("v", 2)
        index = self.expr("uint", 2)
        if kind == 3:
            return f"pairs[{index.text} % 2u].x", lambda s: at("pairs", index.run(s) % 2, 0)
        name, count = [("v", 3), ("list", 3), ("n", 4)][kind - 4]
        return f"{name}[{index.text} % {count}u]", lambda s: at(name, index.run(s) % count)

    def assign(self, _depth):
        text, place = self.target()
        value = self.expr("uint", 3)

        def run(state):
            _get, put = place(state)
            put(state, value.run(state))
        return Stmt(f"{text} = {value.text};", run)

    def compound(self, _depth):
        text, place = self.target()
        value, op = self.expr("uint", 3), self.random.choice(list(ARITHMETIC))

        def run(state):
            get, put = place(state)
            before = get(state)
            put(state, ARITHMETIC[op](before, value.run(state)))
        return Stmt(f"{text} {op}= {value.text};", run)

    def assign_whole(self, _depth):
        name, kind = self.random.choice([("p", "pair"), ("v", "vector"), ("o", "optional")])
        value = self.expr(kind, 3)

        def run(state):
            state.variables[name] = value.run(state)
        return Stmt(f"{name} = {value.text};", run)

    def swizzle(self, _depth):
        value = self.of(("uint", "uint"), 2, "uint2({}, {})", lambda a, b: (a, b))

        def run(state):
            a, b = value.run(state)
            state.variables["v"] = (b, state.variables["v"][1], a)
        return Stmt(f"v.zx = {value.text};", run)

    def if_(self, depth):
        condition, yes, no = self.expr("bool", 3), self.statements(depth - 1), self.statements(depth - 1)
        return Stmt(f"if {condition.text} {{\n{{}}}} else {{\n{{}}}}", lambda s: run_all(yes if condition.run(s) else no, s), (yes, no))

    def if_let(self, depth):
        value, yes, no = self.expr("optional", 3), self.statements(depth - 1), self.statements(depth - 1)
        name = f"w{self.number()}"

        def run(state):
            found = value.run(state)
            if found is not None:
                state.variables["x"] = found
            run_all(yes if found is not None else no, state)
        return Stmt(f"if let {name} = {value.text} {{\nx = {name};\n{{}}}} else {{\n{{}}}}", run, (yes, no))

    def for_(self, depth):
        first, last, inner = self.expr("uint", 2), self.expr("uint", 2), self.statements(depth - 1)
        more = self.expr("bool", 2) if self.random.chance(40) else None

        def run(state):
            begin, end = first.run(state) % 2, last.run(state) % 3
            for _ in range(begin, end):
                if more and not more.run(state):
                    break
                run_all(inner, state)
        text = f"for _i{self.number()} in {first.text} % 2u..{last.text} % 3u " + (f"while {more.text} " if more else "")
        return Stmt(text + "{\n{}}", run, (inner,))

    def while_(self, depth):
        condition, inner, name = self.expr("bool", 3), self.statements(depth - 1), f"t{self.number()}"

        def run(state):
            for _ in range(3):
                if not condition.run(state):
                    return
                run_all(inner, state)
        text = f"var {name} = 0u;\nwhile {name} < 3u && {condition.text} {{\n{name} += 1u;\n{{}}}}"
        return Stmt(text, run, (inner,))

    def statements(self, depth):
        table = [(4, self.assign), (4, self.compound), (2, self.assign_whole), (1, self.swizzle)]
        if depth > 0:
            table += [(2, self.if_), (2, self.if_let), (1, self.for_), (1, self.while_)]
        return [self.random.weighted(table)(depth) for _ in range(self.random.between(1, 3))]

    def text(self):
        state = State()
        state.variables = {"x": 3, "y": 4, "p": (1, 2), "v": (5, 6, 7), "list": [8, 9, 10], "pairs": [(1, 2), (3, 4)], "o": 5,
                           "n": [1, 2, 3, 4]}
        run_all(self.body, state)
        v = state.variables
        parts = [v["x"], v["y"], *v["p"], *v["v"], *v["list"], *v["pairs"][0], *v["pairs"][1], 99 if v["o"] is None else v["o"]]
        names = ["x", "y", "p.x", "p.y", "v.x", "v.y", "v.z", "list[0]", "list[1]", "list[2]", "pairs[0].x", "pairs[0].y",
                 "pairs[1].x", "pairs[1].y", "(o ?? 99u)"]
        if self.is_grouped:
            parts += v["n"]
            names += [f"n[{i}]" for i in range(4)]
        digest = 0
        for part in parts:
            digest = (digest * 33 + part) & MASK
        sums = "\n".join(f"d = d * 33u + {name};" for name in names)
        shared = "shared n: uint[4];\nn[0] = 1u;\nn[1] = 2u;\nn[2] = 3u;\nn[3] = 4u;\n" if self.is_grouped else ""
        start = ("var x = 3u;\nvar y = 4u;\nvar p = Pair(1u, 2u);\nvar v = uint3(5u, 6u, 7u);\nvar list = uint[3](8u, 9u, 10u);\n"
                 "var pairs = Pair[2](Pair(1u, 2u), Pair(3u, 4u));\nvar o: uint? = 5u;\n")
        return f"""

// {self.name}
kernel {self.name}(_a: at<Line>, items: in any<Line>, c: inout coherent<Line>, to: out each<Line>){' group(1)' if self.is_grouped else ''} {{
{shared}{start}{text_of(self.body)}var d = 0u;
{sums}
to = d;
}}

test "{self.name}" {{
temp items = Line({ITEMS});
number(items, items);
temp c = Line(1);
temp to = Line(1);
{self.name}(to, items, c, to);
expect(await c[0] == {state.log}u);
expect(await to[0] == {digest}u);
}}"""
