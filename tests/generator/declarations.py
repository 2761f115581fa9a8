"""A random program's declarations other than kernels and structures: types, helpers for them, functions, generic functions."""
import re

from expressions import Function
from model import (BOOL, DOUBLE, FLOAT, FLOATS, HALF, INT, INT64, INTEGERS, NUMBERS, UINT, UINT64, Array, Enum, Matrix, Node, Optional,
                   Scalar, Struct, Vector, joined, literal, scalar_of)

# Helpers of every program. `without_nan` replaces NaN, whose bits may differ between devices; `digest` hashes a value to a uint;
# `made_T` makes a value of type T from a number.
HELPERS = """
fn without_nan(x: float) -> float { return isnan(x) ? 0.5 : x; }
fn without_nan(x: half) -> half { return isnan(x) ? 0.5h : x; }
fn without_nan(x: double) -> double { return isnan(x) ? 0.5d : x; }
fn without_nan(x: uint) -> uint { return x; }
fn without_nan(x: uint64) -> uint64 { return x; }
fn without_nan(x: int) -> int { return x; }
fn without_nan<N: uint, T: Floating>(v: vec<N, T>) -> vec<N, T> {
    var result = v;
    for i in 0..N { if isnan(v[i]) { result[i] = T(0.5); } }
    return result;
}
fn without_nan<N: uint, T: Integer>(v: vec<N, T>) -> vec<N, T> { return v; }
fn digest(x: uint) -> uint { return x; }
fn digest(x: int) -> uint { return uint(x); }
fn digest(x: bool) -> uint { return x ? 3u : 5u; }
fn digest(x: uint64) -> uint { return uint(x) ^ 31u * uint(x >> 32ul); }
fn digest(x: int64) -> uint { return digest(uint64(x)); }
fn digest(x: float) -> uint { return isnan(x) ? 7u : floatBitsToUint(x); }
fn digest(x: half) -> uint { return digest(float(x)); }
fn digest(x: double) -> uint { return isnan(x) ? 7u : digest(doubleBitsToUint64(x)); }
fn digest<N: uint, T: type>(v: vec<N, T>) -> uint {
    var sum = 17u;
    for i in 0..N { sum = sum * 31u + digest(v[i]); }
    return sum;
}
fn mixed(x: uint) -> uint {
    let a = (x ^ (x >> 16u)) * 0x7feb352du;
    let b = (a ^ (a >> 15u)) * 0x846ca68bu;
    return b ^ (b >> 16u);
}
fn made_uint(h: uint) -> uint { return h % 4u == 0u ? mixed(h) : mixed(h) % 50u; }
fn made_int(h: uint) -> int { return int(made_uint(h)) - 20; }
fn made_bool(h: uint) -> bool { return mixed(h) % 3u == 0u; }
fn made_uint64(h: uint) -> uint64 { return (uint64(made_uint(h)) << (h % 2u == 0u ? 32ul : 0ul)) | uint64(mixed(h + 9u)); }
fn made_int64(h: uint) -> int64 { return int64(made_uint64(h)); }
fn made_float(h: uint) -> float {
    let kind = mixed(h) % 32u;
    if kind == 0u { return uintBitsToFloat(mixed(h + 1u)); }
    if kind == 1u { return -0.0; }
    if kind == 2u { return uintBitsToFloat(0x7f800000u); }
    if kind == 3u { return uintBitsToFloat(0x7fc00000u); }
    return float(int(mixed(h + 2u) % 4001u) - 2000) * (kind < 8u ? 0.1 : 0.125);
}
fn made_half(h: uint) -> half { return half(made_float(h)); }
fn made_double(h: uint) -> double { return double(made_float(h)) * (h % 3u == 0u ? 1.1d : 1.0d); }
"""

VECTOR_SCALARS = (FLOAT, INT, UINT, BOOL)


