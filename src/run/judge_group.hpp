#pragma once

#include <vector>

#include "result/adjudication.hpp"
#include "run/followed_group.hpp"
#include "run/hit_groups.hpp"

namespace zenosphere {

/// The findings about a group of hits, each with the sentence that says what was required for it.
///
/// What counts is the highest precision; the others tell how far they saw the same contacts.
///
/// \param ladder  trials from one state, ascending in precision, the first in that of the run
std::vector<JudgedApproach> judge_group(const HitGroup& group,
                                        const std::vector<FollowedGroup>& ladder);

/// The first approach of the strongest finding; the end where there is none.
std::vector<JudgedApproach>::iterator strongest(std::vector<JudgedApproach>& approaches);

/// Whether more digits may tell more: an approach has used up those there were without a decision.
bool wants_more_digits(const FollowedGroup& top);

}  // namespace zenosphere
