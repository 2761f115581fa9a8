-- The language server of Glift in Neovim's own client, and the commands of its code lenses.
--
--     require("glift").setup { compiler = "/path/to/gliftc", arguments = { "-I", "modules" } }
--
-- Needs Neovim 0.7; code lenses are refreshed by vim.lsp.codelens, hover and the rest by the client's own functions.
local M = {}

local options = { compiler = "gliftc", arguments = {} }

local function command(words)
    local all = { options.compiler }
    vim.list_extend(all, options.arguments)
    return vim.list_extend(all, words)
end

--- Runs gliftc in a terminal below.
local function in_terminal(words)
    vim.cmd("botright 15new")
    vim.fn.termopen(command(words))
end

--- Whether a file of shader code belongs to the kernel: its name, or that of an instance of it, is the file's.
local function is_of_kernel(file, kernel)
    if not file:match("%.glsl$") then return false end
    for part in vim.fn.fnamemodify(file, ":t"):gmatch("[^.]+") do
        if part == kernel or vim.startswith(part, kernel .. "_") or vim.endswith(part, "_" .. kernel) then return true end
    end
    return false
end

local function show_glsl(path, kernel)
    local folder = vim.fn.tempname()
    local output = vim.fn.system(command { "--target", "glsl", "-o", folder, path })
    if vim.v.shell_error ~= 0 then return vim.notify(output, vim.log.levels.ERROR) end
    local found = false
    for _, file in ipairs(vim.fn.globpath(folder, "*.glsl", false, true)) do
        if is_of_kernel(file, kernel) then
            vim.cmd("vsplit " .. vim.fn.fnameescape(file))
            found = true
        end
    end
    if not found then vim.notify("No pipeline or test of this file runs '" .. kernel .. "': it has no shader.") end
end

--- Sets the options and starts the server for .glift files. Called once, before a file is opened.
function M.setup(given)
    options = vim.tbl_extend("force", options, given or {})
    vim.lsp.commands["glift.showGlsl"] = function(lens) show_glsl(unpack(lens.arguments)) end
    vim.lsp.commands["glift.runTest"] = function(lens)
        in_terminal { "test", "--filter", lens.arguments[2], lens.arguments[1] }
    end
    vim.api.nvim_create_autocmd("FileType", {
        pattern = "glift",
        callback = function(event)
            local file = vim.api.nvim_buf_get_name(event.buf)
            local words = vim.list_extend({ "lsp" }, options.arguments)
            local all = vim.list_extend({ options.compiler }, words)
            local folder = vim.fn.fnamemodify(file, ":p:h")
            if vim.lsp.start then
                return vim.lsp.start { name = "glift", cmd = all, root_dir = folder }
            end
            local client = vim.lsp.start_client { name = "glift", cmd = all, root_dir = folder }  -- before 0.8
            if client then vim.lsp.buf_attach_client(event.buf, client) end
        end,
    })
end

return M