class Types:
    """The types that one program uses."""

    def __init__(self, random):
        self.random = random
        self.numbers = [INT, UINT, FLOAT] + [t for t in (HALF, DOUBLE, INT64, UINT64) if random.chance(40)]
        self.scalars = [BOOL] + self.numbers
        self.vectors = [Vector(n, s) for n in (2, 3, 4) for s in VECTOR_SCALARS if random.chance(70)]
        self.vectors += [Vector(random.between(2, 4), s) for s in self.numbers if s not in VECTOR_SCALARS]
        self.matrices = [Matrix(random.between(2, 4), random.between(2, 4)) for _ in range(2)]
        self.vectors = list(dict.fromkeys(self.vectors + [Vector(m.rows, FLOAT) for m in self.matrices]))
        self.enums = [Enum(f"E{i}", tuple(f"{'abcd'[k]}{i}" for k in range(random.between(2, 4)))) for i in range(2)]
        self.structs, self.arrays = [], []
        for i in range(3):
            self.arrays.append(Array(self.part(), random.between(2, 4)))
            self.structs.append(Struct(f"S{i}", tuple((f"f{k}", self.part()) for k in range(random.between(1, 4)))))
        self.optionals = [Optional(random.choice(self.scalars + self.vectors + self.structs)) for _ in range(2)] + [Optional(UINT)]
        self.optionals = list(dict.fromkeys(self.optionals))
        self.storable = self.scalars + self.vectors + self.matrices + self.enums + self.structs + self.arrays
        self.storable = list(dict.fromkeys(self.storable))
        self.all = self.storable + self.optionals
        self.local = self.scalars * 2 + self.all

    def part(self):
        """A random type for a field or an element."""
        return self.random.choice(self.scalars * 2 + self.vectors + self.enums + self.arrays + self.structs)

    def has(self, t):
        scalar = scalar_of(t)
        return scalar in self.scalars

    def is_evaluable(self, t):
        """Whether the compile-time evaluator can compute with a type. It cannot with matrices."""
        return not isinstance(t, Matrix)

    def is_comparable(self, t):
        return not isinstance(t, Array) and parts_of(t) <= 64

    def has_digest(self, t, evaluable):
        """Whether there is a function that digests values of a type; if `evaluable`, one that the compile-time evaluator can
        run. It cannot take the bits of floats, so that only integers, bools and vectors of them remain."""
        if isinstance(t, Vector) and isinstance(t.scalar, Scalar) or isinstance(t, Scalar):
            return not evaluable or scalar_of(t) not in FLOATS
        return t in self.all and not evaluable

    def digest(self, t):
        return "digest" if isinstance(t, (Scalar, Vector)) else f"digest_{name_of(t)}"

    def declarations(self):
        return [Node(text) for enum in self.enums for text in enum_texts(enum)] + \
               [Node(f"struct {s.name} {{ " + " ".join(f"{f}: {t.text()};" for f, t in s.fields) + " }") for s in self.structs] + \
               [Node(text) for text in split_declarations(HELPERS)] + [Node(self.digest_text(t)) for t in self.all if self.digest(t) != "digest"] + \
               [Node(self.made_text(t)) for t in self.storable if not isinstance(t, Scalar)]

    def digest_text(self, t):
        head = f"fn {self.digest(t)}(x: {t.text()}) -> uint "
        if isinstance(t, Enum):
            return head + "{ return " + "".join(f"x == {t.name}.{e} ? {i + 11}u : " for i, e in enumerate(t.enumerators)) + "1u; }"
        if isinstance(t, Optional):
            return head + f"{{ if let y = x {{ return 1u + {self.digest(t.value)}(y); }} return 0u; }}"
        if isinstance(t, Struct):
            parts = [(f"x.{f}", kind) for f, kind in t.fields]
        elif isinstance(t, Array):
            parts = [(f"x[{i}]", t.element) for i in range(t.size)]
        else:
            parts = [(f"x[{i}]", Vector(t.rows, FLOAT)) for i in range(t.columns)]
        text = "17u"
        for part, kind in parts:
            text = f"({text} * 31u + {self.digest(kind)}({part}))"
        return head + f"{{ return {text}; }}"

    def made(self, t, hash_):
        return f"made_{name_of(t)}({hash_})"

    def made_text(self, t):
        head = f"fn made_{name_of(t)}(h: uint) -> {t.text()} "
        if isinstance(t, Enum):
            choices = "".join(f"h % {len(t.enumerators)}u == {i}u ? {t.name}.{e} : " for i, e in enumerate(t.enumerators[:-1]))
            return head + f"{{ return {choices}{t.name}.{t.enumerators[-1]}; }}"
        kinds = ([kind for _, kind in t.fields] if isinstance(t, Struct) else [t.element] * t.size if isinstance(t, Array)
                 else [Vector(t.rows, FLOAT)] * t.columns if isinstance(t, Matrix) else [t.scalar] * t.size)
        return head + f"{{ return {t.text()}({', '.join(self.made(kind, f'h * {2 * i + 3}u + {i}u') for i, kind in enumerate(kinds))}); }}"


