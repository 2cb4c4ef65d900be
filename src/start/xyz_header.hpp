#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "start/xyz_lines.hpp"

namespace zenosphere::xyz {

/// Where the numbers of a sphere stand in its line.
struct Columns {
  struct Span {
    std::size_t first = 0;
    std::size_t count = 0;  ///< 0: there are none
  };
  /// A number that must be that of the spheres of a case.
  struct Fixed {
    std::string name;  ///< `radius`
    std::size_t column;
    double value;
  };

  Span position;
  Span velocity;
  std::string velocity_name;  ///< `velo`
  bool has_momenta = false;   ///< the velocities are momenta
  Span momentum;              ///< beside velocities, whose numbers it must repeat: mass 1
  bool has_masses = false;    ///< a column tells that the mass is 1
  Span spin;                  ///< three columns, or none
  std::vector<Fixed> fixed;   ///< radius, diameter, mass
  /// A column of words for the kinds, and how surely they are meant: the least is the surest.
  struct Kind {
    std::size_t rank;
    std::size_t column;
  };
  std::optional<Kind> kind;
  std::optional<std::size_t> total;  ///< columns in all; none: more may follow
};

/// The box that Lattice tells.
struct Lattice {
  std::vector<double> sides;  ///< D, diameters
  double offset = 0;          ///< of the second vector along x, diameters
};

/// What the second line of a frame tells.
struct Header {
  Lattice lattice;
  std::vector<double> origin;                      ///< D, diameters: the lowest corner of the box
  std::optional<std::array<bool, 3>> is_periodic;  ///< none: not told
  Columns columns;
  std::vector<std::string> kind_names{};  ///< of the numbers in the column `kind`; maybe none
};

/// Reads the second line of a frame: `Lattice`, `Origin`, `pbc` and `Properties`, keys in any case.
///
/// \param comment    the line
/// \param dimension  D
/// \param lines      for the messages: the comment is the line read last
/// Other keys are skipped, unless they say something of the spheres that does not fit.
/// Throws InputError where one of them is wrong, nearly spelt right or there twice, or where there
/// is no Lattice.
Header header_of(std::string_view comment, int dimension, const Lines& lines);

/// Numbers of a file that differ by less are equal: in text they often have ten digits.
inline constexpr double file_accuracy = 1e-9;

/// Throws InputError, at the line read last, unless a number is that of the spheres of a case.
///
/// \param name      `radius`
/// \param expected  what it must be, to 1e-9
void require_unit(const std::string& name, double number, double expected, const Lines& lines);

}  // namespace zenosphere::xyz
