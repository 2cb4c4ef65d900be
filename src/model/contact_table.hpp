#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace zenosphere {

/// The three constants of a contact.
///
/// Source: Walton, in Particulate Two-Phase Flow, ed. Roco (1993), ch. 25.
template <class Real>
struct ContactConstants {
  Real restitution = 1;              ///< e, of the normal velocity, in [0, 1]
  Real tangential_restitution = -1;  ///< beta0, of the surfaces while they stick, in [-1, 1]; -1:
                                     ///< smooth
  Real friction = 0;                 ///< mu >= 0; infinity: they always stick
  bool is_own = false;  ///< the restitution is this one, whatever law the other pairs follow

  /// Whether anything but the normal velocity changes.
  bool is_rough() const { return tangential_restitution > -1 && friction > 0; }
  static Real unbounded() { return std::numeric_limits<Real>::infinity(); }
};

/// The constants of a contact for each pair of kinds.
template <class Real>
class ContactTable {
 public:
  /// One kind of smooth elastic spheres.
  ContactTable() : ContactTable(1, {}) {}
  /// \param kinds  >= 1
  ContactTable(std::int32_t kinds, const ContactConstants<Real>& of_all)
      : kinds_(kinds), constants_(static_cast<std::size_t>(kinds * kinds), of_all) {}

  std::int32_t kinds() const { return kinds_; }
  const ContactConstants<Real>& of(std::int32_t a, std::int32_t b) const {
    return constants_[static_cast<std::size_t>(a * kinds_ + b)];
  }
  void set(std::int32_t a, std::int32_t b, const ContactConstants<Real>& constants) {
    constants_[static_cast<std::size_t>(a * kinds_ + b)] = constants;
    constants_[static_cast<std::size_t>(b * kinds_ + a)] = constants;
  }

  /// Whether any two kinds are rough for each other.
  bool is_rough() const {
    for (const auto& constants : constants_) {
      if (constants.is_rough()) return true;
    }
    return false;
  }

 private:
  std::int32_t kinds_;
  std::vector<ContactConstants<Real>> constants_;
};

}  // namespace zenosphere
