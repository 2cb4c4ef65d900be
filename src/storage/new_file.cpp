#include "storage/new_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "model/errors.hpp"

namespace zenosphere {
namespace {

constexpr std::size_t buffer_size = 1 << 20;

/// Does something with the file; what the system says goes to the user.
template <class Action>
auto guarded(const std::filesystem::path& shown, Action action) {
  try {
    return action();
  } catch (const SystemError& error) {
    throw OutputError(
        fmt::format("{}: could not be written ({}); nothing of it was kept, make "
                    "room or choose another place",
                    shown.string(), error.what()));
  }
}

}  // namespace

NewFile::NewFile(const std::filesystem::path& path, const std::filesystem::path& shown)
    : shown_(shown),
      file_(guarded(shown, [&] { return FileDescriptor(path, O_WRONLY | O_CREAT | O_EXCL); })) {
  buffer_.reserve(buffer_size);
}

NewFile::NewFile(StandardOutput) : shown_("standard output") { buffer_.reserve(buffer_size); }

void NewFile::write(std::string_view text) {
  if (buffer_.size() + text.size() > buffer_size) flush();
  buffer_.insert(buffer_.end(), text.begin(), text.end());
}

void NewFile::flush() {
  guarded(shown_,
          [&] { file_ ? write_at(*file_, size_, buffer_) : write_next(STDOUT_FILENO, buffer_); });
  size_ += buffer_.size();
  buffer_.clear();
}

void NewFile::close() {
  flush();
  if (file_) guarded(shown_, [&] { sync(*file_); });
}

}  // namespace zenosphere
