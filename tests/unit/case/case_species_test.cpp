#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <vector>

#include "case/case_box.hpp"
#include "case/case_grains.hpp"
#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

const std::string small_and_large = R"([[species]]
name = "small"
diameter = 1
share = 0.75
[[species]]
name = "large"
diameter = 1.5
share = 0.25
)";

const std::string gas = R"([system]
dimension = 3
spheres = 1000
restitution = 0.9
solids_volume_fraction = 0.3
[start]
arrangement = "random"
granular_temperature = 1
[drive]
kind = "none"
[run]
collisions = 100
)";

/// The only line that is said about a case, without its place.
std::string said(const std::string& text, const std::vector<std::string>& overrides = {}) {
  const std::string problems = problems_of(text, overrides);
  return problems.empty() ? "" : problems.substr(problems.find(": ") + 2);
}

/// The gas with other text in its species.
std::string with(const std::string& old, const std::string& other) {
  return gas + replaced(small_and_large, old, other);
}

TEST(CaseSpecies, AreTheFirstAndTheLastSpheresByTheirShares) {
  const Case values = overridden(gas + small_and_large, {});
  EXPECT_EQ(spheres_by_species(values), (std::vector<std::int64_t>{750, 250}));
  const Grains<double> grains = grains_of(values);
  ASSERT_EQ(grains.diameters.size(), 1000u);
  EXPECT_EQ(grains.diameters[749], 1);
  EXPECT_EQ(grains.diameters[750], 1.5);
  EXPECT_EQ(grains.masses[999], 3.375);  // 1.5^3: the density of a unit sphere
  EXPECT_EQ(grains.kinds[749], 0);
  EXPECT_EQ(grains.kinds[750], 1);
  EXPECT_TRUE(grains.immobile.empty());
}

TEST(CaseSpecies, FillTheFractionTogether) {
  const Case values = overridden(gas + small_and_large, {});
  // 750 + 250 * 3.375 = 1593.75 unit spheres.
  const double side = box_sides(values)[0];
  EXPECT_NEAR(1593.75 * std::numbers::pi / 6 / (side * side * side), 0.3, 1e-12);
  EXPECT_NEAR(filled_fraction(values), 0.3, 1e-12);
}

TEST(CaseSpecies, ThatSayWhatUnitSpheresAreSayNothing) {
  const std::string unit = gas + "[[species]]\nname = \"all\"\ndiameter = 1\n";
  EXPECT_TRUE(grains_of(overridden(unit, {})).are_alike());
  EXPECT_TRUE(grains_of(overridden(gas, {})).are_alike());
  EXPECT_EQ(box_sides(overridden(unit, {})), box_sides(overridden(gas, {})));
}

TEST(CaseSpecies, AreChangedByOverridesThatNameThem) {
  const Case values =
      overridden(gas + small_and_large, {"species.large.mass=10", "species.small.immobile=true"});
  EXPECT_EQ(values.species[1].mass, 10);
  EXPECT_TRUE(values.species[0].immobile);
  EXPECT_EQ(grains_of(values).immobile[0], 1);
  EXPECT_EQ(said(gas + small_and_large, {"species.huge.mass=10"}),
            "unknown key species.huge.mass (there is no such [[species]])");
}

TEST(CaseSpecies, ReadBackFromTheResolvedCase) {
  const std::string contact =
      "[[contact]]\nbetween = [\"small\", \"large\"]\nrestitution = 0.5\nfriction = \"unbounded\"\n"
      "tangential_restitution = 0.25\n[polydispersity]\ndistribution = \"uniform\"\nspread = 0.1\n";
  const Case values = overridden(gas + small_and_large + contact, {"species.large.mass=10"});
  const std::string resolved = resolved_toml(values);
  const Case again = parse_case(resolved, "resolved", {});
  EXPECT_EQ(resolved_toml(again), resolved);
  EXPECT_EQ(grains_of(again).diameters, grains_of(values).diameters);
  ASSERT_EQ(again.contacts.size(), 1u);
  EXPECT_EQ(again.contacts[0].restitution, 0.5);
  EXPECT_TRUE(std::isinf(again.contacts[0].friction->coefficient));
}

TEST(CaseSpecies, HaveSharesThatAddUpToOne) {
  EXPECT_EQ(said(with("share = 0.25", "share = 0.2")),
            "species.large.share = 0.2 (the shares add up to 0.95, must be 1)");
  EXPECT_EQ(said(with("share = 0.25", "spheres = 250")),
            "species large has spheres, small has not; give the same key for all");
  const std::string numbers =
      replaced(with("share = 0.25", "spheres = 251"), "share = 0.75", "spheres = 750");
  EXPECT_EQ(said(numbers),
            "species.large.spheres = 251 (those of all species add up to 1001, system.spheres = "
            "1000); make them equal");
  EXPECT_EQ(said(with("share = 0.25", "share = 0.25\nspheres = 250")),
            "species.large.spheres = 250 (species.large.share is given too); remove one of them");
}

