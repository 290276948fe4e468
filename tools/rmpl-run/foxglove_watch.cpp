// What changes, for who is there.
// SPDX-License-Identifier: MIT
#include "tools/rmpl-run/foxglove_watch.hpp"

#include <utility>

#include "tools/shared/terminal.hpp"

namespace rmpl::tools {
namespace {

FoxgloveServer::Offer offer_of(const automata::Document& document, const automata::Scenario& scenario) {
  const automata::Plant& plant = document.plant_of(scenario);
  FoxgloveServer::Offer offer{.name = "rmpl-run: " + scenario.name,
                              .metadata = {{"program", document.programs[scenario.program].name},
                                           {"plant", plant.name},
                                           {"cycle", automata::format_seconds(scenario.cycle) + " s"}},
                              .channels = {}};
  const auto channels = runtime::message_channels();
  for (std::size_t c = 0; c < channels.size(); ++c) {
    const std::string topic(channels[c].topic);
    offer.channels.push_back({topic, "rmpl." + topic.substr(1), runtime::message_schema(c, plant)});
  }
  return offer;
}

}  // namespace

FoxgloveWatch::FoxgloveWatch(const automata::Document& document, const automata::Scenario& scenario,
                             const std::string& address, bool remote, bool quiet)
    : stream_(document, scenario), server_(address, remote, offer_of(document, scenario)), quiet_(quiet) {
  if (!quiet_) tell("to be watched by Foxglove at " + server_.url());
}

void FoxgloveWatch::observe(const runtime::CycleRecord& record) {
  stream_.observe(record);
  const std::uint64_t audience = server_.audience();
  const bool anew = std::exchange(audience_, audience) != audience;
  if (audience == 0) return;
  if (anew) stream_.begin_anew();
  if (!server_.send(record.time, stream_.take())) stream_.begin_anew();
  tell_remarks();
}

void FoxgloveWatch::finish(const std::string& summary) {
  server_.finish(summary.substr(0, summary.find('\n')));
  tell_remarks();
}

void FoxgloveWatch::tell_remarks() {
  for (const std::string& remark : server_.remarks()) {
    if (!quiet_) tell(remark);
  }
}

}  // namespace rmpl::tools
