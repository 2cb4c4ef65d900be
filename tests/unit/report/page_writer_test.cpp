#include "report/page_writer.hpp"

#include <gtest/gtest.h>

#include <string_view>

namespace zenosphere {
namespace {

TEST(AsScript, LeavesNoMarkupInAScript) {
  EXPECT_EQ(as_script(R"({"text":"</script><!--"})"), R"({"text":"\u003c/script>\u003c!--"})");
}

}  // namespace
}  // namespace zenosphere
