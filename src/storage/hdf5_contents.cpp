#include "storage/hdf5_contents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "storage/checksum.hpp"
#include "storage/hdf5_checked.hpp"
#include "storage/hdf5_series.hpp"

namespace zenosphere::hdf5 {
namespace {

/// Bounds on a file of unknown origin, whose groups may hold each other.
constexpr int deepest = 8;
constexpr int most_objects = 10000;

std::optional<Type> numbers_of(const Handle& type) {
  for (const Type each : {Type::uint8, Type::int32, Type::int64, Type::float64}) {
    if (checked(H5Tequal(type.id(), number_type(each))) > 0) return each;
  }
  return std::nullopt;
}

const char* word(Type type) {
  switch (type) {
    case Type::uint8:
      return "uint8";
    case Type::int32:
      return "int32";
    case Type::int64:
      return "int64";
    case Type::float64:
      return "float64";
  }
  throw Error("unknown type");
}

std::vector<hsize_t> extents_of(const Handle& space) {
  std::vector<hsize_t> extents(checked(H5Sget_simple_extent_ndims(space.id())));
  checked(H5Sget_simple_extent_dims(space.id(), extents.data(), nullptr));
  return extents;
}

std::string line(std::uint32_t sum, const char* type, const std::vector<hsize_t>& extents) {
  std::string shape;  // g++ 12 sees an overflow in fmt::join
  for (const auto extent : extents) {
    if (!shape.empty()) shape += 'x';
    shape += std::to_string(extent);
  }
  return fmt::format("{:08x} {} {}", sum, type, shape.empty() ? "scalar" : shape);
}

std::uint32_t checksum_of_text(const std::string& text, std::uint32_t before = 0) {
  return checksum({reinterpret_cast<const std::uint8_t*>(text.c_str()), text.size() + 1}, before);
}

std::uint32_t checksum_of_rows(const Handle& dataset, Type type,
                               const std::vector<hsize_t>& extents) {
  constexpr std::int64_t bytes_at_once = 1 << 20;
  auto row_bytes = static_cast<std::int64_t>(H5Tget_size(number_type(type)));
  for (std::size_t axis = 1; axis < extents.size(); ++axis) {
    row_bytes *= static_cast<std::int64_t>(extents[axis]);
  }
  const auto rows = static_cast<std::int64_t>(extents.at(0));
  const std::int64_t most =
      std::max<std::int64_t>(1, bytes_at_once / std::max<std::int64_t>(1, row_bytes));
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(std::min(most, rows) * row_bytes));
  std::uint32_t sum = 0;
  for (std::int64_t first = 0; first < rows; first += most) {
    const std::int64_t count = std::min(most, rows - first);
    read_rows(dataset, type, first, count, bytes.data());
    sum = checksum({bytes.data(), static_cast<std::size_t>(count * row_bytes)}, sum);
  }
  return sum;
}

std::string digest_of_dataset(const Handle& group, const std::string& path) {
  const Handle dataset = opened(group, path);
  const auto extents = extents_of(owned(H5Dget_space(dataset.id())));
  const auto type = numbers_of(owned(H5Dget_type(dataset.id())));
  if (!type) return line(checksum_of_text(text(group, path)), "string", extents);
  if (extents.empty()) throw Error(path + " is a single value where rows are expected");
  return line(checksum_of_rows(dataset, *type, extents), word(*type), extents);
}

/// The strings of an attribute.
std::vector<std::string> texts_of(const Handle& attribute, std::size_t count) {
  const Handle type = owned(H5Aget_type(attribute.id()));
  if (checked(H5Tis_variable_str(type.id())) == 0) throw Error("an attribute of another type");
  std::vector<char*> pointers(count);
  checked(H5Aread(attribute.id(), type.id(), pointers.data()));
  std::vector<std::string> texts;
  for (char* const text : pointers) {
    texts.emplace_back(text ? text : "");
    H5free_memory(text);
  }
  return texts;
}

std::string digest_of_attribute(const Handle& object, const std::string& name) {
  constexpr std::size_t most = 1024;  // this program writes three values at most
  const Handle attribute = owned(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT));
  const Handle space = owned(H5Aget_space(attribute.id()));
  const auto extents = extents_of(space);
  const auto count = static_cast<std::size_t>(checked(H5Sget_simple_extent_npoints(space.id())));
  if (count > most) throw Error(name + " has too many values");
  const auto type = numbers_of(owned(H5Aget_type(attribute.id())));
  if (type) {
    std::vector<std::uint8_t> bytes(count * H5Tget_size(number_type(*type)));
    checked(H5Aread(attribute.id(), number_type(*type), bytes.data()));
    return line(checksum(bytes), word(*type), extents);
  }
  std::uint32_t sum = 0;
  for (const std::string& text : texts_of(attribute, count)) sum = checksum_of_text(text, sum);
  return line(sum, "string", extents);
}

