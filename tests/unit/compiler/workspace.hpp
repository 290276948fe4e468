// A directory of its own for one test: sources are written, compiled, and found wanting.
// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "compiler/session/compiler.hpp"
#include "grammar/source/render.hpp"

namespace rmpl::compiler {

class Workspace : public ::testing::Test {
 protected:
  Workspace() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    directory_ = std::filesystem::temp_directory_path() /
                 ("rmpl-" + std::to_string(getpid()) + "-" + test->test_suite_name() + "-" + test->name());
    std::filesystem::create_directories(directory_);
  }
  ~Workspace() override {
    std::error_code ignored;
    std::filesystem::remove_all(directory_, ignored);
  }

  std::string write(const std::string& name, const std::string& text) {
    const auto path = directory_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

  /// Writes and compiles one text; the extension says what it is.
  Compilation compile_text(const std::string& name, const std::string& text, const Options& options = {}) {
    const std::vector<std::string> paths{write(name, text)};
    return compile(paths, options);
  }

  static Compilation compile_files(const std::vector<std::string>& paths, const Options& options = {}) {
    return compile(paths, options);
  }

  /// All diagnostics, as `RMPL0100 plant.tcca:3:5`.
  static std::vector<std::string> findings(const Compilation& compilation) {
    std::vector<std::string> found;
    for (const auto& item : parsed(compilation)) {
      found.push_back(item.at("code").get<std::string>() + " " + place(item));
    }
    return found;
  }

  /// The places of the notes of all diagnostics.
  static std::vector<std::string> notes(const Compilation& compilation) {
    std::vector<std::string> found;
    for (const auto& item : parsed(compilation)) {
      for (const auto& note : item.at("notes")) found.push_back(place(note));
    }
    return found;
  }

  static std::vector<std::string> messages(const Compilation& compilation) {
    std::vector<std::string> found;
    for (const auto& item : parsed(compilation)) found.push_back(item.at("message").get<std::string>());
    return found;
  }

  static std::vector<std::string> suggestions(const Compilation& compilation) {
    std::vector<std::string> found;
    for (const auto& item : parsed(compilation)) {
      if (item.at("suggestion").is_string()) found.push_back(item.at("suggestion").get<std::string>());
    }
    return found;
  }

  /// The findings in one text.
  std::vector<std::string> errors(const std::string& name, const std::string& text) {
    return findings(compile_text(name, text));
  }

 private:
  static nlohmann::json parsed(const Compilation& compilation) {
    return nlohmann::json::parse(grammar::render_json(compilation.findings()));
  }

  static std::string place(const nlohmann::json& item) {
    return std::filesystem::path(item.at("file").get<std::string>()).filename().string() + ":" +
           std::to_string(item.at("line").get<int>()) + ":" + std::to_string(item.at("column").get<int>());
  }

  std::filesystem::path directory_;
};

using Strings = std::vector<std::string>;

}  // namespace rmpl::compiler
