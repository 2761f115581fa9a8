#!/usr/bin/env python3
"""Speaks the language server protocol with the built gliftc: each feature, at real positions of real files.

    features_test.py GLIFTC
"""
import pathlib
import sys
import unittest

from client import Document, Folder, Server, path_of

compiler = pathlib.Path(sys.argv.pop(1)).resolve()

WAVES = """/// Waves on a grid.
module waves;

use ./shapes;

/// The height of the water.
pub structure Field = Array<2, float>;
pub structure Drops = Array<1, Drop>;

enum Edge { open, closed }

/// Doubles a number.
fn twice(x: float) -> float {
    return 2.0 * x;
}

fn twice(x: float2) -> float2 {
    return 2.0 * x;
}

kernel spread(f: in near<Field, 1>, speed: float, g: out each<Field>) {
    // 🌊🌊 after two characters of two units each
    /* 🌊 */ let middle = f[0];
    var sum = twice(middle);
    for axis in 0..2 {
        sum += f[+unit(axis)] + f[-unit(axis)];
    }
    g = mix(sum, middle, speed);
}

kernel weigh(d: in each<Drops>, to: out each<Drops>) {
    let heavy = Drop(position: d.position, mass: twice(d.mass));
    to = heavy;
}

pub pipeline step(f: in Field, g: out Field) {
    spread(f, 0.5, g);
}

test "a step of still water is still" {
    temp f = Field(uint2(8, 8));
    temp g = Field(uint2(8, 8));
    step(f, g);
    expect_near(await g[uint2(3, 3)], 0.0, 1e-6);
}
"""

SHAPES = """module shapes;

/// A drop of water.
pub struct Drop {
    /// In metres.
    position: float2;
    mass: float;
}

fn hidden() -> float { return 1.0; }
"""


class Session(unittest.TestCase):
    """A session over a folder with two modules."""

    def setUp(self):
        self.folder = Folder(waves=WAVES, shapes=SHAPES)
        self.server = Server(compiler)
        self.server.start(self.folder.path)
        self.waves = self.open("waves", WAVES)

    def tearDown(self):
        self.assertEqual(self.server.stop(), 0)
        self.folder.held.cleanup()

    def open(self, name, text):
        return Document(self.server, self.folder.path / (name + ".glift"), text)

    def changed(self, old, new):
        self.assertIn(old, WAVES)
        self.waves.change(WAVES.replace(old, new, 1))
        return self.waves


class Diagnostics(Session):
    def test_a_correct_file_has_none(self):
        self.assertEqual(self.waves.diagnostics(), [])

    def test_errors_while_typing(self):
        doc = self.changed("mix(sum, middle, speed)", "mix(sum, midle, speed)")
        [error] = doc.diagnostics()
        self.assertEqual(doc.of(error["range"]), "midle")
        self.assertEqual((error["code"], error["severity"], error["source"]), ("unknown-name", 1, "gliftc"))
        self.assertIn("did you mean 'middle'?", [note["message"] for note in error["relatedInformation"]])
        self.assertTrue(path_of(error["codeDescription"]["href"]).is_file())
        doc.change(WAVES)
        self.assertEqual(doc.diagnostics(), [])

    def test_incremental_changes_count_in_utf16(self):
        at = self.waves.at("middle = f[0]", "middle")
        end = {"line": at["line"], "character": at["character"] + len("middle")}
        self.waves.server.notify("textDocument/didChange", {
            "textDocument": {"uri": self.waves.uri, "version": 2},
            "contentChanges": [{"range": {"start": at, "end": end}, "text": "centre"}]})
        self.waves.version, self.waves.text = 2, WAVES.replace("middle = f[0]", "centre = f[0]")
        self.assertEqual({self.waves.of(d["range"]) for d in self.waves.diagnostics()}, {"middle"})

    def test_warnings(self):
        doc = self.changed("    let heavy", "    let unused = 1;\n    let heavy")
        [warning] = doc.diagnostics()
        self.assertEqual((warning["severity"], warning["code"], warning["tags"]), (2, "unused-variable", [1]))

    def test_an_error_in_an_imported_file_is_shown_at_the_import(self):
        shapes = self.open("shapes", SHAPES.replace("mass: float;", "mass: flaot;"))
        [error] = shapes.diagnostics()
        self.assertEqual(shapes.of(error["range"]), "flaot")
        errors = self.waves.diagnostics()
        while not errors:  # the first ones are those of the file on disk
            self.server.receive()
            errors = self.waves.diagnostics()
        self.assertEqual(path_of(errors[0]["relatedInformation"][0]["location"]["uri"]).name, "shapes.glift")

    def test_errors_of_lowering_come_when_a_file_is_saved(self):
        names = [f"t{i}" for i in range(5)]
        text = "module deep;\nstructure Line = Array<1, uint64>;\nkernel many(i: at<Line>, to: out each<Line>) {\n" + \
            "".join(f"    var {t}: uint64[65536];\n    {t}[i % 65536u] = 1ul;\n" for t in names) + \
            "    to = " + " + ".join(f"{t}[(i + 1u) % 65536u]" for t in names) + ";\n}\n"
        deep = self.open("deep", text)
        deep.diagnostics()
        deep.whole("documentSymbol")  # answered after all diagnostics were sent
        self.assertEqual([d["code"] for d in deep.diagnostics()], ["private-memory"])
        deep.change(text + "\n")
        self.assertEqual(deep.diagnostics(), [])

    def test_closing_a_document_clears_its_diagnostics(self):
        doc = self.changed("twice(middle)", "thrice(middle)")
        self.assertEqual(len(doc.diagnostics()), 1)
        doc.close()
        while self.server.diagnostics[doc.uri]["diagnostics"]:
            self.server.receive()


