"""Makes a random program: a module of kernels with tests, and constant expressions for the compile-time evaluator."""
from declarations import Functions, Types
from expressions import APPLIED, Expressions, Scope
from kernels import BAG_TEXT, Kernels
from model import Items, Node, joined
from random_numbers import Random
from statements import Statements
from structures import Structures

USES = ["std.address", "std.array", "std.edge", "std.functions", "std.linear", "std.tiled"]


class Program:
    def __init__(self, seed, kernels):
        self.module = f"generated_{seed}"
        self.random = random = Random(seed)
        self.types = Types(random)
        self.expressions = Expressions(random, self.types)
        self.statements = Statements(random, self.types, self.expressions)
        self.structures = Structures(random, self.types)
        self.functions = Functions(random, self.types, self.statements)
        self.items = Items(self.types.declarations())
        self.items.parts += self.structures.declarations(random.between(4, 6))
        self.items.parts += [Node(BAG_TEXT.strip()), Node(APPLIED)]
        self.items.parts += self.functions.declarations(random.between(6, 12))
        self.add_evaluated()
        maker = Kernels(random, self.types, self.structures, self.statements, self.functions)
        for number in range(kernels):
            self.items.parts += maker.kernel(number)

    def add_evaluated(self):
        """Adds tests that functions give the same result at compile time and in a kernel."""
        for function in self.functions.known:
            if not function.evaluable or (function.generic and not self.random.chance(15)):
                continue
            if any(not self.is_constant(t) for t in function.params):
                continue
            self.add_evaluation(function)

    def is_constant(self, t):
        return t in self.types.storable

    def add_evaluation(self, function):
        name = self.statements.name("e")
        params = ", ".join(f"p{i}: {t.text()}" for i, t in enumerate(function.params))
        names = ", ".join(f"p{i}" for i in range(len(function.params)))
        digest = self.types.digest(function.result)
        self.items.parts.append(Node(f"kernel {name}({params}, to: out each<Line>) {{\nto = {digest}({function.name}({names}));\n}}"))
        lines = [Node("temp to = Line(1);")]
        constants = Scope(evaluable=True)
        for _ in range(3):
            arguments = [self.expressions.constant(t, constants) for t in function.params]
            constant = self.statements.name("c")
            lines += [Node(f"const {constant}: {function.result.text()} = {function.name}(", *joined(arguments), ");"),
                      Node(f"{name}(", *joined(arguments), ", to);"),
                      Node(f"expect(await to[0] == {digest}({constant}));")]
        self.items.parts.append(Node(f'test "{name}" {{\n', Items(lines), "\n}"))

    def text(self):
        uses = "\n".join(f"use {name};" for name in USES)
        return f"module {self.module};\n{uses}\n{self.items.text()}\n"
