#pragma once

#include <hdf5.h>

#include <string>
#include <vector>

#include "storage/hdf5.hpp"

/// What the sources behind hdf5.hpp share; included by no one else, since it shows <hdf5.h>.
namespace zenosphere::hdf5 {

/// The reason in the error stack of the call that just failed.
std::string reason_of_failure();

/// Passes a result on, or turns HDF5's error stack into an `Error`.
template <class Result>
Result checked(Result result) {
  if (result < 0) throw Error(reason_of_failure());
  return result;
}

inline Handle owned(hid_t id) { return Handle(checked(id)); }

inline Handle simple_space(const std::vector<hsize_t>& count) {
  return owned(H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr));
}

enum class Type;

/// The type of a number, in memory and in the file alike.
hid_t number_type(Type type);

}  // namespace zenosphere::hdf5
