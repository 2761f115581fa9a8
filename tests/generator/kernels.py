"""Random kernels, and the tests that run them."""
from expressions import Scope
from model import (BOOL, FLOAT, INT, INTEGERS, UINT, Array, Items, Matrix, Node, Optional, Vector, bytes_of, joined,
                   vector)
from structures import Structure, extent_text

OPERATIONS = ["add", "min", "max", "and", "or", "xor"]
ATOMICS = {"add": "atomicAdd", "min": "atomicMin", "max": "atomicMax", "and": "atomicAnd", "or": "atomicOr", "xor": "atomicXor"}
SUBGROUPS = {"add": "subgroupAdd", "min": "subgroupMin", "max": "subgroupMax", "and": "subgroupAnd", "or": "subgroupOr",
             "xor": "subgroupXor"}
MOST_SHARED_BYTES = 8192  # of one array in workgroup memory; a kernel has up to three, and lavapipe allows 32,768 bytes in all


# A container whose functions write members by `scatter` with an operation, by `coherent` or by both. `of` reads the member `given`,
# which none of them writes.
BAG_TEXT = """
structure Bag(n: uint) {
    structure marks = Line(max(n, 1u));
    structure most = Line(max(n, 1u));
    structure number = Line(1u);
    structure given = Line(max(n, 1u));

    fn mark(x: uint) with scatter<marks, or> { marks[x % max(n, 1u)] = x | 1u; }
    fn raise(x: uint) with coherent<most> { atomicMax(most[x % max(n, 1u)], x); }
    fn enter(x: uint) with coherent<number> -> uint? {
        if x % 3u == 0u { return none; }
        return atomicAdd(number[0], x % 7u);
    }
    fn both(x: uint) with scatter<marks, or>, coherent<most> {
        if x % 2u == 0u { mark(x / 2u); } else { raise(x); }
    }
    fn of(x: uint) -> uint { return given[x % max(n, 1u)] ^ n; }
}
"""
BAG_FUNCTIONS = ["mark", "raise", "enter", "both"]


class Parameter:
    def __init__(self, name, text, structure=None, value=None, moves=False, extent=None):
        self.name, self.text, self.structure, self.value = name, text, structure, value
        self.moves = moves    # whether it follows the iteration (each, near, at), so that it has the kernel's extent
        self.extent = extent  # its own extent if it does not follow the iteration


class Bag(Structure):
    """The container of BAG_TEXT."""

    def make(self, extent):
        return f"Bag({extent[0]}u)"


BAG = Bag("Bag", 1, UINT, each=False)


class Kernel:
    """A kernel under construction: its parameters, the scope of its body, its extent."""

    def __init__(self, name, axes, extent):
        self.name, self.axes, self.extent = name, axes, extent
        self.params = []
        self.scope = Scope()
        self.writes = []  # functions that take a scope and return a statement that writes an output or hashes a window of `near`
        self.bare_address = None  # the `at` parameter whose argument calls may leave out: its pattern names no structure


