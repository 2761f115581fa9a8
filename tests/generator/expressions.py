"""Random expressions of a given type. Their results are the same on every device, except for those of `inexact`."""
import re

from intrinsics import EVALUATED, EVERYWHERE, RANGES, read_table
from model import (BOOL, DOUBLE, FLOAT, FLOATS, HALF, INT, INT64, INTEGERS, NUMBERS, SIGNED, UINT, UINT64, Array, Enum, Matrix, Node,
                   Optional, Scalar, Struct, Vector, is_shaped, joined, literal, scalar_of, size_of, vector)

SUFFIXES = {UINT: "u", INT64: "l", UINT64: "ul", HALF: "h", DOUBLE: "d"}
WHOLE = [0, 1, 1, 2, 3, 5, 7, 8, 31, 32, 33, 63, 64, 255, 1000, 65535, 65536, 16777217, 2147483647]
FRACTIONS = ["0.0", "1.0", "0.5", "2.0", "3.0", "0.1", "0.75", "7.0", "1e-3", "100.0", "1000.5"]
WIDE_FRACTIONS = ["16777216.0", "1e20", "1e-30", "3e38", "1e-40"]
INTRINSICS = read_table()
CAPTURED = re.compile(r"[vp]\d+")  # names of variables and parameters, not of iterators

# Calls a function that it is given, twice.
APPLIED = "fn applied_twice<T: type, F: Function<T, T>>(f: F, x: T) -> T { return f(f(x)); }"


class Scope:
    """What an expression may use: variables, functions, and reads of structures."""

    def __init__(self, variables=(), functions=(), evaluable=False, reads=(), unknown=None):
        self.variables = list(variables)  # (name, type, is assignable)
        self.functions = list(functions)
        self.evaluable = evaluable        # restrict to what the compile-time evaluator can compute
        self.reads = list(reads)          # (type, maker): maker(expressions, scope, depth) reads a value of this type
        self.unknown = unknown            # an expression of type uint whose value is not known at compile time

    def inner(self):
        return Scope(self.variables, self.functions, self.evaluable, self.reads, self.unknown)


class Function:
    def __init__(self, name, params, result, evaluable, generic=False):
        self.name, self.params, self.result, self.evaluable = name, params, result, evaluable
        self.generic = generic


