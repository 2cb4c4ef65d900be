#include "storage/stored_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "model/errors.hpp"
#include "storage/anatomy_group.hpp"
#include "storage/hdf5_series.hpp"
#include "storage/series_group.hpp"
#include "storage/stored_info.hpp"

namespace zenosphere {
namespace {

const std::string spheres_group = "particles/spheres/";

template <class Action>
auto reading(const std::filesystem::path& path, Action action) {
  try {
    return action();
  } catch (const hdf5::Error& error) {
    throw InputError(
        fmt::format("{}: cannot be read ({}); it may be damaged", path.string(), error.what()));
  }
}

void require_shape(const hdf5::Handle& file, const std::string& path,
                   const std::vector<std::int64_t>& shape) {
  if (hdf5::shape(file, path) != shape) throw hdf5::Error(path + " has another shape");
}

/// Rows of a dataset, each of `size` numbers.
template <class T>
std::vector<T> rows_of(const hdf5::Handle& file, const std::string& path, std::int64_t first,
                       std::int64_t count, std::int64_t size) {
  std::vector<T> values(static_cast<std::size_t>(count * size));
  hdf5::read_rows(hdf5::opened(file, path), hdf5::type_of<T>, first, count, values.data());
  return values;
}

/// Row `n` of so many numbers.
template <class T>
std::vector<T> row(const std::vector<T>& values, std::int64_t n, std::int64_t size) {
  const auto begin = values.begin() + n * size;
  return {begin, begin + size};
}

}  // namespace

StoredRun::StoredRun(const std::filesystem::path& path)
    : path_(path), info_(read_stored_info(path)) {
  reading(path, [&] {
    // Numbers are stored as they are, so that a file cannot hold more of them than it has bytes.
    const auto bytes = static_cast<std::int64_t>(std::filesystem::file_size(path));
    if (info_.snapshots > 0 && info_.spheres > bytes / (info_.snapshots * info_.dimension * 8)) {
      throw hdf5::Error("more spheres than bytes");
    }
    file_ = hdf5::opened_file(path);
    const std::int64_t snapshots = info_.snapshots;
    const std::int64_t dimension = info_.dimension;
    for (const std::string name : {"position/value", "velocity/value"}) {
      require_shape(file_, spheres_group + name, {snapshots, info_.spheres, dimension});
    }
    if (has_images()) {
      require_shape(file_, spheres_group + "image/value", {snapshots, info_.spheres, dimension});
    }
    if (spin_components() > 0) {
      require_shape(file_, spheres_group + "angular_velocity/value",
                    {snapshots, info_.spheres, spin_components() / info_.spheres});
    }
    require_shape(file_, spheres_group + "box/edges/value", {snapshots, dimension, dimension});
    require_shape(file_, spheres_group + "position/time", {snapshots});
    CollisionRows::fields(CollisionRows(), [&](const std::string& name, const auto&, auto) {
      require_shape(file_, "collisions/" + name, {info_.logged_collisions});
    });
  });
}

bool StoredRun::has_images() const {
  return hdf5::contains(hdf5::opened(file_, spheres_group), "image");
}

std::int64_t StoredRun::spin_components() const {
  const bool turns = hdf5::contains(hdf5::opened(file_, spheres_group), "angular_velocity");
  return turns ? info_.spheres * (info_.dimension == 3 ? 3 : 1) : 0;
}

Snapshot StoredRun::snapshot(std::int64_t n) const {
  const auto held = static_cast<std::int64_t>(block_.steps.size());
  if (n < block_.first || n >= block_.first + held) read_block(n);
  const std::int64_t at = n - block_.first;
  const std::int64_t components = info_.spheres * info_.dimension;
  const auto place = static_cast<std::size_t>(at);
  return {.step = block_.steps[place],
          .time = block_.times[place],
          .positions = row(block_.positions, at, components),
          .velocities = row(block_.velocities, at, components),
          .box_edges = row(block_.box_edges, at, info_.dimension * info_.dimension),
          .images = has_images() ? row(block_.images, at, components) : std::vector<std::int32_t>{},
          .angular_velocities = row(block_.angular_velocities, at, spin_components())};
}

void StoredRun::read_block(std::int64_t first) const {
  constexpr std::int64_t most_components = 65536;  // half a MiB of positions
  const std::int64_t components = info_.spheres * info_.dimension;
  const std::int64_t count = std::clamp<std::int64_t>(
      most_components / components, 1, std::max<std::int64_t>(info_.snapshots - first, 1));
  const auto read = [&](const std::string& name, std::int64_t size) {
    return rows_of<double>(file_, spheres_group + name, first, count, size);
  };
  block_ = reading(path_, [&] {
    using Images = std::vector<std::int32_t>;
    const std::string images = spheres_group + "image/value";
    return Block{
        .first = first,
        .steps = rows_of<std::int64_t>(file_, spheres_group + "position/step", first, count, 1),
        .times = read("position/time", 1),
        .positions = read("position/value", components),
        .velocities = read("velocity/value", components),
        .box_edges = read("box/edges/value", info_.dimension * info_.dimension),
        .images = has_images() ? rows_of<std::int32_t>(file_, images, first, count, components)
                               : Images{},
        .angular_velocities = spin_components() > 0
                                  ? read("angular_velocity/value", spin_components())
                                  : std::vector<double>{}};
  });
}

Grains<double> StoredRun::grains() const {
  return reading(path_, [&] {
    Grains<double> grains;
    const auto group = hdf5::opened(file_, spheres_group);
    const auto read = [&]<class T>(const std::string& name, std::vector<T>& values) {
      if (!hdf5::contains(group, name)) return;
      require_shape(file_, spheres_group + name, {info_.spheres});
      values = rows_of<T>(file_, spheres_group + name, 0, info_.spheres, 1);
    };
    read("diameter", grains.diameters);
    read("mass", grains.masses);
    read("species", grains.kinds);
    read("immobile", grains.immobile);
    const auto is_size = [](double size) { return std::isfinite(size) && size > 0; };
    const auto is_kind = [](std::int32_t kind) {
      return kind >= 0 && kind < Grains<double>::most_kinds;
    };
    const bool are_possible = std::ranges::all_of(grains.diameters, is_size) &&
                              std::ranges::all_of(grains.masses, is_size) &&
                              std::ranges::all_of(grains.kinds, is_kind);
    if (!are_possible) throw hdf5::Error("spheres that there cannot be");
    return grains;
  });
}

std::vector<CollisionRow> StoredRun::rows(std::int64_t first, std::int64_t count) const {
  return reading(path_, [&] {
    std::vector<CollisionRow> rows(static_cast<std::size_t>(count));
    CollisionRows::fields(
        CollisionRows(),
        [&]<class T>(const std::string& name, const std::vector<T>&, T CollisionRow::*part) {
          const auto column = rows_of<T>(file_, "collisions/" + name, first, count, 1);
          for (std::size_t n = 0; n < rows.size(); ++n) rows[n].*part = column[n];
        });
    return rows;
  });
}

RecordedSeries StoredRun::series() const {
  return reading(path_, [&] { return read_series(file_); });
}

RecordedSamples StoredRun::samples() const {
  return reading(path_, [&] { return read_samples(file_); });
}

Anatomy StoredRun::anatomy() const {
  return reading(path_, [&] {
    return read_anatomy(hdf5::opened(file_, "zenosphere"), info_.dimension, info_.spheres);
  });
}

}  // namespace zenosphere
