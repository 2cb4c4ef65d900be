#pragma once

#include <filesystem>

#include "storage/durable.hpp"

namespace zenosphere {

/// Keeps a second sweep from a store: a lock on a file beside it, which is gone with this object,
/// and whose lock is gone with the process, however that ends.
///
/// Readers are not kept out; SQLite sees to it that they see whole transactions.
class StoreLock {
 public:
  /// Throws OutputError where another sweep has it or the file cannot be made.
  explicit StoreLock(const std::filesystem::path& store);
  StoreLock(const StoreLock&) = delete;
  StoreLock& operator=(const StoreLock&) = delete;
  ~StoreLock();

 private:
  std::filesystem::path path_;
  FileDescriptor file_;
};

}  // namespace zenosphere
