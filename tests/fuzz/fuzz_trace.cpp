// Fuzzes the readers of traces and witnesses, of those that are stepped through and of those that views are made of:
// they refuse with a message, or can be gone through. SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "compiler/session/compiler.hpp"
#include "runtime/executive/step/trace_steps.hpp"
#include "runtime/executive/trace/trace_reader.hpp"
#include "runtime/report/recorder.hpp"
#include "tests/paths.hpp"

using namespace rmpl;

namespace {

const automata::Document& mission() {
  static const std::vector<std::string> paths{rmpl::paths::source() + "/examples/safe-mode/safe_mode.rmpl",
                                              rmpl::paths::source() + "/examples/safe-mode/satellite.tcca"};
  static const compiler::Compilation compiled = compiler::compile(paths);
  return compiled.document();
}

/// As views are made of it.
void record(const std::string& text, const automata::Document& document) {
  const automata::Plant& plant = document.plants.front();
  automata::Scenario scenario;
  runtime::Recorder recorder(document, scenario);
  std::istringstream in(text);
  const auto constraint = [](const std::string&) { return automata::constant(true); };
  try {
    runtime::TraceReader reader(in, "run.jsonl", plant, document.programs.front(), constraint);
    runtime::ScenarioResult result;
    while (const runtime::CycleRecord* record = reader.next()) {
      if (record->time < result.time || record->start > record->time) std::abort();
      result.time = record->time;
      recorder.observe(*record);
    }
    if (recorder.finish(result).plant != &plant) std::abort();
  } catch (const base::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const automata::Document& document = mission();
  record(text, document);
  try {
    runtime::TraceSteps steps(document.plants.front(), document.programs.front(), text, "run.jsonl");
    automata::Ticks before = steps.time();
    do {
      if (to_text(steps.stop(), {}).empty() || steps.time() < before) std::abort();
      before = steps.time();
    } while (steps.advance([](const runtime::CycleRecord&, bool) {}));
  } catch (const base::InputError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
