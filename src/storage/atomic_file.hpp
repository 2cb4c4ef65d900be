#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace zenosphere {

/// What to do where something has the name already.
enum class Existing { refuse, replace };

/// What a folder is made of. Only a folder that holds nothing else is ever replaced.
struct FolderOf {
  std::string content;  ///< for the message: "frames (frame-*.vtp)"
  bool (*holds)(const std::filesystem::directory_entry& entry);
};

/// Where a new file is to be in the end, or a folder of one kind: symbolic links are followed.
///
/// \param existing  `replace` permits a regular file, or a folder of that kind
/// \param kind      null: a file is wanted
/// Throws OutputError where there is no folder to put it in, or something that may not be replaced.
std::filesystem::path permitted_target(const std::filesystem::path& path, Existing existing,
                                       const FolderOf* kind = nullptr);

/// A file, or a folder of files of one kind, that appears under its name once it is complete, in
/// one step. Until then, and for ever where that fails, it is only there as `NAME.part-` and the
/// number of the process. Every function throws OutputError.
class AtomicFile {
 public:
  /// \param target    name in the end; symbolic links are followed
  /// \param existing  `replace` permits a regular file
  AtomicFile(const std::filesystem::path& target, Existing existing);
  /// A folder, which is made at path().
  AtomicFile(const std::filesystem::path& target, Existing existing, FolderOf kind);
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  /// Deletes what was not put in place.
  ~AtomicFile();

  /// Where to make it.
  const std::filesystem::path& path() const { return path_; }

  /// Gives it its name. A folder that is there moves aside first, and is deleted afterwards.
  void put_in_place();

 private:
  AtomicFile(const std::filesystem::path& target, Existing existing, std::optional<FolderOf> kind);
  std::filesystem::path permitted() const;

  std::filesystem::path shown_;
  Existing existing_;
  std::optional<FolderOf> kind_;  ///< none: a file
  std::filesystem::path target_, path_;
  bool is_in_place_ = false;
};

}  // namespace zenosphere
