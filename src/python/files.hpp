#pragma once

#include <mutex>
#include <shared_mutex>

namespace zenosphere {

/// Keeps the reading of files apart from runs that write theirs.
///
/// A file is read in a copy of the process first, where a lock that HDF5 held in another thread
/// would never be released. Who reads waits until all pieces under way are over; pieces that come
/// meanwhile wait at the turnstile. Both are waited for without Python's lock.
class Files {
 public:
  template <class Action>
  void write(Action action) {
    std::unique_lock entrance(turnstile_);
    const std::shared_lock writing(files_);
    entrance.unlock();
    action();
  }

  template <class Action>
  auto read(Action action) {
    const std::lock_guard entrance(turnstile_);
    const std::lock_guard reading(files_);
    return action();
  }

 private:
  std::mutex turnstile_;
  std::shared_mutex files_;
};

inline Files files;

}  // namespace zenosphere
