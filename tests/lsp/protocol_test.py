#!/usr/bin/env python3
"""Breaks the language server protocol in every way that a client may: the server answers with the protocol's errors and
goes on, or ends with the exit code that the protocol demands. It never crashes.

    protocol_test.py GLIFTC
"""
import pathlib
import subprocess
import sys
import unittest

from client import Document, Folder, Server

compiler = pathlib.Path(sys.argv.pop(1)).resolve()

PARSE_ERROR, INVALID_REQUEST, METHOD_NOT_FOUND, INVALID_PARAMS = -32700, -32600, -32601, -32602
NOT_INITIALIZED = -32002

TEXT = "module m;\n\nfn half_of(x: float) -> float {\n    return x * 0.5;  // ½ 🌊\n}\n"


def run(content):
    """The server's exit code and outputs for these bytes."""
    ran = subprocess.run([compiler, "lsp"], input=content, capture_output=True, timeout=60)
    return ran.returncode, ran.stdout, ran.stderr.decode()


def framed(content):
    return b"Content-Length: %d\r\n\r\n" % len(content) + content


class LifeCycle(unittest.TestCase):
    def test_shutdown_then_exit_is_0(self):
        server = Server(compiler)
        server.start()
        self.assertEqual(server.stop(), 0)

    def test_exit_without_shutdown_is_1(self):
        server = Server(compiler)
        server.start()
        server.notify("exit", None)
        self.assertEqual(server.wait(), 1)

    def test_the_end_of_the_input_is_1(self):
        self.assertEqual(run(b"")[0], 1)
        self.assertEqual(run(b"Content-Length: 50\r\n\r\n{\"jsonrpc\"")[0], 1)

    def test_requests_before_initialize(self):
        with Server(compiler) as server:
            answer = server.ask("textDocument/hover", {})
            self.assertEqual(answer["error"]["code"], NOT_INITIALIZED)
            server.notify("textDocument/didOpen", {"textDocument": {"uri": "file:///m.glift", "text": TEXT}})
            server.start()

    def test_initialize_twice_and_requests_after_shutdown(self):
        server = Server(compiler)
        server.start()
        self.assertEqual(server.ask("initialize", {})["error"]["code"], INVALID_REQUEST)
        server.request("shutdown", None)
        self.assertEqual(server.ask("textDocument/hover", {})["error"]["code"], INVALID_REQUEST)
        server.notify("exit", None)
        self.assertEqual(server.wait(), 0)