class Kernels:
    def __init__(self, random, types, structures, statements, functions):
        self.random, self.types, self.structures, self.statements = random, types, structures, statements
        self.expressions, self.functions = statements.expressions, functions

    def kernel(self, number):
        """Makes a kernel and its test."""
        maker = self.random.weighted([(10, self.plain), (4, self.grouped), (2, self.rows), (1, self.inexact), (2, self.shared_loop),
                                      (2, self.exchanged)])
        return maker(f"k{number}")

    # ------------------------------------------------------------------------------------------------ parameters

    def extent(self, axes, most=700):
        sides = {1: (1, most), 2: (1, 29), 3: (1, 9)}[axes]
        return [self.random.between(*sides) for _ in range(axes)]

    def begin(self, name, axes):
        kernel = Kernel(name, axes, self.extent(axes))
        kernel.scope.functions = self.functions.known
        kernel.scope.unknown = "position()" if axes == 1 else "position().y"
        kernel.scope.variables.append(("position()", vector(axes, UINT), False))
        for i in range(self.random.below(3)):
            t = self.random.choice(self.types.storable)
            kernel.params.append(Parameter(f"c{i}", t.text(), value=t))
            kernel.scope.variables.append((f"c{i}", t, False))
        return kernel

    def of_axes(self, axes, each=False):
        return [s for s in self.structures.all if s.axes == axes and (s.each or not each)]

    def visited(self, kernel, each=False):
        """Structures for another parameter that follows the iteration. A kernel visits the blocks of what it writes by `each`,
        or else of what it reads. Of either kind only one may have blocks, since two structures list different ones."""
        has_blocks = any(p.moves and p.structure.block and p.text.startswith("in ") != each for p in kernel.params)
        return [s for s in self.of_axes(kernel.axes, each) if not s.block or not has_blocks]

    def add_inputs(self, kernel, most=3):
        for i in range(self.random.between(1, most)):
            maker = self.random.weighted([(4, self.add_each), (3, self.add_near), (4, self.add_any)])
            maker(kernel, f"x{i}")

    def add_each(self, kernel, name):
        found = self.visited(kernel)
        if found:
            structure = self.random.choice(found)
            kernel.params.append(Parameter(name, f"in each<{structure.name}>", structure, moves=True))
            kernel.scope.variables.append((name, structure.element, False))

    def add_near(self, kernel, name):
        found = self.visited(kernel)
        if not found:
            return
        structure, radius = self.random.choice(found), self.random.between(1, 2)
        radii, text = [radius] * kernel.axes, str(radius)
        if kernel.axes > 1 and self.random.chance(35):
            radii = [self.random.between(0, 2) for _ in range(kernel.axes)]
            radii[self.random.below(kernel.axes)] = radius
            text = f"uint{kernel.axes}({', '.join(map(str, radii))})"
        kernel.params.append(Parameter(name, f"in near<{structure.name}, {text}>", structure, moves=True))

        def offset(expressions, scope, depth):
            lanes = [str(expressions.random.between(-along, along)) for along in radii]
            text = lanes[0] if kernel.axes == 1 else f"int{kernel.axes}({', '.join(lanes)})"
            return Node(f"{name}[{text}]", type=structure.element)
        kernel.scope.reads += [(structure.element, offset)] * 3

        def window(scope):
            result, i = self.statements.name("v"), self.statements.name("i")
            axis = self.random.below(kernel.axes)
            lanes = ["0"] * kernel.axes
            lanes[axis] = i
            at = i if kernel.axes == 1 else f"int{kernel.axes}({', '.join(lanes)})"
            digest = self.types.digest(structure.element)
            scope.variables.append((result, UINT, True))
            return Node(f"var {result} = 0u;\nfor {i} in -{radii[axis]}..{radii[axis] + 1} {{\n{result} = {result} * 31u + {digest}({name}[{at}]);\n}}")
        kernel.writes.append(window)

    def add_any(self, kernel, name):
        structure = self.random.choice(self.structures.all)
        extent = self.extent(structure.axes, 300)
        kernel.params.append(Parameter(name, f"in any<{structure.name}>", structure, extent=extent))
        element, address = structure.element, vector(structure.axes, UINT)

        def inside(expressions, scope, depth):
            return Node("(", expressions.of(address, scope, depth), f" % {name}.domain())", type=address)

        def place(expressions, scope, depth):
            if expressions.random.chance(50):
                return inside(expressions, scope, depth)
            if structure.axes == kernel.axes and expressions.random.chance(50):
                sign = expressions.random.choice("+-")
                return Node(f"(position() {sign} ", expressions.constant(address, scope), ")", type=address)
            return expressions.of(address, scope, depth)

        def read(expressions, scope, depth):
            return Node(f"{name}[", place(expressions, scope, depth), "]", type=element)

        def find(expressions, scope, depth):
            return Node(f"({name}.find(", place(expressions, scope, depth), ") ?? ", expressions.of(element, scope, depth), ")",
                        type=element)

        def contains(expressions, scope, depth):
            return Node(f"{name}.contains(", place(expressions, scope, depth), ")", type=BOOL)

        def domain(expressions, scope, depth):
            return Node(f"{name}.domain()", type=address)
        kernel.scope.reads += [(element, read)] * 4 + [(element, find), (BOOL, contains), (address, domain)]
        if structure.axes == 2 and element in (FLOAT, INT, UINT):
            kernel.scope.reads.append((vector(4, element), self.gather(name, inside, element)))

    def gather(self, name, inside, element):
        """The four elements around a point inside or outside of the structure, whose coordinates are multiples of 1/4."""
        def found(expressions, scope, depth):
            low = -expressions.random.between(0, 4)
            return Node(f"{name}.gather(float2(int2(", inside(expressions, scope, depth), f")) * 1.25 + float2({low}.0))",
                        type=vector(4, element))
        return found

    def add_outputs(self, kernel):
        for i in range(self.random.between(1, 2)):
            found = self.visited(kernel, each=True)
            kind = self.random.weighted([(6, "out"), (3, "inout"), (3, "scatter"), (1, "coherent"), (2, "calls")])
            name = f"y{i}"
            # Where two addresses lead to one element, one invocation may read it while another one writes it.
            found = [s for s in found if kind != "inout" or s.owns]
            if kind in ("out", "inout") and found:
                self.add_written(kernel, name, kind, self.random.choice(found))
            elif kind == "coherent":
                self.add_coherent(kernel, name)
            elif kind == "calls":
                self.add_calls(kernel, name)
            else:
                self.add_scatter(kernel, name)

    def add_written(self, kernel, name, kind, structure):
        kernel.params.append(Parameter(name, f"{kind} each<{structure.name}>", structure, moves=True))
        if kind == "inout":
            kernel.scope.variables.append((name, structure.element, True))
        kernel.writes.append(lambda scope: Node(f"{name} = ", self.mixed(structure.element, scope), ";"))

    def mixed(self, t, scope):
        """A value of type t that depends on `sum`, into which `body` hashes most of the variables that it declares."""
        value = self.expressions.of(t, scope, 4)
        if t in (INT, UINT):
            return Node("(", value, f" ^ {t.name}(sum))", type=t)
        if isinstance(t, Vector) and t.scalar in (INT, UINT):
            return Node("(", value, f" ^ {t.scalar.name}(sum))", type=t)
        return Node("gt(sum % 3u == 0u, ", value, ", ", self.expressions.of(t, scope, 3), ")", type=t)

    def combined_structures(self):
        """Structures in buffers and images whose elements `scatter` can combine: their element is one int, uint or float."""
        return [s for s in self.structures.all if s.element in (INT, UINT, FLOAT) and s.combines]

    def add_scatter(self, kernel, name):
        structure = self.random.choice(self.combined_structures())
        operation = self.random.choice(["min", "max", "add"] if structure.element == FLOAT else OPERATIONS)
        adds_floats = structure.element == FLOAT and operation == "add"
        kernel.params.append(Parameter(name, f"out scatter<{structure.name}, {operation}>", structure,
                                       extent=self.extent(structure.axes, 100)))
        address = vector(structure.axes, UINT)
        meets = self.random.chance(60)
        has_order = meets and adds_floats and structure.buffer and self.random.chance(50)
        place = None
        if meets:
            place = (self.place_of_sum if has_order else self.meeting_place)(kernel, name, structure.axes)

        def write(scope):
            at = [place] if meets else [self.expressions.of(address, scope, 2), f" % {extent_text([40] * structure.axes)}"]
            # Sums of few small numbers are exact in floats, in any order.
            value = ["float(", self.expressions.of(UINT, scope, 3), " % 8u)"] if adds_floats and not has_order else \
                [self.expressions.of(structure.element, scope, 3)]
            parts = [f"{name}[", *at, "] = ", *value, ";"]
            if self.random.chance(30):
                parts = ["if ", self.expressions.of(BOOL, scope, 2), " { ", *parts, " }"]
            return Node(*parts)
        kernel.writes.append(write)

    def place_of_sum(self, kernel, name, axes):
        """An address that is the same along some axes: devices make sums of floats there in one order, so their values are arbitrary."""
        own = self.own_address(kernel, f"at_{name}")
        first, count = self.random.below(kernel.axes), self.random.between(0, min(axes, kernel.axes - 1))
        parts = [own[(first + i) % kernel.axes] for i in range(count)]
        parts += [f"{self.random.between(0, 9)}u" for _ in range(axes - count)]
        return parts[0] if axes == 1 else f"uint{axes}({', '.join(parts)})"

    def meeting_place(self, kernel, name, axes):
        """An address at which many elements meet: each part is a constant, a part of the element's address, or a fraction of one."""
        own = self.own_address(kernel, f"at_{name}")

        def part():
            component = own[self.random.between(0, kernel.axes - 1)]
            run = self.random.choice([3, 4, 8, 12, 16, 40])
            return self.random.weighted([(3, f"{self.random.between(0, 9)}u"), (4, component), (2, f"{component} / {run}u"),
                                         (1, f"({component} + {self.random.between(0, 9)}u) >> {self.random.between(1, 5)}u"),
                                         (1, f"{component} % 5u")])
        parts = [part() for _ in range(axes)]
        return parts[0] if axes == 1 else f"uint{axes}({', '.join(parts)})"

    def add_coherent(self, kernel, name):
        operation = ATOMICS[self.random.choice(OPERATIONS)]
        kernel.params.append(Parameter(name, "inout coherent<Line>", self.structures.line, extent=[self.random.between(1, 40)]))
        kernel.writes.append(lambda scope: Node(f"{operation}({name}[", self.expressions.of(UINT, scope, 2), " % 50u], ",
                                                self.expressions.of(UINT, scope, 3), ");"))

    def add_calls(self, kernel, name):
        """Adds a parameter `calls<Bag>`, a call of one function that writes, and calls of `of`, which reads."""
        kernel.params.append(Parameter(name, "calls<Bag>", BAG, extent=[self.random.between(1, 60)]))
        function = self.random.choice(BAG_FUNCTIONS)
        result = self.statements.name("v")

        def call(scope):
            return Node(f"{name}.{function}(", self.expressions.of(UINT, scope, 3), ");")

        def counted(scope):
            # The sum that `enter` returns depends on the order of the invocations; whether it returns one does not.
            node = Node(f"let {result} = ({name}.enter(", self.expressions.of(UINT, scope, 3), ") ?? 4294967295u) != 4294967295u;")
            scope.variables.append((result, BOOL, False))
            return node
        kernel.writes.append(counted if function == "enter" else call)
        kernel.scope.reads += [(UINT, lambda expressions, scope, depth: Node(f"{name}.of(", expressions.of(UINT, scope, depth), ")",
                                                                           type=UINT))]

    def has_course(self, kernel):
        """Whether a parameter determines the addresses over which the kernel runs; if none does, it needs an `at`."""
        return any(p.moves and " near<" not in p.text for p in kernel.params)

    def ensure_course(self, kernel):
        if not self.has_course(kernel):
            structure = self.random.choice(self.of_axes(kernel.axes))
            kernel.params.append(Parameter("a", f"at<{structure.name}>", structure, moves=True))

    # ------------------------------------------------------------------------------------------------ kinds of kernels

    def plain(self, name):
        kernel = self.begin(name, self.random.choice([s.axes for s in self.structures.all]))
        self.add_inputs(kernel)
        self.add_outputs(kernel)
        self.ensure_course(kernel)
        return self.finished(kernel, self.body(kernel, self.random.between(0, 5)))

    def body(self, kernel, size, returns=True):
        scope = kernel.scope.inner()
        known = len(scope.variables)
        scope.variables.append(("sum", UINT, True))
        items = Items([Node("var sum = 1u;")])
        for _ in range(size):
            items.parts.append(self.statements.statement(scope, size, 2, None, None))
        items.parts += self.statements.uses(scope, known)
        writes = list(kernel.writes)
        if returns and self.random.chance(10):
            items.parts.append(Node("if ", self.expressions.of(BOOL, scope, 2), " {\nreturn;\n}"))
        for write in writes:
            items.parts.append(self.write(write, scope))
        return items

    def write(self, write, scope):
        """A statement that writes: unconditionally, in a branch or in a loop."""
        kind = self.random.weighted([(6, "here"), (2, "if"), (1, "else"), (1, "for")])
        if kind == "here":
            return write(scope)
        inner = scope.inner()
        if kind == "for":
            name = self.statements.name("i")
            inner.variables.append((name, UINT, False))
            return Node(f"for {name} in 0..{self.random.between(1, 3)} {{\n", write(inner), "\n}")
        parts = ["if ", self.expressions.of(BOOL, scope, 3), " {\n", write(inner), "\n}"]
        if kind == "else":
            parts += [" else {\n", write(scope.inner()), "\n}"]
        return Node(*parts)

    def begin_wide(self, name, axes):
        """A kernel over more than one workgroup, in most cases."""
        kernel = self.begin(name, axes)
        most = {1: 1500, 2: 90, 3: 40}[axes]
        kernel.extent = [self.random.between(1, most if axis < 2 else 7) for axis in range(axes)]
        return kernel

    def own_address(self, kernel, name):
        """Adds an `at` parameter, if there is a structure without blocks; returns the texts of its components."""
        found = [s for s in self.of_axes(kernel.axes) if not s.block]
        if found:
            structure = self.random.choice(found)
            kernel.params.append(Parameter(name, f"at<{structure.name}>", structure, moves=True))
        else:
            name = "position()"
        return [name] if kernel.axes == 1 else [f"{name}.{'xyzw'[axis]}" for axis in range(kernel.axes)]

    def shared_loop(self, name):
        """A kernel with one loop, in which elements that are apart read the same: shaders stage such loads."""
        kernel = self.begin_wide(name, self.random.choice([s.axes for s in self.structures.all]))
        own = self.own_address(kernel, "a")
        lines, bounds = [], [f"{self.random.between(0, 90)}u"]
        for i in range(self.random.between(1, 2)):
            structure = self.random.choice(self.structures.all)
            kernel.params.append(Parameter(f"x{i}", f"in any<{structure.name}>", structure,
                                           extent=self.extent(structure.axes, 300)))
            bounds.append(f"x{i}.domain()" + (".y" if structure.axes > 1 else ""))
            parts = [self.random.weighted([(4, "k"), (4, self.random.choice(own)), (1, f"{self.random.choice(own)} / 3u"),
                                           (1, f"(k + {self.random.choice(own)})"), (1, "3u")]) for _ in range(structure.axes)]
            at = parts[0] if structure.axes == 1 else f"uint{structure.axes}({', '.join(parts)})"
            lines.append(f"sum = sum * 31u + {self.types.digest(structure.element)}(x{i}[{at}]);")
        if self.random.chance(30):
            lines[-1] = f"if sum % 3u != 0u {{\n{lines[-1]}\n}}"
        first = self.random.weighted([(3, "0u"), (1, f"{self.random.between(0, 20)}u")])
        start, end = f"var sum = {self.random.choice(own)};\n", self.random.choice(bounds)
        if self.random.chance(60):
            start, end = start + f"let end = {end} - {end} % 3u;\n", "end"
        loop = start + f"for k in {first}..{end} {{\n" + "\n".join(lines) + "\n}"
        self.add_each(kernel, "x9")
        self.add_outputs(kernel)
        self.ensure_course(kernel)
        return self.finished_with(kernel, loop)

    def exchanged(self, name):
        """A kernel that loads, and sometimes stores, with exchanged axes: shaders make such accesses through tiles."""
        axes = [s.axes for s in self.structures.all if s.axes > 1]
        if not axes:
            return self.plain(name)
        kernel = self.begin_wide(name, self.random.choice(axes))
        own = self.own_address(kernel, "a")
        order = list(range(kernel.axes))
        while order[0] == 0:
            order = self.random.shuffled(order)
        structure = self.random.choice(self.of_axes(kernel.axes))
        kernel.params.append(Parameter("x0", f"in any<{structure.name}>", structure,
                                       extent=self.extent(kernel.axes)))
        at = f"uint{kernel.axes}({', '.join(own[axis] for axis in order)})"
        start = f"var sum = {self.types.digest(structure.element)}(x0[{at}]);"
        targets = [s for s in self.of_axes(kernel.axes, each=True) if s.owns]
        if self.random.chance(50) and targets:
            target = self.random.choice(targets)
            kernel.params.append(Parameter("y9", f"out scatter<{target.name}>", target,
                                           extent=[kernel.extent[axis] for axis in order]))
            kernel.writes.append(lambda scope: Node(f"y9[{at}] = ", self.mixed(target.element, scope), ";"))
        self.add_each(kernel, "x9")
        self.add_outputs(kernel)
        self.ensure_course(kernel)
        return self.finished_with(kernel, start)

    def finished_with(self, kernel, start):
        """A kernel whose body begins with `start`, which declares `sum`, and then writes."""
        scope = kernel.scope.inner()
        scope.variables.append(("sum", UINT, True))
        return self.finished(kernel, Items([Node(start)] + [self.write(write, scope) for write in kernel.writes]))

    def inexact(self, name):
        """A kernel that stores results of inexact functions, but does not compute with them."""
        kernel = self.begin(name, 1)
        self.add_inputs(kernel)
        found = [s for s in self.of_axes(1, each=True) if s.element == FLOAT]
        if not found:
            return self.plain(name)
        structure = self.random.choice(found)
        kernel.params.append(Parameter("y", f"out each<{structure.name}>", structure, moves=True))
        kernel.writes.append(lambda scope: Node("y = ", self.expressions.inexact(FLOAT, scope, 3), ";"))
        return self.finished(kernel, self.body(kernel, 2))

    def rows(self, name):
        """A kernel with several elements per invocation: vector loads and stores."""
        count = self.random.choice([2, 3, 4, 4, 8])
        lines = [s for s in self.of_axes(1) if s.element == UINT or not s.element == BOOL]
        source, target = self.random.choice(lines), self.random.choice([s for s in lines if s.is_dense])
        kernel = self.begin(name, 1)
        kernel.scope.variables.pop(0)
        kernel.params += [Parameter("a", f"at<Line, {count}>", self.structures.line, moves=True),
                          Parameter("x", f"in any<{source.name}>", source, extent=kernel.extent),
                          Parameter("y", f"out scatter<{target.name}>", target, extent=kernel.extent)]
        scope = kernel.scope.inner()
        row, result = Array(source.element, count), Array(target.element, count)
        scope.variables += [("row", row, True), ("result", result, True)]
        shift = self.random.choice(["", " + 1u", " - 2u", " + 4u"])
        items = Items([Node(f"var row: {row.text()} = x.load(position(){shift});"), Node(f"var result: {result.text()};")])
        scope.variables.append(("sum", UINT, True))
        items.parts.append(Node("var sum = 1u;"))
        for _ in range(self.random.below(3)):
            items.parts.append(self.statements.statement(scope, 2, 1, None, None))
        inner = scope.inner()
        inner.variables += [("k", UINT, False), ("row[k]", source.element, False)]
        items.parts.append(Node(f"for k in 0..{count} {{\nresult[k] = ", self.expressions.of(target.element, inner, 3), ";\n}"))
        items.parts.append(Node("y.store(position(), result);"))
        return self.finished(kernel, items)

    # ------------------------------------------------------------------------------------------------ workgroups

    def grouped(self, name):
        axes = self.random.choice([s.axes for s in self.structures.all])
        kernel = self.begin(name, axes)
        self.add_inputs(kernel)
        self.add_outputs(kernel)
        self.ensure_course(kernel)
        sides = self.random.choice([[32], [64], [37]]) if kernel.axes == 1 else self.random.choice([[8, 4], [16, 2], [5, 7]])
        if kernel.axes == 3:
            sides = [4, 2, 4]
        group = 1
        for side in sides:
            group *= side
        scope = kernel.scope
        scope.variables += [("local_index()", UINT, False), ("group_size()", UINT, False), ("sum", UINT, True)]
        items = Items([Node("var sum = 1u;")])
        for phase in range(self.random.between(1, 3)):
            self.add_phase(kernel, items, f"s{phase}", group)
        scope = kernel.scope
        for write in kernel.writes:
            items.parts.append(self.write(write, scope))
        return self.finished(kernel, items, f" group({', '.join(map(str, sides))})")

    def add_phase(self, kernel, items, name, group):
        """Adds statements, then either a store to workgroup memory by each invocation and a barrier, or a tally."""
        scope = kernel.scope
        for _ in range(self.random.below(3)):
            items.parts.append(self.statements.statement(scope, 2, 1, None, None))
        if self.random.chance(30):
            return self.add_tally(scope, items, name)
        t = self.random.choice(self.types.storable)
        if bytes_of(t) * group > MOST_SHARED_BYTES:
            t = UINT
        items.parts.insert(0, Node(f"shared {name}: {t.text()}[{group}];"))
        items.parts.append(Node(f"{name}[local_index()] = ", self.expressions.of(t, scope, 4), ";"))
        items.parts.append(Node("barrier();"))

        def read(expressions, inner, depth):
            return Node(f"{name}[", expressions.of(UINT, inner, depth), f" % {group}u]", type=t)
        scope.reads += [(t, read)] * 2
        return None

    def add_tally(self, scope, items, name):
        """Adds a reduction in workgroup memory, by atomics or subgroup operations whose order does not matter."""
        operation, size = self.random.choice(OPERATIONS), self.random.between(1, 9)
        items.parts.insert(0, Node(f"shared {name}: uint[{size}];"))
        items.parts.append(Node(f"if local_index() < {size}u {{\n{name}[local_index()] = 9u;\n}}\nbarrier();"))
        value = self.expressions.of(UINT, scope, 3)
        if self.random.chance(40):
            each = self.statements.name("v")
            items.parts.append(Node(f"let {each} = {SUBGROUPS[operation]}(", value, f");\nif subgroupElect() {{\n"
                                    f"{ATOMICS[operation]}({name}[0], {each});\n}}\nbarrier();"))
        else:
            place = self.expressions.of(UINT, scope, 2)
            items.parts.append(Node(f"{ATOMICS[operation]}({name}[", place, f" % {size}u], ", value, ");\nbarrier();"))

        def read(expressions, inner, depth):
            return Node(f"{name}[", expressions.of(UINT, inner, depth), f" % {size}u]", type=UINT)
        scope.reads += [(UINT, read)] * 2

    # ------------------------------------------------------------------------------------------------ tests

    def finished(self, kernel, body, group=""):
        is_bare = self.random.chance(25)
        text = ", ".join(f"{p.name}: {self.bare(kernel, p) if is_bare and p.structure else p.text}" for p in kernel.params)
        node = Node(f"kernel {kernel.name}({text}){group} {{\n", body, "\n}")
        return node, self.test(kernel)

    def bare(self, kernel, p):
        """The parameter's pattern, in most cases without its structure or with a constraint in its place."""
        word, extra = p.text[:-1].split(f"<{p.structure.name}")
        extra = [extra[2:]] if extra else []
        kind = self.random.weighted([(2, "named"), (4, "bare"), (3, "constraint")])
        if kind == "named" or (kind == "constraint" and p.structure is BAG):
            return p.text
        if kind == "bare" and word == "at" and not extra and sum(q.text.startswith("at<") for q in kernel.params) == 1:
            kernel.bare_address = p
        if kind == "constraint":
            extra.insert(0, f"Structure<{vector(p.structure.axes, UINT).text()}, {p.structure.element.text()}>")
        elif extra and (not extra[0].isdigit() or self.random.chance(50)):
            extra.insert(0, "_")
        return f"{word}<{', '.join(extra)}>" if extra else word

    def leaves_out(self, kernel, p):
        """Whether a call leaves out the argument of `at`, whose range is then that of an `each` parameter."""
        given = any(q.structure and " each<" in q.text for q in kernel.params)
        return p is kernel.bare_address and given and self.random.chance(50)

    def test(self, kernel):
        lines, self.objects, wholes = [], {}, {}
        for i, p in enumerate(kernel.params):
            if p.structure:
                extent = p.extent or kernel.extent
                made = self.made_already(p, extent, wholes)
                self.objects[p.name] = made or p.name
                lines += self.structures.prepared(made or p.name, p.structure, extent, 100 * i, bool(made))
                if p.structure is BAG:
                    lines.append(f"seed_uint({p.name}.given, {i}u, {p.name}.given);")
        values = [f"{self.types.made(p.value, f'{self.random.below(1000)}u')}" for p in kernel.params if p.value]
        on_device = self.random.chance(35)
        if on_device:
            lines += ["temp d = Line(8u);", f"seed_uint(d, {self.random.below(100)}u, d);"]
            values = [self.on_device(p.value, value) for p, value in zip((p for p in kernel.params if p.value), values)]
        calls = [self.call(kernel, values, self.box(kernel) if self.random.chance(30) else None)]
        if self.random.chance(40):
            calls.append(self.call(kernel, values, self.box(kernel)))
        if on_device:
            calls = self.arms(kernel, values, calls)
        return Node(f'test "{kernel.name}" {{\n', Items([Node(line) for line in lines + calls]), "\n}")

    def made_already(self, p, extent, wholes):
        """The object of which an earlier parameter has another component; None: this one's is to be made."""
        if not p.structure.whole:
            return None
        known = wholes.setdefault((p.structure.whole, tuple(extent)), [])
        for name, fields in known:
            if p.structure.field not in fields and self.random.chance(60):
                fields.add(p.structure.field)
                return name
        known.append((p.name, {p.structure.field}))
        return None

    def on_device(self, t, value):
        """A kernel's argument, often one that the host does not know: made from an element of the structure `d`."""
        if t == UINT:
            return f"d[{self.random.below(8)}] + {self.random.below(9)}u"
        if self.random.chance(50):
            return f"{self.types.made(t, f'd[{self.random.below(8)}]')}"
        return value

    def arms(self, kernel, values, calls):
        """The kernel's calls: some under a condition on the device, in a loop with such a condition, or over a slice whose end lies
        on the device."""
        if kernel.axes == 1 and not any("at<Line, " in p.text for p in kernel.params):
            calls.append(self.call(kernel, values, f"[0..min(d[{self.random.below(8)}], {kernel.extent[0]}u)]"))
        condition = f"d[{self.random.below(8)}] % 2u == {self.random.below(2)}u"
        kind = self.random.choice(["plain", "if", "else", "for"])
        if kind == "plain":
            return calls
        if kind == "for":
            return ["var rounds = 0u;", f"for round in 0..3 while rounds < d[{self.random.below(8)}] % 4u {{", *calls, "rounds += 1u;", "}"]
        return [f"if {condition} {{", calls[0], *([] if kind == "if" else ["} else {", calls[-1]]), "}", *calls[1:]]

    def box(self, kernel):
        """A random box of the kernel's extent, as a slice."""
        first = [self.random.below(side) for side in kernel.extent]
        last = [self.random.between(low, side) for low, side in zip(first, kernel.extent)]
        return f"[{extent_text(first)}..{extent_text(last)}]"

    def argument(self, p):
        return p.structure.argument(self.objects[p.name]) if p.structure else p.name

    def call(self, kernel, values, box):
        values = iter(values)
        arguments = [next(values) if p.value else self.argument(p) + (box if box and p.moves else "") for p in kernel.params
                     if not self.leaves_out(kernel, p)]
        return f"{kernel.name}({', '.join(arguments)});"
