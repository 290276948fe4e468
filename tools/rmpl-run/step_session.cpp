// A table of verbs, and what each does.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/step_session.hpp"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <utility>

#include "automata/time/time.hpp"
#include "base/error.hpp"
#include "base/utf8.hpp"
#include "runtime/executive/scenario/moment.hpp"
#include "tools/rmpl-run/step_choice.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/models.hpp"
#include "tools/shared/suggestion.hpp"

namespace rmpl::tools {
namespace {

using runtime::Prospect;

std::string trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r";
  const auto first = text.find_first_not_of(space);
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(space) - first + 1));
}

std::vector<std::string> words_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

bool is_number(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

/// A number of steps; `otherwise` where nothing is said.
std::uint64_t count_of(const std::string& text, const char* verb, std::uint64_t otherwise) {
  if (text.empty()) return otherwise;
  std::uint64_t count = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), count);
  if (failure != std::errc() || end != text.data() + text.size() || count == 0) {
    throw base::InputError(std::string(verb) + ": expected a number of cycles, not '" + text + "'");
  }
  return count;
}

void expect_nothing(const std::string& rest, const char* verb) {
  if (!rest.empty()) throw base::InputError(std::string(verb) + ": expected nothing behind it, not '" + rest + "'");
}

}  // namespace

const std::vector<StepSession::Verb>& StepSession::verbs() {
  static const std::vector<Verb> all{
      {"next", 'n', "[N]", "one cycle, or N; so does an empty line", &StepSession::next},
      {"to", 't', "TIME", "forward or back to the last cycle that ends by this time: to 10 s", &StepSession::to},
      {"until", 'u', "[truth] φ", "forward until φ holds at the end of a cycle: until surprise", &StepSession::until},
      {"back", 'b', "[N]", "back by one cycle, or N; later choices are undone", &StepSession::back},
      {"fault", 'f', "c = m", "the component is in this mode at the end of the cycle", &StepSession::fault},
      {"command", 'c', "x = v", "this command replaces that of the executive in the cycle", &StepSession::command},
      {"observe", 'o', "x = v [for T]", "the sensor reads this from the end of the cycle on", &StepSession::observe},
      {"goal", 'g', "[φ|none]", "from now on only φ is the goal; without φ: show the goals", &StepSession::goal},
      {"why", 'w', "", "the reasons for the command, conflicts, surprises and diagnoses", &StepSession::why},
      {"show", 's', "", "show the current state again", &StepSession::show},
      {"save", '\0', "NAME.scn", "write a scenario that flies the same run", &StepSession::save},
      {"help", 'h', "", "this list", &StepSession::help},
      {"quit", 'q', "", "end the session", &StepSession::quit}};
  return all;
}

const StepSession::Verb& StepSession::verb_of(const std::string& word) {
  std::vector<std::string_view> names;
  std::vector<const Verb*> begun;
  for (const Verb& verb : verbs()) {
    const std::string_view name = verb.name;
    if (name == word || (word.size() == 1 && word.front() == verb.letter)) return verb;
    if (name.starts_with(word)) begun.push_back(&verb);
    names.push_back(name);
  }
  if (begun.size() == 1) return *begun.front();
  if (begun.size() > 1) {
    std::string text;
    for (const Verb* verb : begun) text += (text.empty() ? "'" : " or '") + std::string(verb->name) + "'";
    throw base::InputError("'" + word + "' can be " + text);
  }
  throw base::InputError("no command is called '" + word + "'" + suggestion_or_list(word, names));
}

StepSession::StepSession(StepModel& model, const std::string& trace, const std::string& trace_name,
                         const Common& common)
    : model_(model), common_(common), painter_(output_painter(common.color)), run_(nullptr) {
  if (trace_name.empty()) {
    flight_ = model.fly();
    run_ = flight_.get();
  } else {
    trace_ = std::make_unique<runtime::TraceSteps>(model.plant(), model.program(), trace, trace_name);
    run_ = trace_.get();
  }
}

void StepSession::greet() { show_stop(); }

bool StepSession::obey(const std::string& line) {
  std::string text = trimmed(line);
  if (text.starts_with("//")) return true;
  const std::vector<std::string> words = words_of(text);
  if (words.empty()) {
    next({});
  } else if (std::all_of(words.begin(), words.end(), is_number)) {
    choose(words);
  } else {
    const std::string& word = words.front();
    const Verb& verb = verb_of(word);
    (this->*verb.run)(trimmed(std::string_view(text).substr(word.size())));
  }
  return !quit_;
}

