"""Random structures: those of the library, and others over translators, page tables and blocks that the program defines."""
from declarations import split_declarations
from model import FLOAT, INT, UINT, Enum, Matrix, Node, Vector, literal, vector

TEXELS = [vector(n, s) for s in (FLOAT, INT, UINT) for n in (1, 2, 4)]

TABLES = """
fn exchanged<N: uint>(a: vec<N, uint>) -> vec<N, uint> {
    var result = a;
    result[0] = a[N - 1];
    result[N - 1] = a[0];
    return result;
}

translator Exchanged<N: uint> : vec<N, uint> -> vec<N, uint> {
    extent: vec<N, uint>;
    domain() { return extent; }
    translate(va) { return exchanged(va); }
    invert(pa) { return exchanged(pa); }
}

/// A part of the addresses, moved by one.
translator Shifted<N: uint> : vec<N, uint> -> vec<N, uint>? {
    extent: vec<N, uint>;
    domain() { return extent; }
    translate(va) {
        if !inside(va, extent) || va[0] % 5u == 3u { return none; }
        var result = va;
        result[0] = va[0] + 1u;
        return result;
    }
}

struct PageEntry { resident: uint; frame: uint; }

translator PageTable<N: uint, page: vec<N, uint>, Table: Structure<vec<N, uint>, PageEntry>> : vec<N, uint> -> uint? {
    extent: vec<N, uint>;
    table: Table;
    domain() { return extent; }
    translate(va) {
        if !inside(va, extent) { return none; }
        let entry = table[va / page];
        if entry.resident == 0u { return none; }
        return entry.frame * volume(page) + linearize(va % page, page);
    }
}

kernel make_blocks(a: at<Blocks>, to: out each<Blocks>, count: uint, pages: uint, step: uint) {
    // How many there are, then their numbers in some order, each once; some of them are not there.
    to = a == 0u ? count : (a % 6u == 4u ? 100000u : (a * step) % pages);
}

kernel make_pages<N: uint, S: Structure<vec<N, uint>, PageEntry>>(a: at<S>, to: out each<S>, pages: vec<N, uint>, step: uint) {
    // Frames in some order, each once; some pages have none, or one that the memory does not have.
    let number = linearize(a, pages);
    to = PageEntry(number % 5u == 3u ? 0u : 1u, number % 7u == 5u ? number + 100000u : (number * step) % volume(pages));
}
"""

# Translators from N axes to one: kind, number of axes (0: any), body. Their arithmetic must not overflow 32 bits: in the wide
# form, which may have addresses of 64 bits, it would not wrap.
ORDERS = {
    "Backwards": ("one_to_one", 0, "return volume(extent) - 1u - linearize(va, extent);"),
    "Turned": ("one_to_one", 0, "let i = linearize(va, extent);\nreturn (i + volume(extent) / 3u) % volume(extent);"),
    "Snake": ("one_to_one", 2, "let x = select(va.y % 2u == 0u, va.x, extent.x - 1u - va.x);\nreturn va.y * extent.x + x;"),
    "Skewed": ("one_to_one", 2, "return va.y * extent.x + (va.x + 3u * va.y) % extent.x;"),
    "Swapped": ("one_to_one", 0, "let i = linearize(va, extent);\nif (i ^ 1u) < volume(extent) { return i ^ 1u; }\nreturn i;"),
    "Coarse": ("many_to_one", 0, "return linearize(va, extent) / 3u;"),
    "Holes": ("partial", 0, "if !inside(va, extent) { return none; }\nlet i = linearize(va, extent);\n"
                            "if i % 4u == 1u { return none; }\nreturn i;"),
    "Beyond": ("partial", 0, "let i = linearize(va, extent);\nif i % 5u == 2u { return none; }\nreturn 2u * i;"),
}


def translator_text(name, kind, axes, body):
    result = "uint?" if kind == "partial" else "uint"
    attribute = {"one_to_one": "@one_to_one\n", "many_to_one": "@many_to_one\n", "partial": ""}[kind]
    generic, address = ("<N: uint>", "vec<N, uint>") if not axes else ("", f"uint{axes}")
    return (f"{attribute}translator {name}{generic} : {address} -> {result} {{\n    extent: {address};\n"
            f"    domain() {{ return extent; }}\n    translate(va) {{\n{body}\n}}\n}}")