class Hover(Session):
    def text(self, doc, *place, **more):
        found = doc.ask("hover", doc.at(*place, **more))
        return found["contents"]["value"] if found else None

    def test_variables_have_types(self):
        self.assertIn("middle: float", self.text(self.waves, "mix(sum, middle", "middle"))

    def test_functions_have_signatures_and_comments(self):
        text = self.text(self.waves, "twice(middle)")
        self.assertIn("fn twice(x: float) -> float", text)
        self.assertNotIn("float2", text)
        self.assertIn("Doubles a number.", text)
        self.assertIn("fn twice(x: float2)", self.text(self.waves, "fn twice(x: float2)", "twice"))

    def test_structures_have_sizes_and_properties(self):
        text = self.text(self.waves, "near<Field, 1>", "Field")
        for word in ["Array<2, float>", "The height of the water.", "uint2", "4 bytes each", "buffer of float",
                     "Linear", "one to one", "O(1)"]:
            self.assertIn(word, text)

    def test_structs_have_sizes(self):
        self.assertIn("12 bytes", self.text(self.waves, "Drop(position", "Drop"))

    def test_fields_have_comments(self):
        self.assertIn("In metres.", self.text(self.waves, "d.position", "position"))

    def test_builtin_functions_and_patterns(self):
        self.assertIn("mix(floating, floating, floating or scalar) -> floating", self.text(self.waves, "mix(sum", "mix"))
        self.assertIn("once for each element", self.text(self.waves, "out each<Field>", "each"))

    def test_nothing_has_no_hover(self):
        self.assertIsNone(self.text(self.waves, "{\n    return 2.0", "{"))

    def test_code_around_an_error_keeps_its_meanings(self):
        for broken in ["g = mix(sum, middle, ;", "g = ", "g = mix(sum, unknown, speed);"]:
            doc = self.changed("g = mix(sum, middle, speed);", broken)
            self.assertTrue(doc.diagnostics())
            self.assertIn("middle: float", self.text(doc, "twice(middle)", "middle"), broken)
            self.assertIn("fn twice(x: float) -> float", self.text(doc, "twice(d.mass)", "twice"), broken)


