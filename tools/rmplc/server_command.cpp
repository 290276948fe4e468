// rmplc server: the language server on standard input and output.
// SPDX-License-Identifier: MIT
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <filesystem>
#include <string>
#include <system_error>

#include "base/error.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/rmplc/server/server.hpp"
#include "tools/shared/frame_input.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

constexpr const char* server_notes =
    R"(Editors start it and speak the Language Server Protocol 3.17 with it, on standard
input and output. docs/editors.md says how to set up Neovim, VS Code, Vim, Emacs
and Helix.

Exit status:
  0  the editor shut it down
  1  the editor ended without a shutdown)";

/// Waits for bytes, or their end, while the server uses the time.
void wait_for_input(Server& server) {
  for (;;) {
    const Pause pause = server.pause();
    std::array<pollfd, 2> wanted{{{STDIN_FILENO, POLLIN, 0}, {pause.descriptor, POLLIN, 0}}};
    const int ready = poll(wanted.data(), wanted.size(), pause.milliseconds);
    if (wanted[0].revents != 0 || (ready < 0 && errno != EINTR)) return;
    if (ready >= 0) server.rest();
  }
}

/// The pages of the codes, where they were installed with the program; empty where they were not.
std::string pages() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto folder = (program.parent_path() / RMPL_PAGES).lexically_normal();
  return !error && std::filesystem::is_directory(folder, error) ? folder.string() : std::string();
}

ExitStatus run() {
  constexpr std::size_t most = std::size_t{64} << 20;  // what people edit is a hundred times shorter
  compiler::RegularFiles disk(most);
  Server server(disk, {RMPL_VERSION, pages()}, [](const std::string& message) { print_raw(framed(message)); });
  Frames frames;
  bool more = true;
  while (!server.ended()) {
    while (auto frame = frames.next()) server.receive(*frame);
    // Everything that has come is looked at before anything is done: it may cancel, or change the text once more.
    if (more && input_is_ready()) {
      more = read_some(frames);
    } else if (server.has_work()) {
      server.work();
    } else if (more) {
      server.idle();
      wait_for_input(server);
      more = read_some(frames);
    } else {
      break;
    }
  }
  return server.ended() && server.shut_down() ? ExitStatus::done : ExitStatus::violated;
}

}  // namespace

void add_server(Program& program) {
  Command command = program.add_command("server", "the language server, for editors");
  command.add_flag("--stdio", "use standard input and output, as it always does");
  command.footer(server_notes);
  program.add({command, [] { return run(); }});
}

}  // namespace rmpl::tools