class Structure:
    """A structure type: how to construct it for an extent, and what kernels may do with it."""

    def __init__(self, name, axes, element, extra="", each=True, is_dense=True, capacity=None, buffer=True, block=None, folds=False,
                 owns=True, renews=False, whole=None, field=None, combines=True):
        self.name, self.axes, self.element, self.extra = name, axes, element, extra
        self.block = block        # the size of a block; None: the whole domain is one
        self.each = each          # allows `out each`
        self.is_dense = is_dense  # every element of the domain is stored
        self.capacity = capacity  # structures with a page table: the page's size along each axis; else None
        self.buffer = buffer
        self.folds = folds  # an address outside the domain leads to an element: by an edge mode
        self.renews = renews  # a container with a pipeline `renew`, which gives it other memory
        self.whole, self.field = whole, field  # a component: the structure that it is the field of, which `make` makes; else None
        self.combines = combines  # `scatter` may combine into its elements
        self.owns = owns    # with `each`: no two addresses of the domain lead to one element, not even by the memory's edge mode

    def argument(self, name):
        """The structure as an argument, where `name` is what `make` makes."""
        return f"{name}.{self.field}" if self.field else name

    def make(self, extent):
        size = extent_text(extent)
        if self.whole:
            return f"{self.whole}({size})"
        if self.capacity:
            return f"{self.name}({size}, {pages_of(extent, self.capacity)}u)"
        return f"{self.name}({size}{self.extra})"


def extent_text(extent):
    return f"{extent[0]}u" if len(extent) == 1 else f"uint{len(extent)}({', '.join(map(str, extent))})"


