// What cannot be removed stays: nobody waits for it.
// SPDX-License-Identifier: MIT
#include "base/temporary_folder.hpp"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <system_error>

#include "base/error.hpp"

namespace rmpl::base {

TemporaryFolder::TemporaryFolder(const std::string& prefix, const std::string& told) {
  std::string name = prefix + "XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw InputError(told + ": " + std::strerror(errno));
  path_ = name;
}

TemporaryFolder TemporaryFolder::of_system(const std::string& prefix) {
  std::error_code unknown;
  const std::filesystem::path where = std::filesystem::temp_directory_path(unknown);
  const std::string whole = ((unknown ? std::filesystem::path("/tmp") : where) / prefix).string();
  return {whole, whole};
}

TemporaryFolder TemporaryFolder::beside(const std::filesystem::path& path) {
  return {path.string() + ".", path.string()};
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
}

}  // namespace rmpl::base
