// A log answered line by line, of plants and of model programs alike.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include "base/error.hpp"
#include "base/input_file.hpp"
#include "runtime/executive/trace/log.hpp"
#include "tools/rmpl-run/log_options.hpp"
#include "tools/rmpl-run/telemetry.hpp"
#include "tools/shared/interruption.hpp"
#include "tools/shared/terminal.hpp"

namespace rmpl::tools {

/// Reads the lines of a log for plant or model program, `names`. A plant is where it is at a time: only what is seen at
/// the start may do without one. Each line of a model program's log is a step.
template <class Names>
class LogOf {
 public:
  LogOf(const std::string& log, const Names& names, const LogOptions& options) : input_(log, interrupted) {
    if constexpr (of_plant) {
      telemetry_ = std::make_unique<Telemetry>(input_, log, names, options);
      source_ = &telemetry_->source();
    } else {
      reader_ = std::make_unique<runtime::LogReader>(input_.stream(), input_.name(), names);
      reader_->read_times(options.times, runtime::LogReader::OddSamples::refused);
      source_ = reader_.get();
    }
  }

  /// The next line; nothing at the end, or once the run is interrupted.
  std::optional<runtime::LogLine> next() {
    if (interrupted()) return std::nullopt;
    auto line = source_->next();
    const bool start = first_ && line && !line->commanded;
    if (of_plant && line && !line->timed && !start) {
      throw base::InputError(name() + ":" + std::to_string(line->number) + ": expected a 'time'");
    }
    first_ = false;
    return line;
  }
  [[nodiscard]] const std::string& name() const { return input_.name(); }

  /// Tells what is odd in the lines so far. The steps of a model program take no time.
  void tell_remarks() {
    if (telemetry_) telemetry_->tell_remarks();
  }
  /// Tells which samples were left out, a line for each kind, and which channels were silent.
  void tell_left_out() const {
    if (telemetry_) telemetry_->tell_left_out();
  }

 private:
  static constexpr bool of_plant = std::is_same_v<Names, automata::Plant>;

  base::InputFile input_;
  std::unique_ptr<runtime::LogReader> reader_;
  std::unique_ptr<Telemetry> telemetry_;
  runtime::LogSource* source_ = nullptr;
  bool first_ = true;
};

/// Lines of JSON on their way out, so many bytes at once. Whatever ends the run, whole lines are written.
class WholeLines {
 public:
  explicit WholeLines(std::size_t bytes) : bytes_(bytes) {}
  ~WholeLines() {
    try {
      write();
    } catch (const std::exception&) {  // what ends the run is told
    }
  }
  WholeLines(const WholeLines&) = delete;
  WholeLines& operator=(const WholeLines&) = delete;

  void add(std::string_view line) {
    waiting_ += line;
    if (waiting_.size() >= bytes_) write();
  }
  void write() {
    if (waiting_.empty()) return;
    const Emptied emptied{waiting_};  // also where it cannot be written; the memory is kept
    print_json(waiting_);
  }

 private:
  struct Emptied {
    std::string& text;
    ~Emptied() { text.clear(); }
  };

  std::size_t bytes_;
  std::string waiting_;
};

/// A file is checked in full before anything is answered: how many lines it has. What can be read only once is answered
/// as it comes: nothing, as where the run is interrupted.
template <class Names>
std::optional<std::size_t> check_log(const std::string& log, const Names& names, const LogOptions& options) {
  if (!base::is_read_again(log)) return std::nullopt;
  LogOptions unsampled = options;
  unsampled.samples = false;
  LogOf<Names> lines(log, names, unsampled);
  std::size_t count = 0;
  while (lines.next()) ++count;
  return interrupted() ? std::nullopt : std::optional(count);
}

/// Answers each line with `answer(line, name of the log)`, up to an interruption, which is told; where that came within
/// a line there is no answer to it. Whether one came before the end.
template <class Names, class Answer>
bool answer_log(const std::string& log, const Names& names, const LogOptions& options, std::optional<std::size_t> lines,
                const Answer& answer) {
  LogOf<Names> of(log, names, options);
  std::size_t answered = 0;
  // Of a file many lines are written at once; to who looks on, or sends lines as they come, each is answered by itself.
  WholeLines out(lines && !output_is_seen() ? std::size_t{1} << 15 : 0);
  while (const auto line = of.next()) {
    if (!options.quiet) of.tell_remarks();
    const std::optional<std::string_view> text = answer(*line, of.name());
    if (!text) break;
    out.add(*text);
    ++answered;
  }
  out.write();
  if (!options.quiet) of.tell_left_out();
  const bool early = interrupted() && answered != lines;
  if (early) {
    tell("interrupted after " + std::to_string(answered) + (lines ? " of " + std::to_string(*lines) : std::string()) +
         (answered == 1 && !lines ? " line" : " lines"));
  }
  return early;
}

}  // namespace rmpl::tools
