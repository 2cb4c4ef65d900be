#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <stdexcept>

#include "model/archive.hpp"

/// The parts of POSIX that decide what is on the disk after a crash.
namespace zenosphere {

/// The system refused. The text is its reason ("No space left on device").
class SystemError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// An open file.
class FileDescriptor {
 public:
  FileDescriptor() = default;
  /// \param flags  of open(2); files are created with the permissions that the umask leaves
  /// Throws SystemError.
  FileDescriptor(const std::filesystem::path& path, int flags);
  FileDescriptor(FileDescriptor&& other) noexcept;
  FileDescriptor& operator=(FileDescriptor&& other) noexcept;
  ~FileDescriptor();

  int id() const { return id_; }

 private:
  int id_ = -1;
};

/// Which file a path or a descriptor leads to; two names of one file have the same identity.
struct FileIdentity {
  std::uint64_t device = 0;
  std::uint64_t number = 0;
  friend bool operator==(const FileIdentity&, const FileIdentity&) = default;
};
FileIdentity identity_of(const FileDescriptor& file);
/// Nothing where the path leads to no file.
std::optional<FileIdentity> identity_of(const std::filesystem::path& path);

/// Writes all bytes at a place of the file. Throws SystemError.
void write_at(const FileDescriptor& file, std::uint64_t offset,
              std::span<const std::uint8_t> bytes);
/// The same of bytes in at most 1024 pieces, one behind the other.
void write_at(const FileDescriptor& file, std::uint64_t offset,
              std::span<const std::span<const std::uint8_t>> pieces);
/// Writes all bytes to a descriptor that goes on from where it is: a pipe, a terminal. Throws
/// SystemError.
void write_next(int descriptor, std::span<const std::uint8_t> bytes);
/// Reads so many bytes from a place of the file, fewer where it ends before. Throws SystemError.
Bytes read_at(const FileDescriptor& file, std::uint64_t offset, std::size_t size);

std::uint64_t size_of(const FileDescriptor& file);
std::uint64_t size_of(const std::filesystem::path& path);
void cut(const FileDescriptor& file, std::uint64_t size);

/// Returns once everything written to the file is on the disk. Throws SystemError.
void sync(const FileDescriptor& file);
void sync_file(const std::filesystem::path& path);
/// The same for the names in the folder of a file.
void sync_folder_of(const std::filesystem::path& path);

/// Copies a file, sharing its blocks where the file system can. Throws SystemError.
void clone_file(const std::filesystem::path& from, const std::filesystem::path& to);

/// Gives a complete file its final name in one step that a crash does not split: afterwards the
/// name leads to the new file, before it to the old one or to none.
///
/// Throws SystemError; then the name leads where it did.
void put_in_place(const std::filesystem::path& part, const std::filesystem::path& target);

}  // namespace zenosphere