def split_declarations(text):
    """Splits a text before each line that begins with a declaration."""
    return [part.strip() for part in re.split(r"\n(?=fn |struct |translator |@|kernel |///)", text) if part.strip()]


def enum_texts(enum):
    return [f"enum {enum.name} {{ {', '.join(enum.enumerators)} }}"]


def parts_of(t):
    if isinstance(t, Struct):
        return sum(parts_of(kind) for _, kind in t.fields)
    if isinstance(t, Array):
        return t.size * parts_of(t.element)
    if isinstance(t, Optional):
        return 1 + parts_of(t.value)
    return t.columns * t.rows if isinstance(t, Matrix) else t.size if isinstance(t, Vector) else 1


def name_of(t):
    """A type's name in a form that can be part of an identifier."""
    if isinstance(t, Vector):
        return f"{t.scalar.name}{t.size}"
    if isinstance(t, Array):
        return f"{name_of(t.element)}_{t.size}"
    if isinstance(t, Optional):
        return f"{name_of(t.value)}_or_none"
    return t.text()


class Functions:
    """Makes random functions. Each may call those made before."""

    def __init__(self, random, types, statements):
        self.random, self.types, self.statements = random, types, statements
        self.known = []

    def declarations(self, count):
        return self.generics() + [self.function(i) for i in range(count)]

    def function(self, number):
        evaluable = self.random.chance(60)
        values = [t for t in self.types.all if not evaluable or self.types.is_evaluable(t)]
        params = [(f"p{i}", self.random.choice(self.types.scalars * 2 + values)) for i in range(self.random.between(1, 3))]
        result = self.random.choice(self.types.scalars * 3 + values)
        body = self.statements.function_body(params, result, self.known, evaluable)
        name = f"f{number}"
        self.known.append(Function(name, [t for _, t in params], result, evaluable))
        return Node(f"fn {name}({', '.join(f'{n}: {t.text()}' for n, t in params)}) -> {result.text()}", body)

    def generics(self):
        """Makes generic functions; adds to `known` the instances that a program may call."""
        texts = []
        for i in range(3):
            operators = [self.random.choice(["+", "-", "*"]) for _ in range(3)]
            middle = self.random.choice(["max(a, b) + T(0)", "min(b, T(3)) + T(0)", "select(a < b, a, b)", "a"])
            texts.append(f"fn g{i}<T: Number>(a: T, b: T) -> T {{\nlet c = a {operators[0]} b;\nif c < T({self.random.below(5)}) "
                         f"{{ return c {operators[1]} ({middle}); }}\nreturn b {operators[2]} T({self.random.below(9)});\n}}")
            self.known += [Function(f"g{i}", [t, t], t, True, True) for t in self.types.numbers]
        texts.append(f"fn gv<N: uint, T: Number>(v: vec<N, T>, x: T) -> vec<N, T> {{\nvar r = v;\nfor i in 0..N {{ "
                     f"r[i] = r[i] {self.random.choice('+-*')} (v[N - 1u - i] {self.random.choice('+-*')} x); }}\nreturn r;\n}}")
        self.known += [Function("gv", [v, v.scalar], v, True, True) for v in self.types.vectors if v.scalar != BOOL]
        texts.append("fn gs<N: uint, T: Number>(v: vec<N, T>) -> T {\nvar s = T(1);\nfor i in 0..N { s = s * T(3) + v[i]; }\nreturn s;\n}")
        self.known += [Function("gs", [v], v.scalar, True, True) for v in self.types.vectors if v.scalar != BOOL]
        texts.append("fn gt<T: type>(c: bool, a: T, b: T) -> T { return c ? b : a; }")
        self.known += [Function("gt", [BOOL, t, t], t, True, True) for t in self.types.storable]
        texts.append("fn go<T: type>(c: bool, a: T) -> T? {\nif c { return none; }\nreturn a;\n}")
        self.known += [Function("go", [BOOL, t.value], t, True, True) for t in self.types.optionals]
        return [Node(text) for text in texts]
