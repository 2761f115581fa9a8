"""A client of `gliftc lsp` for tests: starts the server, sends messages, waits for answers."""
import json
import pathlib
import subprocess
import tempfile
import urllib.parse

WAIT = 60  # seconds until a server that does not answer counts as hung


def utf16_length(text):
    return len(text.encode("utf-16-le")) // 2


class Hung(Exception):
    pass


class Server:
    """One session. Used as a context manager, it starts and ends the session properly."""

    def __init__(self, compiler, *options):
        self.process = subprocess.Popen([compiler, "lsp", *options], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                        stderr=subprocess.PIPE)
        self.next_id = 0
        self.diagnostics = {}  # by URI: the latest parameters of publishDiagnostics
        self.logged = []

    def __enter__(self):
        return self

    def __exit__(self, kind, value, trace):
        if kind is None:
            self.stop()
        else:
            self.process.kill()
            self.wait()
        return False

    def start(self, folder=None):
        uri = folder.as_uri() if folder else None
        result = self.request("initialize", {"processId": None, "rootUri": uri, "capabilities": {}})
        self.notify("initialized", {})
        return result

    def stop(self):
        self.request("shutdown", None)
        self.notify("exit", None)
        return self.wait()

    def wait(self):
        """The exit code of the server, which ends by itself."""
        self.process.stdin.close()
        code = self.process.wait(WAIT)
        self.process.stdout.close()
        self.process.stderr.close()
        return code

    def send_bytes(self, content):
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(content) + content)
        self.process.stdin.flush()

    def send(self, message):
        self.send_bytes(json.dumps({"jsonrpc": "2.0", **message}).encode())

    def notify(self, method, params):
        self.send({"method": method, "params": params})

    def receive(self):
        """The next message; None at the end of the output."""
        length = None
        while True:
            line = self.process.stdout.readline()
            if not line:
                return None
            if line == b"\r\n":
                break
            name, value = line.split(b":", 1)
            if name.lower() == b"content-length":
                length = int(value)
        message = json.loads(self.process.stdout.read(length))
        if message.get("method") == "textDocument/publishDiagnostics":
            self.diagnostics[message["params"]["uri"]] = message["params"]
        if message.get("method") == "window/logMessage":
            self.logged.append(message["params"]["message"])
        return message

    def answer_to(self, id):
        while True:
            message = self.receive()
            if message is None:
                raise Hung(f"the server ended: {self.process.stderr.read().decode()}")
            if "method" not in message and message.get("id") == id:
                return message

    def ask(self, method, params):
        """The whole answer to a request, which may be an error."""
        self.next_id += 1
        self.send({"id": self.next_id, "method": method, "params": params})
        return self.answer_to(self.next_id)

    def request(self, method, params):
        answer = self.ask(method, params)
        if "error" in answer:
            raise AssertionError(f"{method}: {answer['error']}")
        return answer["result"]

    def wait_for_diagnostics(self, uri, version):
        """The diagnostics of this version of a document; of the last of several messages that are there already."""
        while True:
            found = self.diagnostics.get(uri)
            if found and found.get("version") == version:
                return found["diagnostics"]
            if self.receive() is None:
                raise Hung(f"the server ended: {self.process.stderr.read().decode()}")


class Document:
    """An open document, of which the test knows the text."""

    def __init__(self, server, path, text):
        self.server, self.text, self.version = server, text, 1
        self.uri = path if "://" in str(path) else pathlib.Path(path).as_uri()
        server.notify("textDocument/didOpen", {"textDocument": {
            "uri": self.uri, "languageId": "glift", "version": 1, "text": text}})

    def change(self, text):
        self.version += 1
        self.text = text
        self.server.notify("textDocument/didChange", {
            "textDocument": {"uri": self.uri, "version": self.version}, "contentChanges": [{"text": text}]})

    def close(self):
        self.server.notify("textDocument/didClose", {"textDocument": {"uri": self.uri}})

    def diagnostics(self):
        return self.server.wait_for_diagnostics(self.uri, self.version)

    def position(self, offset):
        before = self.text[:offset]
        return {"line": before.count("\n"), "character": utf16_length(before[before.rfind("\n") + 1:])}

    def offset(self, position):
        lines = self.text.split("\n")
        start = sum(len(line) + 1 for line in lines[:position["line"]])
        units = 0
        for i, c in enumerate(lines[position["line"]] + "\n"):
            if units >= position["character"]:
                return start + i
            units += utf16_length(c)
        raise AssertionError(f"there is no position {position}")

    def at(self, context, word=None, last=False):
        """The position of `word` (its first character) in the first place with the text `context`."""
        word = word or context
        start = self.text.rindex(context) if last else self.text.index(context)
        return self.position(start + context.index(word))

    def after(self, context):
        """The position behind the first place with the text."""
        return self.position(self.text.index(context) + len(context))

    def of(self, range):
        """The text of a range."""
        return self.text[self.offset(range["start"]):self.offset(range["end"])]

    def ask(self, method, position, **more):
        return self.server.request("textDocument/" + method, {
            "textDocument": {"uri": self.uri}, "position": position, **more})

    def whole(self, method, **more):
        return self.server.request("textDocument/" + method, {"textDocument": {"uri": self.uri}, **more})

    def with_edits(self, edits):
        text = self.text
        for edit in sorted(edits, key=lambda e: self.offset(e["range"]["start"]), reverse=True):
            text = text[:self.offset(edit["range"]["start"])] + edit["newText"] + text[self.offset(edit["range"]["end"]):]
        return text


def path_of(uri):
    return pathlib.Path(urllib.parse.unquote(uri.removeprefix("file://")))


class Folder:
    """A temporary folder with .glift files."""

    def __init__(self, **files):
        self.held = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.held.name).resolve()
        for name, text in files.items():
            (self.path / (name + ".glift")).write_text(text)