TEST(CaseSpecies, HaveASphereEach) {
  EXPECT_EQ(
      said(replaced(with("share = 0.75", "share = 0.9999"), "share = 0.25", "share = 0.0001")),
      "species.large.share = 0.0001 (none of the 1000 spheres would be of it); use more "
      "spheres or a larger share");
}

TEST(CaseSpecies, HaveSizeAndMass) {
  EXPECT_EQ(said(with("share = 0.25", "share = 0.25\nmass = 0")),
            "species.large.mass = 0 (must be in [1e-30, 1e+30])");
  EXPECT_EQ(said(with("diameter = 1.5", "diameter = -1")),
            "species.large.diameter = -1 (must be in [1e-06, 1000000])");
  EXPECT_EQ(said(with("diameter = 1.5\n", "")),
            "missing key species.large.diameter (physics has no default)");
  EXPECT_EQ(said(with("diameter = 1.5", "diametre = 1.5\ndiameter = 1")),
            "unknown key species.large.diametre; did you mean diameter?");
}

TEST(CaseSpecies, HaveNamesOfTheirOwn) {
  EXPECT_EQ(said(with("name = \"large\"", "name = \"small\"")),
            "name = \"small\" (another [[species]] has it)");
  EXPECT_EQ(said(with("name = \"large\"", "name = \"a b\"")),
            "name = \"a b\" (must be letters, digits, _ and -, at most 40)");
  EXPECT_EQ(said(with("name = \"large\"\n", "")),
            "missing key name of [[species]]; add name = \"...\"");
  EXPECT_EQ(said(gas + "[species]\ndiameter = 1\n"),
            "unknown key species.diameter (each kind has a table [[species]] with a name)");
}

TEST(CaseSpecies, FitIntoTheBoxTwice) {
  // 100 spheres, one of 8: (99 + 512) pi / 6 / 0.3 = 10.2^3, and 2.02 * 8 is needed.
  const std::string one_large =
      replaced(with("diameter = 1.5", "diameter = 8"), "spheres = 1000", "spheres = 4");
  EXPECT_NE(said(one_large).find("must be above 16.16"), std::string::npos) << said(one_large);
}

TEST(CaseSpecies, CannotAllBeImmobile) {
  const std::string still = replaced(with("share = 0.75", "share = 0.75\nimmobile = true"),
                                     "share = 0.25", "share = 0.25\nimmobile = true");
  EXPECT_EQ(said(still), "species.large.immobile = true (no sphere could move); let one kind move");
}

TEST(CaseContacts, AreOfSpeciesThatThereAre) {
  const std::string contact = "[[contact]]\nbetween = [\"small\", \"huge\"]\nrestitution = 0.5\n";
  EXPECT_EQ(said(gas + small_and_large + contact),
            "[[contact]] between small and huge (there is no species huge)");
  EXPECT_EQ(said(gas + small_and_large + "[[contact]]\nbetween = [\"small\", \"large\"]\n"),
            "[[contact]] between small and large (changes nothing); add restitution, or remove it");
  EXPECT_EQ(said(gas + small_and_large +
                 "[[contact]]\nbetween = [\"small\", \"large\"]\nrestitution = 1.2\n")
                .find("changes nothing"),
            std::string::npos);
  EXPECT_EQ(said(gas + small_and_large + "[[contact]]\nbetween = \"small\"\nrestitution = 1\n"),
            "between = \"small\" (needs the names of two species)");
}

TEST(CaseContacts, AreRoughByBothConstants) {
  EXPECT_EQ(said(gas, {"collision.friction=0.5"}),
            "collision.friction = 0.5 (needs collision.tangential_restitution too); add it, or "
            "remove this");
  EXPECT_EQ(said(gas, {"collision.tangential_restitution=0.5"}),
            "collision.tangential_restitution = 0.5 (needs collision.friction too, maybe "
            "\"unbounded\"); add it, or remove this");
  const std::string contact = "[[contact]]\nbetween = [\"small\", \"large\"]\nfriction = 0.5\n";
  EXPECT_EQ(said(gas + small_and_large + contact),
            "contact.small.large.friction = 0.5 (needs a tangential_restitution); add it");
}

