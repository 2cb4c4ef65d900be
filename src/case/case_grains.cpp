#include "case/case_grains.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "model/elementary.hpp"
#include "model/instantiate.hpp"
#include "model/power.hpp"
#include "model/random.hpp"
#include "model/spin.hpp"

namespace zenosphere {

namespace {

/// Standard deviations at which a normal distribution is cut off.
constexpr double cut = 3;
/// Standard deviation of what is left of a normal distribution of 1: its square is
/// 1 - 2 c f(c) / (2 F(c) - 1), f the density and F the distribution function at c = 3.
constexpr double cut_deviation = 0.98657839;

/// What the stream of diameters has in place of the seed of the places, 2^64 / golden ratio.
constexpr std::uint64_t other_stream = 0x9E3779B97F4A7C15u;

bool is_polydisperse(const Case& values) {
  return values.polydispersity.distribution && values.polydispersity.spread > 0;
}

/// Diameters of a distribution with the mean 1.
class Diameters {
 public:
  explicit Diameters(const Case& values)
      : distribution_(*values.polydispersity.distribution),
        spread_(values.polydispersity.spread),
        log_variance_(portable_log(1 + spread_ * spread_)),
        random_(values.start.seed ^ other_stream) {}

  double draw() {
    switch (distribution_) {
      case SizeDistribution::uniform:
        return 1 + std::sqrt(3.0) * spread_ * (2 * random_.uniform() - 1);
      case SizeDistribution::normal:
        return 1 + spread_ / cut_deviation * cut_normal();
      case SizeDistribution::lognormal:
        break;
    }
    return portable_exp(std::sqrt(log_variance_) * random_.normal() - log_variance_ / 2);
  }

 private:
  double cut_normal() {
    for (;;) {
      const double number = random_.normal();
      if (std::abs(number) < cut) return number;
    }
  }

