#!/usr/bin/env python3
"""Tests the manual pages and the shell completion that gliftc makes of its options. shell_files_test.py GLIFTC"""
import re
import shutil
import subprocess

from gliftc import Folder, expect, finish, says

here = Folder()
says(here.run("shell-files", "shell"), 0)
shell = here.path / "shell"
commands = ["explain", "fmt", "lsp", "new", "test", "watch"]
expect(here.names("shell/man1") == ["gliftc-" + c + ".1" for c in commands] + ["gliftc.1"], "a page for each command",
       str(here.names("shell/man1")))


def options_of(*words):
    """The long options that --help lists."""
    return set(re.findall(r"(?<!\S)(?:-\w,)?(--[a-z-]+)", here.run(*words, "--help").stdout))


def text_of(name):
    return (shell / name).read_text()


for command in [None, *commands]:
    page = text_of("man1/gliftc" + (f"-{command}" if command else "") + ".1").replace("\\-", "-")
    options = options_of(*([command] if command else []))
    expect(len(options) > 0 and all(option in page for option in options), f"{command}: every option has an entry",
           f"{options}\n{page}")
for name in "bash/gliftc", "zsh/_gliftc":
    wanted = options_of() | options_of("test")
    expect(all(option in text_of(name) for option in wanted), f"{name} has every option", text_of(name))
expect("-l timeout -r" in text_of("fish/gliftc.fish"), "fish knows which options take a value", text_of("fish/gliftc.fish"))
expect("shell-files" not in text_of("man1/gliftc.1") + text_of("bash/gliftc"), "hidden commands stay hidden")


def completions(*words):
    """What bash offers for the last word."""
    script = (f"source {shell}/bash/gliftc; COMP_WORDS=({' '.join(repr(w) for w in words)}); "
              f"COMP_CWORD={len(words) - 1}; _gliftc; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    ran = subprocess.run(["bash", "-c", script], cwd=here.path, text=True, capture_output=True)
    expect(ran.stderr == "", "bash reads the completion", ran.stderr)
    return ran.stdout.split()


here.write("sum.glift", "")
here.write("sum.txt", "")
expect(completions("gliftc", "te") == ["test"], "bash completes commands", str(completions("gliftc", "te")))
expect(completions("gliftc", "test", "--time") == ["--timeout", "--time-report"], "bash completes a command's options",
       str(completions("gliftc", "test", "--time")))
expect("--timeout" not in completions("gliftc", "--time"), "bash completes no options of other commands")
expect(completions("gliftc", "test", "su") == ["sum.glift"], "bash completes .glift files",
       str(completions("gliftc", "test", "su")))

for shell_name, check in (("zsh", ["zsh", "-n", "zsh/_gliftc"]), ("fish", ["fish", "-n", "fish/gliftc.fish"]),
                          ("man", ["man", "--warnings", "-l", "-Tutf8", "man1/gliftc.1"])):
    if shutil.which(shell_name):
        ran = subprocess.run(check, cwd=shell, text=True, capture_output=True)
        expect(ran.returncode == 0 and ran.stderr == "", f"{shell_name} reads its file", ran.stderr)
finish()
