#pragma once

#include <filesystem>
#include <string>

namespace zenosphere {

/// What to do where something has the name already.
enum class Existing { refuse, replace };

/// A file, or a folder of files of one kind, that appears under its name once it is complete, in
/// one step. Until then, and for ever where that fails, it is only there as `NAME.part-` and the
/// number of the process. Every function throws OutputError.
class AtomicFile {
 public:
  /// What a folder is made of. Only a folder that holds nothing else is ever replaced.
  struct FolderOf {
    std::string content;  ///< for the message: "frames (frame-*.vtp)"
    bool (*holds)(const std::filesystem::directory_entry& entry);
  };

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
  bool is_folder() const { return kind_.holds != nullptr; }
  void require_permitted() const;

  std::filesystem::path shown_, target_, path_;
  Existing existing_;
  FolderOf kind_;  ///< holds: null for a file
  bool is_in_place_ = false;
};

}  // namespace zenosphere
