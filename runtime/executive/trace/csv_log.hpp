// A log as a table: a row a time, a column a channel, an attribute or a control.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <istream>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/trace/log.hpp"
#include "runtime/executive/trace/log_names.hpp"
#include "runtime/telemetry/csv.hpp"
#include "runtime/telemetry/log_times.hpp"
#include "runtime/telemetry/monitors.hpp"

namespace rmpl::runtime {

struct CsvLogOptions {
  std::optional<char> delimiter;
  std::string time_column;  ///< empty: the first that is called time, timestamp, datetime, date or t, in any case
  LogTimeOptions times;
  bool samples = true;  ///< whether lines have what was sampled, which is never wrong
};

/// The first row names the columns. A column is a channel of the monitors, a control variable or an observed attribute
/// of the plant, by its name; others are passed over. An empty cell is no sample; of a control it is idle. The unit of
/// a column of numbers that is called `time_ms`, `Time (ms)` or `time [us]` is the one that it names.
class CsvLog final : public LogSource {
 public:
  /// Reads the first row. Throws base::InputError where there is none, where the column of time is missing, where a
  /// column that counts stands there twice, or where no column counts. Keeps references to all but the options.
  CsvLog(std::istream& in, std::string name, const automata::Plant& plant, const Monitors& monitors,
         const CsvLogOptions& options);

  /// Throws too where a row has more or fewer cells than the first, or a cell that is no time or no value.
  std::optional<LogLine> next() override;
  [[nodiscard]] LogTimes& times() override { return times_; }

 private:
  struct Column {
    enum class Kind { none, time, channel, command, observation };
    Kind kind = Kind::none;
    std::uint32_t channel = 0;
    std::string name;
  };

  void read_header(const CsvLogOptions& options);
  void find_time(const CsvLogOptions& options);
  [[noreturn]] void fail(const CsvRow& row, const std::string& what) const;
  [[nodiscard]] std::optional<TimeText> time_ahead();
  void interpret(const CsvRow& row, LogLine& line) const;

  CsvReader reader_;
  std::string name_;
  const automata::Plant& plant_;
  LogNames names_;
  const Monitors& monitors_;
  LogTimes times_;
  std::vector<Column> columns_;
  std::size_t time_ = 0;    ///< the column of time
  bool commanded_ = false;  ///< whether a column is a control
  bool samples_ = true;
  CsvRow last_;  ///< the row before
  std::optional<automata::Ticks> last_time_;
};

}  // namespace rmpl::runtime
