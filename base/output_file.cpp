// Writing a result through a temporary file.
// SPDX-License-Identifier: MIT
#include "base/output_file.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/error.hpp"

namespace rmpl::base {

namespace {

bool written(const std::string& path, const std::string& text) {
  std::ofstream file(path, std::ios::binary);
  file << text;
  file.close();
  return static_cast<bool>(file);
}

}  // namespace

void write_file(const std::string& path, const std::string& text) {
  namespace fs = std::filesystem;
  std::error_code error;
  const bool special = fs::exists(path, error) && !fs::is_regular_file(path, error);
  bool done = false;
  if (special) {
    done = !fs::is_directory(path, error) && written(path, text);
  } else {
    const std::string target = fs::weakly_canonical(path, error).string();  // the file itself, not a link to it
    const std::string temporary = target + ".part" + std::to_string(getpid());
    done = !error && written(temporary, text);
    if (done) fs::rename(temporary, target, error);
    done = done && !error;
    std::error_code ignored;
    if (!done) fs::remove(temporary, ignored);
  }
  if (!done) throw InputError(path + ": cannot be written");
}

}  // namespace rmpl::base
