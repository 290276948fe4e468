// The work is done in a child process: an edit ends it, and the answer to the edit waits for nothing.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/server/linting.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "compiler/lint/lint.hpp"
#include "tools/rmplc/server/features.hpp"
#include "tools/shared/settings.hpp"

namespace rmpl::tools {
namespace {

constexpr int quiet_milliseconds = 300;  // a pause between keystrokes is shorter

/// What lint has to say of a unit, as JSON: {"findings": […]}, or {"complaint": why it could not}.
std::string lint_answer(const Analysis& analysis, const Workspace& workspace) {
  Json answer;
  try {
    const Settings settings = find_settings(analysis.unit().paths.front());
    std::vector<grammar::Diagnostic> found = analysis.lint(settings.lint);
    const grammar::Severity level = settings.level.value_or(grammar::Severity::warning);
    std::erase_if(found, [&](const grammar::Diagnostic& finding) { return finding.severity < level; });
    answer["findings"] = findings_of(found, analysis, workspace);
  } catch (const base::InputError& error) {
    answer["complaint"] = error.what();
  }
  return answer.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::shared_ptr<Analysis> next_subject(Workspace& workspace) {
  const auto& analyses = workspace.analyses();
  const auto found = std::ranges::find_if(analyses, [](const auto& one) { return one && one->awaits_lint(); });
  return found == analyses.end() ? nullptr : *found;
}

}  // namespace

Pause Linting::pause(Workspace& workspace) {
  if (running_ && subject_.expired()) running_.reset();
  if (running_) return {running_->descriptor(), running_->descriptor() < 0 ? 0 : -1};
  return {-1, next_subject(workspace) ? quiet_milliseconds : -1};
}

bool Linting::rest(Workspace& workspace) {
  if (!running_) {
    const std::shared_ptr<Analysis> subject = next_subject(workspace);
    if (!subject) return false;
    subject_ = subject;
    running_ = std::make_unique<Background>([&] { return lint_answer(*subject, workspace); });
    return false;
  }
  const std::optional<std::string> text = running_->take();
  if (!text) return false;
  running_.reset();
  const std::shared_ptr<Analysis> subject = subject_.lock();
  if (!subject) return false;
  const Json answer = Json::parse(*text, nullptr, false);
  complaint_ = answer.is_object() ? answer.value("complaint", std::string()) : std::string();
  const bool linted = answer.is_object() && answer.contains("findings");
  subject->take_lint(linted ? std::optional<Json>(answer["findings"]) : std::nullopt);
  return true;
}

}  // namespace rmpl::tools
