// What of a plant and its program runs have come to, and what not.
// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "automata/plant.hpp"
#include "automata/program.hpp"
#include "runtime/executive/trace/cycle_record.hpp"
#include "runtime/report/flight.hpp"

namespace rmpl::runtime {

/// Something that a run can come to.
struct CoverageItem {
  enum class Kind {
    mode,        ///< a component is in it
    transition,  ///< a component goes from a mode to another one that is no fault
    fault,       ///< a component goes from a mode to a fault mode
    location     ///< a primitive location of the program is marked
  };
  Kind kind = Kind::mode;
  std::string of;    ///< the plant, or the program
  std::string name;  ///< `pde = on`, `pde: off -> on`, `4: engine = standby`
  automata::Origin origin;
  std::uint64_t runs = 0;  ///< that came to it
};

/// `mode`, `transition`, `fault`, `location`.
const char* to_string(CoverageItem::Kind kind);

/// Of one run: marks what it comes to. The modes are those of the simulated plant, or of the estimate where nobody
/// knows better. Of transitions a run shows from where to where they lead: those of one component with the same source
/// and target are one, and those that lead back to their source are none.
class Coverage final : public CycleObserver {
 public:
  /// Keeps the pointers. `program` is null where a plant is looked at alone.
  Coverage(const automata::Plant* plant, const automata::Program* program);

  void observe(const CycleRecord& record) override;
  /// A run of the same plant that was recorded, from its start.
  void follow(const Flight& flight);
  /// All that there is, in the order of plant and program.
  [[nodiscard]] std::vector<CoverageItem> items() const;

 private:
  /// A way from one mode of a component to another.
  struct Way {
    automata::ModeId from, to;
    const automata::Transition* first;  ///< of those that lead there
    bool taken = false;
  };

  void enter(std::size_t component, automata::ModeId mode);

  const automata::Plant& plant_;
  const automata::Program* program_;
  std::vector<std::vector<bool>> entered_;               ///< by component and mode
  std::vector<std::vector<Way>> ways_;                   ///< by component
  std::vector<bool> marked_;                             ///< by location
  std::vector<std::optional<automata::ModeId>> before_;  ///< by component; nothing: it has not been seen yet
};

/// Adds the runs of `more` to the items that are the same, and what is new at the end.
void add(std::vector<CoverageItem>& items, const std::vector<CoverageItem>& more);

/// grammar/schema/coverage.schema.json
std::string to_json(const std::vector<CoverageItem>& items);

/// What `to_json` wrote. Throws base::InputError where it is something else.
std::vector<CoverageItem> read_coverage(const std::string& json);

}  // namespace rmpl::runtime