TEST(CaseRoughSpheres, HaveAReducedMomentOfInertiaOfSpheresOrDisks) {
  const std::vector<std::string> rough{"collision.friction=0.5",
                                       "collision.tangential_restitution=0.5"};
  const auto said_of = [&](const std::string& inertia) {
    auto overrides = rough;
    overrides.push_back("collision.reduced_moment_of_inertia=" + inertia);
    return said(gas, overrides);
  };
  const std::string key = "collision.reduced_moment_of_inertia = ";
  for (const std::string wrong : {"0", "-0.4", "1.5"}) {
    EXPECT_EQ(said_of(wrong), key + wrong + " (must be in (0, 1]; 1 is a ring)");
  }
  EXPECT_EQ(said_of("0.7"), key +
                                "0.7 (must be in (0, 2/3] in three dimensions: 0.4 is a solid "
                                "sphere, 2/3 a shell)");
  EXPECT_EQ(said(gas, {"collision.reduced_moment_of_inertia=0.4"}),
            key + "0.4 (without friction nothing turns); remove it, or add collision.friction");
  auto shell = rough;
  EXPECT_EQ(reduced_moment_of_inertia(overridden(gas, shell)), 0.4);
  shell.push_back("collision.reduced_moment_of_inertia=0.6666666666666667");
  const Case values = overridden(gas, shell);
  EXPECT_EQ(reduced_moment_of_inertia(parse_case(resolved_toml(values), "resolved", {})),
            0.6666666666666667);
  for (std::string& one : shell)
    one = one == shell.back() ? key.substr(0, key.find(' ')) + "=1" : one;
  shell.push_back("system.dimension=2");
  EXPECT_EQ(reduced_moment_of_inertia(overridden(gas, shell)), 1);
}

/// Mean and standard deviation of the diameters of many spheres.
std::pair<double, double> moments(const std::string& distribution, double spread) {
  const Case values =
      overridden(gas, {"system.spheres=100000", "polydispersity.distribution=" + distribution,
                       "polydispersity.spread=" + std::to_string(spread)});
  const Grains<double> grains = grains_of(values);
  double sum = 0;
  double square = 0;
  for (const double d : grains.diameters) {
    EXPECT_GT(d, 0);
    sum += d;
    square += d * d;
  }
  const double mean = sum / 1e5;
  return {mean, std::sqrt(square / 1e5 - mean * mean)};
}

TEST(Polydispersity, HasTheMeanAndSpreadAskedFor) {
  for (const std::string distribution : {"uniform", "normal", "lognormal"}) {
    for (const double spread : {0.1, 0.3}) {
      const auto [mean, deviation] = moments(distribution, spread);
      // Five standard errors; of the deviation, with the kurtosis of a lognormal of 0.3: 1.3 times.
      EXPECT_NEAR(mean, 1, 5 * spread / std::sqrt(1e5)) << distribution;
      EXPECT_NEAR(deviation, spread, 5 * 1.3 * spread / std::sqrt(2e5)) << distribution;
    }
  }
}

TEST(Polydispersity, GivesSpheresOfOneDensityThatFillTheFraction) {
  const Case values =
      overridden(gas, {"polydispersity.distribution=uniform", "polydispersity.spread=0.2"});
  const Grains<double> grains = grains_of(values);
  double volume = 0;
  for (std::size_t i = 0; i < grains.diameters.size(); ++i) {
    const double cube = grains.diameters[i] * grains.diameters[i] * grains.diameters[i];
    EXPECT_NEAR(grains.masses[i] / cube, 1, 1e-14);
    volume += cube * std::numbers::pi / 6;
  }
  const double side = box_sides(values)[0];
  EXPECT_NEAR(volume / (side * side * side), 0.3, 1e-12);
}

TEST(Polydispersity, FollowsTheSeedAndIsTheSameOnEveryMachine) {
  const std::vector<std::string> lognormal{"polydispersity.distribution=lognormal",
                                           "polydispersity.spread=0.3"};
  std::vector<std::string> other = lognormal;
  other.emplace_back("start.seed=2");
  const auto diameters = grains_of(overridden(gas, lognormal)).diameters;
  EXPECT_EQ(diameters, grains_of(overridden(gas, lognormal)).diameters);
  EXPECT_NE(diameters, grains_of(overridden(gas, other)).diameters);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(diameters[0]), 4605104199815569548u);
  EXPECT_EQ(std::bit_cast<std::uint64_t>(diameters[999]), 4606091401445402667u);
}

TEST(Polydispersity, IsRefusedWhereDiametersWouldNotBePositive) {
  EXPECT_EQ(said(gas, {"polydispersity.distribution=uniform", "polydispersity.spread=0.6"}),
            "polydispersity.spread = 0.6 (must be in [0, 0.577]; some diameters would not be "
            "positive)");
  EXPECT_EQ(said(gas, {"polydispersity.spread=0.2"}),
            "missing key polydispersity.distribution (physics has no default); add distribution = "
            "... under [polydispersity]");
}

}  // namespace
}  // namespace zenosphere
