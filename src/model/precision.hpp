#pragma once

#include <array>
#include <compare>
#include <optional>
#include <string>
#include <string_view>

namespace zenosphere {

/// Bits of the significand that hold so many decimal digits, with one or two to spare.
///
/// 1000/301 is a little above log2(10). Source: the rule of Boost.Multiprecision.
constexpr int bits_of_digits(int decimal) {
  return decimal * 1000 / 301 + (decimal * 1000 % 301 != 0 ? 2 : 1);
}

inline constexpr int fewest_digits = 20;   ///< `extended` has 19
inline constexpr int most_digits = 10000;  ///< of decimal digits that a run may ask for

/// The precision of a run's arithmetic, ordered by the bits of its significand.
class Precision {
 public:
  static const Precision double_precision, extended, quad;

  constexpr Precision() = default;

  /// \param decimal  digits, from fewest_digits to most_digits
  static constexpr Precision digits(int decimal) { return {bits_of_digits(decimal), decimal}; }

  /// The precision that a word means: "double", "extended", "quad" or "digits250"; or nothing.
  static std::optional<Precision> from_word(std::string_view word);
  std::string word() const;

  /// Of the significand.
  constexpr int bits() const { return bits_; }

  /// Whether MPFR does the arithmetic, with a significand as long as is asked for.
  constexpr bool is_digits() const { return decimal_ != 0; }

  friend constexpr bool operator==(const Precision&, const Precision&) = default;
  friend constexpr auto operator<=>(const Precision& a, const Precision& b) {
    return a.bits_ <=> b.bits_;
  }

 private:
  constexpr Precision(int bits, int decimal) : bits_(bits), decimal_(decimal) {}

  int bits_ = 53;
  int decimal_ = 0;  ///< 0: one of the three types of the processor and the compiler
};

inline constexpr Precision Precision::double_precision{53, 0};
inline constexpr Precision Precision::extended{64, 0};
inline constexpr Precision Precision::quad{113, 0};

/// Whether numbers with a significand of so many bits are those of some precision.
bool is_precision_of_bits(int bits);

}  // namespace zenosphere