def pages_of(extent, page):
    count = 1
    for size, side in zip(extent, page):
        count *= -(-size // side)
    return count


class Structures:
    """The structures of one program."""

    def __init__(self, random, types):
        self.random, self.types = random, types
        self.line = Structure("Line", 1, UINT)
        self.all = [self.line]
        # Few element types: each adds transfer code to the program.
        elements = [t for t in types.storable if t != UINT]
        self.elements = [UINT, FLOAT] + [random.choice(elements) for _ in range(3)]

    def declarations(self, count):
        nodes = [Node("structure Line = Array<1, uint>;"), Node("structure Blocks = Array<1, uint>;")]
        nodes += [Node(translator_text(name, *order)) for name, order in ORDERS.items()]
        nodes += [Node(text) for text in split_declarations(TABLES)]
        for i in range(count):
            nodes.append(self.declaration(f"T{i}", self.random.weighted([(3, 1), (4, 2), (2, 3)])))
        return nodes + [self.seed(t) for t in dict.fromkeys(s.element for s in self.all)]

    def declaration(self, name, axes):
        maker = self.random.weighted([(3, self.array), (3, self.edged), (2, self.bordered), (3, self.image), (3, self.tiled),
                                      (2, self.morton), (5, self.own), (3, self.composed), (2, self.paged),
                                      (5, self.over), (6, self.blocks)])
        if self.random.chance(25):
            return self.components(name, axes)
        structure, text = maker(name, axes, self.random.choice(self.elements))
        self.all.append(structure)
        return Node(text)

    def components(self, name, axes):
        """A structure of structs, whose fields are kept together or apart, and its components."""
        fields = {"u": self.random.choice(self.elements), "v": self.random.choice(self.elements), "w": FLOAT}
        layout = self.random.choice(["together", "apart"])
        declared = f"struct Of{name} {{ " + " ".join(f"{f}: {t.text()};" for f, t in fields.items()) + " }"
        if self.random.chance(50):
            whole = f"structure {name} = Array<{axes}, Of{name}, layout: {layout}>;"
        else:
            order = self.random.choice([o for o, (kind, needs, _) in ORDERS.items() if needs in (0, axes) and kind == "one_to_one"])
            generic = f"<{axes}>" if not ORDERS[order][1] else ""
            apart = self.random.choice([f" apart({'true' if layout == 'apart' else 'false'})", ""] if layout == "together" else [" apart(true)"])
            whole = (f"structure {name}(extent: {vector(axes, UINT).text()}) {{\n    memory data = buffer<Of{name}>[volume(extent)]{apart};\n"
                     f"    via {order}{generic}(extent);\n}}")
        self.all += [Structure(f"{name}.{f}", axes, t, whole=name, field=f, combines=layout == "apart") for f, t in fields.items()]
        return Node(declared + "\n" + whole)

    def array(self, name, axes, t):
        return Structure(name, axes, t), f"structure {name} = Array<{axes}, {t.text()}>;"

    def edged(self, name, axes, t):
        edge = self.random.choice(["clamp", "repeat", "mirror"])
        named = self.random.choice(["", "edge: "])
        return Structure(name, axes, t, folds=True), f"structure {name} = Array<{axes}, {t.text()}, {named}{edge}>;"

    def bordered(self, name, axes, t):
        return Structure(name, axes, t, f", {literal(t)}"), f"structure {name} = Bordered<{axes}, {t.text()}>;"

    def image(self, name, axes, t):
        texel = self.random.choice([t for t in TEXELS if t in self.types.storable])
        edge = self.random.choice(["none", "none", "clamp", "repeat", "mirror"])
        kind = self.random.choice(["image1d", "image2d", "image3d"])
        rest = self.random.choice([f"{edge}, {kind}", f"storage: {kind}, edge: {edge}"])
        return Structure(name, axes, texel, buffer=False, folds=edge != "none"), f"structure {name} = Array<{axes}, {texel.text()}, {rest}>;"

    def tiled(self, name, axes, t):
        tile = extent_text([self.random.between(2, 5) for _ in range(axes)])
        return Structure(name, axes, t), f"structure {name} = Tiled<{axes}, {t.text()}, {tile}>;"

    def morton(self, name, axes, t):
        axes = max(axes, 2)
        return Structure(name, axes, t), f"structure {name} = MortonArray<{axes}, {t.text()}>;"

    def line_of(self, t, count, edges=("none", "none", "clamp", "repeat")):
        """Memory for a number of elements: a buffer, or a structure, which may have an edge mode."""
        edge = self.random.choice(list(edges))
        made = f"Array<1, {t.text()}, {edge}>({count})"
        return made if self.random.chance(40) else f"buffer<{t.text()}>[{count}]"

    def own(self, name, axes, t):
        order = self.random.choice([o for o, (_, needs, _) in ORDERS.items() if needs in (0, axes)])
        kind, needs, _ = ORDERS[order]
        generic = f"<{axes}>" if not needs else ""
        outside = f"    otherwise made_{self.made_name(t)}(3u);\n" if self.random.chance(40) else ""
        argument, extra = "", ""
        if outside and self.random.chance(50):
            argument, outside = f", outside: {t.text()} = {self.zero(t)}", "    otherwise outside;\n"
            extra = self.random.choice(["", f", {literal(t)}"])
        memory = self.line_of(t, "volume(extent)")
        folds = order == "Beyond" and memory.startswith("Array") and "none" not in memory
        text = (f"structure {name}(extent: {vector(axes, UINT).text()}{argument}) {{\n    memory data = {memory};\n"
                f"    via {order}{generic}(extent);\n{outside}}}")
        return Structure(name, axes, t, extra, each=kind != "many_to_one", is_dense=kind == "one_to_one", folds=folds, owns=not folds), text

    def composed(self, name, axes, t):
        """A composition of translators."""
        axes = max(axes, 2)
        edge = self.random.choice(["", f"Edge<{axes}, Boundary.clamp>(extent) then ", f"Edge<{axes}, Boundary.mirror>(extent) then "])
        last = self.random.choice(["Linear", "Backwards", "Turned"])
        text = (f"structure {name}(extent: uint{axes}) {{\n    memory data = {self.line_of(t, 'volume(extent)')};\n"
                f"    via {edge}Exchanged<{axes}>(extent) then {last}<{axes}>(exchanged(extent));\n}}")
        return Structure(name, axes, t, folds=edge != ""), text

    def paged(self, name, axes, t):
        page = [self.random.between(2, 4) for _ in range(axes)]
        address = vector(axes, UINT).text()
        # An entry for a frame that the memory does not have must not lead to another element: kernels write through the
        # table.
        memory = self.line_of(t, f"capacity * volume({extent_text(page)})", edges=["none"])
        text = (f"structure {name}(extent: {address}, capacity: uint) {{\n    memory pages = {memory};\n"
                f"    structure table = Array<{axes}, PageEntry>(div_ceil(extent, {extent_text(page)}));\n"
                f"    via PageTable<{axes}, {extent_text(page)}>(extent, table);\n}}")
        return Structure(name, axes, t, is_dense=False, capacity=page), text

    def inner(self, axes):
        """A structure of the program without blocks whose constructor takes an extent alone; None if there is none."""
        found = [s for s in self.all if s.axes == axes and not s.extra and not s.capacity and not s.block and not s.field]
        return self.random.choice(found) if found else None

    def container_items(self, memory, made):
        """Items that make a structure a container, and whether they do: host state, and a pipeline that gives it other memory."""
        if not self.random.chance(40):
            return "", False
        return (f"    host rounds: uint = 1u;\n    structure extra = Line(2u);\n"
                f"    fn last() -> uint {{ return extra.domain() + rounds; }}\n"
                f"    pipeline renew() {{\n        temp other = {made};\n        {memory} = other;\n"
                f"        rounds = rounds + 1u;\n    }}\n"), True

    def over(self, name, axes, t):
        """A structure whose memory is another structure, with or without a translator."""
        inner = self.inner(axes)
        if not inner:
            return self.array(name, axes, t)
        address = vector(axes, UINT).text()
        via, extent = self.random.choice([("", "extent"), (f"    via Exchanged<{axes}>(extent);\n", "exchanged(extent)"),
                                          (f"    via Shifted<{axes}>(extent);\n", "extent")]) if axes > 1 else ("", "extent")
        outside = f"    otherwise made_{self.made_name(inner.element)}(5u);\n" if via and self.random.chance(40) else ""
        items, renews = self.container_items("inner", f"{inner.name}({extent})")
        text = f"structure {name}(extent: {address}) {{\n    memory inner = {inner.name}({extent});\n{via}{outside}{items}}}"
        is_shifted = "Shifted" in via
        return Structure(name, axes, inner.element, each=inner.each, is_dense=inner.is_dense and not is_shifted, buffer=inner.buffer,
                         folds=not via and inner.folds, owns=inner.owns and not (is_shifted and inner.folds), renews=renews), text

    def blocks(self, name, axes, t):
        """A structure over another one, of which kernels visit the listed blocks; their number lies on the device."""
        inner = self.inner(axes)
        made, t = (f"{inner.name}(extent)", inner.element) if inner else (f"Array<{axes}, {t.text()}>(extent)", t)
        sides = self.random.choice({1: [[64], [7], [1], [40]], 2: [[8, 8], [8, 4], [3, 2], [5, 7]], 3: [[4, 4, 4], [2, 3, 2]]}[axes])
        page, address = extent_text(sides), vector(axes, UINT).text()
        items, renews = self.container_items("elements", made)
        text = (f"structure {name}(extent: {address}) {{\n    memory elements = {made};\n{items}"
                f"    structure list = Blocks(1u + volume(div_ceil(extent, {page})));\n"
                f"    blocks() {{ return min(list[0], volume(div_ceil(extent, {page}))); }}\n"
                f"    block(i) {{\n        let number = list[1u + i];\n        if number == 100000u {{ return none; }}\n"
                f"        return delinearize(number, div_ceil(extent, {page})) * {page};\n    }}\n"
                f"    block_size() {{ return {page}; }}\n}}")
        return Structure(name, axes, t, each=not inner or inner.each, is_dense=False, buffer=not inner or inner.buffer,
                         block=sides, folds=bool(inner) and inner.folds, owns=not inner or inner.owns, renews=renews), text

    def zero(self, t):
        """A default for an argument of the type: its zero, where it has one."""
        return f"made_{self.made_name(t)}(4u)" if isinstance(t, Enum) or self.random.chance(30) else f"{t.text()}()"

    def made_name(self, t):
        return self.types.made(t, "").removeprefix("made_").removesuffix("()")

    def seed(self, t):
        """A kernel that fills a structure with values made from a hash of the address."""
        name = self.made_name(t)
        return Node(f"kernel seed_{name}<D: type, S: Structure<D, {t.text()}>>(a: at<S>, seed: uint, to: out scatter<S>) {{\n"
                    f"to[a] = made_{name}(digest(a) * 7u + seed);\n}}")

    def prepared(self, name, structure, extent, seed, is_made=False):
        """Statements of a test that construct a structure, unless it is made already, and fill it if it allows `out each`."""
        lines = [] if is_made else [f"temp {name} = {structure.make(extent)};"]
        if structure.renews:
            lines.append(f"{name}.renew();")
        if structure.capacity:
            step = next(s for s in range(3, 100, 2) if coprime(s, pages_of(extent, structure.capacity)))
            pages = extent_text([-(-size // side) for size, side in zip(extent, structure.capacity)])
            lines.append(f"make_pages({name}.table, {pages}, {step}u);")
        if structure.block:
            number = pages_of(extent, structure.block)
            step = next(s for s in range(3, 100, 2) if coprime(s, number))
            lines.append(f"make_blocks({name}.list, {self.random.between(0, number + 1)}u, {number}u, {step}u);")
        if structure.each:
            given = structure.argument(name)
            lines.append(f"seed_{self.made_name(structure.element)}({given}, {seed}u, {given});")
        return lines


def coprime(a, b):
    while b:
        a, b = b, a % b
    return a == 1
