// The files of a new project: written beside, and given their name once all are there.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/new_project.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "base/error.hpp"
#include "base/output_file.hpp"
#include "base/temporary_folder.hpp"
#include "base/utf8.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;

struct NewFile {
  const char* name;
  std::string_view text;
};

constexpr std::string_view manifest =
    R"(# What belongs together, and how it is tested: see rmpl.toml(5). `rmplc test` does it.

[project]
name = @NAME@

[lint]
level = "warning"

[set.fill]
plant = "plant/station.tcca"
program = "program/fill.rmpl"
scenarios = ["scenarios/*.scn"]
properties = ["properties/*.props"]

[rmplc.test]
time-limit = "60 s"
)";

constexpr std::string_view plant = R"(// A pump that runs while a switch gives it power.

component Switch {
  input  cmd   : { none, on, off };
  output power : { off, on };

  initial open;
  mode  open   { power = off };
  mode  closed { power = on } reward -1;  // the executive opens it when nothing needs it
  fault stuck  { power = off } reward -10;

  open   -> closed when cmd = on;
  open   -> stuck  when cmd = on with 0.01;
  closed -> open   when cmd = off;
}

component Pump {
  input  power : { off, on };
  output flow  : { zero, full };

  initial off;
  mode  off      { flow = zero };
  mode  starting { flow = zero };
  mode  running  { flow = full };
  fault broken   { flow = zero } reward -20;

  off      -> starting when power = on;
  starting -> running  when power = on in [2 s, 4 s];
  starting, running -> off when power = off;
  running  -> broken   with rate 0.01 /h;
}

plant Station {
  switch : Switch;
  pump   : Pump;

  switch.power = pump.power;

  control switch.cmd default none;
  observe switch.power, pump.flow;
}
)";

constexpr std::string_view program =
    R"(// Runs the pump for ten seconds, or as long as it can, and opens the switch. That the pump needs the switch is not said
// here: it follows from the plant.

Fill() :: {
  do {
    pump = running;
    t = 0;
    do always (pump = running) watching (t >= 10 s)
  } watching (pump = broken | switch = stuck);
  do (switch = open) watching (switch = stuck)
}
)";

constexpr std::string_view scenarios =
    R"(// Flights of the program with a plant that is drawn from the model, and with faults at bad moments.

scenario "the tank is filled" {
  program "../program/fill.rmpl";
  plant   "../plant/station.tcca";
  cycle   0.5 s;
  duration 1 min;
  seed    1;

  expect pump = running within 6 s;
  expect pump = off within 12 s after pump = running;
  expect finished within 30 s;
}

scenario "the switch does not close" {
  program "../program/fill.rmpl";
  plant   "../plant/station.tcca";
  cycle   0.5 s;
  duration 1 min;
  seed    1;

  at 0.5 s fault switch = stuck;

  expect never pump = running;
  expect finished within 5 s;
}

scenario "the pump breaks while it runs" {
  program "../program/fill.rmpl";
  plant   "../plant/station.tcca";
  cycle   0.5 s;
  duration 1 min;
  seed    1;

  at 8 s fault pump = broken;

  expect pump = broken within 9 s;
  expect switch = open within 5 s after pump = broken;
  expect finished within 15 s;
}
)";

constexpr std::string_view properties = R"(// What is so in every run, whatever comes by chance.

property "the pump can run" {
  reach pump = running;
}

property "a stuck switch leaves the pump off" {
  never switch = stuck & pump = running;
  faults 2;
}

property "the program ends, whatever breaks" {
  program terminates;
  faults 1;
}
)";

constexpr std::string_view attributes = R"(# Lines end alike everywhere, as `rmplc format` leaves them.
*.tcca  text eol=lf
*.rmpl  text eol=lf
*.scn   text eol=lf
*.props text eol=lf
*.mon   text eol=lf
)";

constexpr std::array files = {NewFile{"rmpl.toml", manifest},
                              NewFile{"plant/station.tcca", plant},
                              NewFile{"program/fill.rmpl", program},
                              NewFile{"scenarios/fill.scn", scenarios},
                              NewFile{"properties/station.props", properties},
                              NewFile{".gitattributes", attributes}};

/// A text as a string of TOML.
std::string as_toml(const std::string& text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\') result += '\\';
    if (byte < 0x20 || byte == 0x7f) {
      result += std::string("\\u00") + digits[byte / digits.size()] + digits[byte % digits.size()];
    } else {
      result += c;
    }
  }
  return result + "\"";
}

[[noreturn]] void fail(const std::string& folder, int reason) {
  throw base::InputError(folder + ": " + std::strerror(reason));
}

/// Gives a folder the name of the target, with the rights that a new one has.
void keep(base::TemporaryFolder& folder, const fs::path& target) {
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::chmod(folder.path().c_str(), 0777 & ~mask) != 0) fail(target.string(), errno);
  if (::renameat2(AT_FDCWD, folder.path().c_str(), AT_FDCWD, target.c_str(), RENAME_NOREPLACE) != 0) {
    fail(target.string(), errno);
  }
  folder.release();
}

}  // namespace

void make_project(const std::string& folder) {
  std::error_code error;
  fs::path target = fs::path(folder).lexically_normal();
  if (!target.has_filename()) target = target.parent_path();  // `demo/`
  const std::string name = target.filename().string();
  if (name.empty() || name == "." || name == "..") throw base::InputError("'" + folder + "' is no name for a project");
  for (std::string_view rest = name; !rest.empty();) {
    const std::size_t length = base::code_point_length(rest);
    if (length == 0) throw base::InputError(folder + ": expected a name in UTF-8");
    rest.remove_prefix(length);
  }
  if (fs::exists(fs::symlink_status(target, error))) throw base::InputError(folder + ": this exists already");
  base::TemporaryFolder draft = base::TemporaryFolder::beside(target);
  for (const NewFile& file : files) {
    const fs::path path = draft.path() / file.name;
    fs::create_directories(path.parent_path(), error);
    if (error) fail(folder, error.value());
    std::string text(file.text);
    if (const std::size_t at = text.find("@NAME@"); at != std::string::npos) text.replace(at, 6, as_toml(name));
    base::write_file(path.string(), text);
  }
  keep(draft, target);
}

}  // namespace rmpl::tools
