#pragma once

#include <filesystem>

namespace zenosphere {

/// What to do where something has the name already.
enum class Occupied { refuse, replace };

/// A file, or a folder of frames, that appears under its name once it is complete, in one step.
/// Until then, and for ever where that fails, only its draft is there: `NAME.part-` and the number
/// of the process. Every function throws OutputError.
class Draft {
 public:
  enum class Kind { file, folder };

  /// \param target    name in the end; symbolic links are followed
  /// \param occupied  `replace` permits a regular file, or a folder with nothing but frames in it
  Draft(const std::filesystem::path& target, Kind kind, Occupied occupied);
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;
  /// Deletes what was not put in place.
  ~Draft();

  /// Where to make it. A folder is there already.
  const std::filesystem::path& path() const { return path_; }

  /// Gives it its name. A folder that is there moves aside first, and is deleted afterwards.
  void put_in_place();

 private:
  void require_permitted() const;

  std::filesystem::path shown_, target_, path_;
  Kind kind_;
  Occupied occupied_;
  bool is_in_place_ = false;
};

/// `frame-000012.vtp`: the only names that a folder may hold for `Occupied::replace`.
std::filesystem::path frame_name(std::int64_t number);

}  // namespace zenosphere
