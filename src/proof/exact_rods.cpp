#include "proof/exact_rods.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "model/errors.hpp"

namespace zenosphere {

namespace {

/// A positive number of any size as mantissa x 2^exponent, to 52 bits.
struct Rough {
  double mantissa;
  long exponent;
};

Rough rough_quotient(const Integer& numerator, const Integer& denominator) {
  long top = 0;
  long bottom = 0;
  const double a = mpz_get_d_2exp(&top, numerator.get_mpz_t());
  const double b = mpz_get_d_2exp(&bottom, denominator.get_mpz_t());
  int shift = 0;
  const double mantissa = std::frexp(a / b, &shift);
  return {mantissa, top - bottom + shift};
}

/// Compares a/b with c/d exactly: less than, equal to or greater than zero, as a/b - c/d is. All
/// are positive, a and c may be zero. The numbers have thousands of digits, of which the first
/// sixteen are nearly always enough.
int compare_quotients(const Integer& a, const Integer& b, const Integer& c, const Integer& d) {
  if (a != 0 && c != 0) {
    const Rough left = rough_quotient(a, b);
    const Rough right = rough_quotient(c, d);
    if (std::abs(left.exponent - right.exponent) < 2) {
      const double ratio = std::ldexp(left.mantissa / right.mantissa,
                                      static_cast<int>(left.exponent - right.exponent));
      constexpr double distinct = 1e-12;  // each mantissa is good to 4 x 2^-52
      if (std::abs(ratio - 1) > distinct) return ratio < 1 ? -1 : 1;
    } else {
      return left.exponent < right.exponent ? -1 : 1;
    }
  }
  return cmp(Integer(a * d), Integer(c * b));
}

std::vector<Rational> numbers(const std::vector<std::string>& texts) {
  std::vector<Rational> values;
  for (const std::string& text : texts) values.push_back(exact_number(text));
  return values;
}

/// The least common multiple of all denominators.
Integer common_denominator(const std::vector<Rational>& values, Integer denominator) {
  for (const Rational& value : values) denominator = lcm(denominator, Integer(value.get_den()));
  return denominator;
}

Integer times(const Rational& value, const Integer& scale) {
  return Integer(scale / value.get_den()) * value.get_num();
}

/// A number that is not below the root of one that is not negative.
Rational root_above(const Rational& value) {
  Rational root(Integer(sqrt(Integer(value.get_num() * value.get_den()))) + 1, value.get_den());
  root.canonicalize();
  return root;
}

/// Positive numbers, one for each rod; 1 where none are told.
std::vector<Rational> sizes(const std::vector<std::string>& texts, std::size_t rods,
                            const std::string& name) {
  if (texts.empty()) return std::vector<Rational>(rods, Rational(1));
  const std::vector<Rational> values = numbers(texts);
  const auto is_positive = [](const Rational& value) { return value > 0; };
  if (values.size() != rods || !std::all_of(values.begin(), values.end(), is_positive)) {
    throw InputError("exact rods: " + name + " (needs a number > 0 for each rod)");
  }
  return values;
}

/// Twice the speed, relative to the centre of mass, that the lightest rod would have with all the
/// energy: collisions take none of the momentum and add no energy.
Rational largest_difference(const std::vector<Rational>& v, const std::vector<Rational>& m) {
  Rational mass, momentum, energy;
  for (std::size_t i = 0; i < v.size(); ++i) {
    mass += m[i];
    momentum += m[i] * v[i];
    energy += m[i] * v[i] * v[i];
  }
  energy -= momentum * momentum / mass;
  return 2 * root_above(energy / *std::min_element(m.begin(), m.end()));
}

bool are_equal(const std::vector<Rational>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::not_equal_to<>()) == values.end();
}

}  // namespace

ExactRods::ExactRods(const RodsStart& start)
    : is_periodic_(!start.period.empty()), restitution_(exact_number(start.restitution)) {
  if (start.positions.size() != start.velocities.size() || start.positions.size() < 2) {
    throw InputError("exact rods: " + std::to_string(start.positions.size()) + " positions and " +
                     std::to_string(start.velocities.size()) +
                     " velocities (must be as many, at least two)");
  }
  if (restitution_ < 0 || restitution_ > 1) {
    throw InputError("exact rods: restitution = " + start.restitution + " (must be in [0, 1])");
  }
  place(start);
}