/// Whether a value of this type and rank is one that this program could have written.
bool is_ours(const Handle& type, const Handle& space, bool is_dataset) {
  const int rank = checked(H5Sget_simple_extent_ndims(space.id()));
  if (numbers_of(type)) return !is_dataset || rank > 0;
  return checked(H5Tis_variable_str(type.id())) > 0 && (!is_dataset || rank == 0);
}

bool is_own_dataset(const Handle& dataset) {
  return is_ours(owned(H5Dget_type(dataset.id())), owned(H5Dget_space(dataset.id())), true);
}

bool is_own_attribute(const Handle& object, const std::string& name) {
  const Handle attribute = owned(H5Aopen(object.id(), name.c_str(), H5P_DEFAULT));
  return is_ours(owned(H5Aget_type(attribute.id())), owned(H5Aget_space(attribute.id())), false);
}

/// Adds a name in which nothing looks like the marks of a list.
void keep(const std::string& name, void* names) {
  if (name.find_first_of("@\n") != std::string::npos) return;
  static_cast<std::vector<std::string>*>(names)->push_back(name);
}

herr_t keep_attribute(hid_t, const char* name, const H5A_info_t*, void* names) {
  keep(name, names);
  return 0;
}

herr_t keep_member(hid_t, const char* name, const H5L_info_t* link, void* names) {
  if (link->type == H5L_TYPE_HARD) keep(name, names);
  return 0;
}

/// Collects names, object by object.
class Collector {
 public:
  void visit_members(const Handle& group, const std::string& prefix, int depth) {
    if (depth > deepest) return;
    std::vector<std::string> members;
    checked(H5Literate(group.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_member, &members));
    for (const auto& member : members) visit(opened(group, member), prefix + member, depth);
  }

  std::vector<std::string> names() && { return std::move(names_); }

 private:
  void visit(const Handle& object, const std::string& path, int depth) {
    if (++visits_ > most_objects) return;
    std::vector<std::string> attributes;
    checked(
        H5Aiterate2(object.id(), H5_INDEX_NAME, H5_ITER_INC, nullptr, keep_attribute, &attributes));
    for (const auto& each : attributes) {
      if (is_own_attribute(object, each)) names_.push_back(path + '@' + each);
    }
    const H5I_type_t kind = H5Iget_type(object.id());
    if (kind == H5I_DATASET && is_own_dataset(object)) names_.push_back(path);
    if (kind == H5I_GROUP) visit_members(object, path + '/', depth + 1);
  }

  std::vector<std::string> names_;
  int visits_ = 0;
};

}  // namespace

std::vector<std::string> value_names(const Handle& group) {
  Collector collector;
  collector.visit_members(group, "", 1);
  return std::move(collector).names();
}

std::string digest(const Handle& group, const std::string& name) {
  const auto mark = name.find('@');
  if (mark == std::string::npos) return digest_of_dataset(group, name);
  return digest_of_attribute(opened(group, name.substr(0, mark)), name.substr(mark + 1));
}

}  // namespace zenosphere::hdf5
