#include "storage/durable.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>
#include <vector>

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

/// Passes a result on, or throws what the system says.
template <class Result>
Result checked(Result result) {
  if (result < 0) throw SystemError(std::strerror(errno));
  return result;
}

fs::path folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

FileIdentity identity(const struct stat& status) { return {status.st_dev, status.st_ino}; }

/// Copies with the calls that every file system has.
void copy_rest(const FileDescriptor& from, const FileDescriptor& to, std::uint64_t offset) {
  constexpr std::size_t block = 1 << 20;
  for (Bytes bytes = read_at(from, offset, block); !bytes.empty();
       bytes = read_at(from, offset, block)) {
    write_at(to, offset, bytes);
    offset += bytes.size();
  }
}

}  // namespace

FileDescriptor::FileDescriptor(const fs::path& path, int flags)
    : id_(checked(open(path.c_str(), flags | O_CLOEXEC, 0666))) {}

FileDescriptor::FileDescriptor(FileDescriptor&& other) noexcept
    : id_(std::exchange(other.id_, -1)) {}

FileDescriptor& FileDescriptor::operator=(FileDescriptor&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

FileDescriptor::~FileDescriptor() {
  if (id_ >= 0) close(id_);
}

FileIdentity identity_of(const FileDescriptor& file) {
  struct stat status {};
  checked(fstat(file.id(), &status));
  return identity(status);
}

std::optional<FileIdentity> identity_of(const fs::path& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) return std::nullopt;
  return identity(status);
}

void write_at(const FileDescriptor& file, std::uint64_t offset,
              std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = pwrite(file.id(), bytes.data(), bytes.size(), static_cast<off_t>(offset));
    if (count < 0 && errno == EINTR) continue;
    checked(count);
    offset += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

void write_at(const FileDescriptor& file, std::uint64_t offset,
              std::span<const std::span<const std::uint8_t>> pieces) {
  std::vector<iovec> vectors;
  for (const auto piece : pieces) {
    vectors.push_back({const_cast<std::uint8_t*>(piece.data()), piece.size()});  // only read
  }
  ssize_t count = 0;
  do {
    count = pwritev(file.id(), vectors.data(), static_cast<int>(vectors.size()),
                    static_cast<off_t>(offset));
  } while (count < 0 && errno == EINTR);
  auto written = static_cast<std::size_t>(checked(count));
  for (const auto piece : pieces) {  // a full disk takes a part: the rest tells so
    const std::size_t done = std::min(written, piece.size());
    write_at(file, offset + done, piece.subspan(done));
    offset += piece.size();
    written -= done;
  }
}

void write_next(int descriptor, std::span<const std::uint8_t> bytes) {
  while (!bytes.empty()) {
    const ssize_t count = write(descriptor, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    bytes = bytes.subspan(static_cast<std::size_t>(checked(count)));
  }
}

Bytes read_at(const FileDescriptor& file, std::uint64_t offset, std::size_t size) {
  Bytes bytes(size);
  std::size_t done = 0;
  while (done < size) {
    const ssize_t count =
        pread(file.id(), bytes.data() + done, size - done, static_cast<off_t>(offset + done));
    if (count < 0 && errno == EINTR) continue;
    if (checked(count) == 0) break;
    done += static_cast<std::size_t>(count);
  }
  bytes.resize(done);
  return bytes;
}

std::uint64_t size_of(const FileDescriptor& file) {
  struct stat status {};
  checked(fstat(file.id(), &status));
  return static_cast<std::uint64_t>(status.st_size);
}

std::uint64_t size_of(const fs::path& path) { return size_of(FileDescriptor(path, O_RDONLY)); }

void cut(const FileDescriptor& file, std::uint64_t size) {
  checked(ftruncate(file.id(), static_cast<off_t>(size)));
}

void sync(const FileDescriptor& file) { checked(fsync(file.id())); }

void sync_file(const fs::path& path) { sync(FileDescriptor(path, O_RDONLY)); }

void sync_folder_of(const fs::path& path) {
  sync(FileDescriptor(folder_of(path), O_RDONLY | O_DIRECTORY));
}

void clone_file(const fs::path& from, const fs::path& to) {
  const FileDescriptor source(from, O_RDONLY);
  const FileDescriptor copy(to, O_WRONLY | O_CREAT | O_TRUNC);
  const std::uint64_t size = size_of(source);
  std::uint64_t done = 0;
  while (done < size) {
    const std::size_t left = static_cast<std::size_t>(size - done);
    const ssize_t count = copy_file_range(source.id(), nullptr, copy.id(), nullptr, left, 0);
    if (count <= 0) break;  // not on every file system; the plain calls then tell what is wrong
    done += static_cast<std::uint64_t>(count);
  }
  copy_rest(source, copy, done);
}

void put_in_place(const fs::path& part, const fs::path& target) {
  sync_file(part);
  checked(std::rename(part.c_str(), target.c_str()));
  sync_folder_of(target);
}

}  // namespace zenosphere
