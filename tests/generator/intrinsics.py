"""The intrinsics of compiler/ir/intrinsics.def, and the argument types with which they have a given result type."""
import pathlib
import re

from model import BOOL, DOUBLE, FLOAT, FLOATS, INT, INTEGERS, NUMBERS, UINT, UINT64, Matrix, Vector, scalar_of, size_of, vector

TABLE = pathlib.Path(__file__).resolve().parents[2] / "compiler" / "ir" / "intrinsics.def"
FIXED = {"f": FLOAT, "u": UINT, "i": INT, "b": BOOL, "2": Vector(2, FLOAT), "4": Vector(4, FLOAT)}
SCALARS = {"F": FLOATS, "G": FLOATS[:2], "V": FLOATS, "N": NUMBERS, "I": INTEGERS, "J": (INT, UINT), "U": (UINT,), "R": (FLOAT,),
           "D": (DOUBLE,), "L": (UINT64,), "S": (INT,), "B": (BOOL,)}

# The intrinsics that the compile-time evaluator (ir/evaluate.cpp) computes.
EVALUATED = {"abs", "sign", "floor", "ceil", "round", "trunc", "min", "max", "clamp", "mod", "sqrt", "any", "all", "lessThan",
             "lessThanEqual", "greaterThan", "greaterThanEqual", "equal", "notEqual", "bitCount", "findLSB", "findMSB"}

# Ranges of arguments for inexact functions, within those for which docs/reference/language.md bounds their error; EVERYWHERE for all others.
RANGES = {"exp": (-10, 10), "exp2": (-10, 10), "log": (0.01, 1e6), "log2": (0.01, 1e6), "pow": (0.01, 4), "tan": (-1.5, 1.5),
          "asin": (-1, 1), "acos": (-1, 1), "sinh": (-5, 5), "cosh": (-5, 5), "tanh": (-80, 80), "inversesqrt": (0.01, 1e6)}
EVERYWHERE = (-100, 100)


class Intrinsic:
    def __init__(self, name, signature, exact):
        self.name, self.exact = name, exact
        letters, self.result = signature.split(":")
        # "Nn" and "Fn": the argument has the type that the letter stands for, or is a scalar of its element type.
        self.params = re.findall(r"[NF]n|.", letters)

    def arguments_for(self, wanted, random):
        """Argument types for which the result has the wanted type; None if there are none."""
        shape = self._shape_for(wanted, random)
        if shape is None:
            return None
        if self.name == "cross" and size_of(shape) != 3:
            return None
        return [self._type_of(param, shape, random) for param in self.params]

    def _type_of(self, param, shape, random):
        if param[0] in FIXED:
            return FIXED[param[0]]
        if len(param) == 2 and random.chance(50):
            return scalar_of(shape)
        return shape

    def _shape_for(self, wanted, random):
        """The type that the signature's first letter has to stand for if the result is to have the wanted type; None if there is no
        such type, and for functions of matrices other than transpose. If the letter always stands for one type, gives `wanted`
        instead."""
        first = self.params[0][0] if self.params else ""
        if self.result in FIXED and FIXED[self.result] != wanted:
            return None
        if first == "M":
            return Matrix(wanted.rows, wanted.columns) if self.result == "t" and isinstance(wanted, Matrix) else None
        if isinstance(wanted, Matrix) or first not in SCALARS:
            return wanted if first in FIXED and self.result in FIXED else None
        scalars = SCALARS[first]
        if self.result in FIXED:
            return vector(random.between(1, 4), random.choice(scalars))
        if self.result == "=":
            return vector(random.between(2, 4), wanted) if wanted in scalars else None
        if self.result == first:
            return wanted if scalar_of(wanted) in scalars else None
        results = (FLOAT,) if self.result == "F" else SCALARS[self.result]
        if scalar_of(wanted) not in results:
            return None
        return vector(size_of(wanted), random.choice(scalars))


def read_table():
    """The intrinsics that any kernel may call: none of subgroups, quads or atomic operations."""
    found = re.findall(r'^INTRINSIC\((\w+), "([^"]*)", (\w+)\)', TABLE.read_text(), re.MULTILINE)
    return [Intrinsic(name, signature, exactness == "exact") for name, signature, exactness in found
            if not name.startswith(("subgroup", "atomic")) and not signature.endswith("+")]