std::vector<std::string> StepSession::words() const {
  std::vector<std::string> result;
  for (const Verb& verb : verbs()) result.emplace_back(verb.name);
  const automata::Plant& plant = run_->plant();
  for (std::size_t v = 0; v < plant.variables.size(); ++v) {
    const automata::Variable& variable = plant.variables[automata::VariableId(v)];
    result.push_back(variable.name);
    result.insert(result.end(), variable.values.begin(), variable.values.end());
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

runtime::FlightSteps& StepSession::flight(const char* what) {
  if (flight_) return *flight_;
  throw base::InputError(std::string(what) + ": a recorded trace has no choices");
}

void StepSession::tell_story() {
  for (const std::string& line : run_->take_story()) print(line + "\n");
}

void StepSession::show_stop() {
  if (common_.quiet) return;
  const runtime::Stop stop = run_->stop();
  std::string text = to_text(stop, painter_);
  if (flight_ && !stop.over) {
    text += to_text(run_->ahead(), run_->plant(), run_->time(), run_->next_time(), painter_);
  }
  print(text);
}

bool StepSession::go_on(const std::function<bool()>& enough, const runtime::SteppedRun::Look& look) {
  while (!interrupted()) {
    const bool on = run_->advance(look);
    tell_story();
    if (!on) return false;
    if (enough()) return true;
  }
  return false;
}

void StepSession::next(const std::string& rest) {
  std::uint64_t left = count_of(rest, "next", 1);
  const std::uint64_t before = run_->position();
  go_on([&] { return --left == 0; }, nullptr);
  if (run_->position() == before && !interrupted()) throw base::InputError("next: the run has ended");
  show_stop();
}

void StepSession::to(const std::string& rest) {
  const auto time = automata::parse_duration(rest);
  if (!time || time->is_infinite()) {
    throw base::InputError("to: expected a time since the start, such as 10 s, not '" + rest + "'");
  }
  if (*time < run_->time()) {
    std::uint64_t position = run_->position();
    if (flight_) {
      position = static_cast<std::uint64_t>(time->count / flight_->scenario().cycle.count);
      go_to(position);
    } else {
      while (position > 0 && run_->time() > *time) run_->go_back_to(--position);
    }
  } else if (run_->next_time() <= *time) {
    go_on([&] { return run_->next_time() > *time; }, nullptr);
  }
  show_stop();
}

void StepSession::until(const std::string& rest) {
  std::string text = rest;
  bool truth = false;
  const std::vector<std::string> words = words_of(rest);
  if (words.size() > 1 && words.front() == "truth" && words[1] != "=" && words[1] != "!=") {
    truth = true;
    text = trimmed(std::string_view(rest).substr(words.front().size()));
  }
  if (text.empty()) throw base::InputError("until: expected a condition, such as engine = standby");
  if (truth && run_->stop().truth.empty()) {
    throw base::InputError("until truth: this trace does not record the truth; ask the estimate");
  }
  const automata::Formula formula = truth ? formula_option(text, run_->plant(), "until", common_)
                                          : program_formula_option(text, run_->plant(), "until", common_);
  if (const std::string why = run_->cannot_answer(formula); !why.empty()) throw base::InputError("until: " + why);
  runtime::Watch watch(*run_, formula, truth);
  bool holds = false;
  const bool found = go_on([&] { return holds; },
                           [&](const runtime::CycleRecord& record, bool ended) { holds = watch.holds(record, ended); });
  if (!found && !interrupted()) print("the run has ended, but " + text + " did not come true\n");
  show_stop();
}

void StepSession::go_to(std::uint64_t position) {
  if (flight_ && model_.forget_goals_after(position)) {
    reopen(position);
  } else {
    run_->go_back_to(position);
  }
}

/// The document is another one: the flight is flown again.
void StepSession::reopen(std::uint64_t position) {
  std::vector<runtime::Choice> choices = flight_->choices();
  std::erase_if(choices, [&](const runtime::Choice& choice) { return choice.cycle >= position; });
  flight_ = model_.fly(std::move(choices));
  run_ = flight_.get();
  while (run_->position() < position && run_->advance(nullptr)) {
  }
  (void)run_->take_story();
}

void StepSession::back(const std::string& rest) {
  const std::uint64_t count = count_of(rest, "back", 1);
  const std::uint64_t position = run_->position();
  if (position == 0) throw base::InputError("back: this is where the run starts");
  go_to(position - std::min(position, count));
  show_stop();
}

void StepSession::goal(const std::string& rest) {
  runtime::FlightSteps& flown = flight("goal");
  if (rest.empty()) {
    const auto asked = model_.asked();
    print(asked ? (asked->empty() ? "no goals\n" : "goals set by hand: " + *asked + "\n")
                : "the program '" + flown.program().name + "' asserts the goals\n");
    return;
  }
  const std::uint64_t position = flown.position();
  model_.ask_for(rest == "none" ? "" : rest, flown.time(), position);
  reopen(position);
  show_stop();
}

void StepSession::choose(const std::vector<std::string>& numbers) {
  runtime::FlightSteps& flown = flight("a choice");
  const std::vector<Prospect> all = flown.ahead();
  std::vector<Prospect> open;
  std::copy_if(all.begin(), all.end(), std::back_inserter(open), runtime::can_be_chosen);
  std::vector<Prospect> chosen;
  for (const std::string& text : numbers) {
    const std::uint64_t number = text.size() > 9 ? 0 : count_of(text, "a choice", 0);
    if (number == 0 || number > open.size()) {
      throw base::InputError("'" + text + "': expected a number from 1 to " + std::to_string(open.size()));
    }
    const Prospect& prospect = open[number - 1];
    const bool moves = prospect.kind != Prospect::Kind::command;
    if (moves && !flown.has_truth()) {
      throw base::InputError("'" + text +
                             "': the plant is declared 'rules only' and has no modes: choose readings, with observe");
    }
    const auto twice = std::find_if(chosen.begin(), chosen.end(), [&](const Prospect& other) {
      return other.what.variable == prospect.what.variable;
    });
    if (twice != chosen.end())
      throw base::InputError("'" + text + "': '" + run_->plant().variables.name(prospect.what.variable) +
                             "' is chosen twice");
    chosen.push_back(prospect);
  }
  for (const Prospect& prospect : chosen) {
    if (prospect.component) {
      flown.force(*prospect.component, automata::ModeId(prospect.what.value.index()));
    } else {
      flown.command(prospect.what);
    }
  }
  next({});
}

void StepSession::fault(const std::string& rest) {
  choose_fault(flight("fault"), rest, common_);
  next({});
}

void StepSession::command(const std::string& rest) {
  choose_command(flight("command"), rest, common_);
  next({});
}

void StepSession::observe(const std::string& rest) {
  choose_reading(flight("observe"), rest, common_);
  next({});
}

void StepSession::why(const std::string& rest) {
  expect_nothing(rest, "why");
  print(why_text(run_->stop(), painter_));
}

void StepSession::show(const std::string& rest) {
  expect_nothing(rest, "show");
  show_stop();
}

void StepSession::save(const std::string& rest) {
  runtime::FlightSteps& flown = flight("save");
  if (rest.empty()) throw base::InputError("save: expected the name of a scenario, NAME.scn");
  std::string names;
  for (const std::string& name : model_.save(rest, flown)) names += (names.empty() ? "" : " and ") + name;
  print("written: " + names + "\n");
}

void StepSession::help(const std::string& rest) {
  expect_nothing(rest, "help");
  std::string text;
  const auto add = [&](std::string left, const char* meaning) {
    constexpr std::size_t column = 24;
    const std::size_t size = base::code_points(left);
    left.append(size < column ? column - size : 1, ' ');
    text += "  " + left + meaning + "\n";
  };
  add("NUMBER ...", "choose events by their numbers, one or several, and go forward by one cycle");
  for (const Verb& verb : verbs()) {
    add(std::string(verb.name) + (*verb.arguments == '\0' ? "" : std::string(" ") + verb.arguments), verb.meaning);
  }
  print(text + "Commands may be abbreviated: n, b 3, u surprise. A line that begins with // is a comment.\n");
}

void StepSession::quit(const std::string& rest) {
  expect_nothing(rest, "quit");
  quit_ = true;
}

}  // namespace rmpl::tools
