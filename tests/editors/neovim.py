#!/usr/bin/env python3
# The language server in a real editor: Neovim without a screen opens a program, asks, edits, and is told.
# SPDX-License-Identifier: MIT
"""Usage: neovim.py ROOT PROGRAMS      exits with 77 where there is no nvim."""

import pathlib
import shutil
import subprocess
import sys
import tempfile

SCRIPT = """
local function check(holds, what) if not holds then io.stderr:write('failed: ' .. what .. '\\n') vim.cmd('cquit 1') end end
local buffer = vim.api.nvim_get_current_buf()
local client = vim.lsp.start_client({ name = 'rmplc', cmd = { '%s', 'server' }, root_dir = vim.fn.getcwd() })
vim.lsp.buf_attach_client(buffer, client)
check(vim.wait(10000, function() return vim.lsp.buf_get_clients(buffer)[client] ~= nil and vim.lsp.get_client_by_id(client).server_capabilities ~= nil end), 'attached')

local line = vim.fn.search('engine = standby') - 1
local text = vim.api.nvim_buf_get_lines(buffer, line, line + 1, false)[1]
local at = { textDocument = { uri = vim.uri_from_bufnr(buffer) }, position = { line = line, character = text:find('standby') - 1 } }
local function ask(method) return vim.lsp.buf_request_sync(buffer, method, at, 10000)[client].result end
check(ask('textDocument/hover').contents.value:find('mode standby'), 'hover')
check(ask('textDocument/definition').uri:find('mars_lander.tcca'), 'definition')
check(#vim.diagnostic.get(buffer) == 0, 'no diagnostics at first')

vim.api.nvim_buf_set_lines(buffer, line, line + 1, false, { '  /* \\240\\159\\154\\128 */ engine = standbye;' })
check(vim.wait(10000, function() return #vim.diagnostic.get(buffer) == 1 end), 'a diagnostic')
local told = vim.diagnostic.get(buffer)[1]
check(told.lnum == line and told.message:find('standbye'), 'its place and message: ' .. vim.inspect(told))
check(vim.api.nvim_buf_get_lines(buffer, line, line + 1, false)[1]:sub(told.col + 1, told.end_col) == 'standbye', 'its columns')
vim.cmd('undo')
check(vim.wait(10000, function() return #vim.diagnostic.get(buffer) == 0 end), 'it goes')
vim.lsp.stop_client(client)
check(vim.wait(10000, function() return vim.lsp.client_is_stopped(client) end), 'it stops')
io.stdout:write('neovim and the server understand each other\\n')
vim.cmd('qall!')
"""


# A program of a project, whose plant lies in another folder.
PROJECT = """
local buffer = vim.api.nvim_get_current_buf()
local client = vim.lsp.start_client({ name = 'rmplc', cmd = { '%s', 'server' }, root_dir = vim.fn.getcwd() })
vim.lsp.buf_attach_client(buffer, client)
local line = vim.fn.search('pump = broken') - 1
vim.api.nvim_buf_set_lines(buffer, line, line + 1, false, { '  } watching (pump = brokem | switch = stuck);' })
local told = vim.wait(10000, function() return #vim.diagnostic.get(buffer) == 1 end)
if not told or vim.diagnostic.get(buffer)[1].lnum ~= line then
  io.stderr:write('no diagnostic across folders: ' .. vim.inspect(vim.diagnostic.get(buffer)) .. '\\n')
  vim.cmd('cquit 1')
end
vim.lsp.stop_client(client)
vim.cmd('qall!')
"""


def main(root: str, programs: str) -> int:
    if not shutil.which("nvim"):
        print("skipped: there is no nvim; cmake/install-packages editors installs it")
        return 77
    rmplc = pathlib.Path(programs, "rmplc").resolve()

    def edited(folder, file, script):
        path = pathlib.Path(folder, "check.lua")
        path.write_text(script % rmplc, encoding="utf-8")
        done = subprocess.run(["nvim", "--headless", "--clean", "-n", file, "-c", f"luafile {path}"], cwd=folder, timeout=90,
                              stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        print(done.stdout + done.stderr)
        return done.returncode == 0, done.stdout

    with tempfile.TemporaryDirectory() as at:
        folder = pathlib.Path(at, "mars-entry")
        shutil.copytree(pathlib.Path(root, "examples/mars-entry"), folder)
        good, text = edited(folder, "mars_entry.rmpl", SCRIPT)
        subprocess.run([rmplc, "new", "-q", "demo"], cwd=at, check=True)
        project, _ = edited(pathlib.Path(at, "demo"), "program/fill.rmpl", PROJECT)
    return 0 if good and "understand each other" in text and project else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
