#include "run/setup.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "case/case_cells.hpp"
#include "case/case_file.hpp"
#include "case/case_grains.hpp"
#include "case/resting_flight.hpp"
#include "engine/start.hpp"
#include "model/errors.hpp"
#include "model/instantiate.hpp"
#include "start/start_file.hpp"

namespace zenosphere {

namespace {

template <int Dim, class Real>
std::vector<Vec<Dim, Real>> vectors(const std::vector<double>& numbers) {
  std::vector<Vec<Dim, Real>> vectors(numbers.size() / Dim);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    vectors[k / Dim][static_cast<int>(k % Dim)] = from_decimal<Real>(numbers[k]);
  }
  return vectors;
}

template <int Dim, class Real>
std::vector<Vec<Dim, Real>> in_precision(const std::vector<Vec<Dim, double>>& vectors) {
  std::vector<Vec<Dim, Real>> result(vectors.size());
  for (std::size_t i = 0; i < vectors.size(); ++i) {
    for (int axis = 0; axis < Dim; ++axis) result[i][axis] = Real(vectors[i][axis]);
  }
  return result;
}

template <int Dim, class Real>
std::vector<Spin<Dim, Real>> spins(const std::vector<double>& numbers) {
  constexpr std::size_t axes = spin_axes<Dim>;
  std::vector<Spin<Dim, Real>> spins(numbers.size() / axes);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    spins[k / axes][static_cast<int>(k % axes)] = from_decimal<Real>(numbers[k]);
  }
  return spins;
}

/// What spheres are, in the precision of Real.
template <class Real, class Convert>
Grains<Real> converted(const Grains<double>& grains, const Convert& convert) {
  Grains<Real> result{{}, {}, grains.kinds, grains.immobile};
  for (const double diameter : grains.diameters) result.diameters.push_back(convert(diameter));
  for (const double mass : grains.masses) result.masses.push_back(convert(mass));
  return result;
}

/// What of walls moves along their normal or is thermal.
template <class Real>
void add_motion_and_heat(const Case& values, Walls<Real>& walls) {
  const Case::Walls& told = values.walls;
  walls.seed = values.start.seed;
  if (told.lower_temperature) walls.temperature[0] = from_decimal<Real>(*told.lower_temperature);
  if (told.upper_temperature) walls.temperature[1] = from_decimal<Real>(*told.upper_temperature);
  if (!told.motion) return;
  const Real period = 1 / from_decimal<Real>(told.frequency);
  walls.oscillation.emplace(*told.motion, from_decimal<Real>(told.amplitude), period);
  const auto& acceleration = values.gravity.acceleration;
  const auto axis = static_cast<std::size_t>(walls.axis);
  const Real gravity =
      acceleration.empty() ? Real(0) : Real(-from_decimal<Real>(acceleration[axis]));
  walls.resting_flight =
      longest_resting_flight<Real>(from_decimal<Real>(told.resting_flight), period,
                                   walls.oscillation->peak_acceleration(), gravity);
}

/// Positions and velocities that the case gives; laboratory velocities become peculiar ones.
template <int Dim, class Real>
Configuration<Dim, Real> given_configuration(const Case& values, const ShearBox<Dim, Real>& box) {
  const GivenStart given = given_start(values);
  Configuration<Dim, Real> start{vectors<Dim, Real>(given.positions),
                                 vectors<Dim, Real>(given.velocities),
                                 from_decimal<Real>(given.offset)};
  start.grains = converted<Real>(given.grains, from_decimal<Real>);
  if (is_rough(values)) start.spins = spins<Dim, Real>(given.spins);
  if (values.start.granular_temperature) {
    Random random(values.start.seed);
    start.velocities = in_precision<Dim, Real>(
        thermal_velocities<Dim>(static_cast<std::int32_t>(start.positions.size()),
                                *values.start.granular_temperature, random, given.grains));
  } else if (box.is_sheared()) {
    for (std::size_t i = 0; i < start.positions.size(); ++i) {
      start.velocities[i][0] -= box.profile(start.positions[i]);
    }
  }
  return start;
}

}  // namespace

template <int Dim, class Real>
Configuration<Dim, Real> start_of(const Case& values, const ShearBox<Dim, Real>& box) {
  const Arrangement arrangement = values.start.arrangement;
  if (arrangement == Arrangement::given || arrangement == Arrangement::file) {
    return given_configuration<Dim, Real>(values, box);
  }
  try {
    const auto made =
        make_start<Dim>({.arrangement = arrangement,
                         .spheres = static_cast<std::int32_t>(values.system.spheres),
                         .granular_temperature = values.start.granular_temperature.value_or(0),
                         .seed = values.start.seed,
                         .grains = grains_of(values)},
                        box_of<Dim, double>(values));
    Configuration<Dim, Real> start{in_precision<Dim, Real>(made.positions),
                                   in_precision<Dim, Real>(made.velocities)};
    start.grains = converted<Real>(made.grains, [](double number) { return Real(number); });
    return start;
  } catch (const std::invalid_argument& error) {
    throw InputError(std::string("start: ") + error.what() +
                     "; lower system.solids_volume_fraction or choose another start");
  }
}

