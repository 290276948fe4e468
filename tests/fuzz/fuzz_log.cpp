// Fuzzes the reader of logs, with a plant's names and with names as they come: it refuses with a message, or reads.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "compiler/session/compiler.hpp"
#include "runtime/executive/trace/log.hpp"
#include "tests/paths.hpp"

using namespace rmpl;

namespace {

const automata::Plant& lander() {
  static const std::vector<std::string> paths{rmpl::paths::source() + "/examples/mars-entry/mars_lander.tcca"};
  static const compiler::Compilation compiled = compiler::compile(paths);
  return compiled.document().plants.front();
}

template <class Names>
void read(const std::string& text, Names& names) {
  try {
    std::istringstream in(text);
    runtime::read_log(in, "log.jsonl", names);
  } catch (const base::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
}

/// As the log of a plant is read: odd samples are left out, and counted.
void read_leaving_out(const std::string& text) {
  try {
    std::istringstream in(text);
    runtime::LogReader reader(in, "log.jsonl", lander());
    reader.read_times({.from_first = true, .origin = {}}, runtime::LogReader::OddSamples::left_out);
    automata::Ticks before;
    while (const auto line = reader.next()) {
      if (line->time < before) std::abort();
      before = line->time;
    }
  } catch (const base::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  read(text, lander());
  automata::Variables names;
  read(text, names);
  read_leaving_out(text);
  return 0;
}
