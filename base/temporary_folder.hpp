// A folder that goes with everything in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace rmpl::base {

class TemporaryFolder {
 public:
  /// Makes a folder whose name is the prefix and six random letters, for this user alone. Throws base::InputError with
  /// the prefix and the reason.
  explicit TemporaryFolder(const std::string& prefix);
  /// The same where the system keeps such folders.
  static TemporaryFolder of_system(const std::string& prefix);
  ~TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::move(other.path_)) { other.path_.clear(); }
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// It is the caller's, and stays.
  void release() { path_.clear(); }

 private:
  std::filesystem::path path_;  ///< empty: of none
};

}  // namespace rmpl::base
