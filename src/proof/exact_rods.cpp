#include "proof/exact_rods.hpp"

#include <algorithm>
#include <cmath>
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
      constexpr double kSafe = 1e-12;  // each mantissa is good to 4 x 2^-52
      if (std::abs(ratio - 1) > kSafe) return ratio < 1 ? -1 : 1;
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
    gaps.push_back(x[right] + around - x[left] - 1);
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
  const std::vector<int> beside = neighbours(letter);
  collide_letters(c_, letter, beside, restitution_);
  collide_letters(u_, letter, beside, restitution_);
  scale_ *= 2 * restitution_.get_den();
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

void collide_letters(std::vector<Integer>& values, int letter, const std::vector<int>& neighbours,
                     const Rational& restitution) {
  const Integer p = restitution.get_num();
  const Integer q = restitution.get_den();
  const Integer at = values[letter];
  for (Integer& value : values) value *= 2 * q;
  for (const int i : neighbours) values[i] += (p + q) * at;
  values[letter] = -2 * p * at;
}

}  // namespace zenosphere
