#include "campaign/store_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <system_error>

#include "model/errors.hpp"

namespace zenosphere {

namespace {

FileDescriptor opened(const std::filesystem::path& path, const std::filesystem::path& store) {
  try {
    return {path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW};
  } catch (const SystemError& error) {
    throw OutputError(fmt::format("{}: cannot be written beside ({}: {}); choose another place",
                                  store.string(), path.string(), error.what()));
  }
}

/// Beside the file itself: a store that is reached by a link has the same lock.
std::filesystem::path lock_of(const std::filesystem::path& store) {
  std::error_code ignored;
  const bool is_link = std::filesystem::is_symlink(store, ignored);
  const auto file = is_link ? std::filesystem::weakly_canonical(store, ignored) : store;
  return (file.empty() ? store : file).string() + "-lock";
}

}  // namespace

StoreLock::StoreLock(const std::filesystem::path& store) : path_(lock_of(store)) {
  // Another sweep may remove the file between our opening and locking it: then it is made anew.
  do {
    file_ = opened(path_, store);
    if (flock(file_.id(), LOCK_EX | LOCK_NB) == 0) continue;
    if (errno == EWOULDBLOCK) {
      throw OutputError(store.string() +
                        ": another sweep is writing to it; wait for its end or choose another "
                        "store with -o");
    }
    throw OutputError(fmt::format("{}: cannot be locked ({}); choose another place", path_.string(),
                                  std::strerror(errno)));
  } while (identity_of(file_) != identity_of(path_));
}

StoreLock::~StoreLock() {
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

}  // namespace zenosphere
