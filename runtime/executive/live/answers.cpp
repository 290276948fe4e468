// Answers are lines of a log.
// SPDX-License-Identifier: MIT
#include "runtime/executive/live/answers.hpp"

#include <utility>

#include "base/error.hpp"
#include "base/printable.hpp"
#include "base/utf8.hpp"

namespace rmpl::runtime {
namespace {

/// A message quotes what was sent, which may be long and odd.
std::string bounded(const std::string& message) {
  constexpr std::size_t most = 240;
  std::string text = base::printable(message);
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && base::is_continuation(text[end])) --end;  // not within a character
  return text.substr(0, end) + "…";
}

}  // namespace

Answers::Answers(const automata::Plant& plant, std::uint64_t connection, const Monitors* monitors)
    : name_("plant " + std::to_string(connection)), reader_(text_, name_, plant) {
  if (monitors != nullptr) reader_.read_channels(*monitors);
}

std::string Answers::next_place() const { return name_ + ":" + std::to_string(lines_ + 1); }

Answer Answers::read(const Inbox::Line& line) {
  const std::string place = next_place();
  ++lines_;
  // The reader counts lines: those that were skipped it gets as blank ones.
  text_.str(std::string(std::exchange(skipped_, 0), '\n') + line.text + "\n");
  text_.clear();
  std::optional<LogLine> read;
  try {
    read = reader_.next();
  } catch (const base::InputError& error) {
    throw base::InputError(bounded(error.what()));
  }
  if (line.too_long) {
    throw base::InputError(place + ": longer than " + std::to_string(Inbox::longest) + " bytes");
  }
  if (!read) throw base::InputError(place + ": expected a JSON object, found nothing");
  if (!read->cycle) throw base::InputError(place + ": expected 'cycle', the one that is answered");
  return {*read->cycle, std::move(read->observations), std::move(read->samples)};
}

}  // namespace rmpl::runtime
