// One call to the system for each text.
// SPDX-License-Identifier: MIT
#include "base/journal_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"

namespace rmpl::base {

JournalFile::JournalFile(std::string path) : path_(std::move(path)) {
  if (path_.empty()) throw InputError("'' is no name of a file");
  if (path_ == "-")
    throw InputError("-: standard output has the result; expected the name of a file (./- for that one)");
  if (const auto input = input_at(path_)) throw InputError(path_ + ": writing there would destroy the input " + *input);
  // What cannot be written is told before anything begins; nothing is taken away yet.
  const bool existed = ::access(path_.c_str(), F_OK) == 0;
  file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC | O_NOCTTY, 0666);
  if (file_ < 0) fail(errno);
  ::close(std::exchange(file_, -1));
  if (!existed) ::unlink(path_.c_str());
}

JournalFile::~JournalFile() {
  if (file_ >= 0) ::close(file_);
}

void JournalFile::append(std::string_view text) {
  if (file_ < 0) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_APPEND | O_CLOEXEC | O_NOCTTY, 0666);
    if (file_ < 0) fail(errno);
  }
  while (!text.empty()) {
    const ssize_t written = ::write(file_, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(errno);
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

void JournalFile::fail(int reason) const {
  throw InputError(path_ + ": cannot be written: " + (reason == EISDIR ? "is a directory" : std::strerror(reason)));
}

}  // namespace rmpl::base
