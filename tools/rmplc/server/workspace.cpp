// Keeping units and what is known of them up to date: only what an edit reaches is compiled again.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/workspace.hpp"

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "tools/rmplc/server/positions.hpp"

namespace rmpl::tools {

void Workspace::open(const Json& params) {
  documents_.open(params);
  disk_changed();
}

void Workspace::close(const Json& params) {
  documents_.close(params);
  disk_changed();
}

void Workspace::change(const Json& params) {
  const OpenDocument& document = documents_.change(params);
  if (references_.update(document.path)) units_are_old_ = true;
  const std::string identity = texts_.identity(document.path);
  for (auto& analysis : analyses_) {
    if (analysis && analysis->depends_on(identity)) analysis.reset();
  }
  analyses_are_old_ = true;
}

void Workspace::disk_changed() {
  references_.forget();
  for (auto& analysis : analyses_) analysis.reset();
  units_are_old_ = analyses_are_old_ = true;
}

void Workspace::bring_up_to_date() {
  if (std::exchange(units_are_old_, false)) {
    std::vector<Unit> units = units_of(documents_, references_, texts_);
    std::vector<std::shared_ptr<Analysis>> analyses(units.size());
    for (std::size_t u = 0; u < units.size(); ++u) {
      const auto same = std::find(units_.begin(), units_.end(), units[u]);
      if (same != units_.end()) analyses[u] = std::move(analyses_[static_cast<std::size_t>(same - units_.begin())]);
    }
    units_ = std::move(units);
    analyses_ = std::move(analyses);
  }
  if (!std::exchange(analyses_are_old_, false)) return;
  for (std::size_t u = 0; u < units_.size(); ++u) {
    if (analyses_[u]) continue;
    try {
      analyses_[u] = std::make_shared<Analysis>(units_[u], texts_);
    } catch (const base::InputError&) {
      continue;  // a file beside an open one that cannot be read: it is looked at again when the disk changes
    }
  }
}

const std::vector<std::shared_ptr<Analysis>>& Workspace::analyses() {
  bring_up_to_date();
  return analyses_;
}

const Analysis* Workspace::analysis_of(const OpenDocument& document) {
  const std::string identity = texts_.identity(document.path);
  for (const auto& analysis : analyses()) {
    if (analysis && analysis->find(identity)) return analysis.get();
  }
  return nullptr;
}

Spot Workspace::spot(const Json& params) {
  const OpenDocument& document = documents_.of(params);
  const Analysis* analysis = analysis_of(document);
  if (analysis == nullptr) {
    throw RpcError(RpcCode::request_failed,
                   document.uri + ": expected a file named .rmpl, .tcca, .scn, .props or .mon");
  }
  const std::uint32_t file = *analysis->find(texts_.identity(document.path));
  return {analysis, file, offset_of(analysis->sources()[file], member(params, "position"))};
}

}  // namespace rmpl::tools
