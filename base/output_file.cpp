// Writing a result through a temporary file.
// SPDX-License-Identifier: MIT
#include "base/output_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <mutex>
#include <random>
#include <set>
#include <utility>

#include "base/error.hpp"
#include "base/input_file.hpp"

namespace rmpl::base {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t block = std::size_t{1} << 16;

/// The names of unfinished files, where a signal handler finds them.
struct Slot {
  enum State : int { empty, filling, used };
  std::atomic<int> state = empty;
  std::array<char, 4096> name;
};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler reads it");
std::array<Slot, 16> slots;

/// The slot that holds the name now; `slots.size()` where none is free or the name is too long: then a signal leaves
/// the file behind.
std::size_t take_slot(const std::string& name) {
  if (name.size() >= slots.front().name.size()) return slots.size();
  for (std::size_t s = 0; s < slots.size(); ++s) {
    int expected = Slot::empty;
    if (!slots[s].state.compare_exchange_strong(expected, Slot::filling)) continue;
    std::copy_n(name.c_str(), name.size() + 1, slots[s].name.begin());
    slots[s].state = Slot::used;
    return s;
  }
  return slots.size();
}

void free_slot(std::size_t slot) {
  if (slot < slots.size()) slots[slot].state = Slot::empty;
}

/// Where a path leads: the file itself, also where a link leads to nothing yet.
std::string behind_links(const std::string& path) {
  constexpr int most_links = 40;  // as the kernel has it
  fs::path target = path;
  std::error_code error;
  for (int i = 0; i < most_links && fs::is_symlink(fs::symlink_status(target, error)); ++i) {
    const fs::path next = fs::read_symlink(target, error);
    if (error) break;
    target = next.is_absolute() ? next : target.parent_path() / next;
  }
  return target.string();
}

/// A hidden name beside the target that nobody can guess.
std::string name_beside(const std::string& target) {
  constexpr std::size_t longest = 200;  // of 255 bytes that a name may have
  static constexpr std::string_view digits = "0123456789abcdef";
  const fs::path path = target;
  std::string name = "." + path.filename().string().substr(0, longest) + ".";
  std::random_device random;
  for (int i = 0; i < 16; ++i) name += digits[random() % digits.size()];
  return (path.parent_path() / name).string();
}

/// A device is written in place, also where it leads to a regular file, as /dev/stdout may.
bool is_device(const std::string& path) { return path.starts_with("/dev/") || path.starts_with("/proc/"); }

/// The targets of files that are being written, by their names behind all links.
struct Targets {
  std::mutex mutex;
  std::set<std::string> claimed;
};

Targets& targets() {
  static Targets all;
  return all;
}

/// However it is spelt.
std::string name_of(const std::string& target) {
  std::error_code error;
  const fs::path name = fs::weakly_canonical(fs::absolute(target), error);
  return error ? target : name.string();
}

}  // namespace

OutputFile::Claim::Claim(const std::string& path, const std::string& target) : name_(name_of(target)) {
  const std::lock_guard lock(targets().mutex);
  if (!targets().claimed.insert(name_).second) throw InputError(path + ": another output of this run is written there");
}

OutputFile::Claim::~Claim() {
  const std::lock_guard lock(targets().mutex);
  targets().claimed.erase(name_);
}

OutputFile::OutputFile(std::string path) : path_(std::move(path)) {
  if (path_.empty()) throw InputError("'' is no name of a file");
  if (path_ == "-")
    throw InputError("-: standard output has the result; expected the name of a file (./- for that one)");
  if (const auto input = input_at(path_)) throw InputError(path_ + ": writing there would destroy the input " + *input);
  struct stat about = {};
  const bool exists = stat(path_.c_str(), &about) == 0;
  if (!exists && errno != ENOENT) fail(errno);
  if (exists && S_ISDIR(about.st_mode)) fail(EISDIR);
  if (exists && (!S_ISREG(about.st_mode) || is_device(path_))) {
    open_in_place();
  } else {
    target_ = behind_links(path_);
    claim_.emplace(path_, target_);
    open_beside(exists);
  }
}

OutputFile::~OutputFile() {
  if (file_ >= 0) ::close(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  free_slot(slot_);
}

void OutputFile::open_in_place() {
  file_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY);
  if (file_ < 0) fail(errno);
}

void OutputFile::open_beside(bool replaces) {
  constexpr mode_t secret = 0600, usual = 0666;  // the latter less what the umask forbids
  struct stat old = {};
  if (replaces && stat(target_.c_str(), &old) != 0) fail(errno);
  if (replaces && access(target_.c_str(), W_OK) != 0) fail(errno);
  while (file_ < 0) {
    temporary_ = name_beside(target_);
    slot_ = take_slot(temporary_);  // before it is there, so that a signal in between finds it
    file_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, replaces ? secret : usual);
    if (file_ >= 0) break;
    const int reason = errno;
    free_slot(std::exchange(slot_, no_slot));
    temporary_.clear();
    if (reason != EEXIST) fail(reason);
  }
  if (!replaces) return;
  // Another's file stays another's where that is allowed; the mode comes last, for a change of owner takes bits away.
  if ((old.st_uid != geteuid() || old.st_gid != getegid()) && fchown(file_, old.st_uid, old.st_gid) != 0) errno = 0;
  constexpr mode_t all_bits = 07777;
  if (fchmod(file_, old.st_mode & all_bits) != 0) {
    const int reason = errno;
    ::close(std::exchange(file_, -1));
    ::unlink(temporary_.c_str());
    free_slot(slot_);
    fail(reason);
  }
}

void OutputFile::write(std::string_view text) {
  pending_ += text;
  if (pending_.size() >= block) flush();
}

void OutputFile::flush() {
  std::string_view rest = pending_;
  while (!rest.empty()) {
    const ssize_t count = ::write(file_, rest.data(), rest.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(count));
  }
  pending_.clear();
}

void OutputFile::keep() {
  flush();
  if (!temporary_.empty() && fsync(file_) != 0) fail(errno);
  if (::close(std::exchange(file_, -1)) != 0) fail(errno);
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail(errno);
  temporary_.clear();
  free_slot(std::exchange(slot_, no_slot));
  claim_.reset();
}

void OutputFile::fail(int reason) const {
  throw InputError(path_ + ": cannot be written: " + (reason == EISDIR ? "is a directory" : std::strerror(reason)));
}

void write_file(const std::string& path, std::string_view text) {
  OutputFile file(path);
  file.write(text);
  file.keep();
}

bool remove_stale_file(const std::string& path) {
  if (const auto input = input_at(path)) throw InputError(path + ": removing it would destroy the input " + *input);
  struct stat about = {};
  if (is_device(path) || stat(path.c_str(), &about) != 0 || !S_ISREG(about.st_mode)) return false;
  if (::unlink(behind_links(path).c_str()) == 0) return true;
  throw InputError(path + ": is of an earlier run, and cannot be removed: " + std::strerror(errno));
}

void remove_unfinished_files() noexcept {
  for (Slot& slot : slots) {
    if (slot.state == Slot::used) ::unlink(slot.name.data());
  }
}

}  // namespace rmpl::base
