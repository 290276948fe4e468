// Counts the known findings.
// SPDX-License-Identifier: MIT
#include "tools/rmplc/project/baseline.hpp"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/input_file.hpp"

namespace rmpl::tools {
namespace {

namespace fs = std::filesystem;
using grammar::Diagnostic;

std::string folder_of(const std::string& path) {
  const std::string folder = fs::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

/// The name of a finding's file, as seen from a folder.
std::string name_of(const Diagnostic& finding, const grammar::Sources& sources, const std::string& folder) {
  const std::string& name = sources[finding.span.file].name();
  std::error_code error;
  const fs::path seen = fs::proximate(name, folder, error);
  return error ? name : seen.generic_string();
}

}  // namespace

Baseline::Baseline(const std::string& path) : folder_(folder_of(path)) {
  try {
    const nlohmann::json document = nlohmann::json::parse(base::read_file(path));
    for (const nlohmann::json& one : document.at("findings")) {
      const Key key{one.at("code").get<std::string>(), one.at("file").get<std::string>(),
                    one.at("message").get<std::string>()};
      const nlohmann::json& count = one.at("count");
      if (!count.is_number_unsigned()) throw base::InputError(path + ": `count`: expected a whole number");
      left_[key] += count.get<std::size_t>();
    }
  } catch (const nlohmann::json::exception& error) {
    throw base::InputError(path + ": no baseline of lint: " + error.what());
  }
}

std::vector<Diagnostic> Baseline::unknown(const std::vector<Diagnostic>& found, const grammar::Sources& sources) {
  std::vector<Diagnostic> result;
  for (const Diagnostic& finding : found) {
    const auto known = left_.find({to_string(finding.code), name_of(finding, sources, folder_), finding.message});
    if (known != left_.end() && known->second > 0) {
      --known->second;
    } else {
      result.push_back(finding);
    }
  }
  return result;
}

std::size_t Baseline::unmet() const {
  std::size_t count = 0;
  for (const auto& [key, left] : left_) count += left;
  return count;
}

std::string to_baseline(std::span<const Diagnostic> found, const grammar::Sources& sources, const std::string& path) {
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> counts;  // by file, so that it reads well
  const std::string folder = folder_of(path);
  for (const Diagnostic& finding : found) {
    ++counts[{name_of(finding, sources, folder), to_string(finding.code), finding.message}];
  }
  nlohmann::ordered_json findings = nlohmann::ordered_json::array();
  for (const auto& [key, count] : counts) {
    const auto& [file, code, message] = key;
    findings.push_back({{"code", code}, {"file", file}, {"message", message}, {"count", count}});
  }
  const nlohmann::ordered_json document = {{"findings", std::move(findings)}};
  return document.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace rmpl::tools