class Expressions:
    def __init__(self, random, types):
        self.random = random
        self.types = types  # the types of the program

    def of(self, t, scope, depth):
        """An expression of type t."""
        if depth <= 0:
            return self.leaf(t, scope)
        makers = [(3, self.leaf), (3, self.call), (2, self.choice), (2, self.part), (2, self.read), (1, self.closure)]
        if isinstance(t, Scalar) or isinstance(t, Vector):
            makers += self._shaped_makers(t)
        elif isinstance(t, Matrix):
            makers += [(4, self.matrix), (3, self.intrinsic)]
        elif isinstance(t, (Array, Struct)):
            makers += [(5, self.made)]
        elif isinstance(t, Optional):
            makers = [(3, self.leaf), (3, self.call), (4, self.some), (1, self.chosen_optional)]
        for _ in range(4):
            node = self.random.weighted(makers)(t, scope, depth) if depth else None
            if node is not None:
                return node
        return self.leaf(t, scope)

    def _shaped_makers(self, t):
        scalar = scalar_of(t)
        makers = [(6, self.intrinsic), (2, self.value_of_optional)]
        if isinstance(t, Vector):
            makers += [(5, self.made_vector), (3, self.swizzle)]
        if scalar == BOOL:
            return makers + ([(8, self.comparison), (5, self.logic)] if t == BOOL else [(2, self.leaf)])
        if scalar in INTEGERS:
            makers += [(9, self.arithmetic), (5, self.bits), (2, self.unary), (3, self.converted)]
        else:
            makers += [(10, self.arithmetic), (2, self.unary), (3, self.converted)]
        if t == UINT:
            makers += [(2, self.digest)]
        return makers

    # ------------------------------------------------------------------------------------------------ leaves

    def leaf(self, t, scope, depth=0):
        if self.random.chance(75):
            node = self.variable(t, scope) or self.from_variable(t, scope)
            if node is not None:
                return node
        return self.constant(t, scope)

    def from_variable(self, t, scope):
        """An expression of type t made from a variable of another type."""
        if not isinstance(t, Scalar) or not scope.variables or self.random.chance(30):
            return None
        name, type, _ = self.random.choice(scope.variables)
        if t in NUMBERS and type in NUMBERS:
            return Node(f"{t.name}({name})", type=t)
        if t == BOOL and type in NUMBERS:
            return Node(f"({name} < ", self.constant(type, scope), ")", type=t)
        if t in (UINT, INT, FLOAT) and self.types.has_digest(type, scope.evaluable):
            return Node(f"{t.name}({self.types.digest(type)}({name}))", type=t)
        return None

    def variable(self, t, scope):
        names = [name for name, type, _ in scope.variables if type == t]
        if isinstance(t, Scalar):
            for name, type, _ in scope.variables:
                if isinstance(type, Vector) and type.scalar == t:
                    names += [f"{name}.{'xyzw'[i]}" for i in range(type.size)]
                if isinstance(type, Struct):
                    names += [f"{name}.{f}" for f, kind in type.fields if kind == t]
        return Node(self.random.choice(names), type=t) if names else None

    def constant(self, t, scope):
        if isinstance(t, Scalar):
            return Node(self.number(t), type=t)
        if isinstance(t, Vector):
            count = 1 if self.random.chance(40) else t.size
            return Node(t.text(), "(", *joined([self.constant(t.scalar, scope) for _ in range(count)]), ")", type=t)
        if isinstance(t, Enum):
            return Node(f"{t.name}.{self.random.choice(t.enumerators)}", type=t)
        if isinstance(t, Optional):
            return self.some(t, scope, 0) if self.random.chance(60) else Node("none", type=t)
        return Node(literal(t), type=t)

    def number(self, t):
        if t == BOOL:
            return self.random.choice(["true", "false"])
        suffix = SUFFIXES.get(t, "")
        if t in INTEGERS:
            number = self.random.choice(WHOLE) if self.random.chance(60) else self.random.below(20)
            if t == UINT and self.random.chance(10):
                number = self.random.choice([2147483648, 4294967295, 4294967294])
            if t == UINT64 and self.random.chance(10):
                number = self.random.choice([4294967296, 18446744073709551615, 9223372036854775808])
            text = f"{number}{suffix}"
        else:
            choices = FRACTIONS if t == HALF or self.random.chance(90) else WIDE_FRACTIONS
            text = self.random.choice(choices) + suffix
            if choices is WIDE_FRACTIONS and not suffix:
                text = f"float({text})"  # a literal without a suffix could take the type half, for which it is too large
        if t not in SIGNED or not self.random.chance(25):
            return text
        # A literal without a suffix takes the expected type, which could be unsigned: negative ones are converted to
        # int explicitly.
        return f"int(-{text})" if t == INT else f"(-{text})"

    # ------------------------------------------------------------------------------------------------ operators

    def binary(self, left, operator, right, t):
        return Node("(", left, f" {operator} ", right, ")", type=t)

    def operands(self, t, scope, depth):
        """Two operands of an operation with a result of type t. If t is a vector, one of them may be a scalar."""
        left = right = t
        if isinstance(t, Vector) and self.random.chance(30):
            left, right = (t.scalar, t) if self.random.chance(50) else (t, t.scalar)
        return self.of(left, scope, depth - 1), self.of(right, scope, depth - 1)

    def arithmetic(self, t, scope, depth):
        left, right = self.operands(t, scope, depth)
        operator = self.random.weighted([(4, "+"), (4, "-"), (4, "*"), (2, "/")] + ([(2, "%")] if scalar_of(t) in INTEGERS else []))
        return self.binary(left, operator, right, t)

    def bits(self, t, scope, depth):
        if self.random.chance(40):
            # The shift amount has the type of the value that is shifted.
            return self.binary(self.of(t, scope, depth - 1), self.random.choice(["<<", ">>"]), self.of(t, scope, depth - 1), t)
        left, right = self.operands(t, scope, depth)
        return self.binary(left, self.random.choice(["&", "|", "^"]), right, t)

    def unary(self, t, scope, depth):
        operators = (["-"] if scalar_of(t) in SIGNED else []) + (["~"] if scalar_of(t) in INTEGERS else [])
        operand = self.of(t, scope, depth - 1)
        name = "int" if t == INT and operand.text()[0].isdigit() else ""  # an explicit int, as in number()
        return Node(f"{name}(", self.random.choice(operators), operand, ")", type=t)

    def comparison(self, t, scope, depth):
        if self.random.chance(25):
            kinds = [k for k in self.types.all if not isinstance(k, (Matrix, Optional)) and self.types.is_comparable(k)]
            kind = self.random.choice(kinds)
            operator = self.random.choice(["==", "!="])
        else:
            kind = self.random.choice(self.types.numbers)
            operator = self.random.choice(["<", "<=", ">", ">=", "==", "!="])
        return self.binary(self.of(kind, scope, depth - 1), operator, self.of(kind, scope, depth - 1), BOOL)

    def logic(self, t, scope, depth):
        if self.random.chance(25):
            return Node("(!", self.of(BOOL, scope, depth - 1), ")", type=BOOL)
        return self.binary(self.of(BOOL, scope, depth - 1), self.random.choice(["&&", "||", "==", "!="]),
                           self.of(BOOL, scope, depth - 1), BOOL)

    def choice(self, t, scope, depth):
        condition = self.of(BOOL, scope, depth - 1)
        first, second = self.of(t, scope, depth - 1), self.of(t, scope, depth - 1)
        if self.random.chance(50):
            return Node("select(", condition, ", ", first, ", ", second, ")", type=t)
        return Node("(", condition, " ? ", first, " : ", second, ")", type=t)

    # ------------------------------------------------------------------------------------------------ parts of values

    def part(self, t, scope, depth):
        """A field of a variable, or an element of one at an index that may be out of range."""
        found = []
        for name, type, _ in scope.variables:
            if isinstance(type, Array) and type.element == t:
                found.append((name, type))
            if isinstance(type, Matrix) and Vector(type.rows, FLOAT) == t and not scope.evaluable:
                found.append((name, Array(t, type.columns)))
            if isinstance(type, Vector) and type.scalar == t:
                found.append((name, Array(t, type.size)))
            if isinstance(type, Struct):
                found += [(f"{name}.{f}", kind) for f, kind in type.fields if kind == t]
        if not found:
            return None
        name, type = self.random.choice(found)
        if type == t:
            return Node(name, type=t)
        return Node(name, "[", self.index(type.size, scope, depth), "]", type=t)

    def index(self, size, scope, depth):
        if self.random.chance(30):
            return Node(f"{self.random.below(size)}")
        # A constant index out of range is an error, and the evaluator cannot compute a read out of range.
        if scope.evaluable or not scope.unknown or self.random.chance(70):
            return Node("(", self.of(UINT, scope, depth - 1), f" % {size}u)")
        return Node(f"({scope.unknown} % {size + 3}u)")

    def swizzle(self, t, scope, depth):
        size = self.random.between(2, 4)
        lanes = "".join(self.random.choice("xyzw"[:size]) for _ in range(t.size))
        return Node(self.of(Vector(size, t.scalar), scope, depth - 1), ".", lanes, type=t)

    def made_vector(self, t, scope, depth):
        sizes, left = [], t.size
        while left:
            sizes.append(self.random.between(1, min(left, t.size - 1)))
            left -= sizes[-1]
        parts = [self.of(vector(size, t.scalar), scope, depth - 1) for size in sizes]
        return Node(t.text(), "(", *joined(parts), ")", type=t)

    def made(self, t, scope, depth):
        types = [t.element] * t.size if isinstance(t, Array) else [kind for _, kind in t.fields]
        return Node(t.text(), "(", *joined([self.of(kind, scope, depth - 1) for kind in types]), ")", type=t)

    def matrix(self, t, scope, depth):
        if self.random.chance(40):
            columns = [self.of(Vector(t.rows, FLOAT), scope, depth - 1) for _ in range(t.columns)]
            return Node(t.text(), "(", *joined(columns), ")", type=t)
        if self.random.chance(50):
            inner = self.random.between(2, 4)
            return self.binary(self.of(Matrix(inner, t.rows), scope, depth - 2), "*", self.of(Matrix(t.columns, inner), scope, depth - 2), t)
        return self.binary(self.of(t, scope, depth - 1), self.random.choice(["+", "-"]), self.of(t, scope, depth - 1), t)

    def converted(self, t, scope, depth):
        source = vector(size_of(t), self.random.choice([s for s in self.types.numbers if s != scalar_of(t)]))
        value = self.of(source, scope, depth - 1)
        # A literal takes the type of the conversion around it, for which an operator of integers alone, such as %,
        # would be an error.
        if scalar_of(source) == INT:
            value = Node(source.text(), "(", value, ")", type=source)
        return Node(t.text(), "(", value, ")", type=t)

    # ------------------------------------------------------------------------------------------------ optionals

    def some(self, t, scope, depth):
        return Node(self.of(t.value, scope, depth - 1), type=t)

    def chosen_optional(self, t, scope, depth):
        return Node("(", self.of(BOOL, scope, depth - 1), " ? ", self.of(t.value, scope, depth - 1), " : none)", type=t)

    def value_of_optional(self, t, scope, depth):
        optional = self.variable(Optional(t), scope) or self.call(Optional(t), scope, depth)
        if optional is None:
            return None
        return Node("(", optional, " ?? ", self.of(t, scope, depth - 1), ")", type=t)

    # ------------------------------------------------------------------------------------------------ calls

    def read(self, t, scope, depth):
        found = [read for kind, read in scope.reads if kind == t]
        return self.random.choice(found)(self, scope, depth - 1) if found else None

    def call(self, t, scope, depth):
        found = [f for f in scope.functions if f.result == t and (f.evaluable or not scope.evaluable)]
        if not found:
            return None
        function = self.random.choice(found)
        arguments = [self.of(type, scope, depth - 2) for type in function.params]
        return Node(function.name, "(", *joined(arguments), ")", type=t)

    def closure(self, t, scope, depth):
        """A call of a function that is given a closure, which captures variables."""
        if scope.evaluable or depth < 2:
            return None
        name = f"c{depth}"
        captured = [v for v in scope.variables if CAPTURED.fullmatch(v[0])]
        inner = Scope([(name, t, False), *[(n, kind, False) for n, kind, _ in captured]], scope.functions)
        return Node(f"applied_twice(|{name}| ", self.of(t, inner, depth - 2), ", ", self.of(t, scope, depth - 1), ")", type=t)

    def digest(self, t, scope, depth):
        if scope.evaluable:
            return None
        kind = self.random.choice([k for k in self.types.all if k != UINT])
        return Node(self.types.digest(kind), "(", self.of(kind, scope, depth - 1), ")", type=UINT)

    def intrinsic(self, t, scope, depth):
        found = []
        for intrinsic in INTRINSICS:
            if intrinsic.exact and (intrinsic.name in EVALUATED or not scope.evaluable):
                types = intrinsic.arguments_for(t, self.random)
                if types is not None and all(self.types.has(type) for type in types):
                    found.append((intrinsic, types))
        if not found:
            return None
        intrinsic, types = self.random.choice(found)
        arguments = [self.of(type, scope, depth - 1) for type in types]
        return self._defined(intrinsic.name, types, arguments, t)

    def _defined(self, name, types, arguments, t):
        """A call whose result is the same on every device. Two things differ between devices: the bits of a NaN, for which the
        functions that take bits get 0.5 instead; and the sign of a zero that min, max, clamp or reflect give (in reflect a product of
        constants may be a zero), to which a zero is added."""
        if name.endswith(("BitsToUint", "BitsToInt", "BitsToUint64", "Half2x16", "packUnorm4x8")) and not name.startswith("unpack"):
            arguments = [Node("without_nan(", argument, ")", type=type) for argument, type in zip(arguments, types)]
        node = Node(name, "(", *joined(arguments), ")", type=t)
        if name in ("min", "max", "clamp", "reflect") and scalar_of(t) in FLOATS:
            return Node("(", node, f" + {literal(scalar_of(t))})", type=t)
        return node

    def inexact(self, t, scope, depth):
        """A call of a function with an error bound, with arguments in the range of that bound (docs/reference/language.md)."""
        named = [i for i in INTRINSICS if not i.exact and i.params[0][0] in "GFV" and (i.result != "=" or t == FLOAT)]
        found = [(i, types) for i in named if (types := i.arguments_for(t, self.random)) is not None]
        intrinsic, types = self.random.choice(found)
        low, high = RANGES.get(intrinsic.name, EVERYWHERE)
        arguments = [Node("clamp(", self.of(type, scope, depth - 1), f", {float(low)}, {float(high)})", type=type) for type in types]
        return Node(intrinsic.name, "(", *joined(arguments), ")", type=t)
