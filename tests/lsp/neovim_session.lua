-- A session in Neovim without a screen: writes what the editor shows. neovim_test.py runs it and compares the text.
local source = vim.env.GLIFT_SOURCE_DIR
package.path = package.path .. ";" .. source .. "/tools/editors/neovim/?.lua"
require("glift").setup { compiler = vim.env.GLIFTC }

local lines = {}
local function say(text) vim.list_extend(lines, vim.split(text, "\n", { plain = true })) end
local function heading(text) say(""); say("# " .. text) end

local function wait_until(what, condition)
    if not vim.wait(60000, condition, 20) then
        say("waited in vain: " .. what)
        vim.fn.writefile(lines, vim.env.TRANSCRIPT)
        vim.cmd("cquit")
    end
end

--- Puts the cursor on the first place with the text.
local function go(text)
    vim.fn.cursor(1, 1)
    assert(vim.fn.search("\\V" .. text, "cW") > 0, text .. " is not there")
end

local function at_cursor() return vim.lsp.util.make_position_params() end

local function ask(method, params)
    local answers = vim.lsp.buf_request_sync(0, method, params, 60000)
    for _, answer in pairs(answers or {}) do return answer.result end
end

local function diagnostics_are(count)
    wait_until(count .. " diagnostics", function() return #vim.diagnostic.get(0) == count end)
    for _, each in ipairs(vim.diagnostic.get(0)) do
        say(("%d:%d: %s [%s]"):format(each.lnum + 1, each.col + 1, each.message, each.code or ""))
    end
end

local function replace(old, new)
    go(old)
    local row, column = unpack(vim.api.nvim_win_get_cursor(0))
    vim.api.nvim_buf_set_text(0, row - 1, column, row - 1, column + #old, { new })
end

vim.cmd("edit water.glift")
heading("file type and colours")
say("filetype: " .. vim.bo.filetype)
for _, word in ipairs { "kernel", "near", "float", "mix", "0.5", "/// Waves", "\"still" } do
    go(word)
    local position = vim.api.nvim_win_get_cursor(0)
    say(word .. ": " .. vim.fn.synIDattr(vim.fn.synID(position[1], position[2] + 1, 1), "name"))
end

wait_until("the server", function() return #vim.lsp.buf_get_clients(0) == 1 end)
wait_until("initialization", function()
    for _, client in pairs(vim.lsp.buf_get_clients(0)) do return client.initialized end
end)

heading("an error while typing")
replace("middle, 0.5", "midle, 0.5")
diagnostics_are(1)
heading("its code action")
go("midle")
local range = vim.lsp.util.make_range_params()
range.context = { diagnostics = {} }
local actions = ask("textDocument/codeAction", range)
for _, action in ipairs(actions) do say(action.title) end
vim.lsp.util.apply_workspace_edit(actions[1].edit, "utf-16")
diagnostics_are(0)

heading("hover")
go("sum = 2")
say(ask("textDocument/hover", at_cursor()).contents.value)

heading("go to definition")
go("middle, 0.5")
vim.lsp.buf.definition()
wait_until("the cursor to move", function() return vim.fn.getline("."):find("let middle") ~= nil end)
say(("line %d: %s"):format(vim.fn.line("."), vim.fn.getline(".")))

heading("completion")
go("middle, 0.5")
vim.bo.omnifunc = "v:lua.vim.lsp.omnifunc"
local offered = {}
for _, item in ipairs(ask("textDocument/completion", at_cursor()).items) do offered[item.label] = item.detail or "" end
for _, name in ipairs { "middle", "sum", "f", "mix" } do say(name .. ": " .. (offered[name] or "not offered")) end

heading("rename")
go("middle =")
vim.lsp.buf.rename("centre")
wait_until("the new name", function() return vim.fn.search("mix(sum, centre, 0.5)", "nw") > 0 end)
for _, line in ipairs(vim.fn.getline(1, "$")) do
    if line:find("centre") then say(line) end
end

heading("format")
replace("    g = mix", "  g=mix")
vim.lsp.buf.formatting_sync({}, 60000)
go("g = mix")
say(vim.fn.getline("."))

heading("code lenses")
vim.lsp.codelens.refresh()
wait_until("lenses", function() return #vim.lsp.codelens.get(0) > 0 end)
for _, lens in ipairs(vim.lsp.codelens.get(0)) do
    say(("line %d: %s (%s %s)"):format(lens.range.start.line + 1, lens.command.title, lens.command.command,
        lens.command.arguments[2]))
end

heading("show GLSL")
vim.cmd("silent write")
for _, lens in ipairs(vim.lsp.codelens.get(0)) do
    if lens.command.command == "glift.showGlsl" then vim.lsp.commands[lens.command.command](lens.command) end
end
say(vim.fn.expand("%:t"))
say(vim.fn.getline(1))

vim.fn.writefile(lines, vim.env.TRANSCRIPT)
vim.cmd("qall!")
