#include "text/printable.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

TEST(Printable, TextOfPeopleStaysAsItIs) {
  EXPECT_EQ(printable("a b\n\tc = \"\xC3\xA9\" \xC2\xB5"), "a b\n\tc = \"\xC3\xA9\" \xC2\xB5");
}

TEST(Printable, EscapeSequencesLoseTheirEffect) {
  EXPECT_EQ(printable("\x1B[2J\x07\r\x7F"), "?[2J???");
  EXPECT_EQ(printable("\xC2\x9B"
                      "2J"),
            "??2J");  // the one-character form of ESC [
}

TEST(Printable, PlainTextIsOneLineOfAscii) {
  EXPECT_TRUE(is_plain("0.1.0 (~ !)"));
  EXPECT_FALSE(is_plain("a\nb"));
  EXPECT_FALSE(is_plain("\x7F"));
  EXPECT_FALSE(is_plain("\xC3\xA9"));
}

}  // namespace
}  // namespace zenosphere
