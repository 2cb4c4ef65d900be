#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

/// A small, typed and owning surface over the C API of HDF5, which no other file sees.
///
/// Arrays are row-major and numbers little-endian in the file. Everything here throws `Error`;
/// the caller knows which file is meant and says so. HDF5 prints nothing, loads no plug-ins and
/// opens no file but the one that is asked for. A damaged file can still make it crash or allocate
/// without bound: files of unknown origin are read in a sandbox first
/// (storage/sandboxed_read.hpp).
namespace zenosphere::hdf5 {

/// A call into HDF5 failed. The text is the reason: the system's ("No space left on device")
/// where the system refused, else the innermost entry of HDF5's error stack.
class Error : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Owns one identifier of HDF5: a file, group, dataset, attribute, type or space.
class Handle {
 public:
  Handle() = default;
  explicit Handle(std::int64_t id) noexcept : id_(id) {}
  Handle(Handle&& other) noexcept;
  Handle& operator=(Handle&& other) noexcept;
  ~Handle();

  std::int64_t id() const { return id_; }

  /// Lets go without closing. After a failed write HDF5 could only fail again, or crash.
  void abandon() noexcept { id_ = -1; }

 private:
  std::int64_t id_ = -1;
};

/// A new file; fails if the path exists. Readable by HDF5 1.8 and later, and not locked.
Handle created_file(const std::filesystem::path& path);
/// An existing file, to read only.
Handle opened_file(const std::filesystem::path& path);
/// An existing file, to read and write.
Handle reopened_file(const std::filesystem::path& path);
/// Whether a readable file has the signature of HDF5.
bool is_hdf5(const std::filesystem::path& path);
/// Where HDF5's part of a file ends: bytes that follow it are nothing to HDF5.
std::int64_t end_of(const Handle& file);
/// Hands everything written so far to the operating system.
void flush(const Handle& file);

Handle created_group(const Handle& parent, const std::string& path);
/// The group or dataset at `path`, which may have several parts ("a/b/c").
Handle opened(const Handle& parent, const std::string& path);
/// Whether there is a link `name` (one part) in `parent`.
bool contains(const Handle& parent, const std::string& name);
/// Removes the link `name` (one part) from `parent`, if it is there.
void remove(const Handle& parent, const std::string& name);
/// A second, equal name for the object at `existing`.
void link(const Handle& parent, const std::string& existing, const std::string& name);

void write_attribute(const Handle& object, const std::string& name, std::string_view text);
void write_attribute(const Handle& object, const std::string& name,
                     const std::vector<std::string>& texts);
/// The number attributes are written in place where they exist already.
void write_attribute(const Handle& object, const std::string& name, std::uint8_t value);
void write_attribute(const Handle& object, const std::string& name, std::int64_t value);
void write_attribute(const Handle& object, const std::string& name, double value);
void write_attribute(const Handle& object, const std::string& name,
                     const std::vector<std::int64_t>& values);

bool has_attribute(const Handle& object, const std::string& name);
std::string text_attribute(const Handle& object, const std::string& name);
std::int64_t number_attribute(const Handle& object, const std::string& name);
double real_attribute(const Handle& object, const std::string& name);

/// A scalar dataset of one UTF-8 string; it ends at the first zero byte. Written in place where it
/// exists already.
void write_text(const Handle& parent, const std::string& name, std::string_view text);
std::string text(const Handle& parent, const std::string& path);

}  // namespace zenosphere::hdf5
