#include "physics/random_system.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "support/gas.hpp"

namespace zenosphere {
namespace {

using support::Dice;

/// Beyond these speeds the engine has no numbers: shear has been tried up to 1e40, the square of an
/// acceleration has to be a number too.
constexpr double fastest_sheared = 1e30;
constexpr double fastest_falling = 1e70;

/// The side that a system of rods and discs has where it has none.
constexpr double other_side = 4;

template <std::size_t Count, class Value>
Value one_of(Dice& dice, const std::array<Value, Count>& values) {
  return values[static_cast<std::size_t>(dice.below(Count))];
}

double nearest(const std::vector<double>& a, const std::vector<double>& b,
               const std::vector<double>& sides) {
  double square = 0;
  for (std::size_t axis = 0; axis < a.size(); ++axis) {
    double along = a[axis] - b[axis];
    along -= sides[axis] * std::round(along / sides[axis]);
    square += along * along;
  }
  return std::sqrt(square);
}

/// On a line along x, from left to right; some touch.
void place_on_a_line(RandomSystem& system, Dice& dice) {
  const double room = system.sides[0] - 1.01 * system.spheres;
  std::vector<double> gaps;
  double sum = 0;
  for (int i = 0; i < system.spheres; ++i) {
    gaps.push_back(dice.below(6) == 0 ? 0.0 : dice.between(0.01, 1));
    sum += gaps.back();
  }
  double x = dice.between(0, 0.01);
  for (int i = 0; i < system.spheres; ++i) {
    std::vector<double> place(static_cast<std::size_t>(system.dimension), 2.0);
    place[0] = x;
    system.positions.push_back(place);
    x += 1 + gaps[static_cast<std::size_t>(i)] * room / std::max(sum, 1.0);
  }
}

/// One by one where there is room.
void place_anywhere(RandomSystem& system, Dice& dice) {
  while (std::ssize(system.positions) < system.spheres) {
    std::vector<double> place;
    for (const double side : system.sides) place.push_back(dice.between(0.5, side - 0.5));
    const bool is_free =
        std::all_of(system.positions.begin(), system.positions.end(),
                    [&](const auto& other) { return nearest(place, other, system.sides) >= 1; });
    if (is_free) system.positions.push_back(place);
  }
}

/// On the corners of a regular polygon, all flying to its centre, where they come to rest at low
/// restitution: no momentum is left over. All meet at once, in an order that rounding decides.
void place_on_a_polygon(RandomSystem& system, Dice& dice) {
  const double step = 2 * std::numbers::pi / system.spheres;
  const double least_radius = 0.5 / std::sin(step / 2);
  const double radius = dice.between(1.01, 3) * least_radius;
  const double turn = dice.between(0, step);
  system.is_bare = false;  // as to an oracle
  system.sides = {2 * radius + dice.between(2, 9), 2 * radius + dice.between(2, 9)};
  for (int i = 0; i < system.spheres; ++i) {
    const double angle = turn + i * step;
    const double x = std::cos(angle), y = std::sin(angle);
    system.positions.push_back(
        {system.sides[0] / 2 + radius * x, system.sides[1] / 2 + radius * y});
    system.velocities.push_back({-system.speed * x, -system.speed * y});
  }
}

/// Random speeds, the same speed either way, or all at rest but one.
void set_in_motion(RandomSystem& system, Dice& dice, bool is_along_x) {
  const int kind = dice.below(3);
  for (int i = 0; i < system.spheres; ++i) {
    std::vector<double> velocity(static_cast<std::size_t>(system.dimension), 0.0);
    for (int axis = 0; axis < (is_along_x ? 1 : system.dimension); ++axis) {
      const double part = kind == 0   ? dice.between(-1.7, 1.7)
                          : kind == 1 ? (dice.below(2) == 0 ? -1.0 : 1.0)
                                      : (i == 0 ? 1.0 : 0.0);
      velocity[static_cast<std::size_t>(axis)] = part * system.speed;
    }
    system.velocities.push_back(velocity);
  }
}

std::string drive(RandomSystem& system, Dice& dice) {
  const int kind = dice.below(4);
  const bool may_shear = system.dimension > 1 && system.spheres > 1;
  if (kind == 0 && may_shear && system.speed < fastest_sheared) {
    system.shear_rate = dice.between(0.01, 2) * system.speed;
    return fmt::format("kind = \"shear\"\nshear_rate = {}\n", system.shear_rate);
  }
  if (kind != 1) return "kind = \"none\"\n";
  system.is_bare = false;
  return fmt::format("kind = \"random\"\nnoise_strength = {}\nkick_interval = {}\n",
                     dice.between(0.01, 1) * std::pow(system.speed, 3),
                     dice.between(0.05, 1) / system.speed);
}

/// Walls or gravity, where there is no shear.
std::string surroundings(RandomSystem& system, Dice& dice) {
  std::string text;
  const bool is_alone = system.spheres == 1;  // there have to be walls
  if (is_alone || (system.shear_rate == 0 && dice.below(3) == 0)) {
    const int axis = dice.below(system.dimension);
    const bool is_rough = system.dimension > 1 && axis != 0 && dice.below(3) == 0;
    text += fmt::format("[walls]\naxis = \"{}\"\nrestitution = {}\n", "xyz"[axis],
                        one_of(dice, std::array{0.0, 0.3, 1.0}));
    if (is_rough) {
      text += fmt::format("tangential_restitution = 0.0\nupper_speed = {}\n", system.speed);
    }
    const bool is_in_wall = axis == 0 && system.positions[0][0] < 0.5;  // a line begins at 0
    for (auto& place : system.positions) place[0] += is_in_wall ? 0.5 : 0.0;
  }
  if (system.shear_rate == 0 && system.speed < fastest_falling && dice.below(4) == 0) {
    std::vector<double> pull(static_cast<std::size_t>(system.dimension), 0.0);
    pull.back() = -dice.between(0.01, 1) * system.speed * system.speed;
    text += fmt::format("[gravity]\nacceleration = [{}]\n", fmt::join(pull, ", "));
  }
  if (!text.empty()) system.is_bare = false;
  return text;
}

std::string contact(RandomSystem& system, Dice& dice) {
  std::string text =
      fmt::format("[collision]\noverlap = \"{}\"\nguard = {}\n",
                  one_of(dice, std::array{"rewind", "rewind", "immediate", "guarded", "stop"}),
                  1e-15 * system.speed);
  const int model = dice.below(6);
  if (model == 0) text += fmt::format("contact_duration = {}\n", 1e-3 / system.speed);
  if (model == 1 && system.dimension > 1) text += "rotation_angle = 0.3\n";
  if (model == 2) {
    text += fmt::format("restitution_law = \"viscoelastic\"\nviscoelastic_constant = {}\n",
                        0.1 / std::pow(system.speed, 0.2));
    system.restitution.reset();
  }
  if (model == 3) {
    text += fmt::format("restitution_law = \"fixed-loss\"\nenergy_loss = {}\n",
                        0.1 * system.speed * system.speed);
    system.restitution.reset();
  }
  if (model < 4) system.is_bare = false;
  return text;
}

}  // namespace

RandomSystem::RandomSystem(std::uint64_t seed) {
  Dice dice(seed);
  dimension = 1 + dice.below(3);
  spheres = 1 + dice.below(12);
  const bool is_ordinary = dice.below(2) == 0;
  speed = is_ordinary ? 1.0 : std::pow(10.0, dice.between(-72, 72));  // a case: 1e-75 to 1e75
  restitution = one_of(dice, std::array{0.0, 0.0, 1e-15, 1e-12, 1e-9, 1e-3, 0.05, 0.3, 0.9, 1.0});
  const bool is_line = dimension == 1 || dice.below(3) == 0;
  for (int axis = 0; axis < dimension; ++axis) {
    const double least = is_line && axis == 0 ? 1.1 * spheres + 2.1 : 3 + spheres / 3.0;
    sides.push_back(least * dice.between(1, 3));
  }
  if (dimension == 2 && spheres > 2 && dice.below(4) == 0) {
    place_on_a_polygon(*this, dice);
  } else {
    if (is_line) place_on_a_line(*this, dice);
    if (!is_line) place_anywhere(*this, dice);
    set_in_motion(*this, dice, is_line && dice.below(3) != 0);
  }
  more = "[drive]\n" + drive(*this, dice);
  more += surroundings(*this, dice);
  more += contact(*this, dice);
}

std::string RandomSystem::text() const {
  std::vector<std::string> places, speeds;
  for (const auto& place : positions) places.push_back(fmt::format("[{}]", fmt::join(place, ", ")));
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    auto velocity = velocities[i];  // in the file in the laboratory
    if (dimension > 1) velocity[0] += shear_rate * (positions[i][1] - sides[1] / 2);
    speeds.push_back(fmt::format("[{}]", fmt::join(velocity, ", ")));
  }
  return fmt::format(
      "[system]\ndimension = {}\nspheres = {}\nsides = [{}]\n{}"
      "[start]\narrangement = \"given\"\npositions = [{}]\nvelocities = [{}]\n"
      "{}[collapse]\nwindow = 200\n[run]\ncollisions = 400\ntime = {}\n"
      "[output]\ncollision_log = \"none\"\n",
      dimension, spheres, fmt::join(sides, ", "),
      restitution ? fmt::format("restitution = {}\n", *restitution) : "", fmt::join(places, ", "),
      fmt::join(speeds, ", "), more, 30 / speed);
}

Configuration<3, double> RandomSystem::start(double displacement) const {
  Dice dice(1);
  Configuration<3, double> state;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    Vec<3, double> place{{2, 2, 2}}, velocity;
    for (int axis = 0; axis < dimension; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      place[axis] = positions[i][a] + displacement * dice.between(-1, 1);
      velocity[axis] = velocities[i][a];
    }
    state.positions.push_back(place);
    state.velocities.push_back(velocity);
  }
  return state;
}

Vec<3, double> RandomSystem::box_sides() const {
  Vec<3, double> all{{other_side, other_side, other_side}};
  for (int axis = 0; axis < dimension; ++axis) all[axis] = sides[static_cast<std::size_t>(axis)];
  return all;
}

}  // namespace zenosphere
