// Whether two trees say the same, wherever in their texts they stand.
// SPDX-License-Identifier: MIT
#pragma once

#include "grammar/ast/monitor.hpp"
#include "grammar/ast/plant.hpp"
#include "grammar/ast/program.hpp"
#include "grammar/ast/property.hpp"
#include "grammar/ast/scenario.hpp"

namespace rmpl::grammar {

// Equal in all but spans: names, values, numbers as written, the order of everything. Linear in the trees.

bool same(const ProgramFile& one, const ProgramFile& other);
bool same(const PlantFile& one, const PlantFile& other);
bool same(const ScenarioFile& one, const ScenarioFile& other);
bool same(const PropertyFile& one, const PropertyFile& other);
bool same(const MonitorFile& one, const MonitorFile& other);

}  // namespace rmpl::grammar
