#!/usr/bin/env python3
"""Tests `tools/inspect --follow`: the page shows what was saved last. inspect_follow_test.py INSPECT"""
import array
import base64
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import urllib.request

inspect = sys.argv[1]


def words(kind, values):
    return base64.b64encode(array.array(kind, values).tobytes()).decode()


def save(path, name, value):
    plane = {"axes": [0, 1], "through": [0, 0], "first": [4, 8], "size": [2, 2], "cell": [1, 1], "count": [2, 2],
             "values": words("f", [0.0, 1.0, 2.0, value])}
    root = {"name": name, "role": "root", "type": "Array<2, float>", "bytes": 16, "domain": [2, 2], "elements": 4,
            "planes": [plane]}
    part = path.with_suffix(".part")
    part.write_text(json.dumps({"glift_inspection": 1, "device": "host", "root": root}))
    os.replace(part, path)


with tempfile.TemporaryDirectory() as folder:
    file = pathlib.Path(folder) / "some.inspection"
    server = subprocess.Popen([inspect, str(file), "--follow", "--port", "0"], stdout=subprocess.PIPE, text=True)
    try:
        address = server.stdout.readline().split()[0]

        def get(path):
            with urllib.request.urlopen(address + path, timeout=10) as answer:
                return answer.read().decode()

        assert "is not there yet" in get(""), "the page waits for the file"
        save(file, "first", 3.0)
        page = json.loads(get("page?after=0"))
        assert page["version"] == 1 and page["title"] == "first" and "values, 0 to 3" in page["body"], page
        assert "<b>4</b><b>x &rarr;</b><b>5</b>" in page["body"], "pictures have axes"
        assert json.loads(get("page?after=1")) == {"version": 1, "title": "first", "body": ""}, "nothing new, nothing sent"
        file.write_text("{ half")
        assert json.loads(get("page?after=1"))["version"] == 1, "a file that is half written keeps the last page"
        save(file, "second", 4.0)
        page = json.loads(get("page?after=1"))
        assert page["version"] == 2 and page["title"] == "second" and "values, 0 to 4" in page["body"], page
        assert "setInterval" in get(""), "the page asks again by itself"
        taken = subprocess.run([inspect, str(file), "--follow", "--port", address.rsplit(":", 1)[1].strip("/")],
                               capture_output=True, text=True, timeout=20, check=False)
        assert taken.returncode == 1 and "choose another by --port" in taken.stderr, taken
    finally:
        server.terminate()
        server.wait()
