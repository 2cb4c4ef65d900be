#include "io/run_file.hpp"

#include <fmt/format.h>

#include <string>

#include "io/anatomy_group.hpp"
#include "io/hdf5_series.hpp"
#include "model/errors.hpp"

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

/// Row `n` of a dataset whose rows hold `size` numbers.
template <class T>
std::vector<T> row(const hdf5::Handle& file, const std::string& path, std::int64_t n,
                   std::int64_t size) {
  std::vector<T> values(static_cast<std::size_t>(size));
  hdf5::read_rows(hdf5::opened(file, path), hdf5::type_of<T>, n, 1, values.data());
  return values;
}

template <class T>
std::vector<T> column(const hdf5::Handle& file, const std::string& name, std::int64_t first,
                      std::int64_t count) {
  std::vector<T> values(static_cast<std::size_t>(count));
  hdf5::read_rows(hdf5::opened(file, "collisions/" + name), hdf5::type_of<T>, first, count,
                  values.data());
  return values;
}

}  // namespace

RunFile::RunFile(const std::filesystem::path& path) : path_(path), info_(read_stored_info(path)) {
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
    require_shape(file_, spheres_group + "box/edges/value", {snapshots, dimension, dimension});
    require_shape(file_, spheres_group + "position/time", {snapshots});
    for (const std::string name : {"k", "time", "i", "j", "gap", "normal_speed", "flags"}) {
      require_shape(file_, "collisions/" + name, {info_.logged_collisions});
    }
  });
}

bool RunFile::has_images() const {
  return hdf5::contains(hdf5::opened(file_, spheres_group), "image");
}

Snapshot RunFile::snapshot(std::int64_t n) const {
  return reading(path_, [&] {
    const std::int64_t dimension = info_.dimension;
    const std::int64_t components = info_.spheres * dimension;
    return Snapshot{
        .step = row<std::int64_t>(file_, spheres_group + "position/step", n, 1).front(),
        .time = row<double>(file_, spheres_group + "position/time", n, 1).front(),
        .positions = row<double>(file_, spheres_group + "position/value", n, components),
        .velocities = row<double>(file_, spheres_group + "velocity/value", n, components),
        .box_edges =
            row<double>(file_, spheres_group + "box/edges/value", n, dimension * dimension),
        .images = has_images()
                      ? row<std::int32_t>(file_, spheres_group + "image/value", n, components)
                      : std::vector<std::int32_t>{}};
  });
}

std::vector<CollisionRow> RunFile::rows(std::int64_t first, std::int64_t count) const {
  return reading(path_, [&] {
    const auto k = column<std::int64_t>(file_, "k", first, count);
    const auto time = column<double>(file_, "time", first, count);
    const auto i = column<std::int32_t>(file_, "i", first, count);
    const auto j = column<std::int32_t>(file_, "j", first, count);
    const auto gap = column<double>(file_, "gap", first, count);
    const auto speed = column<double>(file_, "normal_speed", first, count);
    const auto flags = column<std::uint8_t>(file_, "flags", first, count);
    std::vector<CollisionRow> rows;
    rows.reserve(k.size());
    for (std::size_t n = 0; n < k.size(); ++n) {
      rows.push_back({k[n], time[n], i[n], j[n], gap[n], speed[n], flags[n]});
    }
    return rows;
  });
}

Anatomy RunFile::anatomy() const {
  return reading(path_, [&] {
    return read_anatomy(hdf5::opened(file_, "zenosphere"), info_.dimension, info_.spheres);
  });
}

std::optional<std::string> RunFile::adjudication() const {
  return reading(path_, [&]() -> std::optional<std::string> {
    const hdf5::Handle own = hdf5::opened(file_, "zenosphere");
    if (!hdf5::contains(own, "adjudication")) return std::nullopt;
    return hdf5::text(own, "adjudication");
  });
}

}  // namespace zenosphere
