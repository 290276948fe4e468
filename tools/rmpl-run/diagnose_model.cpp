// A line a diagnosis, or one object of JSON.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/diagnose_model.hpp"

#include <sstream>
#include <string>

#include "runtime/executive/cycle/stopwatch.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/reasoning/diagnose/model_diagnosis.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

using runtime::JsonLine;
using runtime::ModelDiagnoses;
using runtime::ModelDiagnosis;

std::string as_json(const automata::ModelProgram& program, const ModelDiagnoses& found, double seconds) {
  JsonLine json;
  json.open('{').key("diagnoses").open('[');
  for (const ModelDiagnosis& diagnosis : found.diagnoses) {
    json.open('{').key("probability").number(diagnosis.probability).key("markings").open('[');
    for (const automata::Marking& marking : diagnosis.faults) {
      json.open('[');
      for (const automata::LocationId l : marking) json.number(l.value + 1);
      json.close(']');
    }
    json.close(']').key("values").assignments(diagnosis.values, program.variables).close('}');
  }
  json.close(']').key("count").number(found.diagnoses.size()).key("checked").number(found.checked);
  json.key("seconds").number(seconds).close('}');
  return std::string(json.text()) + "\n";
}

std::string in_words(const automata::Marking& marking, const automata::ModelProgram& program) {
  std::string text;
  for (const automata::LocationId l : marking) {
    const automata::ModelLocation& location = program.locations[l.index()];
    text += (text.empty() ? "" : ", ") + location.label + automata::in_brackets(location.origin);
  }
  return text.empty() ? "a thread has ended" : text;
}

std::string as_text(const automata::ModelProgram& program, const ModelDiagnoses& found) {
  if (found.diagnoses.empty())
    return "no diagnosis: the observations contradict every combination of markings of the threads\n";
  std::string text;
  for (const ModelDiagnosis& diagnosis : found.diagnoses) {
    JsonLine number;
    number.number(diagnosis.probability);
    std::string line(number.text());
    constexpr std::size_t column = 24;
    line.append(line.size() < column ? column - line.size() : 0, ' ');
    if (diagnosis.faults.empty()) line += " nothing improbable";
    for (std::size_t f = 0; f < diagnosis.faults.size(); ++f) {
      line += (f == 0 ? " " : "; ") + in_words(diagnosis.faults[f], program);
    }
    text += line + "\n";
  }
  return text;
}

}  // namespace

ExitStatus diagnose_model(const automata::ModelProgram& program, const std::string& path,
                          const automata::Observation& observation, std::size_t k, double ratio, bool stats,
                          const Common& common) {
  const runtime::Stopwatch stopwatch;
  const ModelDiagnoses found = runtime::diagnose(program, observation, k, ratio);
  if (!found.starts) refuse_start(program, path);
  const double seconds = stopwatch.seconds();
  common.format == Format::json ? print_json(as_json(program, found, seconds)) : print(as_text(program, found));
  if (stats || common.verbose) {
    std::ostringstream cost;
    cost << found.checked << " candidates checked in " << seconds << " s\n";
    print_error(cost.str());
  }
  return ExitStatus::done;
}

}  // namespace rmpl::tools
