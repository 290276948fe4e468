// Sends commands, reads answers, and reports where either fails.
// SPDX-License-Identifier: MIT
#include "runtime/executive/live/live_plant.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"

namespace rmpl::runtime {
namespace {

/// More lines than this in one cycle are a flood, and are not read.
constexpr std::uint64_t many_lines = 1000;

}  // namespace

using automata::Ticks;

LivePlant::LivePlant(const automata::Plant& model, Channel& channel, Ticks period, LiveOptions options)
    : model_(model), channel_(channel), period_(period), options_(std::move(options)), monitors_(options_.monitors) {}

void LivePlant::Several::add(const std::string& message) {
  if (count++ == 0) first = message;
}

void LivePlant::compose(const automata::ControlAction& action, Ticks now) {
  line_.clear();
  line_.open('{').key("cycle").number(cycle_).key("time").seconds(now);
  line_.key("until").seconds({period_.count * static_cast<std::int64_t>(cycle_)});
  line_.key("command").assignments(automata::assignments_of(model_, action), model_.variables).close('}');
}

void LivePlant::issue(const automata::ControlAction& action, Ticks now) {
  ++cycle_;
  answered_ = parted_ = false;
  lines_ = 0;
  observations_.clear();
  samples_.clear();
  compose(action, now);
  if (!channel_.connected()) {
    const bool waits = options_.time == LiveOptions::Time::lock_step;
    channel_.revive(++cycles_without_, waits ? channel_.now() + options_.patience : channel_.now());
  } else {
    cycles_without_ = 0;
  }
  if (channel_.connected() && answers_ == nullptr) return meet();
  if (answers_ == nullptr) return;
  outbox_.put(line_.text() + "\n");
  outbox_.send(channel_);
}

/// A plant has come: it gets the command that is in force, whatever the one before got.
void LivePlant::meet() {
  answers_ = std::make_unique<Answers>(model_, ++connections_, options_.monitors.empty() ? nullptr : &monitors_);
  tell(Event::Kind::connected, "plant " + std::to_string(connections_) + " is connected");
  outbox_.put(line_.text() + "\n");
  outbox_.send(channel_);
}

void LivePlant::part() {
  if (answers_ == nullptr) return;
  if (inbox_.begun()) refused_.add(answers_->next_place() + ": cut off by the end of the connection");
  tell(Event::Kind::gone, "plant " + std::to_string(connections_) + " is gone: " + channel_.reason());
  parted_ = true;
  answers_.reset();
  inbox_.clear();
  outbox_.clear();
}

void LivePlant::handle(Channel::News news, const std::string& bytes) {
  switch (news) {
    case Channel::News::none:
      break;
    case Channel::News::connected:
      part();
      meet();
      break;
    case Channel::News::received:
      inbox_.add(bytes);
      break;
    case Channel::News::sendable:
      outbox_.send(channel_);
      break;
    case Channel::News::gone:
      part();
      break;
  }
}

Ticks LivePlant::now() const { return options_.time == LiveOptions::Time::lock_step ? simulated_ : channel_.now(); }

/// In lock-step what comes behind the answer is for the next cycle, so that nothing depends on how fast it comes; and
/// so is what comes behind a flood, which is not waited out.
void LivePlant::read_lines() {
  const bool all = options_.time == LiveOptions::Time::wall;
  while (answers_ != nullptr && (all || !(answered_ || lines_ > many_lines))) {
    const auto line = inbox_.next();
    if (!line) break;
    read(*line);
  }
}

void LivePlant::wait_until(Ticks time) {
  const bool lock_step = options_.time == LiveOptions::Time::lock_step;
  const Ticks end = lock_step ? channel_.now() + options_.patience : time;
  std::string bytes;
  read_lines();
  do {
    if (lock_step && (answered_ || answers_ == nullptr || lines_ > many_lines)) break;
    bytes.clear();
    handle(channel_.wait(end, !outbox_.empty(), bytes), bytes);
    read_lines();
  } while (channel_.now() < end && !options_.interrupted());
  simulated_ = std::max(simulated_, time);
}

void LivePlant::read(const Inbox::Line& line) {
  if (++lines_ > many_lines) return answers_->skip();  // reading them would make the cycle late
  try {
    const std::string place = answers_->next_place();
    const Answer answer = answers_->read(line);
    if (answer.cycle > cycle_) {
      refused_.add(place + ": cycle " + std::to_string(answer.cycle) + " has not begun");
    } else if (answer.cycle < cycle_) {
      late_.add(place + ": cycle " + std::to_string(answer.cycle) + " is over");
    } else {
      keep(answer);
    }
  } catch (const base::InputError& error) {
    refused_.add(error.what());
  }
}

/// Of two readings of one sensor in a cycle the later one is kept.
void LivePlant::keep(const Answer& answer) {
  answered_ = true;
  samples_.insert(samples_.end(), answer.samples.begin(), answer.samples.end());
  for (const automata::Assignment& reading : answer.observations) {
    const auto at =
        std::lower_bound(observations_.begin(), observations_.end(), reading.variable,
                         [](const automata::Assignment& a, automata::VariableId id) { return a.variable < id; });
    if (at != observations_.end() && at->variable == reading.variable) {
      at->value = reading.value;
    } else {
      observations_.insert(at, reading);
    }
  }
}

void LivePlant::tell(Event::Kind kind, std::string message) {
  events_.push_back({kind, std::move(message), std::nullopt, std::nullopt});
}

void LivePlant::tell(Event::Kind kind, Several& several, const char* others) {
  if (several.count == 0) return;
  if (several.count > 1) several.first += "; and " + std::to_string(several.count - 1) + others;
  tell(kind, several.first);
  several = {};
}

std::string LivePlant::why_unacknowledged() const {
  if (answers_ == nullptr) return parted_ ? "the plant is gone" : "no plant is connected";
  return outbox_.empty() ? "no answer came in time" : "the plant does not read its input";
}

const automata::Observation& LivePlant::sense(Ticks now) {
  tell(Event::Kind::refused, refused_, " more");
  tell(Event::Kind::late, late_, " more");
  if (lines_ > many_lines) {
    tell(Event::Kind::flood,
         std::to_string(lines_) + " lines in one cycle, of which " + std::to_string(many_lines) + " were read");
  }
  if (answered_) {
    ++acknowledged_;
  } else {
    tell(Event::Kind::unacknowledged, "the command of this cycle is not acknowledged: " + why_unacknowledged());
  }
  monitors_.take(samples_, now);
  for (std::string& remark : monitors_.take_remarks()) tell(Event::Kind::refused, std::move(remark));
  read_back_ = monitors_.readings(now);
  for (const automata::Assignment& reading : observations_) {
    std::erase_if(read_back_, [&](const automata::Assignment& known) { return known.variable == reading.variable; });
    read_back_.insert(std::lower_bound(read_back_.begin(), read_back_.end(), reading), reading);
  }
  happenings_ = std::exchange(events_, {});
  return read_back_;
}

}  // namespace rmpl::runtime
