#include "storage/atomic_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <utility>

#include "model/errors.hpp"
#include "storage/durable.hpp"

namespace zenosphere {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& path, const std::string& text) {
  throw OutputError(path.string() + ": " + text);
}

fs::path with_suffix(fs::path path, const std::string& suffix) {
  path += suffix;
  return path;
}

bool holds_only(const fs::path& folder, bool (*is_of_kind)(const fs::directory_entry&)) {
  std::error_code failure;
  const fs::directory_iterator entries(folder, failure);
  return !failure && std::all_of(begin(entries), end(entries), is_of_kind);
}

/// Does something to the file system; what that says goes to the user.
template <class Action>
void guarded(const fs::path& shown, const std::string& what, Action action) {
  try {
    action();
  } catch (const fs::filesystem_error& error) {
    refuse(shown,
           fmt::format("could not be {} ({}); choose another place", what, error.code().message()));
  } catch (const SystemError& error) {
    refuse(shown, fmt::format("could not be {} ({}); choose another place", what, error.what()));
  }
}

}  // namespace

fs::path permitted_target(const fs::path& path, Existing existing, const FolderOf* kind) {
  std::error_code ignored;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (!fs::is_directory(folder, ignored)) {
    refuse(path,
           fmt::format("there is no folder {}; create it or choose another", folder.string()));
  }
  const auto status = fs::status(path, ignored);
  if (!fs::exists(status)) return path;
  if (!kind && fs::is_directory(status)) refuse(path, "is a folder; choose the name of a file");
  if (!kind && !fs::is_regular_file(status)) {
    refuse(path, "is not a regular file; choose another name");
  }
  if (existing == Existing::refuse) {
    refuse(path, "exists already; choose another name or pass --overwrite");
  }
  if (kind && !(fs::is_directory(status) && holds_only(path, kind->holds))) {
    refuse(path, "is not a folder of " + kind->content + " only; choose another name");
  }
  return fs::is_symlink(path, ignored) ? fs::canonical(path, ignored) : path;
}

AtomicFile::AtomicFile(const fs::path& target, Existing existing)
    : AtomicFile(target, existing, std::optional<FolderOf>()) {}

AtomicFile::AtomicFile(const fs::path& target, Existing existing, FolderOf kind)
    : AtomicFile(target, existing, std::optional(std::move(kind))) {}

AtomicFile::AtomicFile(const fs::path& target, Existing existing, std::optional<FolderOf> kind)
    : shown_(target),
      existing_(existing),
      kind_(std::move(kind)),
      target_(permitted()),
      path_(with_suffix(target_, fmt::format(".part-{}", getpid()))) {
  std::error_code ignored;
  if (fs::exists(fs::symlink_status(path_, ignored))) {
    refuse(path_, "is left from a command that was cut off; delete it");
  }
  if (kind_) guarded(shown_, "created", [&] { fs::create_directory(path_); });
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!is_in_place_) fs::remove_all(path_, ignored);
}

fs::path AtomicFile::permitted() const {
  return permitted_target(shown_, existing_, kind_ ? &*kind_ : nullptr);
}

void AtomicFile::put_in_place() {
  permitted();  // another process may have been faster
  guarded(shown_, "put in place", [&] {
    const fs::path old = with_suffix(target_, fmt::format(".old-{}", getpid()));
    const bool moves_aside = fs::is_directory(target_);
    if (moves_aside) fs::rename(target_, old);
    fs::rename(path_, target_);
    is_in_place_ = true;
    sync_folder_of(target_);
    if (moves_aside) fs::remove_all(old);
  });
}

}  // namespace zenosphere
