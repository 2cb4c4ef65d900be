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

AtomicFile::AtomicFile(const fs::path& target, Existing existing)
    : AtomicFile(target, existing, FolderOf{}) {}

AtomicFile::AtomicFile(const fs::path& target, Existing existing, FolderOf kind)
    : shown_(target), target_(target), existing_(existing), kind_(std::move(kind)) {
  std::error_code ignored;
  const bool leads_on = fs::is_symlink(target, ignored) && fs::exists(target, ignored);
  if (leads_on) target_ = fs::canonical(target, ignored);
  require_permitted();
  path_ = with_suffix(target_, fmt::format(".part-{}", getpid()));
  if (fs::exists(fs::symlink_status(path_, ignored))) {
    refuse(path_, "is left from a command that was cut off; delete it");
  }
  if (is_folder()) guarded(shown_, "created", [&] { fs::create_directory(path_); });
}

AtomicFile::~AtomicFile() {
  std::error_code ignored;
  if (!is_in_place_) fs::remove_all(path_, ignored);
}

/// Throws where the folder is missing or something is there that may not be replaced.
void AtomicFile::require_permitted() const {
  std::error_code ignored;
  const fs::path parent = target_.has_parent_path() ? target_.parent_path() : ".";
  if (!fs::is_directory(parent, ignored)) {
    refuse(shown_,
           fmt::format("there is no folder {}; create it or choose another", parent.string()));
  }
  const auto status = fs::status(target_, ignored);
  if (!fs::exists(status)) return;
  if (!is_folder() && !fs::is_regular_file(status)) {
    refuse(shown_, "is not a regular file; choose another name");
  }
  if (existing_ == Existing::refuse) {
    refuse(shown_, "exists already; choose another name or pass --overwrite");
  }
  if (is_folder() && !(fs::is_directory(status) && holds_only(target_, kind_.holds))) {
    refuse(shown_, "is not a folder of " + kind_.content + " only; choose another name");
  }
}

void AtomicFile::put_in_place() {
  require_permitted();  // another process may have been faster
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