class Messages(unittest.TestCase):
    def setUp(self):
        self.server = Server(compiler)
        self.server.start()
        self.document = Document(self.server, "file:///nowhere/m.glift", TEXT)

    def tearDown(self):
        # The session goes on after all that.
        self.document.change(TEXT.replace("0.5", "y"))
        self.assertEqual([d["code"] for d in self.document.diagnostics()], ["unknown-name"])
        self.assertEqual(self.server.stop(), 0)

    def answer_to_bytes(self, content):
        self.server.send_bytes(content)
        while True:
            message = self.server.receive()
            if "method" not in message:
                return message

    def test_malformed_messages(self):
        for content, code in [(b"{", PARSE_ERROR), (b"", PARSE_ERROR), (b"\xff\xfe", PARSE_ERROR),
                              (b"[]", INVALID_REQUEST), (b"3", INVALID_REQUEST), (b"{}", INVALID_REQUEST),
                              (b'{"id": 1}', INVALID_REQUEST), (b'{"id": {}, "method": "x"}', INVALID_REQUEST),
                              (b'{"id": 1, "method": 3}', INVALID_REQUEST),
                              (b'{"id": "a", "method": "x"}', METHOD_NOT_FOUND),
                              (b"[" * 100000, PARSE_ERROR)]:
            self.assertEqual(self.answer_to_bytes(content)["error"]["code"], code, content[:40])

    def test_unknown_methods(self):
        self.assertEqual(self.server.ask("textDocument/dance", {})["error"]["code"], METHOD_NOT_FOUND)
        self.server.notify("$/dance", {})
        self.server.notify("textDocument/dance", {})
        self.server.notify("$/cancelRequest", {"id": 1})
        self.server.send({"id": 77, "result": None})  # a response to no request

    def test_parameters_of_wrong_types(self):
        place = {"line": 0, "character": 0}
        document = {"uri": self.document.uri}
        wrong = [None, [], 3, {}, {"textDocument": 3}, {"textDocument": {}}, {"textDocument": {"uri": 3}},
                 {"textDocument": document, "position": 3}, {"textDocument": document, "position": {"line": -1}},
                 {"textDocument": document, "position": {"line": "a", "character": 0}},
                 {"textDocument": document, "position": {"line": 0, "character": -1}},
                 {"textDocument": {"uri": "file:///nowhere/else.glift"}, "position": place},
                 {"textDocument": {"uri": "%%%:"}, "position": place}]
        for method in ["hover", "definition", "references", "rename", "prepareRename", "completion", "signatureHelp",
                       "codeAction", "documentSymbol", "semanticTokens/full", "formatting", "codeLens"]:
            for params in wrong:
                whole = method in ("documentSymbol", "semanticTokens/full", "formatting", "codeLens")
                answer = self.server.ask("textDocument/" + method, params)
                if whole and isinstance(params, dict) and params.get("textDocument") == document:
                    self.assertIn("result", answer)
                else:
                    self.assertEqual(answer.get("error", {}).get("code"), INVALID_PARAMS, (method, params))

    def test_notifications_of_wrong_types_are_logged(self):
        for method in ["didOpen", "didChange", "didClose", "didSave"]:
            for params in [None, [], {"textDocument": 3}, {"textDocument": {"uri": "file:///nowhere/x.glift"},
                                                           "contentChanges": [3]}]:
                if method == "didSave" and isinstance(params, dict) and params["textDocument"] != 3:
                    continue  # a document that is not open may be saved
                before = len(self.server.logged)
                self.server.notify("textDocument/" + method, params)
                self.server.ask("$/sync", {})
                self.assertEqual(len(self.server.logged), before + 1, (method, params))

    def change(self, *changes):
        self.document.version += 1
        self.server.notify("textDocument/didChange", {
            "textDocument": {"uri": self.document.uri, "version": self.document.version},
            "contentChanges": list(changes)})

    def text_of_server(self):
        """The text as the server has it: hover gives a range, and symbols the whole text's end."""
        edits = self.document.whole("formatting", options={})
        return self.document.with_edits(edits)

    def test_wild_ranges(self):
        far = {"line": 4000000000, "character": 4000000000}
        start = {"line": 0, "character": 0}
        self.change({"range": {"start": far, "end": far}, "text": "fn end() -> float { return 1.0; }\n"})
        self.change({"range": {"start": {"line": 1, "character": 99}, "end": {"line": 0, "character": 50}}, "text": ""})
        self.change({"range": {"start": {"line": 3, "character": 25}, "end": {"line": 3, "character": 26}}, "text": "x"})
        self.change({"range": {"start": far, "end": start}, "text": "// end\n"})
        names = [each["name"] for each in self.document.whole("documentSymbol")]
        self.assertEqual(names, ["half_of", "end"])
        self.change({"range": {"start": start, "end": far}, "text": ""})
        self.assertEqual(self.document.whole("documentSymbol"), [])
        self.change({"text": TEXT}, {"range": {"start": start, "end": far}, "text": "module n;\n"}, {"text": "module m;\n"})
        self.assertEqual(self.document.whole("documentSymbol"), [])
        self.document.text = "module m;\n"

    def test_requests_at_every_kind_of_place(self):
        for position in [{"line": 0, "character": 0}, {"line": 99, "character": 99}, {"line": 3, "character": 27},
                         {"line": 3, "character": 28}, {"line": 2, "character": 4000000000}]:
            for method in ["hover", "definition", "references", "completion", "signatureHelp"]:
                self.assertIn("result", self.server.ask("textDocument/" + method, {
                    "textDocument": {"uri": self.document.uri}, "position": position}))

    def test_text_that_is_no_utf8_and_text_that_is_empty(self):
        for text in ["", "\0", "\ufffd", "module", "module m", "use", "\"", "/*", "{" * 5000]:
            self.document.change(text)
            self.assertIsInstance(self.document.whole("documentSymbol"), list)
            self.assertIsInstance(self.document.whole("semanticTokens/full")["data"], list)


class Headers(unittest.TestCase):
    def test_bad_headers_end_the_session(self):
        for header in [b"Content-Length: x\r\n\r\n{}", b"Content-Length: -5\r\n\r\n{}", b"Hello\r\n\r\n", b"\r\n{}",
                       b"Content-Length: 99999999999999999999\r\n\r\n", b"Content-Type: a\r\n\r\n{}", b"x" * 9000]:
            code, out, err = run(header)
            self.assertEqual((code, out), (1, b""), header[:40])
            self.assertTrue(err.startswith("gliftc lsp: "), (header[:40], err))

    def test_other_headers_and_cases_are_accepted(self):
        message = b'{"jsonrpc": "2.0", "id": 1, "method": "initialize", "params": {}}'
        code, out, err = run(b"Content-Type: x; charset=utf-8\r\ncontent-length:  %d \r\n\r\n" % len(message) + message)
        self.assertEqual((code, err), (1, ""))
        self.assertIn(b"capabilities", out)


if __name__ == "__main__":
    unittest.main()