template <class Real>
ContactRules<Real> contact_rules_of(const Case& values) {
  const auto& collision = values.collision;
  ContactRules<Real> rules{from_decimal<Real>(values.system.restitution), collision.overlap,
                           from_decimal<Real>(collision.guard)};
  rules.models.law = RestitutionLaws::chosen<Real>(collision.restitution_law, collision);
  rules.models.contact_duration = from_decimal<Real>(collision.contact_duration);
  rules.models.rotation_angle = from_decimal<Real>(collision.rotation_angle);
  rules.models.seed = values.start.seed;
  rules.table = contact_table_of<Real>(values);
  if (collision.reduced_moment_of_inertia) {
    rules.inertia = from_decimal<Real>(*collision.reduced_moment_of_inertia);
  }
  return rules;
}

template <int Dim, class Real>
Surroundings<Dim, Real> surroundings_of(const Case& values) {
  Surroundings<Dim, Real> surroundings;
  for (std::size_t axis = 0; axis < values.gravity.acceleration.size(); ++axis) {
    surroundings.acceleration[static_cast<int>(axis)] =
        from_decimal<Real>(values.gravity.acceleration[axis]);
  }
  surroundings.all_fall =
      surroundings.acceleration == Vec<Dim, Real>{} || !has_immobile_species(values);
  if (values.walls.axis) {
    surroundings.walls = Walls<Real>{
        .axis = static_cast<int>(*values.walls.axis),
        .restitution = from_decimal<Real>(values.walls.restitution),
        .tangential_restitution = from_decimal<Real>(values.walls.tangential_restitution),
        .friction = values.walls.friction && std::isfinite(values.walls.friction->coefficient)
                        ? from_decimal<Real>(values.walls.friction->coefficient)
                        : ContactConstants<Real>::unbounded(),
        .speed = {from_decimal<Real>(values.walls.lower_speed),
                  from_decimal<Real>(values.walls.upper_speed)}};
    add_motion_and_heat(values, *surroundings.walls);
  }
  return surroundings;
}

template <int Dim, class Real>
Simulation<Dim, Real> new_simulation(const Case& values) {
  const auto box = box_of<Dim, Real>(values);
  return {box, start_of<Dim, Real>(values, box), contact_rules_of<Real>(values),
          surroundings_of<Dim, Real>(values)};
}

template <int Dim, class Real>
Simulation<Dim, Real> archived_simulation(const Case& values, ArchiveReader& archive) {
  Simulation<Dim, Real> simulation(box_of<Dim, Real>(values), contact_rules_of<Real>(values),
                                   surroundings_of<Dim, Real>(values), archive);
  if (archive.is_promoting()) simulation.predict_anew();
  return simulation;
}

std::optional<double> constant_restitution(const Case& values) {
  const auto& collision = values.collision;
  const bool is_constant = collision.restitution_law == RestitutionLaw::constant;
  if (!is_constant || collision.contact_duration > 0 || !are_unit_spheres(values)) {
    return std::nullopt;
  }
  return values.system.restitution;
}

OutputHeader output_header(const Case& values) {
  OutputHeader header{
      values.text, resolved_toml(values), values.system.dimension, values.system.spheres,
      std::vector<std::string>(static_cast<std::size_t>(values.system.dimension), "periodic")};
  header.grains = grains_of(values);
  for (const Species& species : values.species) header.species.push_back(species.name);
  if (is_rough(values)) header.spin_axes = values.system.dimension == 3 ? 3 : 1;
  if (values.walls.axis) header.boundary[static_cast<std::size_t>(*values.walls.axis)] = "none";
  return header;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real)                                                         \
  template Configuration<Dim, Real> start_of<Dim, Real>(const Case&, const ShearBox<Dim, Real>&); \
  template Surroundings<Dim, Real> surroundings_of<Dim, Real>(const Case&);                       \
  template Simulation<Dim, Real> new_simulation<Dim, Real>(const Case&);                          \
  template Simulation<Dim, Real> archived_simulation<Dim, Real>(const Case&, ArchiveReader&);
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

#define ZENOSPHERE_INSTANTIATE(Real) \
  template ContactRules<Real> contact_rules_of<Real>(const Case&);
ZENOSPHERE_FOR_EACH_REAL(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
