// Reading by descriptor: a stream of the standard library would not tell an error from an end.
// SPDX-License-Identifier: MIT
#include "base/input_file.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <map>
#include <mutex>
#include <streambuf>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/limit_error.hpp"
#include "base/rewrite_file.hpp"

namespace rmpl::base {
namespace {

constexpr const char* standard_input = "standard input";

/// The files that were read, by device and number: an output must not be one of them.
class FilesRead {
 public:
  void add(const struct stat& file, const std::string& name) {
    const std::lock_guard lock(mutex_);
    names_.insert_or_assign(std::pair(file.st_dev, file.st_ino), name);
  }
  void forget(const struct stat& file) {
    const std::lock_guard lock(mutex_);
    names_.erase({file.st_dev, file.st_ino});
  }
  std::optional<std::string> find(const struct stat& file) {
    const std::lock_guard lock(mutex_);
    const auto known = names_.find({file.st_dev, file.st_ino});
    if (known == names_.end()) return std::nullopt;
    // A file that is gone may have left its number to another.
    struct stat still = {};
    const bool there =
        known->second == standard_input ? fstat(STDIN_FILENO, &still) == 0 : stat(known->second.c_str(), &still) == 0;
    if (!there || still.st_dev != file.st_dev || still.st_ino != file.st_ino) return std::nullopt;
    return known->second;
  }

 private:
  std::mutex mutex_;
  std::map<std::pair<dev_t, ino_t>, std::string> names_;
};

/// At once, in bytes. Set before anything is read, so that threads only read it.
std::size_t limit = std::size_t{1} << 30;

/// Whether whoever runs this wants to wait no longer. Set before anything is read.
std::function<bool()> inputs_ended;

void check_length(const std::string& name, const char* what, std::size_t length) {
  if (length <= limit) return;
  throw InputError(name + ": " + what + " of more than " + std::to_string(limit) +
                   " bytes; `--max-input` permits more");
}

/// All that there is, up to a bound, and the limit.
std::string whole(InputFile& file, std::size_t most) {
  std::streambuf& buffer = *file.stream().rdbuf();
  std::string text;
  std::array<char, std::size_t{1} << 16> block;
  while (const std::streamsize count = buffer.sgetn(block.data(), block.size())) {
    text.append(block.data(), static_cast<std::size_t>(count));
    check_length(file.name(), "a text", text.size());
    if (text.size() > most) throw InputError(file.name() + ": a text of more than " + std::to_string(most) + " bytes");
  }
  return text;
}

FilesRead& files_read() {
  static FilesRead files;
  return files;
}

[[noreturn]] void fail(const std::string& name, int reason) {
  if (reason == EISDIR) throw InputError(name + ": is a directory, expected a file");
  if (reason == EBADF) throw InputError(name + ": cannot be read: it is closed");
  throw InputError(name + ": " + std::strerror(reason));
}

}  // namespace

/// A descriptor that is read in blocks.
class InputFile::Buffer final : public std::streambuf {
 public:
  Buffer(const std::string& path, const std::string& name, std::function<bool()> stop, Accept accept)
      : name_(name), stop_(std::move(stop)), owned_(path != "-" || accept == Accept::regular_files) {
    if (path.empty()) throw InputError("'' is no name of a file");
    const bool regular = accept == Accept::regular_files;
    const int flags = O_RDONLY | O_CLOEXEC | (regular ? O_NONBLOCK | O_NOCTTY : 0);
    do {
      file_ = owned_ ? ::open(path.c_str(), flags) : STDIN_FILENO;
    } while (file_ < 0 && errno == EINTR && !(stop_ && stop_()));
    if (file_ < 0 && errno == EINTR) throw LimitError(name_ + ": interrupted before its beginning");
    if (file_ < 0) fail(name_, errno);
    struct stat about = {};
    const int reason = fstat(file_, &about) != 0 ? errno : S_ISDIR(about.st_mode) ? EISDIR : 0;
    const bool refused = regular && !S_ISREG(about.st_mode);
    if (reason != 0 || refused) close();
    if (reason != 0) fail(name_, reason);
    if (refused) throw InputError(name_ + ": is no regular file");
    if (S_ISREG(about.st_mode)) files_read().add(about, name_);
  }
  ~Buffer() override { close(); }
  Buffer(const Buffer&) = delete;
  Buffer& operator=(const Buffer&) = delete;

 protected:
  int_type underflow() override {
    ssize_t count = 0;
    do {
      if (!waits_for_more()) return traits_type::eof();
      count = ::read(file_, block_.data(), block_.size());
    } while (count < 0 && errno == EINTR);
    if (count < 0) fail(name_, errno);
    measure(std::string_view(block_.data(), static_cast<std::size_t>(count)));
    setg(block_.data(), block_.data(), block_.data() + count);
    return count == 0 ? traits_type::eof() : traits_type::to_int_type(block_.front());
  }

 private:
  void close() {
    if (owned_) ::close(file_);
  }
  /// Returns once there is something to read, or an error; false where `stop` says that this is the end. It is asked
  /// now and then: a signal that comes just before a read would not end that.
  bool waits_for_more() {
    constexpr int pace = 100;  // milliseconds
    if (!stop_) return true;
    for (pollfd file = {file_, POLLIN, 0};;) {
      const int ready = ::poll(&file, 1, pace);
      if (ready > 0 || (ready < 0 && errno != EINTR)) return true;
      if (stop_()) return false;
    }
  }
  void measure(std::string_view text) {
    const std::size_t end = text.find_last_of('\n');
    line_ = end == std::string_view::npos ? line_ + text.size() : text.size() - end - 1;
    check_length(name_, "a line", line_);
  }

  const std::string& name_;
  std::function<bool()> stop_;
  bool owned_;
  int file_ = -1;
  std::size_t line_ = 0;  ///< bytes of the last line so far; of longer ones within a block there is nothing to fear
  std::array<char, std::size_t{1} << 16> block_;
};

InputFile::InputFile(const std::string& path, std::function<bool()> stop, Accept accept)
    : name_(path == "-" && accept == Accept::anything ? standard_input : path),
      buffer_(std::make_unique<Buffer>(path, name_, std::move(stop), accept)),
      stream_(buffer_.get()) {
  stream_.exceptions(std::ios::badbit);  // what the buffer throws comes out of whatever reads
}

InputFile::~InputFile() = default;

void limit_inputs(std::size_t bytes) { limit = bytes; }

void end_inputs_when(std::function<bool()> ended) { inputs_ended = std::move(ended); }

std::string read_file(const std::string& path) {
  bool ended = false;
  InputFile file(path, [&ended] { return ended = inputs_ended && inputs_ended(); });
  std::string text = whole(file, limit);
  if (ended) throw LimitError(file.name() + ": interrupted before its end");
  return text;
}

std::string read_regular_file(const std::string& path, std::size_t most) {
  InputFile file(path, {}, InputFile::Accept::regular_files);
  return whole(file, most);
}

bool is_read_again(const std::string& path) {
  struct stat about = {};
  return path != "-" && stat(path.c_str(), &about) == 0 && S_ISREG(about.st_mode);
}

std::optional<std::string> input_at(const std::string& path) {
  struct stat about = {};
  if (stat(path.c_str(), &about) != 0) {
    if (errno == ENOENT || errno == ENOTDIR) return std::nullopt;
    fail(path, errno);
  }
  return S_ISREG(about.st_mode) ? files_read().find(about) : std::nullopt;
}

void forget_input(const std::string& path) {
  struct stat file = {};
  if (stat(path.c_str(), &file) == 0) files_read().forget(file);
}

}  // namespace rmpl::base
