#include "storage/hdf5.hpp"

#include <bit>
#include <utility>

#include "storage/hdf5_checked.hpp"

namespace zenosphere::hdf5 {
namespace {

/// Keeps the innermost entry of an error stack, or the system's message where there is one.
herr_t collect_reason(unsigned, const H5E_error2_t* entry, void* result) {
  auto& reason = *static_cast<std::string*>(result);
  const std::string text = entry->desc ? entry->desc : "";
  const std::string mark = "error message = '";  // HDF5's wording around strerror
  const auto start = text.find(mark);
  if (start != std::string::npos) {
    const auto from = start + mark.size();
    reason = text.substr(from, text.find('\'', from) - from);
    return 1;  // ends the walk
  }
  if (reason.empty()) reason = text;
  return 0;
}

/// Switches off HDF5's work at exit, which crashes where a file could not be closed (HDF5 1.10.8),
/// and what a file could use to reach beyond itself: filters loaded as plug-ins, links to other
/// files.
bool restricted() {
  H5dont_atexit();
  H5PLset_loading_state(0);
  return H5Lunregister(H5L_TYPE_EXTERNAL) >= 0;
}

/// Makes HDF5 harmless, and switches off its own printing of errors, which a thread-safe HDF5 keeps
/// for each thread.
void silence() {
  [[maybe_unused]] static const bool once = restricted();
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

Handle text_type() {
  Handle type = owned(H5Tcopy(H5T_C_S1));
  checked(H5Tset_size(type.id(), H5T_VARIABLE));
  checked(H5Tset_cset(type.id(), H5T_CSET_UTF8));
  return type;
}

/// Access without HDF5's lock: the lock would keep readers out as long as a run lasts.
Handle file_access() {
  silence();
  Handle access = owned(H5Pcreate(H5P_FILE_ACCESS));
  checked(H5Pset_file_locking(access.id(), false, true));
  return access;
}

static_assert(std::endian::native == std::endian::little);  // memory types are file types

Handle scalar_space() { return owned(H5Screate(H5S_SCALAR)); }

/// The attribute `name`, created if it is not there.
Handle attribute_to_write(const Handle& object, const std::string& name, hid_t type,
                          const Handle& space) {
  if (checked(H5Aexists(object.id(), name.c_str())) > 0) {
    return owned(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT));
  }
  return owned(H5Acreate2(object.id(), name.c_str(), type, space.id(), H5P_DEFAULT, H5P_DEFAULT));
}

void write_texts(const Handle& object, const std::string& name, const Handle& space,
                 const std::vector<const char*>& texts) {
  const Handle type = text_type();
  const Handle attribute = attribute_to_write(object, name, type.id(), space);
  checked(H5Awrite(attribute.id(), type.id(), texts.data()));
}

void write_numbers(const Handle& object, const std::string& name, hid_t type, const Handle& space,
                   const void* values) {
  const Handle attribute = attribute_to_write(object, name, type, space);
  checked(H5Awrite(attribute.id(), type, values));
}

/// Takes over a string that HDF5 allocated.
std::string adopted(char* text) {
  std::string result = text ? text : "";
  H5free_memory(text);
  return result;
}

void require_text(const Handle& type, const std::string& name) {
  if (checked(H5Tis_variable_str(type.id())) == 0) throw Error(name + " is not a string");
}

/// More values would be written beyond the variable that takes one.
void require_one_value(const Handle& space, const std::string& name) {
  if (checked(H5Sget_simple_extent_npoints(space.id())) != 1) {
    throw Error(name + " is not a single value");
  }
}

/// Refuses a dataset whose values are in other files: raw ones, or datasets that it stitches.
void require_own_values(const Handle& object, const std::string& path) {
  if (H5Iget_type(object.id()) != H5I_DATASET) return;
  const Handle creation = owned(H5Dget_create_plist(object.id()));
  const bool stitched = H5Pget_layout(creation.id()) == H5D_VIRTUAL;
  if (stitched || H5Pget_external_count(creation.id()) != 0) {
    throw Error(path + " takes its values from other files");
  }
}

}  // namespace

std::string reason_of_failure() {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, collect_reason, &reason);
  return reason.empty() ? "unknown error of HDF5" : reason;
}

Handle::Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, -1)) {}

Handle& Handle::operator=(Handle&& other) noexcept {
  std::swap(id_, other.id_);
  return *this;
}

Handle::~Handle() {
  if (id_ >= 0) H5Idec_ref(id_);
}

Handle created_file(const std::filesystem::path& path) {
  const Handle access = file_access();
  return owned(H5Fcreate(path.c_str(), H5F_ACC_EXCL, H5P_DEFAULT, access.id()));
}

Handle opened_file(const std::filesystem::path& path) {
  const Handle access = file_access();
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, access.id());
  if (file >= 0) return Handle(file);
  // h5py in this process may have it open with HDF5's lock, which must then be asked for here too.
  return owned(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
}

