#pragma once

#include <pybind11/numpy.h>

#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace zenosphere {

/// An array that takes over a vector, without copying it.
///
/// \param shape  its product is the size of the vector
/// \param type   of an item, as numpy has it
template <class T>
pybind11::array owning_array(std::vector<T> values, std::vector<pybind11::ssize_t> shape,
                             const pybind11::dtype& type = pybind11::dtype::of<T>()) {
  auto kept = std::make_unique<std::vector<T>>(std::move(values));
  const T* data = kept->data();
  const pybind11::capsule owner(kept.get(),
                                [](void* vector) { delete static_cast<std::vector<T>*>(vector); });
  kept.release();
  return pybind11::array(type, std::move(shape), data, owner);
}

/// A table of so many columns.
template <class T>
pybind11::array owning_table(std::vector<T> values, pybind11::ssize_t columns) {
  const auto rows = static_cast<pybind11::ssize_t>(values.size()) / columns;
  return owning_array(std::move(values), {rows, columns});
}

/// The images of the spheres of a snapshot, or None where they are not known.
inline pybind11::object owning_images(std::vector<std::int32_t> images, pybind11::ssize_t columns) {
  if (images.empty()) return pybind11::none();
  return owning_table(std::move(images), columns);
}

/// The angular velocities of a snapshot, three columns or one, or None where nothing turns.
inline pybind11::object owning_spins(std::vector<double> spins, pybind11::ssize_t dimension) {
  if (spins.empty()) return pybind11::none();
  return owning_table(std::move(spins), dimension == 3 ? 3 : 1);
}

}  // namespace zenosphere