class Names(Session):
    def targets(self, doc, *place, **more):
        return [(path_of(found["uri"]).name, found["range"]["start"])
                for found in doc.ask("definition", doc.at(*place, **more))]

    def test_definitions(self):
        here = lambda *place: [("waves.glift", self.waves.at(*place))]
        self.assertEqual(self.targets(self.waves, "sum, middle", "middle"), here("let middle", "middle"))
        self.assertEqual(self.targets(self.waves, "f[+unit", "f"), here("f: in near", "f"))
        self.assertEqual(self.targets(self.waves, "spread(f, 0.5", "spread"), here("kernel spread", "spread"))
        self.assertEqual(self.targets(self.waves, "twice(d.mass)", "twice"), here("fn twice(x: float)", "twice"))
        self.assertEqual(self.targets(self.waves, "in Field", "Field"), here("structure Field", "Field"))

    def test_definitions_in_other_files(self):
        shapes = self.open("shapes", SHAPES)
        there = lambda *place: [("shapes.glift", shapes.at(*place))]
        self.assertEqual(self.targets(self.waves, "d.mass", "mass"), there("mass"))
        self.assertEqual(self.targets(self.waves, "mass: twice", "mass"), there("mass"))
        self.assertEqual(self.targets(self.waves, "use ./shapes", "shapes"), there("module shapes", "shapes"))
        [(name, _)] = self.targets(self.waves, "Array<2")
        self.assertEqual(name, "array.glift")

    def test_references(self):
        def references(*place, declaration=True):
            found = self.waves.ask("references", self.waves.at(*place), context={"includeDeclaration": declaration})
            return sorted((path_of(each["uri"]).name, each["range"]["start"]["line"]) for each in found)

        line = lambda *place: self.waves.at(*place)["line"]
        middle = [line("let middle"), line("twice(middle)"), line("sum, middle")]
        self.assertEqual(references("sum, middle", "middle"), [("waves.glift", at) for at in middle])
        self.assertEqual(references("sum, middle", "middle", declaration=False), [("waves.glift", at) for at in middle[1:]])
        self.assertEqual(references("d.mass", "mass"), [("shapes.glift", 6)] + [("waves.glift", line("d.mass"))] * 2)
        one = references("twice(middle)", "twice")  # not the other overload
        self.assertEqual(one, sorted(("waves.glift", at) for at in
                                     [line("fn twice(x: float)"), line("twice(middle)"), line("twice(d.mass)")]))

    def test_rename(self):
        edits = self.waves.ask("rename", self.waves.at("d.mass", "mass"), newName="weight")["changes"]
        changed = {path_of(uri).name: found for uri, found in edits.items()}
        self.assertEqual(set(changed), {"waves.glift", "shapes.glift"})
        text = self.waves.with_edits(changed["waves.glift"])
        self.assertIn("weight: twice(d.weight)", text)
        shapes = self.open("shapes", SHAPES)
        shapes.change(shapes.with_edits(changed["shapes.glift"]))
        self.waves.change(text)
        self.assertEqual(shapes.diagnostics() + self.waves.diagnostics(), [])

    def refused(self, position, name):
        answer = self.server.ask("textDocument/rename", {
            "textDocument": {"uri": self.waves.uri}, "position": position, "newName": name})
        return answer["error"]["message"]

    def test_renames_that_are_refused(self):
        at = self.waves.at
        self.assertIn("no name of the language", self.refused(at("let middle", "middle"), "two words"))
        self.assertIn("no name of the language", self.refused(at("let middle", "middle"), "while"))
        self.assertIn("declared twice", self.refused(at("let middle", "middle"), "sum"))
        self.assertIn("outside of the workspace", self.refused(at("Array<2"), "Vector"))
        self.assertIn("not declared", self.refused(at("mix(sum", "mix"), "blend"))
        self.assertIn("no name here", self.refused(at("{\n    return 2.0", "{"), "x"))

    def test_prepare_rename(self):
        found = self.waves.ask("prepareRename", self.waves.at("sum, middle", "middle"))
        self.assertEqual((found["placeholder"], self.waves.of(found["range"])), ("middle", "middle"))


