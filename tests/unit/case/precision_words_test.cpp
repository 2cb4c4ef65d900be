#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "case/case_file.hpp"
#include "model/errors.hpp"
#include "unit/case/case_texts.hpp"

namespace zenosphere {
namespace {

std::string answer(const std::string& override) {
  try {
    parse_case(cooling_case, "case.toml", std::vector<std::string>{override});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(PrecisionWords, UnknownOneIsAnsweredWithTheKnownOnesAndTheirRange) {
  for (const std::string word : {"half", "digits19", "digits10001", "digitsx", "digits0100"}) {
    const std::string override = "collision.precision=" + word;
    EXPECT_EQ(answer(override),
              fmt::format("--set {}: collision.precision = \"{}\" (must be \"double\", "
                          "\"extended\", \"quad\" or \"digitsN\" with N from 20 to 10000)",
                          override, word));
  }
}

TEST(PrecisionWords, NearMissIsAnsweredWithTheWordThatWasMeant) {
  EXPECT_TRUE(answer("collision.precision=quat").ends_with("; did you mean \"quad\"?"));
}

TEST(PrecisionWords, BothEndsOfTheRangeAreRight) {
  EXPECT_EQ(answer("collision.precision=digits20"), "");
  EXPECT_EQ(answer("collision.precision=digits10000"), "");
}

TEST(PrecisionWords, ThresholdThatIsNoNumberIsRefused) {
  EXPECT_EQ(answer("collapse.gap_threshold=small"),
            "--set collapse.gap_threshold=small: collapse.gap_threshold = \"small\" (must be a "
            "number > 0, or the text of one as in \"1e-1000\")");
}

}  // namespace
}  // namespace zenosphere
