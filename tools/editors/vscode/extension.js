// The client of `gliftc lsp` in VS Code, and the commands of its code lenses.
"use strict";

const fs = require("fs");
const os = require("os");
const path = require("path");
const vscode = require("vscode");
const { LanguageClient } = require("vscode-languageclient/node");

let client;

const settings = () => vscode.workspace.getConfiguration("glift");

/** The command line of gliftc with these words, for a shell. */
function commandLine(words) {
    const quoted = (word) => (/^[\w./=:+-]+$/.test(word) ? word : "'" + word.replace(/'/g, "'\\''") + "'");
    return [settings().get("compiler"), ...settings().get("arguments"), ...words].map(quoted).join(" ");
}

/** Runs gliftc in a task; resolves to its exit code. */
async function run(name, words) {
    const task = new vscode.Task({ type: "shell" }, vscode.TaskScope.Workspace, name, "glift",
        new vscode.ShellExecution(commandLine(words)));
    task.presentationOptions = { clear: true, reveal: vscode.TaskRevealKind.Always };
    const execution = await vscode.tasks.executeTask(task);
    return new Promise((resolve) => {
        const listener = vscode.tasks.onDidEndTaskProcess((event) => {
            if (event.execution !== execution) return;
            listener.dispose();
            resolve(event.exitCode);
        });
    });
}

/** Whether a file of shader code belongs to the kernel: its name, or that of an instance of it, is the file's. */
function isOfKernel(file, kernel) {
    return /\.(comp|vert|frag)\.glsl$/.test(file) && file.split(".").some((part) => part === kernel ||
        part.startsWith(kernel + "_") || part.endsWith("_" + kernel));
}

/** Compiles the file to GLSL in a temporary folder, and opens the shaders of the kernel beside it. */
async function showGlsl(file, kernel) {
    const folder = fs.mkdtempSync(path.join(os.tmpdir(), "glift-"));
    const code = await run("show GLSL", ["--target", "glsl", "-o", folder, file]);
    if (code !== 0) return;
    const files = fs.readdirSync(folder).filter((each) => isOfKernel(each, kernel));
    if (files.length === 0)
        vscode.window.showInformationMessage(`No pipeline or test of this file runs '${kernel}': it has no shader.`);
    for (const each of files) {
        const document = await vscode.workspace.openTextDocument(path.join(folder, each));
        await vscode.window.showTextDocument(document, { viewColumn: vscode.ViewColumn.Beside, preview: false });
    }
}

function runTest(file, title) {
    return run("run test", ["test", "--filter", title, file]);
}

async function start() {
    const command = settings().get("compiler");
    const options = { command, args: ["lsp", ...settings().get("arguments")] };
    client = new LanguageClient("glift", "Glift", { run: options, debug: options }, {
        documentSelector: [{ language: "glift" }],
        synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.glift") },
    });
    try {
        await client.start();
    } catch (error) {
        vscode.window.showErrorMessage(
            `The Glift language server '${command}' does not start. Set glift.compiler to the path of gliftc. ${error}`);
    }
}

async function activate(context) {
    context.subscriptions.push(
        vscode.commands.registerCommand("glift.showGlsl", showGlsl),
        vscode.commands.registerCommand("glift.runTest", runTest),
        vscode.commands.registerCommand("glift.restart", async () => {
            if (client) await client.stop();
            await start();
        }));
    await start();
}

function deactivate() {
    return client ? client.stop() : undefined;
}

module.exports = { activate, deactivate };
