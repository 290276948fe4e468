// Line by line; printed when all of it was drawn.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/scenario_model.hpp"

#include <optional>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "base/limit_error.hpp"
#include "runtime/executive/plant/simulated_model.hpp"
#include "runtime/executive/trace/json_line.hpp"
#include "runtime/executive/trace/log.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

using automata::ModelProgram;
using automata::Ticks;
using runtime::LogLine;

namespace {

class ModelFlight {
 public:
  ModelFlight(const ModelProgram& program, std::uint64_t seed) : program_(program), plant_(program, seed) {
    tell({}, nullptr);
  }

  /// The start is told already. An interruption within the line ends it.
  void fly(const LogLine& line) {
    if (!begun_ && line.timed && line.is_of_start()) return;
    for (std::uint64_t i = 1; i <= line.unchanged; ++i) {
      if (interrupted()) return;
      step(before_, line.time_of_unchanged(i));
    }
    step(line, line.time);
    before_ = line;
  }

  [[nodiscard]] const std::string& log() const { return log_; }

 private:
  void step(const LogLine& told, Ticks time) {
    begun_ = true;
    plant_.step(automata::command_from(program_, told.command));
    tell(time, &told);
  }

  void tell(Ticks time, const LogLine* told) {
    json_.clear();
    json_.open('{').key("time").seconds(time);
    if (told != nullptr) json_.key("command").assignments(told->command, program_.variables);
    json_.key("observations").assignments(plant_.read(), program_.variables);
    json_.key("marking").open('[');
    for (const automata::LocationId l : plant_.marking()) json_.number(l.value + 1);
    json_.close(']').key("truth").assignments(plant_.values(), program_.variables).close('}');
    log_ += json_.text() + "\n";
  }

  const ModelProgram& program_;
  runtime::SimulatedModel plant_;
  runtime::JsonLine json_;
  bool begun_ = false;  ///< a step was taken
  LogLine before_;
  std::string log_;
};

}  // namespace

ExitStatus fly_model(const ModelProgram& program, const std::string& paths, const std::string& commands,
                     std::uint64_t seed) {
  base::InputFile input(commands, interrupted);
  runtime::LogReader reader(input.stream(), input.name(), program);
  std::optional<ModelFlight> flight;
  try {
    flight.emplace(program, seed);
  } catch (const base::InputError&) {
    refuse_start(program, paths);
  }
  while (!interrupted()) {
    const auto line = reader.next();
    if (!line) break;
    const std::string where = input.name() + ":" + std::to_string(line->number) + ": ";
    if (!line->observations.empty()) {
      throw base::InputError(where + "the simulation draws the readings: give commands without observations");
    }
    try {
      flight->fly(*line);
    } catch (const base::InputError& error) {
      throw base::InputError(where + error.what());
    } catch (const base::LimitError& error) {
      throw base::LimitError(where + error.what());
    }
  }
  print_json(flight->log());
  return interrupted() ? ExitStatus::undecided : ExitStatus::done;
}

}  // namespace rmpl::tools
