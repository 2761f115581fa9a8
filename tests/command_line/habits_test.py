#!/usr/bin/env python3
"""Tests the tables of hints for users of other languages (compiler/syntax/habits.cpp): the code that hints suggest compiles, and each
word of `names` and `declarations` is answered by its hint. habits_test.py GLIFTC"""
import re

from gliftc import Folder, expect, finish, says, sources

text = (sources.parent.parent / "compiler/syntax/habits.cpp").read_text()
strings = dict(re.findall(r'constexpr std::string_view (\w+) =\s*"((?:[^"\\]|\\.)*)";', text))


def table(name):
    """The words of a table with their hints."""
    body = re.search(r"constexpr Habit " + name + r"\[\] = \{(.*?)\};", text, re.S)[1]
    entries = re.findall(r'\{"(\w+)",\s*(?:"((?:[^"\\]|\\.)*)"|(\w+))\}', body)
    expect(len(entries) == body.count('{"'), f"all entries of {name} are read", body)
    return {word: (hint or strings[shared]).replace('\\"', '"') for word, hint, shared in entries}


# The texts that hints quote, each with declarations that use it, in which `…` and parts of declarations are completed.
BITS = "fn f{n}(x: float) -> uint {{ return floatBitsToUint(x); }}"
USES = {
    "mix": "fn f{n}(x: float) -> float {{ return mix(x, 2.0, 0.5); }}",
    "fract": "fn f{n}(x: float) -> float {{ return fract(x); }}",
    "inversesqrt": "fn f{n}(x: float) -> float {{ return inversesqrt(x); }}",
    "abs": "fn f{n}(x: float) -> float {{ return abs(x); }}",
    "sqrt": "fn f{n}(x: float) -> float {{ return sqrt(x); }}",
    "pow": "fn f{n}(x: float) -> float {{ return pow(x, 2.0); }}",
    "bitCount": "fn f{n}(x: uint) -> int {{ return bitCount(x); }}",
    "clamp(x, 0.0, 1.0)": "fn f{n}(x: float) -> float {{ return clamp(x, 0.0, 1.0); }}",
    "mod": "fn f{n}(x: float, y: float) -> float {{ return mod(x, y); }}",
    "y": "",  # the parameter of mod
    "*": "fn f{n}(m: float4x4, x: float4) -> float4 {{ return m * x; }}",
    "none": "fn f{n}() -> int? {{ return none; }}",
    "float(x)": "fn f{n}(x: int) -> float {{ return float(x); }}",
    "floatBitsToUint": BITS,
    "s[a]": "kernel k{n}(a: at<Line>, s: in any<Line>, to: out each<Line>) {{ to = s[a]; }}",
    "s.sample(x)": "kernel k{n}(x: at<Line>, s: in any<Film>, to: out each<Line>) {{ to = s.sample(float2(1.5)).x; }}",
    "s[a] = x": "kernel k{n}(a: at<Line>, x: in each<Line>, s: out scatter<Line>) {{ s[a] = x; }}",
    "a: at<S>": "kernel k{n}(a: at<Line>, to: out each<Line>) {{ to = float(a); }}",
    "at": "",  # in the hint that quotes "a: at<S>"
    "barrier()": "kernel k{n}(a: at<Line>, to: out each<Line>) group(64) {{ barrier(); to = 1.0; }}",
    'print("speed {}", v);': 'kernel k{n}(v: in each<Line>) {{ print("speed {{}}", v); }}',
    "print(v);": "kernel k{n}(v: in each<Line>) {{ print(v); }}",
    "assert(condition);": "kernel k{n}(v: in each<Line>) {{ assert(v > 0.0); }}",
    "count(s)": "kernel k{n}(n: uint, to: out each<Line>) {{ to = float(n); }}\npipeline p{n}(s: inout Line) {{ k{n}(count(s), s); }}",
    "let x = …;": "fn f{n}() -> int {{ let x = 1; return x; }}",
    "var x = …;": "fn f{n}() -> int {{ var x = 1; x += 1; return x; }}",
    "->": "fn f{n}(x: float) {{ }}",
    "true": "fn f{n}() -> bool {{ return true; }}",
    "false": "fn f{n}() -> bool {{ return false; }}",
    "use std.array;": "",  # in `lines` below
    'extern struct S from "s.h";': 'extern struct S from "s.h";',
    "fn f(x: float) -> float { … }": "fn f{n}(x: float) -> float {{ return x; }}",
    "const n = 3;": "const n{n} = 3;",
    "structure S(n: uint) { memory data = buffer<float>[n]; … }":
        "structure S{n}(n: uint) {{ memory data = buffer<float>[n]; via Linear<1>(n); }}",
    "struct": "struct R{n} {{ x: float; }}",
    "structure": "structure S{n} = Array<1, float>;",
    "type real = float;": "type real{n} = float;",
    "fn f<T: type>(x: T) -> T { … }": "fn f{n}<T: type>(x: T) -> T {{ return x; }}\nfn g{n}() -> int {{ return f{n}(1); }}",
    "module name;": "",  # in `lines` below
}
TYPES = {"int", "uint", "int64", "uint64", "half", "float", "double"}

