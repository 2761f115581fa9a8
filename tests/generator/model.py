"""Types of the language, and programs as trees whose leaves are text."""
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Scalar:
    name: str

    def text(self):
        return self.name


@dataclass(frozen=True)
class Vector:
    size: int
    scalar: Scalar

    def text(self):
        if self.scalar in (FLOAT, INT, UINT, BOOL):
            return f"{self.scalar.name}{self.size}"
        return f"vec<{self.size}, {self.scalar.name}>"


@dataclass(frozen=True)
class Matrix:
    """A matrix of floats."""
    columns: int
    rows: int

    def text(self):
        return f"float{self.columns}x{self.rows}"


@dataclass(frozen=True)
class Array:
    element: object
    size: int

    def text(self):
        return f"{self.element.text()}[{self.size}]"


@dataclass(frozen=True)
class Struct:
    name: str
    fields: tuple = field(compare=False)  # (name, type) pairs

    def text(self):
        return self.name


@dataclass(frozen=True)
class Enum:
    name: str
    enumerators: tuple = field(compare=False)

    def text(self):
        return self.name


@dataclass(frozen=True)
class Optional:
    value: object

    def text(self):
        return f"{self.value.text()}?"


BOOL, INT, UINT, FLOAT = Scalar("bool"), Scalar("int"), Scalar("uint"), Scalar("float")
HALF, DOUBLE, INT64, UINT64 = Scalar("half"), Scalar("double"), Scalar("int64"), Scalar("uint64")
INTEGERS = (INT, UINT, INT64, UINT64)
FLOATS = (FLOAT, HALF, DOUBLE)
NUMBERS = INTEGERS + FLOATS
SIGNED = (INT, INT64) + FLOATS


def vector(size, scalar):
    return scalar if size == 1 else Vector(size, scalar)


def scalar_of(t):
    return t.scalar if isinstance(t, Vector) else FLOAT if isinstance(t, Matrix) else t


def size_of(t):
    return t.size if isinstance(t, Vector) else 1


def bytes_of(t):
    """At least as many bytes as a value of the type takes in workgroup memory."""
    if isinstance(t, Struct):
        return sum(bytes_of(of) for _, of in t.fields) + 8
    if isinstance(t, Array):
        return t.size * bytes_of(t.element)
    if isinstance(t, Matrix):
        return 4 * t.columns * t.rows
    return size_of(t) * (8 if scalar_of(t) in (DOUBLE, INT64, UINT64) else 4)


def is_shaped(t):
    """Whether a type is a scalar or a vector."""
    return isinstance(t, (Scalar, Vector))


class Node:
    """Text and child nodes, in order. A node with a type is an expression; the shrinker may put another of that type in its
    place."""

    def __init__(self, *parts, type=None):
        self.parts = list(parts)
        self.type = type

    def text(self):
        return "".join(part if isinstance(part, str) else part.text() for part in self.parts)

    def children(self):
        return [part for part in self.parts if not isinstance(part, str)]


class Items(Node):
    """Statements or declarations. The shrinker may remove each of them."""

    def __init__(self, items=()):
        super().__init__(*items)

    def text(self):
        return "\n".join(part if isinstance(part, str) else part.text() for part in self.parts)


def joined(nodes, separator=", "):
    """The nodes with the separator between them, as parts of a Node."""
    parts = []
    for i, node in enumerate(nodes):
        if i:
            parts.append(separator)
        parts.append(node)
    return parts


def literal(t):
    """The simplest expression of a type."""
    if isinstance(t, Scalar):
        return {"bool": "false", "int": "0", "uint": "0u", "float": "0.0", "half": "0.0h", "double": "0.0d", "int64": "0l",
                "uint64": "0ul"}.get(t.name, f"{t.name}(0)")
    if isinstance(t, Vector):
        return f"{t.text()}({literal(t.scalar)})"
    if isinstance(t, Matrix):
        return f"{t.text()}({', '.join([literal(Vector(t.rows, FLOAT))] * t.columns)})"
    if isinstance(t, Array):
        return f"{t.text()}({', '.join([literal(t.element)] * t.size)})"
    if isinstance(t, Struct):
        return f"{t.name}({', '.join(literal(f) for _, f in t.fields)})"
    if isinstance(t, Enum):
        return f"{t.name}.{t.enumerators[0]}"
    return "none"
