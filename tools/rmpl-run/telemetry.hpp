// The log of a plant, whatever form it has: JSON Lines or CSV, readings or samples of channels.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "automata/plant.hpp"
#include "base/input_file.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/measured_log.hpp"
#include "runtime/telemetry/monitors.hpp"
#include "tools/rmpl-run/log_options.hpp"

namespace rmpl::tools {

/// A log with its monitors. It is CSV where its name says so, where options of CSV are given, or where there are
/// monitors and it does not begin with a bracket.
class Telemetry {
 public:
  /// Keeps references to all but the options.
  Telemetry(base::InputFile& input, const std::string& path, const automata::Plant& plant, const LogOptions& options);

  [[nodiscard]] runtime::LogSource& source();
  void tell_remarks();
  void tell_left_out();

 private:
  std::string name_;
  runtime::Monitors monitors_;
  std::unique_ptr<runtime::LogSource> lines_;
  std::optional<runtime::MeasuredLog> measured_;
};

}  // namespace rmpl::tools
