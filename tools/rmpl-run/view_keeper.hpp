// Views of a flight that goes on, kept by a process of its own: whatever ends the flight, they are whole.
// SPDX-License-Identifier: MIT
#pragma once

#include <sys/types.h>

#include <string>

#include "automata/scenario.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/executive/trace/trace_writer.hpp"
#include "tools/rmpl-run/views.hpp"

namespace rmpl::tools {

/// The other process gets a line of a trace for each cycle, and writes the views anew, but for less than a tenth of the
/// time. Where this process ends in any way, the other one writes them a last time, up to the last cycle. The flight
/// does not wait for it, unless it is megabytes behind.
class ViewKeeper final : public runtime::CycleObserver {
 public:
  /// Forks: to be made before there are threads, and before files are opened that the other process must not hold.
  /// Throws base::InputError where a view cannot be written. Keeps references.
  ViewKeeper(const automata::Document& document, const automata::Scenario& scenario, const ViewPaths& paths,
             bool quiet);
  /// Without `finish` the views say that the flight was cut off.
  ~ViewKeeper() override;
  ViewKeeper(const ViewKeeper&) = delete;
  ViewKeeper& operator=(const ViewKeeper&) = delete;

  void observe(const runtime::CycleRecord& record) override { trace_.observe(record); }
  /// The flight is over, and this is how; `ended`: for the program has ended. Waits for the views. Throws
  /// base::InputError where they could not be written.
  void finish(const std::string& summary, bool ended);

 private:
  void send(std::string_view text);
  int await() noexcept;

  int socket_ = -1;
  pid_t keeper_ = -1;
  runtime::TraceWriter trace_;
};

}  // namespace rmpl::tools
