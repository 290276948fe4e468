// rmplc server: the language server on standard input and output.
// SPDX-License-Identifier: MIT
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>
#include <system_error>

#include "base/error.hpp"
#include "tools/rmplc/commands.hpp"
#include "tools/rmplc/server/server.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

constexpr const char* notes =
    R"(Editors start it and speak the Language Server Protocol 3.17 with it, on standard
input and output. docs/editors.md says how to set up Neovim, VS Code, Vim, Emacs
and Helix.

Exit status:
  0  the editor shut it down
  1  the editor ended without a shutdown)";

/// Whether bytes, or their end, can be had without waiting.
bool is_ready(int descriptor) {
  pollfd wanted{descriptor, POLLIN, 0};
  return poll(&wanted, 1, 0) > 0;
}

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

/// Reads what there is, waiting for the first byte. False at the end.
bool read_some(Frames& frames) {
  std::array<char, 1 << 16> bytes;
  ssize_t count = 0;
  do {
    count = ::read(STDIN_FILENO, bytes.data(), bytes.size());
  } while (count < 0 && errno == EINTR);
  if (count < 0) throw base::InputError(std::string("standard input: ") + std::strerror(errno));
  frames.feed({bytes.data(), static_cast<std::size_t>(count)});
  return count > 0;
}

/// The pages of the codes, where they were installed with the program; empty where they were not.
std::string pages() {
  std::error_code error;
  const std::filesystem::path program = std::filesystem::read_symlink("/proc/self/exe", error);
  const auto folder = (program.parent_path() / RMPL_PAGES).lexically_normal();
  return !error && std::filesystem::is_directory(folder, error) ? folder.string() : std::string();
}

ExitStatus run() {
  compiler::Disk disk;
  Server server(disk, {RMPL_VERSION, pages()}, [](const std::string& message) { print(framed(message)); });
  Frames frames;
  bool more = true;
  while (!server.ended()) {
    while (auto frame = frames.next()) server.receive(*frame);
    // Everything that has come is looked at before anything is done: it may cancel, or change the text once more.
    if (more && is_ready(STDIN_FILENO)) {
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
  CLI::App* command = program.app().add_subcommand("server", "the language server, for editors");
  command->add_flag("--stdio")->description("use standard input and output, as it always does");
  command->footer(notes);
  program.add({command, [] { return run(); }});
}

}  // namespace rmpl::tools