void ExactRods::place(const RodsStart& start) {
  const std::vector<Rational> x = numbers(start.positions);
  const std::vector<Rational> v = numbers(start.velocities);
  const std::vector<Rational> lengths = sizes(start.lengths, x.size(), "lengths");
  const std::vector<Rational> masses = sizes(start.masses, x.size(), "masses");
  order_.resize(x.size());
  std::iota(order_.begin(), order_.end(), 0);
  std::sort(order_.begin(), order_.end(), [&x](int a, int b) { return x[a] < x[b]; });
  const std::size_t letters = is_periodic_ ? x.size() : x.size() - 1;
  std::vector<Rational> gaps;
  std::vector<Rational> slopes;
  for (std::size_t i = 0; i < letters; ++i) {
    const int left = order_[i];
    const int right = order_[(i + 1) % x.size()];
    const Rational around = i + 1 == x.size() ? exact_number(start.period) : Rational(0);
    gaps.push_back(x[right] + around - x[left] - (lengths[left] + lengths[right]) / 2);
    slopes.push_back(v[right] - v[left]);
    if (gaps.back() < 0) {
      throw InputError("exact rods: rods " + std::to_string(left) + " and " +
                       std::to_string(right) + " overlap by " + decimal_above(-gaps.back(), 20));
    }
  }
  scale_ = common_denominator(slopes, common_denominator(gaps, 1));
  for (const Rational& gap : gaps) c_.push_back(times(gap, scale_));
  for (const Rational& slope : slopes) u_.push_back(times(slope, scale_));
  const auto [least, greatest] = std::minmax_element(v.begin(), v.end());
  velocity_range_ = *greatest - *least;
  if (are_equal(masses)) return;
  const Integer scale = common_denominator(masses, 1);
  for (const int rod : order_) masses_.push_back(times(masses[rod], scale));
  velocity_range_ = largest_difference(v, masses);
}

std::vector<Integer> ExactRods::masses_from(int place, std::size_t count) const {
  std::vector<Integer> masses;
  for (std::size_t n = 0; n < count && !masses_.empty(); ++n) {
    masses.push_back(masses_[(static_cast<std::size_t>(place) + n) % masses_.size()]);
  }
  return masses;
}

std::vector<int> ExactRods::neighbours(int letter) const {
  std::vector<int> beside;
  const int count = letters();
  for (const int i : {letter - 1, letter + 1}) {
    if (is_periodic_) {
      beside.push_back((i + count) % count);
    } else if (i >= 0 && i < count) {
      beside.push_back(i);
    }
  }
  return beside;
}

/// A gap beside the letter is zero as well when the letter's gap is.
bool ExactRods::has_contact_beside(int letter) const {
  for (const int i : neighbours(letter)) {
    if (i != letter && c_[i] * u_[letter] == u_[i] * c_[letter]) return true;
  }
  return false;
}

ExactRods::Event ExactRods::next_event() {
  int next = -1;
  for (int i = 0; i < letters(); ++i) {
    if (u_[i] >= 0) continue;
    // c_i / -u_i, the time of its contact: c_i >= 0 since the gap is.
    const bool is_first = next < 0 || compare_quotients(c_[i], -u_[i], c_[next], -u_[next]) < 0;
    if (is_first) next = i;
  }
  if (next < 0) return Event::none_left;
  const bool has_begun = letter_ >= 0;
  const Integer over = -u_[next];
  const bool is_again = has_begun && compare_quotients(c_[next], over, now_times_, now_over_) == 0;
  now_times_ = c_[next];
  now_over_ = over;
  letter_ = next;
  if (has_contact_beside(next)) return Event::exact_contact;
  has_simultaneous_ = has_simultaneous_ || is_again;
  collide(next);
  return Event::contact;
}

void ExactRods::collide(int letter) {
  Integer left = 1;
  Integer right = 1;
  if (const std::vector<Integer> pair = masses_from(letter, 2); !pair.empty()) {
    const Integer common = gcd(pair[0], pair[1]);
    left = pair[0] / common;
    right = pair[1] / common;
  }
  collide_letters(c_, letter, left, right);
  collide_letters(u_, letter, left, right);
  scale_ *= (left + right) * restitution_.get_den();
}

/// Times one positive integer, c and u after a contact of rods of these masses, whole numbers.
void ExactRods::collide_letters(std::vector<Integer>& values, int letter, const Integer& left,
                                const Integer& right) const {
  const Integer p = restitution_.get_num();
  const Integer q = restitution_.get_den();
  const Integer both = left + right;
  const Integer at = values[letter];
  for (Integer& value : values) value *= both * q;
  // Gap letter - 1 ends at the left rod, which the right one pushes.
  if (is_periodic_ || letter > 0) {
    values[(letter + letters() - 1) % letters()] += (p + q) * right * at;
  }
  if (is_periodic_ || letter + 1 < letters()) {
    values[(letter + 1) % letters()] += (p + q) * left * at;
  }
  values[letter] = -p * both * at;
}

Rational ExactRods::now() const {
  Rational time(now_times_, now_over_);
  time.canonicalize();
  return time;
}

bool ExactRods::is_after(const Rational& time) const {
  return now_times_ * time.get_den() > now_over_ * time.get_num();
}

Rational ExactRods::gap(int letter) const { return (c_[letter] + now() * u_[letter]) / scale_; }

}  // namespace zenosphere
