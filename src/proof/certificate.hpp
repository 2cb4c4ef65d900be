#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace zenosphere {

/// What mathematics says of a collapse, beside what computations suggest.
struct Certificate {
  enum class Kind {
    none,           ///< nothing shown; the reason says why
    enclosed,       ///< the order of contacts is certain down to gaps of 10^-decades
    proven,         ///< infinitely many collisions until a time between lower and upper
    exact_contact,  ///< three spheres touch at one instant: what follows is not defined
    escapes,        ///< proven: after so many collisions nothing will ever collide again
    finite,         ///< proven: so many collisions, and no more, until the time that was asked for
  };
  Kind kind = Kind::none;
  std::string
      word{};  ///< one round of contacts, "abcb": for `none`, the last that repeated; may be empty
  std::vector<int> spheres{};   ///< of the cluster, in the order of its letters' places
  std::int64_t collisions = 0;  ///< that were followed one by one
  std::string lower{};     ///< decimal: the collapse is not before, for `enclosed` the last contact
  std::string upper{};     ///< decimal: nor after; for `enclosed` the last contact
  std::string exact{};     ///< the collapse time as a fraction, where it is one
  double contraction = 1;  ///< `proven`: what remains shrinks at least by this factor a round
  int decades = 0;         ///< `enclosed`: of the smallest gap
  std::string reason{};    ///< one sentence
};

}  // namespace zenosphere