Handle reopened_file(const std::filesystem::path& path) {
  const Handle access = file_access();
  return owned(H5Fopen(path.c_str(), H5F_ACC_RDWR, access.id()));
}

bool is_hdf5(const std::filesystem::path& path) {
  silence();
  return H5Fis_hdf5(path.c_str()) > 0;
}

std::int64_t end_of(const Handle& file) {
  haddr_t end = 0;
  checked(H5Fget_eoa(file.id(), &end));
  return static_cast<std::int64_t>(end);
}

void flush(const Handle& file) { checked(H5Fflush(file.id(), H5F_SCOPE_GLOBAL)); }

Handle created_group(const Handle& parent, const std::string& path) {
  return owned(H5Gcreate2(parent.id(), path.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
}

Handle opened(const Handle& parent, const std::string& path) {
  Handle object = owned(H5Oopen(parent.id(), path.c_str(), H5P_DEFAULT));
  require_own_values(object, path);
  return object;
}

bool contains(const Handle& parent, const std::string& name) {
  return checked(H5Lexists(parent.id(), name.c_str(), H5P_DEFAULT)) > 0;
}

void remove(const Handle& parent, const std::string& name) {
  if (contains(parent, name)) checked(H5Ldelete(parent.id(), name.c_str(), H5P_DEFAULT));
}

void link(const Handle& parent, const std::string& existing, const std::string& name) {
  checked(H5Lcreate_hard(parent.id(), existing.c_str(), parent.id(), name.c_str(), H5P_DEFAULT,
                         H5P_DEFAULT));
}

void write_attribute(const Handle& object, const std::string& name, std::string_view text) {
  const std::string terminated(text);
  write_texts(object, name, scalar_space(), {terminated.c_str()});
}

void write_attribute(const Handle& object, const std::string& name,
                     const std::vector<std::string>& texts) {
  std::vector<const char*> pointers;
  pointers.reserve(texts.size());
  for (const auto& each : texts) pointers.push_back(each.c_str());
  write_texts(object, name, simple_space({texts.size()}), pointers);
}

void write_attribute(const Handle& object, const std::string& name, std::uint8_t value) {
  write_numbers(object, name, H5T_STD_U8LE, scalar_space(), &value);
}

void write_attribute(const Handle& object, const std::string& name, std::int64_t value) {
  write_numbers(object, name, H5T_STD_I64LE, scalar_space(), &value);
}

void write_attribute(const Handle& object, const std::string& name, double value) {
  write_numbers(object, name, H5T_IEEE_F64LE, scalar_space(), &value);
}

void write_attribute(const Handle& object, const std::string& name,
                     const std::vector<std::int64_t>& values) {
  write_numbers(object, name, H5T_STD_I64LE, simple_space({values.size()}), values.data());
}

bool has_attribute(const Handle& object, const std::string& name) {
  return H5Aexists(object.id(), name.c_str()) > 0;
}

std::string text_attribute(const Handle& object, const std::string& name) {
  const Handle attribute = owned(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT));
  require_text(owned(H5Aget_type(attribute.id())), name);
  require_one_value(owned(H5Aget_space(attribute.id())), name);
  char* text = nullptr;
  checked(H5Aread(attribute.id(), text_type().id(), &text));
  return adopted(text);
}

std::int64_t number_attribute(const Handle& object, const std::string& name) {
  const Handle attribute = owned(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT));
  require_one_value(owned(H5Aget_space(attribute.id())), name);
  std::int64_t value = 0;
  checked(H5Aread(attribute.id(), H5T_STD_I64LE, &value));
  return value;
}

double real_attribute(const Handle& object, const std::string& name) {
  const Handle attribute = owned(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT));
  require_one_value(owned(H5Aget_space(attribute.id())), name);
  double value = 0;
  checked(H5Aread(attribute.id(), H5T_IEEE_F64LE, &value));
  return value;
}

void write_text(const Handle& parent, const std::string& name, std::string_view text) {
  const Handle type = text_type();
  const Handle space = scalar_space();
  const Handle dataset = contains(parent, name)
                             ? opened(parent, name)
                             : owned(H5Dcreate2(parent.id(), name.c_str(), type.id(), space.id(),
                                                H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  const std::string terminated(text);
  const char* pointer = terminated.c_str();
  checked(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &pointer));
}

std::string text(const Handle& parent, const std::string& path) {
  const Handle dataset = opened(parent, path);
  require_text(owned(H5Dget_type(dataset.id())), path);
  require_one_value(owned(H5Dget_space(dataset.id())), path);
  char* text = nullptr;
  checked(H5Dread(dataset.id(), text_type().id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, &text));
  return adopted(text);
}

}  // namespace zenosphere::hdf5
