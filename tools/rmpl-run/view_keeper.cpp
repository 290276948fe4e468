// A socket between the two: what was written into it before the flight was killed is still read.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/view_keeper.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstring>
#include <exception>
#include <sstream>

#include "base/error.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "runtime/executive/trace/trace_reader.hpp"
#include "runtime/report/recorder.hpp"
#include "tools/rmpl-run/trace_constraint.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

/// Before the text that says how the flight ended, which a program did or others; no line of JSON begins with them.
constexpr char program_mark = '!', end_mark = '#';

/// What the other process does.
class Keeping {
 public:
  Keeping(const automata::Document& document, const automata::Scenario& scenario, const ViewPaths& paths, bool quiet)
      : plant_(document.plant_of(scenario)),
        program_(document.programs[scenario.program]),
        recorder_(document, scenario),
        reader_(lines_, "flight", plant_, program_, trace_constraint(plant_)),
        views_(paths, plant_, program_),
        quiet_(quiet) {}

  /// Until nothing more comes.
  void keep(int socket) {
    using Clock = std::chrono::steady_clock;
    constexpr auto least = std::chrono::milliseconds(200);
    Clock::time_point next = Clock::now();
    for (bool open = true; open;) {
      const auto wait = std::chrono::ceil<std::chrono::milliseconds>(next - Clock::now()).count();
      pollfd input{socket, POLLIN, 0};
      const int ready = ::poll(&input, 1, !dirty_ ? -1 : static_cast<int>(std::max<std::int64_t>(wait, 0)));
      if (ready > 0) open = take(socket);
      if (!dirty_ || !open || Clock::now() < next) continue;
      const Clock::time_point begin = Clock::now();
      write();
      next = Clock::now() + std::max<Clock::duration>(9 * (Clock::now() - begin), least);
    }
    write();
  }

 private:
  /// False where the other end is closed, and all of it was read.
  bool take(int socket) {
    std::array<char, 1U << 16> block;
    const ssize_t count = ::read(socket, block.data(), block.size());
    if (count < 0) return errno == EINTR || errno == EAGAIN;
    if (count == 0) return false;
    rest_.append(block.data(), static_cast<std::size_t>(count));
    for (std::size_t end = rest_.find('\n'); end != std::string::npos; end = rest_.find('\n')) {
      take_line(rest_.substr(0, end));
      rest_.erase(0, end + 1);
    }
    return true;
  }

  void take_line(const std::string& line) {
    dirty_ = true;
    if (line.starts_with(end_mark) || line.starts_with(program_mark)) {
      summary_ = line.substr(1);
      if (line.starts_with(program_mark)) result_.ended = result_.time;
      return;
    }
    lines_.clear();
    lines_.str(line + "\n");
    while (const runtime::CycleRecord* record = reader_.next()) {
      recorder_.observe(*record);
      result_.cycles = record->cycle;
      result_.time = record->time;
    }
  }

  void write() {
    dirty_ = false;
    runtime::Flight flight = recorder_.so_far(result_);
    flight.verdict.clear();
    flight.seed.reset();
    flight.summary = summary_.empty() ? "up to " + runtime::moment(result_.time) : summary_;
    views_.write(flight, quiet_);
  }

  const automata::Plant& plant_;
  const automata::Program& program_;
  runtime::Recorder recorder_;
  std::istringstream lines_;
  runtime::TraceReader reader_;
  Views views_;
  bool quiet_;
  std::string rest_;
  std::string summary_;
  runtime::ScenarioResult result_;
  bool dirty_ = false;
};

/// Away from the terminal and its signals; only standard error stays, for what is missing.
void go_apart() {
  ::setsid();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU}) std::signal(signal, SIG_IGN);
  const int nothing = ::open("/dev/null", O_RDWR | O_CLOEXEC);
  ::dup2(nothing, STDIN_FILENO);
  ::dup2(nothing, STDOUT_FILENO);
}

[[noreturn]] void be_keeper(int socket, const automata::Document& document, const automata::Scenario& scenario,
                            const ViewPaths& paths, bool quiet) noexcept {
  int status = 1;
  try {
    go_apart();
    Keeping(document, scenario, paths, quiet).keep(socket);
    status = 0;
  } catch (const std::exception& error) {
    tell(error.what());
  }
  std::_Exit(status);
}

}  // namespace

ViewKeeper::ViewKeeper(const automata::Document& document, const automata::Scenario& scenario, const ViewPaths& paths,
                       bool quiet)
    : trace_(
          document.plant_of(scenario), document.programs[scenario.program],
          [this](std::string_view line) { send(line); }, runtime::TraceDetail::beliefs) {
  const Views tried(paths, document.plant_of(scenario), document.programs[scenario.program]);
  std::array<int, 2> ends{};
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw base::InputError(std::string("the views cannot be kept: ") + std::strerror(errno));
  constexpr int room = 1 << 22;
  ::setsockopt(ends[0], SOL_SOCKET, SO_SNDBUF, &room, sizeof room);
  keeper_ = ::fork();
  if (keeper_ == 0) {
    ::close(ends[0]);
    be_keeper(ends[1], document, scenario, paths, quiet);
  }
  const int reason = errno;
  ::close(ends[1]);
  socket_ = ends[0];
  if (keeper_ > 0) return;
  ::close(socket_);
  throw base::InputError(std::string("the views cannot be kept: ") + std::strerror(reason));
}

ViewKeeper::~ViewKeeper() {
  if (socket_ >= 0) await();
}

void ViewKeeper::send(std::string_view text) {
  while (!text.empty()) {
    const ssize_t sent = ::send(socket_, text.data(), text.size(), MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent < 0) return;  // it has ended, and `finish` says so
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
}

void ViewKeeper::finish(const std::string& summary, bool ended) {
  std::string line(1, ended ? program_mark : end_mark);
  for (const char c : summary) line += c == '\n' ? ' ' : c;
  send(line.substr(0, line.find_last_not_of(' ') + 1) + "\n");
  if (await() != 0) throw base::InputError("the views of the flight could not be written");
}

/// Closes the socket; the status of the other process.
int ViewKeeper::await() noexcept {
  ::close(socket_);
  socket_ = -1;
  int status = 0;
  while (::waitpid(keeper_, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace rmpl::tools
