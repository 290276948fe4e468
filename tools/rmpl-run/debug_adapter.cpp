// Requests to a flight that is stepped through.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/debug_adapter.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "tools/rmpl-run/debug_scopes.hpp"
#include "tools/shared/frame_input.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/program.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

using automata::Json;

namespace {

constexpr int the_thread = 1;
/// Cycles until the client is listened to again.
constexpr int cycles_at_once = 64;

std::string text_of(const Json& message) { return message.dump(-1, ' ', false, Json::error_handler_t::replace); }

std::optional<automata::Ticks> time_argument(const Json& arguments, const char* key) {
  const auto at = arguments.find(key);
  if (at == arguments.end() || at->is_null()) return std::nullopt;
  const auto time = at->is_number()   ? automata::ticks_from_seconds(at->get<double>())
                    : at->is_string() ? automata::parse_duration(at->get<std::string>())
                                      : std::nullopt;
  if (!time || *time <= automata::Ticks{} || time->is_infinite()) {
    throw base::InputError(std::string("`") + key + "`: expected a duration above 0, such as 0.5 or \"500 ms\"");
  }
  return time;
}

const Json& list_argument(const Json& arguments, const char* key) {
  static const Json none = Json::array();
  const auto at = arguments.find(key);
  if (at == arguments.end() || at->is_null()) return none;
  if (!at->is_array()) throw base::InputError(std::string("`") + key + "`: expected an array");
  return *at;
}

StepOptions options_of(const Json& arguments) {
  StepOptions options;
  const auto program = text_argument(arguments, "program");
  const auto plant = text_argument(arguments, "plant");
  const auto scenario = text_argument(arguments, "scenario");
  if (program && program->ends_with(".scn") && !plant && !scenario) {
    options.files = {*program};
  } else if (scenario) {
    if (program || plant) throw base::InputError("`scenario`: it names its program and plant");
    options.files = {*scenario};
  } else {
    if (!plant) throw base::InputError("expected a `plant`, a .tcca file, or a `scenario`");
    if (program) options.files.push_back(*program);
    options.files.push_back(*plant);
  }
  options.only = text_argument(arguments, "only").value_or("");
  if (const auto monitors = text_argument(arguments, "monitors")) options.monitors = {*monitors};
  options.main = text_argument(arguments, "main").value_or("");
  options.cycle = time_argument(arguments, "cycle");
  options.duration = time_argument(arguments, "duration");
  if (const auto seed = arguments.find("seed"); seed != arguments.end() && !seed->is_null()) {
    if (!seed->is_number_unsigned()) throw base::InputError("`seed`: expected a whole number");
    options.seed = seed->get<std::uint64_t>();
  }
  return options;
}

}  // namespace

DebugAdapter::DebugAdapter(runtime::ScenarioOptions engines, const Common& common, Send send)
    : engines_(std::move(engines)), common_(common), send_(std::move(send)) {}

const std::vector<DebugAdapter::Entry>& DebugAdapter::handlers() {
  static const std::vector<Entry> all{{"initialize", &DebugAdapter::initialize},
                                      {"launch", &DebugAdapter::launch},
                                      {"configurationDone", &DebugAdapter::configuration_done},
                                      {"setBreakpoints", &DebugAdapter::set_breakpoints},
                                      {"setFunctionBreakpoints", &DebugAdapter::set_function_breakpoints},
                                      {"setExceptionBreakpoints", &DebugAdapter::set_exception_breakpoints},
                                      {"dataBreakpointInfo", &DebugAdapter::data_breakpoint_info},
                                      {"setDataBreakpoints", &DebugAdapter::set_data_breakpoints},
                                      {"threads", &DebugAdapter::threads},
                                      {"stackTrace", &DebugAdapter::stack_trace},
                                      {"scopes", &DebugAdapter::scopes},
                                      {"variables", &DebugAdapter::variables},
                                      {"evaluate", &DebugAdapter::evaluate},
                                      {"continue", &DebugAdapter::go_on},
                                      {"next", &DebugAdapter::next},
                                      {"stepIn", &DebugAdapter::next},
                                      {"stepOut", &DebugAdapter::next},
                                      {"stepBack", &DebugAdapter::step_back},
                                      {"reverseContinue", &DebugAdapter::reverse_continue},
                                      {"pause", &DebugAdapter::pause},
                                      {"terminate", &DebugAdapter::disconnect},
                                      {"disconnect", &DebugAdapter::disconnect}};
  return all;
}

void DebugAdapter::receive(const Frame& frame) {
  if (!frame.wrong.empty()) return tell(frame.wrong);
  const Json message = Json::parse(frame.message, nullptr, false);
  if (message.is_discarded() || !message.is_object()) return tell("a message that is no JSON object is passed over");
  if (message.value("type", Json()) != "request") return;  // we ask nothing, so nothing is answered
  answer(message);
  // What an answer brings about comes after it.
  const auto events = std::exchange(afterwards_, {});
  for (const auto& tell_it : events) tell_it();
}

