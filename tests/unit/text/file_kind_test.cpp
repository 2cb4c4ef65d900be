#include "text/file_kind.hpp"

#include <gtest/gtest.h>

namespace zenosphere {
namespace {

TEST(KindOfFile, IsToldByTheHeadOfATableAtTheBeginningOfALine) {
  EXPECT_EQ(kind_of_file("[system]\n"), FileKind::case_file);
  EXPECT_EQ(kind_of_file("# of [sweep]\n[system]\n"), FileKind::case_file);
  EXPECT_EQ(kind_of_file("# a sweep\n[sweep]\n"), FileKind::sweep);
  EXPECT_EQ(kind_of_file("# a [system] and a [sweep]\n"), FileKind::other);
}

TEST(KindOfFile, IsToldByItsFirstBytes) {
  EXPECT_EQ(kind_of_file("\x89HDF\r\n\x1a\n[system]\n"), FileKind::output);
  EXPECT_EQ(kind_of_file("SQLite format 3"), FileKind::store);
  EXPECT_EQ(kind_of_file(" SQLite format 3"), FileKind::other);
  EXPECT_EQ(kind_of_file(""), FileKind::other);
}

}  // namespace
}  // namespace zenosphere
