// Names in the documents: what stands at a place, and where else it is used.
// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "compiler/session/names.hpp"
#include "tools/rmplc/server/message.hpp"
#include "tools/rmplc/server/workspace.hpp"

namespace rmpl::tools {

/// A mention in one of the units.
struct Use {
  const Analysis* analysis;
  compiler::Mention mention;
  std::string uri;
};

std::optional<compiler::Mention> mention_at(const Spot& spot);

/// Every mention of what is declared there in these units, by URI and place; of a file in several units, each once.
std::vector<Use> uses_of(Workspace& workspace, const std::vector<std::shared_ptr<Analysis>>& analyses, const Spot& spot,
                         grammar::Span declaration);

/// The units in which something may be used that is declared there, in all of the workspace (everywhere.hpp).
std::vector<std::shared_ptr<Analysis>> users_of(Workspace& workspace, const Spot& spot, grammar::Span declaration);

/// {uri, range} of a span.
Json location_of(const Workspace& workspace, const Analysis& analysis, grammar::Span span);

}  // namespace rmpl::tools