void DebugAdapter::answer(const Json& request) {
  const Json command = request.value("command", Json());
  Json response{{"type", "response"}, {"request_seq", request.value("seq", Json(0))}, {"success", true}};
  response["command"] = command.is_string() ? command : Json("");
  std::string wrong;
  try {
    const auto entry =
        std::find_if(handlers().begin(), handlers().end(), [&](const Entry& one) { return command == one.command; });
    if (entry == handlers().end()) throw base::InputError("no request is called " + text_of(command));
    const auto arguments = request.find("arguments");
    const bool some = arguments != request.end() && arguments->is_object();
    Json body = (this->*entry->handler)(some ? *arguments : Json::object());
    if (!body.is_null()) response["body"] = std::move(body);
  } catch (const base::InputError& error) {
    wrong = error.what();
  } catch (const Rejected& rejected) {
    wrong = rejected.text;
  }
  if (!wrong.empty()) {
    afterwards_.clear();
    response["success"] = false;
    response["message"] = wrong;
    // Braces would stand for variables of the format.
    response["body"] = {
        {"error", {{"id", 1}, {"format", "{reason}"}, {"variables", {{"reason", wrong}}}, {"showUser", true}}}};
  }
  say(std::move(response));
}

void DebugAdapter::say(Json message) {
  message["seq"] = ++sequence_;
  send_(text_of(message));
}

void DebugAdapter::event(const char* name, Json body) {
  say({{"type", "event"}, {"event", name}, {"body", std::move(body)}});
}

void DebugAdapter::stopped(const char* reason, const std::string& text, const std::vector<int>& hit) {
  running_ = false;
  Json body{{"reason", reason}, {"threadId", the_thread}, {"allThreadsStopped", true}};
  if (!text.empty()) body["description"] = body["text"] = text;
  if (!hit.empty()) body["hitBreakpointIds"] = hit;
  event("stopped", std::move(body));
}

/// The run is over: nothing more can come.
void DebugAdapter::finish() {
  running_ = false;
  if (std::exchange(over_, true)) return;
  event("terminated");
  event("exited", {{"exitCode", 0}});
}

runtime::FlightSteps& DebugAdapter::flight() {
  if (!flight_) throw base::InputError("nothing has been launched");
  return *flight_;
}

void DebugAdapter::tell_story() {
  for (const std::string& line : flight_->take_story()) {
    event("output", {{"category", "stdout"}, {"output", line + "\n"}});
  }
}

Json DebugAdapter::initialize(const Json&) {
  Json filters = Json::array();
  filters.push_back(
      {{"filter", "surprise"}, {"label", "Surprise: a reading that nothing explains"}, {"default", true}});
  filters.push_back({{"filter", "noplan"}, {"label", "No plan: a goal that nothing leads to"}, {"default", false}});
  filters.push_back({{"filter", "goal-conflict"}, {"label", "Goals that contradict each other"}, {"default", true}});
  return {{"supportsConfigurationDoneRequest", true}, {"supportsFunctionBreakpoints", true},
          {"supportsDataBreakpoints", true},          {"supportsStepBack", true},
          {"supportsEvaluateForHovers", true},        {"supportsTerminateRequest", true},
          {"exceptionBreakpointFilters", filters}};
}

Json DebugAdapter::launch(const Json& arguments) {
  if (flight_) throw base::InputError("a session launches once");
  StepOptions options = options_of(arguments);
  options.engines = engines_;
  auto model = std::make_unique<StepModel>(std::move(options), common_);
  flight_ = model->fly();
  model_ = std::move(model);
  breakpoints_.bind(*flight_);
  stop_on_entry_ = arguments.value("stopOnEntry", Json(true)) != false;
  // From here on breakpoints can be placed: what they stand on is known.
  afterwards_.emplace_back([this] { event("initialized"); });
  return nullptr;
}

Json DebugAdapter::configuration_done(const Json&) {
  (void)flight();
  afterwards_.emplace_back([this] {
    tell_story();
    const auto hit = breakpoints_.look_at_start();
    if (hit) hit_ = hit->location;
    if (hit && !stop_on_entry_) return stopped(hit->reason, hit->text, hit->ids);
    if (stop_on_entry_) return stopped("entry");
    running_ = true;
  });
  return nullptr;
}

Json DebugAdapter::set_breakpoints(const Json& arguments) {
  (void)flight();
  const auto source = arguments.find("source");
  const auto path = source != arguments.end() && source->is_object() ? text_argument(*source, "path") : std::nullopt;
  if (!path) throw base::InputError("`source`: expected a `path`");
  return {{"breakpoints", breakpoints_.set_lines(*path, list_argument(arguments, "breakpoints"))}};
}

Json DebugAdapter::set_function_breakpoints(const Json& arguments) {
  (void)flight();
  return {{"breakpoints", breakpoints_.set_conditions(list_argument(arguments, "breakpoints"))}};
}

