// Where the estimate parts from the modes of the witness, readings leave both possible.
// SPDX-License-Identifier: MIT
#include "tools/tcca-check/rehearsal.hpp"

#include <filesystem>
#include <vector>

#include "base/error.hpp"
#include "compiler/session/compiler.hpp"
#include "compiler/session/provider.hpp"
#include "runtime/executive/scenario/run.hpp"
#include "verifier/export/witness_scenario.hpp"

namespace rmpl::tools {
namespace {

/// Looks for the first cycle in which the executive takes something else for the truth than the witness.
class Comparison final : public runtime::CycleObserver {
 public:
  Comparison(const automata::Plant& plant, const verifier::Witness& witness) : plant_(plant), witness_(witness) {}

  void observe(const runtime::CycleRecord& record) override {
    if (record.cycle == 0) return;
    if (!record.consistent && !unexplained_) unexplained_ = record.time;
    if (const automata::Modes* modes = modes_at(record.time)) {
      if (difference_.empty()) difference_ = difference(record, *modes);
    } else if (!agreed_) {
      // What the last event leads to is not known.
      last_difference_ = difference(record, witness_.events[witness_.events.size() - 2].modes);
      agreed_ = last_difference_.empty();
    }
  }
  /// Empty where there is none.
  [[nodiscard]] const std::string& difference() const { return difference_; }
  /// To what the trace comes to, where the executive never takes all of that to be so; empty where the trace goes
  /// round.
  [[nodiscard]] std::string last_difference() const { return witness_.repeats_from ? "" : last_difference_; }
  /// How there can be a difference.
  [[nodiscard]] std::string origin() const {
    if (unexplained_) {
      return "no state that the executive tracks explains the readings at " + automata::format_seconds(*unexplained_) +
             " s";
    }
    return verifier::starts_likely(plant_, witness_) ? "the readings allow both"
                                                     : "it starts in the modes that are most likely there";
  }

 private:
  [[nodiscard]] std::string difference(const runtime::CycleRecord& record, const automata::Modes& modes) const {
    for (std::size_t c = 0; c < modes.size(); ++c) {
      if (modes[c] == record.estimate[c]) continue;
      const automata::Component& component = plant_.components[c];
      return "at " + automata::format_seconds(record.time) + " s the executive takes '" + component.name + "' to be '" +
             component.modes[record.estimate[c].index()].name + "', where the trace has '" +
             component.modes[modes[c].index()].name + "'";
    }
    return "";
  }
  /// Of the trace; null once it is over. What its last event leads to is not known.
  [[nodiscard]] const automata::Modes* modes_at(automata::Ticks time) const {
    const auto& events = witness_.events;
    if (events.back().time < time) return nullptr;
    const automata::Modes* modes = &events.front().modes;
    for (std::size_t e = 1; e + 1 < events.size() && events[e].time <= time; ++e) modes = &events[e].modes;
    return modes;
  }

  const automata::Plant& plant_;
  const verifier::Witness& witness_;
  std::string difference_, last_difference_;
  bool agreed_ = false;                         ///< after the trace, at some time
  std::optional<automata::Ticks> unexplained_;  ///< when readings first contradicted the estimate
};

/// Whether it is violated by something that is there at a time, and not by what does not come.
bool is_at_a_time(verifier::ProgramProperty::Kind kind) {
  using Kind = verifier::ProgramProperty::Kind;
  return kind == Kind::never || kind == Kind::goal_conflict || kind == Kind::no_plan;
}

}  // namespace

std::optional<std::string> rehearse(const std::string& path, const std::string& text, const automata::Plant& plant,
                                    const verifier::ProgramProperty& property, const verifier::Witness& witness,
                                    const std::atomic<bool>* interrupted) {
  compiler::Disk disk;
  compiler::Overlay sources(disk);
  // The file may be of any name and kind; what it says of program and plant is relative to its folder.
  const std::string name = (std::filesystem::absolute(path).lexically_normal().parent_path() / "witness.scn").string();
  sources.put(name, text);
  const std::vector<std::string> paths{name};
  const compiler::Compilation compilation = compiler::compile(paths, {}, sources);
  if (!compilation.ok()) {  // it did, a moment ago
    throw base::InputError("the program and its plant cannot be read again: " +
                           compilation.findings().diagnostics.sorted().front().message);
  }
  Comparison comparison(plant, witness);
  runtime::ScenarioOptions options;
  options.interrupted = [interrupted] { return interrupted != nullptr && interrupted->load(); };
  const automata::Document& document = compilation.document();
  runtime::ScenarioResult result;
  try {
    result = runtime::run_scenario(document, document.scenarios.front(), options, {&comparison});
  } catch (const base::InputError& error) {
    return std::string("the test flight does not end: ") + error.what();
  }
  if (result.interrupted) return "the test flight was interrupted";
  // What is owed after something that never comes is failed too, but not as in the trace.
  const automata::Expectation& expected = document.scenarios.front().expectations.front();
  const bool waits = expected.after.has_value();
  const bool failed = result.verdict() == runtime::Judgement::Verdict::failed;
  if (failed && is_at_a_time(property.kind)) {
    const automata::Ticks found = result.judgements.front().time.value_or(result.time);
    const automata::Ticks shown = witness.events.back().cycle->begin;
    if (found < shown) {
      return "the test flight fails at " + automata::format_seconds(found) + " s, the trace at " +
             automata::format_seconds(shown) + " s: " + comparison.origin();
    }
  }
  const std::string& difference = comparison.difference();
  // A program that has not ended may only be on its way.
  const bool open = expected.kind == automata::Expectation::Kind::finished && !result.ended;
  const std::string left = open ? comparison.last_difference() : "";
  // What is to hold as the program ends is not failed in the same way by one that does not end.
  const bool elsewhere = open && property.kind == verifier::ProgramProperty::Kind::finally;
  if (elsewhere && difference.empty()) return "in the test flight the program does not end";
  // A flight that starts elsewhere, and is not led to where the trace is, fails for a reason of its own.
  const bool strict = waits || !verifier::starts_likely(plant, witness);
  if (failed && left.empty() && !elsewhere && (!strict || difference.empty())) return std::nullopt;
  if (!failed && difference.empty()) return "the test flight meets its expectations";
  // The first difference is where the estimate parts from the trace; later ones follow from it.
  return "the test flight does not fail as the trace does: " + (difference.empty() ? left : difference) + "; " +
         comparison.origin();
}

}  // namespace rmpl::tools