class Completion(Session):
    def items(self, doc, context):
        found = doc.ask("completion", doc.after(context))["items"]
        return {item["label"]: item for item in found}

    def test_members_of_structs(self):
        doc = self.changed("to = heavy;", "to = heavy;\n    d.\n")
        items = self.items(doc, "to = heavy;\n    d.")
        self.assertEqual(set(items), {"position", "mass"})
        self.assertEqual((items["position"]["detail"], items["position"]["documentation"]["value"]),
                         ("float2", "In metres."))

    def test_members_of_structures_modules_enums_and_vectors(self):
        def members(value):
            return set(self.items(self.changed("    step(f, g);", f"    step(f, g);\n    let n = {value}\n"),
                                  "let n = " + value))

        self.assertLessEqual({"extent", "domain", "sample"}, members("f."))
        self.assertEqual(members("shapes."), {"Drop"})
        self.assertEqual(members("Edge."), {"open", "closed"})
        self.assertEqual(members("uint2(1, 2)."), {"x", "y"})
        self.assertEqual(members("nothing."), set())

    def test_names_in_scope(self):
        doc = self.changed("g = mix(sum, middle, speed);", "g = m\n")
        items = self.items(doc, "g = m")
        self.assertLessEqual({"middle", "sum", "speed", "f", "g", "twice", "spread", "Field", "Drop", "mix", "float"},
                             set(items))
        self.assertEqual(items["middle"]["detail"], "float")
        self.assertNotIn("heavy", items)
        self.assertNotIn("hidden", items)

    def test_patterns(self):
        doc = self.changed("d: in each<Drops>", "d: in e")
        self.assertLessEqual({"each", "near", "any"}, set(self.items(doc, "d: in ")))

    def test_modules(self):
        doc = self.changed("use ./shapes;", "use ./shapes;\nuse std.re\n")
        self.assertIn("reduce", self.items(doc, "use std.re"))

    def test_names_that_need_an_import(self):
        doc = self.changed("    step(f, g);", "    step(f, g);\n    let s = reduc\n")
        item = self.items(doc, "let s = reduc")["reduce"]
        text = doc.with_edits(item["additionalTextEdits"])
        self.assertIn("use ./shapes;\nuse std.reduce;\n", text)

    def test_nothing_in_comments_and_strings(self):
        self.assertEqual(self.items(self.waves, "// 🌊🌊 aft"), {})
        self.assertEqual(self.items(self.waves, 'test "a st'), {})

    def test_signatures(self):
        doc = self.changed("    spread(f, 0.5, g);", "    spread(f, 0.5, \n")
        found = doc.ask("signatureHelp", doc.after("spread(f, 0.5, "))
        [signature] = found["signatures"]
        self.assertEqual([each["label"] for each in signature["parameters"]],
                         ["f: in near<Field, 1>", "speed: float", "g: out each<Field>"])
        self.assertEqual(found["activeParameter"], 2)
        doc = self.changed("mix(sum, middle, speed)", "mix(sum, ")
        found = doc.ask("signatureHelp", doc.after("mix(sum, "))
        self.assertEqual((found["signatures"][0]["label"], found["activeParameter"]),
                         ("mix(floating, floating, floating or scalar) -> floating", 1))
        doc = self.changed("twice(middle)", "twice(")
        self.assertEqual(len(doc.ask("signatureHelp", doc.after("sum = twice("))["signatures"]), 2)
        self.assertIsNone(self.waves.ask("signatureHelp", self.waves.at("let heavy")))


