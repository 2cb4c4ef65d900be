#pragma once

namespace zenosphere {

/// What is done with two spheres that overlap by rounding while they approach.
///
/// The rule decides whether an arrested state is left again, so it is part of the case.
enum class OverlapRule {
  rewind,     ///< collide at the time the formula gives, even if it lies in the past, as far as
              ///< rounding can have led there (longest_way_back); now if it lies further back
  immediate,  ///< collide now (Bannerman et al., Comput. Part. Mech. 1 (2014) 191)
  guarded,    ///< collide now if dr.dv < -guard, otherwise let them pass
  stop,       ///< end the run before the collision; those who touch at the start collide
};

}  // namespace zenosphere
