// Fuzzes the reader of CSV logs: it refuses with a message, or reads lines whose times never fall.
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/monitors.hpp"
#include "runtime/executive/trace/csv_log.hpp"
#include "runtime/executive/trace/measured_log.hpp"
#include "tests/paths.hpp"

using namespace rmpl;

namespace {

const automata::Plant& rig() {
  static const std::vector<std::string> paths{rmpl::paths::source() + "/examples/telemetry/pump.tcca"};
  static const compiler::Compilation compiled = compiler::compile(paths);
  return compiled.document().plants.front();
}

const std::vector<automata::Monitor>& rig_monitors() {
  static grammar::Findings findings;
  static const auto compiled =
      compiler::compile_monitors(rmpl::paths::source() + "/examples/telemetry/pump.mon", rig(), findings);
  return *compiled;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    std::istringstream in(std::string(reinterpret_cast<const char*>(data), size));
    runtime::Monitors monitors(rig_monitors());
    const runtime::CsvLogOptions options{std::nullopt, {}, {.from_first = true, .origin = {}}};
    runtime::CsvLog lines(in, "log.csv", rig(), monitors, options);
    runtime::MeasuredLog log(lines, monitors);
    automata::Ticks before;
    while (const auto line = log.next()) {
      if (line->time < before) std::abort();
      before = line->time;
    }
  } catch (const base::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
