// What channels of telemetry say, and what is read of it, where one of these changes.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "runtime/executive/trace/cycle_record.hpp"

namespace rmpl::runtime {

/// Looks at the samples of one cycle after the other. Of noise within limits nothing is told.
class SampleStory {
 public:
  /// Keeps a reference.
  explicit SampleStory(const automata::Plant& plant) : plant_(plant) {}

  struct Line {
    std::string text;                            ///< `"LEVEL" = 0.7: tank.level = low`
    std::optional<automata::ComponentId> about;  ///< the component that is read
  };
  /// What there is to tell of a cycle, by the names of the channels: the last sample of one where it means something
  /// else than the one before, or where it changes a reading; and readings that have become stale.
  std::vector<Line> lines(const CycleRecord& record);

 private:
  using Reading = std::optional<automata::ValueId>;
  struct Read {
    bool heard = false;  ///< one of its channels had a sample
    Reading reading;     ///< as of the cycle before
    bool changed = false;
    bool told = false;
  };

  void read(const CycleRecord& record);
  Line line_of(const std::string& channel, const Sample& sample, const CycleRecord& record, bool& news);

  const automata::Plant& plant_;
  std::map<std::string, std::string> meant_;  ///< by the last sample of each channel
  std::vector<Read> read_;                    ///< per monitor
};

}  // namespace rmpl::runtime