names, declarations = table("names"), table("declarations")
scalars = table("scalars")
here = Folder()
here.write("s.h", "struct S { float x; };\n")
lines = ["module name;", "use std.array;", "use std.image;", "use std.linear;", "structure Line = Array<1, float>;",
         "structure Film = Array<2, float4>;"]
made = set()
for hint in [*names.values(), *declarations.values()]:
    for quoted in re.findall(r"'([^']*)'", hint):
        use = f"fn f{{n}}(x: {quoted}) -> {quoted} {{{{ return x; }}}}" if quoted in TYPES else USES.get(quoted)
        expect(use is not None, f"USES has '{quoted}', which a hint tells people to write")
        if use and use not in made:
            lines.append(use.format(n=len(made)))
            made.add(use)
for scalar in scalars.values():
    lines += [f"fn of_{scalar}{n}(x: {scalar}{n}) -> {scalar}{n} {{ return x; }}" for n in "234"]
lines += [f"fn of_matrix{n}(x: float{n}x{n}) -> float{n}x{n} {{ return x; }}" for n in "234"]
here.write("name.glift", "\n".join(lines) + "\n")
says(here.run("--check", "name.glift"), 0)

# The words themselves: each is an error, those of `names` as a name, those of `declarations` (also words of Glift, such as `let`) at
# the start of a declaration; the error has the word's hint.
for k, (word, hint) in enumerate(names.items()):
    here.write(f"n{k}.glift", f"module n{k};\nfn f() -> int {{ return {word}; }}\n")
for k, (word, hint) in enumerate(declarations.items()):
    here.write(f"d{k}.glift", f"module d{k};\n{word} x;\n")
# A mistake of syntax ends the compilation before names are resolved: a run for each table.
said = "".join(here.run("--check", "--error-limit", "0", *(n for n in here.names() if re.match(kind + r"\d", n))).said
               for kind in "nd")
for k, (word, hint) in enumerate(names.items()):
    part = re.search(rf"^n{k}\.glift:2:\d+: error:.*?(?=^\w+\.glift:\d+:\d+: error|\Z)", said, re.M | re.S)
    expect(part and f"unknown name '{word}'" in part[0] and f"note: {hint}" in part[0], f"'{word}' is answered: {hint}",
           part and part[0])
for k, (word, hint) in enumerate(declarations.items()):
    part = re.search(rf"^d{k}\.glift:2:\d+: error:.*?(?=^\w+\.glift:\d+:\d+: error|\Z)", said, re.M | re.S)
    expect(part and f"note: {hint}" in part[0], f"'{word}' is answered: {hint}", part and part[0])
finish()