  SizeDistribution distribution_;
  double spread_;
  double log_variance_;  ///< of the logarithm of a lognormal diameter
  Random random_;
};

double power_of(double length, int dimension) {
  if (dimension == 1) return length;
  return dimension == 2 ? power<2>(length) : power<3>(length);
}

double mass_of(const Species& species, int dimension) {
  return species.mass.value_or(power_of(species.diameter, dimension));
}

std::int32_t kind_named(const std::string& name, const Case& values) {
  const auto is_it = [&](const Species& species) { return species.name == name; };
  const auto found = std::find_if(values.species.begin(), values.species.end(), is_it);
  return static_cast<std::int32_t>(found - values.species.begin());
}

template <class Real>
ContactConstants<Real> constants_of(double restitution, double tangential_restitution,
                                    Friction friction) {
  const bool is_bounded = std::isfinite(friction.coefficient);
  return {
      from_decimal<Real>(restitution), from_decimal<Real>(tangential_restitution),
      is_bounded ? from_decimal<Real>(friction.coefficient) : ContactConstants<Real>::unbounded()};
}

/// The species of a case, or the unit spheres that are there without any.
std::vector<Species> all_species(const Case& values) {
  if (!values.species.empty()) return values.species;
  return {{.name = "", .diameter = 1, .mass = 1, .spheres = values.system.spheres}};
}

/// Removes what says the same of all as nothing does.
void drop_defaults(Grains<double>& grains) {
  const auto is_one = [](double number) { return number == 1; };
  if (std::all_of(grains.diameters.begin(), grains.diameters.end(), is_one)) {
    grains.diameters.clear();
  }
  if (std::all_of(grains.masses.begin(), grains.masses.end(), is_one)) grains.masses.clear();
  const auto is_zero = [](auto number) { return number == 0; };
  if (std::all_of(grains.kinds.begin(), grains.kinds.end(), is_zero)) grains.kinds.clear();
  if (std::all_of(grains.immobile.begin(), grains.immobile.end(), is_zero)) grains.immobile.clear();
}

}  // namespace

double largest_spread(SizeDistribution distribution) {
  if (distribution == SizeDistribution::uniform) return 0.577;
  return distribution == SizeDistribution::normal ? 0.328 : 1.0;
}

template <class Real>
std::optional<ContactTable<Real>> contact_table_of(const Case& values) {
  const auto& collision = values.collision;
  if (values.contacts.empty() && !collision.friction) return std::nullopt;
  const ContactConstants<Real> of_all =
      constants_of<Real>(values.system.restitution, collision.tangential_restitution.value_or(-1),
                         collision.friction.value_or(Friction{}));
  const auto kinds = static_cast<std::int32_t>(std::max<std::size_t>(values.species.size(), 1));
  ContactTable<Real> table(kinds, of_all);
  for (const SpeciesContact& contact : values.contacts) {
    ContactConstants<Real> constants = constants_of<Real>(
        contact.restitution.value_or(values.system.restitution),
        contact.tangential_restitution.value_or(collision.tangential_restitution.value_or(-1)),
        contact.friction.value_or(collision.friction.value_or(Friction{})));
    constants.is_own = contact.restitution.has_value();
    table.set(kind_named(contact.between[0], values), kind_named(contact.between[1], values),
              constants);
  }
  return table;
}

bool is_rough(const Case& values) {
  const auto table = contact_table_of<double>(values);
  return table && table->is_rough();
}

double reduced_moment_of_inertia(const Case& values) {
  const double solid = values.system.dimension == 3 ? solid_inertia<3> : solid_inertia<2>;
  return values.collision.reduced_moment_of_inertia.value_or(solid);
}

bool are_unit_spheres(const Case& values) {
  return values.species.empty() && values.contacts.empty() && !is_polydisperse(values) &&
         !values.collision.friction;
}

bool has_immobile_species(const Case& values) {
  return std::any_of(values.species.begin(), values.species.end(),
                     [](const Species& species) { return species.immobile; });
}

std::vector<std::int64_t> spheres_by_species(const Case& values) {
  const std::vector<Species> species = all_species(values);
  std::vector<std::int64_t> counts;
  std::vector<double> lost;
  for (const Species& one : species) {
    const double wanted = one.spheres
                              ? static_cast<double>(*one.spheres)
                              : one.share.value_or(1) * static_cast<double>(values.system.spheres);
    counts.push_back(static_cast<std::int64_t>(std::floor(wanted * (1 + 1e-12))));
    lost.push_back(wanted - static_cast<double>(counts.back()));
  }
  if (species.front().spheres) return counts;
  std::int64_t left =
      values.system.spheres - std::accumulate(counts.begin(), counts.end(), std::int64_t{0});
  for (; left > 0; --left) {
    const auto most = std::max_element(lost.begin(), lost.end());
    ++counts[static_cast<std::size_t>(most - lost.begin())];
    *most -= 1;
  }
  return counts;
}

Grains<double> grains_of(const Case& values) {
  if (values.species.empty() && !is_polydisperse(values)) return {};
  const int dimension = values.system.dimension;
  const std::vector<Species> species = all_species(values);
  const std::vector<std::int64_t> counts = spheres_by_species(values);
  std::optional<Diameters> diameters;
  if (is_polydisperse(values)) diameters.emplace(values);
  Grains<double> grains;
  for (std::size_t kind = 0; kind < species.size(); ++kind) {
    const double mass = mass_of(species[kind], dimension);
    for (std::int64_t n = 0; n < counts[kind]; ++n) {
      const double relative = diameters ? diameters->draw() : 1;
      grains.diameters.push_back(species[kind].diameter * relative);
      grains.masses.push_back(mass * power_of(relative, dimension));
      grains.kinds.push_back(static_cast<std::int32_t>(kind));
      grains.immobile.push_back(species[kind].immobile ? 1 : 0);
    }
  }
  drop_defaults(grains);
  return grains;
}

SizeSummary sizes_of(const Case& values) {
  const Grains<double> grains = grains_of(values);
  if (grains.diameters.empty()) return {};
  SizeSummary sizes{0, 0, grains.diameters.front(), 0};
  for (const double diameter : grains.diameters) {
    sizes.mean += diameter;
    sizes.mean_power += power_of(diameter, values.system.dimension);
    sizes.smallest = std::min(sizes.smallest, diameter);
    sizes.largest = std::max(sizes.largest, diameter);
  }
  sizes.mean /= static_cast<double>(grains.diameters.size());
  sizes.mean_power /= static_cast<double>(grains.diameters.size());
  return sizes;
}

#define ZENOSPHERE_INSTANTIATE(Real) \
  template std::optional<ContactTable<Real>> contact_table_of<Real>(const Case&);
ZENOSPHERE_FOR_EACH_REAL(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
