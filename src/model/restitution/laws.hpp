#pragma once

#include <array>
#include <optional>
#include <utility>
#include <variant>

#include "model/restitution/fixed_loss.hpp"
#include "model/restitution/two_valued.hpp"
#include "model/restitution/viscoelastic.hpp"
#include "model/word_table.hpp"

namespace zenosphere {

/// How the restitution depends on the speed.
enum class RestitutionLaw { constant, viscoelastic, fixed_loss, two_valued };

/// A law of the list, with its name in the program.
template <RestitutionLaw name, class Law>
struct ListedLaw : Law {
  static constexpr RestitutionLaw choice = name;
};

/// Laws of restitution that depend on the speed.
///
/// Each is a struct with `word`, its word in a case file, a member for each of its numbers, their
/// `keys`, and `in<Real>()`, which makes of them the law in a number type: a function of the
/// closing speed along the normal and, where it depends on sizes or masses, of a CollidingPair.
template <class... Laws>
struct LawList {
  /// The numbers of all of them, as a case has them.
  struct Numbers : Laws... {};

  /// One of them in a number type.
  template <class Real>
  using Any = std::variant<decltype(std::declval<const Laws&>().template in<Real>())...>;

  /// The words of all, and that of the constant restitution.
  static constexpr std::array words{Word<RestitutionLaw>{"constant", RestitutionLaw::constant},
                                    Word<RestitutionLaw>{Laws::word, Laws::choice}...};

  /// Calls visit(law) for the numbers of each.
  template <class Visitor>
  static void for_each(Numbers& numbers, Visitor&& visit) {
    (visit(static_cast<Laws&>(numbers)), ...);
  }

  /// The law of a case in a number type; nothing where the restitution is constant.
  template <class Real>
  static std::optional<Any<Real>> chosen(RestitutionLaw choice, const Numbers& numbers) {
    std::optional<Any<Real>> law;
    const auto make = [&](const auto& one) {
      if (one.choice == choice) law.emplace(one.template in<Real>());
    };
    (make(static_cast<const Laws&>(numbers)), ...);
    return law;
  }
};

/// All there are, in the order of the reference page. A new one is a line here, and a name above.
using RestitutionLaws = LawList<ListedLaw<RestitutionLaw::viscoelastic, ViscoelasticLaw>,
                                ListedLaw<RestitutionLaw::fixed_loss, FixedLossLaw>,
                                ListedLaw<RestitutionLaw::two_valued, TwoValuedLaw>>;

inline const auto& words_of(RestitutionLaw) { return RestitutionLaws::words; }

}  // namespace zenosphere
