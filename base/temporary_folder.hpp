// A folder that goes with everything in it.
// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <utility>

namespace rmpl::base {

class TemporaryFolder {
 public:
  /// Makes a folder where the system keeps such folders, for this user alone: its name is the prefix and six random
  /// letters. Throws base::InputError with its place and the reason.
  static TemporaryFolder of_system(const std::string& prefix);
  /// The same beside the path, with a name that begins with that. Throws base::InputError with the path and the reason.
  static TemporaryFolder beside(const std::filesystem::path& path);
  ~TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::move(other.path_)) { other.path_.clear(); }
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// It is the caller's, and stays.
  void release() { path_.clear(); }

 private:
  /// `told`: what messages call it.
  TemporaryFolder(const std::string& prefix, const std::string& told);

  std::filesystem::path path_;  ///< empty: of none
};

}  // namespace rmpl::base
