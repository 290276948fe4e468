// The debug adapter: editors step through runs (Debug Adapter Protocol 1.68,
// microsoft.github.io/debug-adapter-protocol). SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "automata/json/parse.hpp"
#include "runtime/executive/step/flight_steps.hpp"
#include "tools/rmpl-run/debug_breakpoints.hpp"
#include "tools/rmpl-run/step_model.hpp"
#include "tools/shared/framing.hpp"
#include "tools/shared/options.hpp"

namespace rmpl::tools {

/// One session with one client. A step is a cycle; frames are the marked locations of the program; breakpoints stand on
/// lines of programs, on modes in plants, and on conditions. Messages go out through `send`, without their frames.
class DebugAdapter {
 public:
  using Send = std::function<void(const std::string& message)>;
  /// `engines`: of the flights that are launched.
  DebugAdapter(runtime::ScenarioOptions engines, const Common& common, Send send);

  /// Takes a message, or what was found where one was expected, and answers.
  void receive(const Frame& frame);
  /// Whether the run goes on: then `work` is to be called whenever nothing is to be received.
  [[nodiscard]] bool has_work() const { return running_; }
  /// Some cycles.
  void work();
  /// Whether the client has ended the session.
  [[nodiscard]] bool ended() const { return ended_; }

 private:
  using Json = automata::Json;
  using Handler = Json (DebugAdapter::*)(const Json& arguments);
  struct Entry {
    const char* command;
    Handler handler;
  };
  static const std::vector<Entry>& handlers();

  void answer(const Json& request);
  void say(Json message);
  void event(const char* name, Json body = Json::object());
  void stopped(const char* reason, const std::string& text = {}, const std::vector<int>& hit = {});
  void finish();
  [[nodiscard]] runtime::FlightSteps& flight();
  void tell_story();
  bool step_once();
  bool choose(const std::string& text);

  Json initialize(const Json& arguments);
  Json launch(const Json& arguments);
  Json configuration_done(const Json& arguments);
  Json set_breakpoints(const Json& arguments);
  Json set_function_breakpoints(const Json& arguments);
  Json set_exception_breakpoints(const Json& arguments);
  Json data_breakpoint_info(const Json& arguments);
  Json set_data_breakpoints(const Json& arguments);
  Json threads(const Json& arguments);
  Json stack_trace(const Json& arguments);
  Json scopes(const Json& arguments);
  Json variables(const Json& arguments);
  Json evaluate(const Json& arguments);
  Json go_on(const Json& arguments);
  Json next(const Json& arguments);
  Json step_back(const Json& arguments);
  Json reverse_continue(const Json& arguments);
  Json pause(const Json& arguments);
  Json disconnect(const Json& arguments);

  runtime::ScenarioOptions engines_;
  const Common& common_;
  Send send_;
  std::int64_t sequence_ = 0;
  std::vector<std::function<void()>> afterwards_;  ///< what follows the answer at hand
  std::unique_ptr<StepModel> model_;
  std::unique_ptr<runtime::FlightSteps> flight_;
  DebugBreakpoints breakpoints_;
  std::optional<automata::LocationId> hit_;  ///< the location that stands on top of the frames
  bool stop_on_entry_ = true;
  bool running_ = false;
  bool told_end_ = false;  ///< that the program has ended
  bool over_ = false;      ///< the client has been told that the run is over
  bool ended_ = false;
};

/// Serves one client on standard input and output until it disconnects; `violated` where it goes without.
ExitStatus serve_debugger(const runtime::ScenarioOptions& engines, const Common& common);

}  // namespace rmpl::tools
