// A flight that Foxglove watches while it goes on.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "automata/scenario.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/report/messages.hpp"
#include "tools/rmpl-run/foxglove/server.hpp"

namespace rmpl::tools {

/// The channels are those of MCAP. Where nobody looks on, a cycle costs comparisons only; nothing waits for who does.
class FoxgloveWatch final : public runtime::CycleObserver {
 public:
  /// Listens from now on, and says where unless `quiet`. Throws base::InputError where it cannot. Starts a thread: to
  /// be made after the last fork.
  FoxgloveWatch(const automata::Document& document, const automata::Scenario& scenario, const std::string& address,
                bool remote, bool quiet);

  void observe(const runtime::CycleRecord& record) override;
  /// The flight is over, and this is how: of the text the first line.
  void finish(const std::string& summary);

 private:
  void tell_remarks();

  runtime::MessageStream stream_;
  FoxgloveServer server_;
  bool quiet_;
  std::uint64_t audience_ = 0;  ///< in the cycle before
};

}  // namespace rmpl::tools