Json DebugAdapter::set_exception_breakpoints(const Json& arguments) {
  breakpoints_.set_reports(list_argument(arguments, "filters"));
  return nullptr;
}

Json DebugAdapter::data_breakpoint_info(const Json& arguments) {
  const std::string name = text_argument(arguments, "name").value_or("");
  const Json reference = arguments.value("variablesReference", Json(0));
  const bool of_truth = reference == static_cast<int>(DebugScope::truth);
  if (!flight().plant().find_component(name)) {
    return {{"dataId", nullptr}, {"description", "'" + name + "' is no component"}};
  }
  return {{"dataId", (of_truth ? "truth " : "") + name},
          {"description", (of_truth ? "when '" : "when the estimate of '") + name + "' changes"},
          {"accessTypes", {"write"}}};
}

Json DebugAdapter::set_data_breakpoints(const Json& arguments) {
  (void)flight();
  return {{"breakpoints", breakpoints_.set_data(list_argument(arguments, "breakpoints"))}};
}

Json DebugAdapter::threads(const Json&) {
  Json all = Json::array();
  all.push_back({{"id", the_thread}, {"name", flight_ ? flight_->program().name : "executive"}});
  return {{"threads", all}};
}

/// One cycle; whether the run goes on after it. Where it stops the client is told.
bool DebugAdapter::step_once() {
  bool advanced = false;
  try {
    advanced = flight_->advance(nullptr);
  } catch (const base::InputError& error) {
    stopped("exception", error.what());
    return false;
  }
  if (!advanced) {
    finish();
    return false;
  }
  tell_story();
  const auto hit = breakpoints_.look(flight_->last(), flight_->ended());
  hit_ = hit ? hit->location : std::nullopt;
  if (hit) {
    stopped(hit->reason, hit->text, hit->ids);
    return false;
  }
  if (flight_->ended() && !std::exchange(told_end_, true)) {
    stopped("pause", "the program has ended");
    return false;
  }
  return true;
}

void DebugAdapter::work() {
  for (int cycle = 0; running_ && cycle < cycles_at_once; ++cycle) {
    step_once();
  }
}

Json DebugAdapter::go_on(const Json&) {
  (void)flight();
  afterwards_.emplace_back([this] { running_ = true; });
  return {{"allThreadsContinued", true}};
}

Json DebugAdapter::next(const Json&) {
  (void)flight();
  running_ = false;
  afterwards_.emplace_back([this] {
    if (step_once()) stopped("step");
  });
  return nullptr;
}

Json DebugAdapter::step_back(const Json&) {
  running_ = false;
  if (flight().position() == 0) throw base::InputError("this is where the run starts");
  flight_->go_back_to(flight_->position() - 1);
  told_end_ = flight_->ended();
  hit_.reset();
  breakpoints_.look_anew();
  afterwards_.emplace_back([this] { stopped("step"); });
  return nullptr;
}

/// Back to the last cycle before this one that a breakpoint would have stopped at, else to the start.
Json DebugAdapter::reverse_continue(const Json&) {
  running_ = false;
  const std::uint64_t here = flight().position();
  if (here == 0) throw base::InputError("this is where the run starts");
  flight_ = model_->fly(flight_->choices());
  breakpoints_.bind(*flight_);
  std::uint64_t target = 0;
  DebugHit last{"entry", {}, {}, std::nullopt};
  while (flight_->position() + 1 < here) {
    if (!flight_->advance(nullptr)) break;
    if (auto hit = breakpoints_.look(flight_->last(), flight_->ended())) {
      target = flight_->position();
      last = *std::move(hit);
    }
  }
  flight_->go_back_to(target);
  (void)flight_->take_story();
  told_end_ = flight_->ended();
  hit_ = last.location;
  breakpoints_.look_anew();
  afterwards_.emplace_back([this, last] { stopped(last.reason, last.text, last.ids); });
  return nullptr;
}

Json DebugAdapter::pause(const Json&) {
  (void)flight();
  afterwards_.emplace_back([this] { stopped("pause"); });
  return nullptr;
}

Json DebugAdapter::disconnect(const Json&) {
  running_ = false;
  afterwards_.emplace_back([this] {
    finish();
    ended_ = true;
  });
  return nullptr;
}

ExitStatus serve_debugger(const runtime::ScenarioOptions& engines, const Common& common) {
  end_at_signals();  // an editor that ends it wants to be told nothing
  DebugAdapter adapter(engines, common, [](const std::string& message) { print_raw(framed(message)); });
  Frames frames;
  bool more = true;
  while (true) {
    while (auto frame = frames.next()) {
      adapter.receive(*frame);
      if (adapter.ended()) return ExitStatus::done;
    }
    if (more && (!adapter.has_work() || input_is_ready())) {
      more = read_some(frames);
    } else if (more && adapter.has_work()) {
      adapter.work();
    } else {
      break;  // the client has gone
    }
  }
  return ExitStatus::violated;
}

}  // namespace rmpl::tools