class Whole(Session):
    """Requests about a whole document."""

    def test_document_symbols(self):
        symbols = {each["name"]: each for each in self.waves.whole("documentSymbol")}
        self.assertEqual(list(symbols), ["Field", "Drops", "Edge", "twice", "spread", "weigh", "step",
                                         'test "a step of still water is still"'])
        self.assertEqual([each["name"] for each in symbols["Edge"]["children"]], ["open", "closed"])
        self.assertEqual(self.waves.of(symbols["spread"]["selectionRange"]), "spread")
        self.assertTrue(self.waves.of(symbols["spread"]["range"]).startswith("kernel spread"))
        self.assertTrue(self.waves.of(symbols["spread"]["range"]).endswith("}"))

    def test_semantic_tokens(self):
        legend = Server(compiler)
        names = legend.start()["capabilities"]["semanticTokensProvider"]["legend"]["tokenTypes"]
        legend.stop()
        data = self.waves.whole("semanticTokens/full")["data"]
        self.assertEqual(len(data) % 5, 0)
        coloured, line, character = set(), 0, 0
        for i in range(0, len(data), 5):
            down, right, length, kind, _ = data[i:i + 5]
            line, character = line + down, right if down else character + right
            start = self.waves.offset({"line": line, "character": character})
            end = self.waves.offset({"line": line, "character": character + length})
            coloured.add((self.waves.text[start:end], names[kind]))
        for each in [("kernel", "keyword"), ("Field", "type"), ("middle", "variable"), ("f", "parameter"),
                     ("twice", "function"), ("mix", "function"), ("mass", "property"), ("Drop", "struct"),
                     ("closed", "enumMember"), ("2.0", "number"), ("/// Waves on a grid.", "comment"),
                     ("// 🌊🌊 after two characters of two units each", "comment"), ("float2", "type")]:
            self.assertIn(each, coloured)

    def test_formatting(self):
        self.assertEqual(self.waves.whole("formatting", options={"tabSize": 4, "insertSpaces": True}), [])
        doc = self.changed("    to = heavy;", "  to=heavy ;")
        edits = doc.whole("formatting", options={"tabSize": 4, "insertSpaces": True})
        self.assertEqual(doc.with_edits(edits), WAVES)
        doc = self.changed("    to = heavy;", "  to=heavy (;")
        self.assertEqual(doc.whole("formatting", options={"tabSize": 4, "insertSpaces": True}), [])

    def fixed(self, doc, context, word):
        place = doc.at(context, word)
        actions = doc.whole("codeAction", range={"start": place, "end": place}, context={"diagnostics": []})
        return {action["title"]: {path_of(uri).name: edits for uri, edits in action["edit"]["changes"].items()}
                for action in actions}

    def test_code_actions(self):
        doc = self.changed("sum, middle, speed", "sum, midle, speed")
        edits = self.fixed(doc, "midle", "midle")["replace by 'middle'"]["waves.glift"]
        self.assertEqual(doc.with_edits(edits), WAVES)
        doc = self.changed("twice(d.mass)", "twice(d.maas)")
        edits = self.fixed(doc, "maas", "maas")["replace by 'mass'"]["waves.glift"]
        self.assertEqual(doc.with_edits(edits), WAVES)
        doc = self.changed("    step(f, g);", "    let s = reduce(f, add);")
        edits = self.fixed(doc, "reduce(f", "reduce")["import std.reduce"]["waves.glift"]
        self.assertIn("use std.reduce;\n", doc.with_edits(edits))
        doc = self.changed("sum = twice(middle);", "sum = twice(middle) * hidden();")
        edits = self.fixed(doc, "hidden", "hidden")["export it by 'pub'"]["shapes.glift"]
        self.assertEqual((edits[0]["newText"], edits[0]["range"]["start"]), ("pub ", {"line": 9, "character": 0}))
        doc = self.changed("    let heavy", "    let unused = 1;\n    let heavy")
        edits = self.fixed(doc, "unused", "unused")["begin the name with '_'"]["waves.glift"]
        self.assertIn("let _unused = 1;", doc.with_edits(edits))
        doc = self.changed("    to = heavy;", "    to = heavy")
        edits = self.fixed(doc, "heavy\n", "\n")["insert ';'"]["waves.glift"]
        self.assertEqual(doc.with_edits(edits), WAVES)

    def test_code_lenses(self):
        lenses = {each["command"]["title"] + " " + each["command"]["arguments"][1]: each
                  for each in self.waves.whole("codeLens")}
        self.assertEqual(set(lenses), {"show GLSL spread", "show GLSL weigh",
                                       "run test a step of still water is still"})
        lens = lenses["show GLSL spread"]
        self.assertEqual(lens["command"]["command"], "glift.showGlsl")
        self.assertEqual(lens["range"]["start"], self.waves.at("kernel spread"))
        self.assertEqual(path_of(self.waves.uri), pathlib.Path(lens["command"]["arguments"][0]))


if __name__ == "__main__":
    unittest.main()
