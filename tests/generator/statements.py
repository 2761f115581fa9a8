"""Makes random statements: the bodies of functions and kernels."""
from expressions import Scope
from model import (BOOL, INT, INTEGERS, FLOATS, UINT, Array, Items, Matrix, Node, Optional, Scalar, Struct, Vector, literal, scalar_of)


class Statements:
    def __init__(self, random, types, expressions):
        self.random, self.types, self.expressions = random, types, expressions
        self.names = 0

    def name(self, stem):
        self.names += 1
        return f"{stem}{self.names}"

    def block(self, scope, size, depth, jumps=None, result=None):
        """A block with its own scope. `jumps`: whether it is in a loop, so that it may break or continue. `result`: the
        function's result type."""
        inner = scope.inner()
        items = Items([self.statement(inner, size, depth, jumps, result) for _ in range(size)])
        items.parts += self.uses(inner, len(scope.variables))
        return items

    def uses(self, scope, first):
        """Statements that hash most variables from number `first` on into `sum`, so that these are not dead code."""
        return [Node(f"sum = sum * 31u + {self.types.digest(t)}({name});") for name, t, _ in scope.variables[first:]
                if name != "sum" and self.types.has_digest(t, scope.evaluable) and self.random.chance(70)]

    def braced(self, scope, size, depth, jumps, result, before=""):
        return [" {" + before + "\n", self.block(scope, size, depth, jumps, result), "\n}"]

    def statement(self, scope, size, depth, jumps, result):
        makers = [(8, self.declaration), (9, self.assignment)]
        if depth > 0:
            makers += [(4, self.condition), (1, self.selection), (2, self.optional_condition), (3, self.counted_loop), (1, self.open_loop), (1, self.nested)]
        if jumps:
            makers.append((1, self.jump))
        if result is not None and depth < 3:
            makers.append((1, self.early_return))
        return self.random.weighted(makers)(scope, size, depth, jumps, result)

    # ------------------------------------------------------------------------------------------------ values

    def declaration(self, scope, size, depth, jumps, result):
        t = self.random.choice([t for t in self.types.local if not scope.evaluable or self.types.is_evaluable(t)])
        name, varies = self.name("v"), self.random.chance(60)
        if varies and not isinstance(t, Optional) and self.random.chance(15):
            node = Node(f"var {name}: {t.text()};")
        else:
            typed = isinstance(t, Optional) or self.random.chance(30)
            node = Node("var " if varies else "let ", name, f": {t.text()}" if typed else "", " = ",
                        self.expressions.of(t, scope, self.random.between(1, 4)), ";")
        scope.variables.append((name, t, varies))
        return node


    def assignment(self, scope, size, depth, jumps, result):
        found = [(name, t) for name, t, varies in scope.variables if varies]
        if not found:
            return self.declaration(scope, size, depth, jumps, result)
        name, t = self.random.choice(found[-6:])
        target, t = self.target(name, t, scope)
        operator = "="
        if self.random.chance(40):
            if scalar_of(t) in INTEGERS and not isinstance(t, Matrix):
                operator = self.random.choice(["+=", "-=", "*=", "&=", "|=", "^=", "/=", "%=", "<<=", ">>="])
            elif scalar_of(t) in FLOATS and not isinstance(t, Matrix):
                operator = self.random.choice(["+=", "-=", "*="])
        return Node(target, f" {operator} ", self.expressions.of(t, scope, self.random.between(1, 4)), ";")

    def target(self, name, t, scope):
        """A target of an assignment: a variable or a part of it."""
        parts = [name]
        while self.random.chance(60):
            if isinstance(t, Array):
                parts += ["[", self.expressions.index(t.size, scope, 2), "]"]
                t = t.element
            elif isinstance(t, Matrix):
                parts.append(f"[{self.random.below(t.columns)}]")
                t = Vector(t.rows, scalar_of(t))
            elif isinstance(t, Struct):
                field, t = self.random.choice(t.fields)
                parts.append(f".{field}")
            elif isinstance(t, Vector) and self.random.chance(50):
                lanes = self.random.shuffled("xyzw"[:t.size])[:self.random.between(1, t.size)]
                parts.append("." + "".join(lanes))
                return Node(*parts), t.scalar if len(lanes) == 1 else Vector(len(lanes), t.scalar)
            elif isinstance(t, Vector):
                parts += ["[", self.expressions.index(t.size, scope, 2), "]"]
                return Node(*parts), t.scalar
            else:
                break
        return Node(*parts), t

    # ------------------------------------------------------------------------------------------------ control flow

    def inner_size(self):
        return self.random.between(1, 3)

    def condition(self, scope, size, depth, jumps, result):
        parts = ["if ", self.expressions.of(BOOL, scope, 3), *self.braced(scope, self.inner_size(), depth - 1, jumps, result)]
        if self.random.chance(50):
            parts += [" else", *self.braced(scope, self.inner_size(), depth - 1, jumps, result)]
        return Node(*parts)

    def selection(self, scope, size, depth, jumps, result):
        """A `switch` over an enumerator, whose cases are complete without an `else`, or over an integer."""
        kind = self.random.choice(self.types.enums)
        if self.random.chance(40) and (not scope.evaluable or self.types.is_evaluable(kind)):
            value = self.expressions.of(kind, scope, 3)
            names = [f"{kind.name}.{name}" for name in kind.enumerators]
            cases, has_else = [", ".join(names[:2]), *names[2:]], False
        else:
            value = Node("(", self.expressions.of(UINT, scope, 3), " % 8u)")
            cases = self.random.shuffled(["0", "1..4", "4, 6u", "7"])[:self.random.between(1, 4)]
            has_else = self.random.chance(60)
        branches = []
        for case in cases + ["else"] * has_else:
            branches += [f"\n{case}:", *self.braced(scope, self.inner_size(), depth - 1, jumps, result)]
        return Node("switch ", value, " {", *branches, "\n}")

    def optional_condition(self, scope, size, depth, jumps, result):
        found = [(name, t) for name, t, _ in scope.variables if isinstance(t, Optional)]
        calls = [t for t in self.types.all if isinstance(t, Optional)]
        if found and self.random.chance(60):
            name, t = self.random.choice(found)
            value = Node(name)
        else:
            t = self.random.choice(calls)
            value = self.expressions.call(t, scope, 3)
            if value is None:
                return self.condition(scope, size, depth, jumps, result)
        name = self.name("v")
        inner = scope.inner()
        inner.variables.append((name, t.value, False))
        return Node(f"if let {name} = ", value, *self.braced(inner, self.inner_size(), depth - 1, jumps, result))

    def counted_loop(self, scope, size, depth, jumps, result):
        name = self.name("i")
        inner = scope.inner()
        if self.random.chance(40):
            first = self.random.below(3)
            range_, t = f"{first}..{first + self.random.between(1, 5)}", UINT
        elif self.random.chance(30):
            range_, t = f"-{self.random.between(1, 2)}..{self.random.between(1, 3)}", INT
        else:
            range_, t = Node("0u..(", self.expressions.of(UINT, scope, 2), f" % {self.random.between(2, 6)}u)"), UINT
        inner.variables.append((name, t, False))
        return Node(f"for {name} in ", range_, *self.braced(inner, self.inner_size(), depth - 1, True, result))

    def open_loop(self, scope, size, depth, jumps, result):
        """A `while` loop with a random condition and a limit of its iterations."""
        name, limit = self.name("n"), self.random.between(1, 5)
        inner = scope.inner()
        inner.variables.append((name, UINT, False))
        condition = Node(self.expressions.of(BOOL, inner, 2), type=BOOL)
        return Node(f"var {name} = 0u;\nwhile {name} < {limit}u && ", condition,
                    *self.braced(inner, self.inner_size(), depth - 1, True, result, f"\n{name} += 1u;"))

    def nested(self, scope, size, depth, jumps, result):
        return Node(*self.braced(scope, self.inner_size(), depth - 1, jumps, result))

    def jump(self, scope, size, depth, jumps, result):
        return Node("if ", self.expressions.of(BOOL, scope, 2), " {\n", self.random.choice(["break;", "continue;"]), "\n}")

    def early_return(self, scope, size, depth, jumps, result):
        return Node("if ", self.expressions.of(BOOL, scope, 2), " {\nreturn ", self.expressions.of(result, scope, 2), ";\n}")

    # ------------------------------------------------------------------------------------------------ functions

    def function_body(self, params, result, functions, evaluable):
        unknown = next((name for name, t in params if t == UINT), None)
        scope = Scope([(name, t, False) for name, t in params], functions, evaluable, unknown=unknown)
        size = self.random.between(0, 5)
        if not size:
            return Node(" {\nreturn ", self.expressions.of(result, scope, 4), ";\n}")
        scope.variables.append(("sum", UINT, True))
        body = Items([Node("var sum = 1u;")])
        body.parts += [self.statement(scope, size, 2, None, result) for _ in range(size)]
        body.parts += self.uses(scope, len(params))
        return Node(" {\n", body, "\nreturn ", self.expressions.of(result, scope, 4), ";\n}")
