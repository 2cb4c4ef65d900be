#include "python/collision_rows.hpp"

#include <utility>

#include "python/arrays.hpp"

namespace zenosphere {

namespace py = pybind11;

py::dtype collision_dtype() {
  py::list names, formats, offsets;
  const CollisionRow row;
  const auto* const begin = reinterpret_cast<const char*>(&row);
  CollisionRows::fields(CollisionRows(), [&]<class T>(const char* name, const std::vector<T>&,
                                                      T CollisionRow::*part) {
    names.append(name);
    formats.append(py::dtype::of<T>());
    offsets.append(reinterpret_cast<const char*>(&(row.*part)) - begin);
  });
  return py::dtype(names, formats, offsets, sizeof row);
}

py::array owning_rows(std::vector<CollisionRow> rows) {
  const auto count = static_cast<py::ssize_t>(rows.size());
  return owning_array(std::move(rows), {count}, collision_dtype());
}

}  // namespace zenosphere
