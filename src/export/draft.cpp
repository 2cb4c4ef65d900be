#include "export/draft.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>

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

bool is_frame(const fs::directory_entry& entry) {
  const std::string name = entry.path().filename().string();
  return entry.is_regular_file() && name.starts_with("frame-") && name.ends_with(".vtp");
}

bool holds_frames_only(const fs::path& folder) {
  std::error_code failure;
  const fs::directory_iterator entries(folder, failure);
  return !failure && std::all_of(begin(entries), end(entries), is_frame);
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

fs::path frame_name(std::int64_t number) { return fmt::format("frame-{:06}.vtp", number); }

Draft::Draft(const fs::path& target, Kind kind, Occupied occupied)
    : shown_(target), target_(target), kind_(kind), occupied_(occupied) {
  std::error_code ignored;
  const bool leads_on = fs::is_symlink(target, ignored) && fs::exists(target, ignored);
  if (leads_on) target_ = fs::canonical(target, ignored);
  require_permitted();
  path_ = with_suffix(target_, fmt::format(".part-{}", getpid()));
  if (fs::exists(fs::symlink_status(path_, ignored))) {
    refuse(path_, "is left from an export that was cut off; delete it");
  }
  if (kind == Kind::folder) guarded(shown_, "created", [&] { fs::create_directory(path_); });
}

Draft::~Draft() {
  std::error_code ignored;
  if (!is_in_place_) fs::remove_all(path_, ignored);
}

/// Throws where the folder is missing or something is there that may not be replaced.
void Draft::require_permitted() const {
  std::error_code ignored;
  const fs::path parent = target_.has_parent_path() ? target_.parent_path() : ".";
  if (!fs::is_directory(parent, ignored)) {
    refuse(shown_,
           fmt::format("there is no folder {}; create it or choose another", parent.string()));
  }
  const auto status = fs::status(target_, ignored);
  if (!fs::exists(status)) return;
  if (occupied_ == Occupied::refuse) {
    refuse(shown_, "exists already; choose another name or pass --overwrite");
  }
  if (kind_ == Kind::file && !fs::is_regular_file(status)) {
    refuse(shown_, "is not a regular file; choose another name");
  }
  if (kind_ == Kind::folder && !(fs::is_directory(status) && holds_frames_only(target_))) {
    refuse(shown_, "is not a folder of frames only (frame-*.vtp); choose another name");
  }
}

void Draft::put_in_place() {
  require_permitted();  // somebody may have been faster
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
