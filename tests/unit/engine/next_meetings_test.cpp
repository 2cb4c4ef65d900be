#include "engine/next_meetings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>

#include "model/archive.hpp"

namespace zenosphere {
namespace {

Meeting<double> at(double time, std::int32_t partner) { return {time, partner, 7, false}; }

TEST(Meeting, TellsWhatItWasMadeOf) {
  const Meeting<double> meeting(2.5, 16'777'216, 9, true);
  EXPECT_EQ(meeting.time, 2.5);
  EXPECT_EQ(meeting.partner(), 16'777'216);
  EXPECT_EQ(meeting.partner_collisions, 9u);
  EXPECT_TRUE(meeting.has_partner());
  EXPECT_TRUE(meeting.is_overlap());
  EXPECT_FALSE(at(1, 0).is_overlap());
  EXPECT_TRUE(at(1, 0).has_partner());
  EXPECT_FALSE(Meeting<double>().has_partner());
}

TEST(Meeting, TakesTwoToHalfALineOfTheCache) { EXPECT_EQ(sizeof(NextMeetings<double>), 32u); }

TEST(Meeting, OfEqualTimesTheLowerPartnersComesFirst) {
  EXPECT_TRUE(at(1, 3).is_before(at(2, 1)));
  EXPECT_TRUE(at(1, 1).is_before(at(1, 3)));
  EXPECT_FALSE(at(1, 3).is_before(at(1, 3)));
  EXPECT_TRUE(at(1, 3).is_before(Meeting<double>()));
}

TEST(NextMeetings, KeepTheFirstTwoInWhateverOrderTheyCome) {
  for (const auto& times :
       {std::array{1, 2, 3}, {1, 3, 2}, {2, 1, 3}, {2, 3, 1}, {3, 1, 2}, {3, 2, 1}}) {
    NextMeetings<double> next;
    for (const int time : times) next.add(at(time, 10 * time));
    EXPECT_EQ(next.first().partner(), 10);
    EXPECT_EQ(next.second().partner(), 20);
    EXPECT_FALSE(next.is_all());
  }
}

TEST(NextMeetings, AreAllAsLongAsNoneWasLeftOut) {
  NextMeetings<double> next;
  EXPECT_TRUE(next.is_all());
  next.add(at(2, 4));
  next.add(at(1, 5));
  EXPECT_TRUE(next.is_all());
  next.drop_first();
  EXPECT_EQ(next.first().partner(), 4);
  EXPECT_FALSE(next.second().has_partner());
  EXPECT_TRUE(next.is_all());
  next.add(at(3, 6));
  EXPECT_EQ(next.second().partner(), 6);
  EXPECT_TRUE(next.is_all());
}

TEST(NextMeetings, AddedToOthersAreAsIfAddedOneByOne) {
  constexpr int most = 3;
  for (int mine = 0; mine <= most; ++mine) {
    for (int theirs = 0; theirs <= most; ++theirs) {
      for (const bool first_is_known_alone : {false, true}) {
        NextMeetings<double> one_by_one;
        for (int k = 0; k < mine; ++k) one_by_one.add(at(2 + 2 * k, 2 * k));
        if (first_is_known_alone) one_by_one.drop_first();
        NextMeetings<double> at_once = one_by_one;
        NextMeetings<double> others;
        for (int k = 0; k < theirs; ++k) {
          one_by_one.add(at(3 + 2 * k, 2 * k + 1));
          others.add(at(3 + 2 * k, 2 * k + 1));
        }
        at_once.add(others);
        EXPECT_EQ(at_once.first().partner(), one_by_one.first().partner());
        EXPECT_EQ(at_once.second().partner(), one_by_one.second().partner());
        EXPECT_EQ(at_once.is_all(), one_by_one.is_all());
      }
    }
  }
}

TEST(NextMeetings, TakeNoSecondWhereAThirdMayComeBeforeIt) {
  NextMeetings<double> next(at(1, 4), at(2, 5), false);
  next.drop_first();  // the third, which is not known, comes now
  next.add(at(9, 6));
  EXPECT_EQ(next.first().partner(), 5);
  EXPECT_FALSE(next.second().has_partner());
  EXPECT_FALSE(next.is_all());
  next.add(at(1.5, 7));
  EXPECT_EQ(next.first().partner(), 7);
  EXPECT_EQ(next.second().partner(), 5);
}

TEST(NextMeetings, GoThroughAnArchive) {
  const NextMeetings<double> next({1, 4, 2, true}, at(2, 5), true);
  ArchiveWriter writer;
  writer(next);
  ArchiveReader reader(writer.bytes());
  const auto again = reader.next<NextMeetings<double>>();
  EXPECT_EQ(again.first().time, 1);
  EXPECT_EQ(again.first().partner_collisions, 2u);
  EXPECT_TRUE(again.first().is_overlap());
  EXPECT_EQ(again.second().partner(), 5);
  EXPECT_TRUE(again.is_all());
}

}  // namespace
}  // namespace zenosphere
