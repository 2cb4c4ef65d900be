#include "model/archive.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "model/clock.hpp"
#include "model/random.hpp"
#include "model/vec.hpp"

namespace zenosphere {
namespace {

template <class T>
Bytes archived(const T& value) {
  ArchiveWriter archive;
  archive(value);
  return archive.release();
}

template <class T>
T restored(const Bytes& bytes) {
  ArchiveReader archive(bytes);
  const T value = archive.next<T>();
  archive.require_end();
  return value;
}

template <class Real>
class ArchivedNumber : public ::testing::Test {};
using Reals = ::testing::Types<double, Extended, Quad, Digits>;
TYPED_TEST_SUITE(ArchivedNumber, Reals);

TYPED_TEST(ArchivedNumber, ComesBackInEveryBit) {
  using Real = TypeParam;
  using Limits = std::numeric_limits<Real>;
  using std::ldexp;
  const Real third = Real(1) / 3;
  for (const Real& value : {third, Real(-third), Real(0), Real(1), Real(1 - Limits::epsilon() / 2),
                            Real(ldexp(third, 1000)), Real(ldexp(third, -1000)), Limits::infinity(),
                            Real(-Limits::infinity())}) {
    const Real back = restored<Real>(archived(value));
    EXPECT_EQ(back, value);
    EXPECT_EQ(back - third, value - third);  // not a number near it in fewer digits
  }
}

TYPED_TEST(ArchivedNumber, KeepsTheSignOfZeroAndWhatIsNoNumber) {
  using Real = TypeParam;
  using std::isnan;
  using std::signbit;
  EXPECT_TRUE(signbit(restored<Real>(archived(Real(-Real(0))))));
  EXPECT_FALSE(signbit(restored<Real>(archived(Real(0)))));
  EXPECT_TRUE(isnan(restored<Real>(archived(std::numeric_limits<Real>::quiet_NaN()))));
}

TEST(Archive, HasOneFormOfANumberAlsoJustBelowAPowerOfTwo) {
  const Digits below_one = 1 - std::numeric_limits<Digits>::epsilon() / 2;
  const Bytes bytes = archived(below_one);
  EXPECT_EQ(Bytes(bytes.begin() + 2, bytes.begin() + 6),
            archived(std::int32_t{0}));  // the exponent
}

TEST(Archive, NumbersTakeTheBytesOfTheirSignificantDigits) {
  EXPECT_EQ(archived(1.5).size(), 8u);
  EXPECT_EQ(archived(Extended(1.5)).size(), 10u);
  EXPECT_EQ(archived(Quad(1.5)).size(), 16u);
  EXPECT_EQ(archived(Digits(1.5)).size(), 50u);  // kind, sign, exponent and 11 words
}

TEST(Archive, DigitsTakeFourBytesForEach32Bits) {
  const WorkingPrecision here(bits_of_digits(1000));  // 3324 bits: 104 words
  EXPECT_EQ(archived(Digits(1.5)).size(), 6u + 4 * 104);
}

TEST(Archive, DigitsOfAnyLengthComeBackInEveryBit) {
  for (const int decimal : {20, 50, 99, 115, 116, 1000, 10000}) {
    const WorkingPrecision here(bits_of_digits(decimal));
    for (const Digits& value : {Digits(Digits(1) / 3), Digits(-Digits(1) / 7), Digits(0),
                                ldexp(Digits(1) / 3, -100000)}) {
      EXPECT_EQ(restored<Digits>(archived(value)), value) << decimal;
    }
  }
}

template <class Real>
Real promoted(const Bytes& bytes, int bits) {
  ArchiveReader archive(bytes);
  archive.promote_from(bits);
  return archive.next<Real>();
}

TEST(Archive, NumberThatIsPromotedStaysTheSame) {
  const Bytes in_double = archived(1.0 / 3);
  const Bytes in_extended = archived(Extended(1) / 3);
  const Bytes in_quad = archived(Quad(Quad(1) / 3));
  const Bytes in_hundred = archived(Digits(Digits(1) / 3));
  const Digits hundred = Digits(1) / 3;
  const WorkingPrecision here(bits_of_digits(250));
  EXPECT_EQ(promoted<Digits>(in_double, 53), 1.0 / 3);
  EXPECT_EQ(promoted<Digits>(in_extended, 64), Digits(Extended(1) / 3));
  EXPECT_EQ(promoted<Digits>(in_quad, 113), Digits(Quad(Quad(1) / 3)));
  EXPECT_EQ(promoted<Digits>(in_hundred, 334), hundred);
  // All that is made of it has the digits of the run.
  EXPECT_EQ(promoted<Digits>(in_hundred, 334).bits(), bits_of_digits(250));
}

TEST(Archive, DigitsBecomeAQuadWhereThatIsLonger) {
  const int bits = bits_of_digits(30);  // 101
  const WorkingPrecision here(bits);
  const Digits third = Digits(1) / 3;
  const Bytes bytes = archived(third);
  EXPECT_EQ(Digits(promoted<Quad>(bytes, bits)), third);
  EXPECT_LT(abs(promoted<Quad>(bytes, bits) - Quad(1) / 3), Quad(1e-30));
}

TEST(Archive, StructuresComeBack) {
  using Pairs = std::vector<std::pair<std::int32_t, std::int64_t>>;
  const Pairs pairs{{1, 2}, {-3, 1LL << 60}};
  EXPECT_EQ(restored<Pairs>(archived(pairs)), pairs);
  EXPECT_EQ(restored<std::optional<double>>(archived(std::optional<double>(2.5))), 2.5);
  EXPECT_EQ(restored<std::optional<double>>(archived(std::optional<double>())), std::nullopt);
  EXPECT_EQ(restored<std::string>(archived(std::string("a\0b", 3))), std::string("a\0b", 3));
  const Vec<3, Quad> vector{{Quad(1) / 3, 2, 3}};
  EXPECT_EQ((restored<Vec<3, Quad>>(archived(vector))), vector);
  const auto instant = restored<Instant<double>>(archived(Instant<double>{7, 0.25}));
  EXPECT_EQ(instant.units, 7);
  EXPECT_EQ(instant.remainder, 0.25);
}

TEST(Archive, RandomNumbersGoOnWhereTheyWere) {
  Random random(5);
  for (int k = 0; k < 1000; ++k) random.uniform();
  ArchiveWriter writer;
  writer(random);
  Random other(6);
  ArchiveReader reader(writer.bytes());
  reader(other);
  for (int k = 0; k < 1000; ++k) ASSERT_EQ(other.uniform(), random.uniform());
}

TEST(Archive, EveryTruncationIsAnError) {
  const std::vector<std::pair<std::string, double>> value{{"one", 1}, {"two", 2}};
  const Bytes bytes = archived(value);
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    const Bytes part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THROW((restored<std::vector<std::pair<std::string, double>>>(part)), ArchiveError);
  }
}

TEST(Archive, BytesThatAreLeftAreAnError) {
  Bytes bytes = archived(1.0);
  bytes.push_back(0);
  EXPECT_THROW(restored<double>(bytes), ArchiveError);
}

TEST(Archive, LengthBeyondTheEndIsAnErrorAndNotAnAllocation) {
  for (const std::uint64_t length : {std::uint64_t{2}, std::uint64_t{1} << 40, ~std::uint64_t{0}}) {
    Bytes bytes = archived(length);
    bytes.push_back(0);
    EXPECT_THROW(restored<std::string>(bytes), ArchiveError);
    EXPECT_THROW(restored<std::vector<double>>(bytes), ArchiveError);
    EXPECT_THROW(restored<std::vector<Digits>>(bytes), ArchiveError);
  }
}

TEST(Archive, CountsThatNoRunComesToAreAnError) {
  EXPECT_NO_THROW(require_counts(0, most_counted, std::optional<std::int64_t>()));
  EXPECT_THROW(require_counts(1, std::int64_t{-1}), ArchiveError);
  EXPECT_THROW(require_counts(std::optional(most_counted + 1)), ArchiveError);
}

TEST(Archive, RandomGeneratorThatIsStuckIsAnError) {
  std::string zeros;
  for (int word = 0; word < 312; ++word) zeros += "0 ";
  // The lowest 31 bits of the first word are never used: the second one is a state of zeros too.
  for (const std::string& words : {zeros, "7" + zeros.substr(1)}) {
    const Bytes text = archived(words + "312");
    Random random(1);
    ArchiveReader reader(text);
    EXPECT_THROW(reader(random), ArchiveError);
  }
}

TEST(Archive, NonsenseIsAnError) {
  EXPECT_THROW(restored<bool>({2}), ArchiveError);
  EXPECT_THROW(restored<std::optional<bool>>({7, 1}), ArchiveError);
  EXPECT_THROW(restored<Instant<double>>(archived(Instant<double>{-1, 0})), ArchiveError);
  EXPECT_THROW(restored<Instant<double>>(archived(Instant<double>{0, HUGE_VAL})), ArchiveError);
  Bytes digits = archived(Digits(1));
  digits[0] = 3;
  EXPECT_THROW(restored<Digits>(digits), ArchiveError);
  Bytes unbegun = archived(Digits(1));
  unbegun[9] = 0;  // the first word no longer begins with a 1
  unbegun[10] = 1;
  EXPECT_THROW(restored<Digits>(unbegun), ArchiveError);
  Bytes longer = archived(Digits(1));
  longer[46] = 1;  // the 352nd bit of 334
  EXPECT_THROW(restored<Digits>(longer), ArchiveError);
  Random random(1);
  const Bytes text = archived(std::string("one two three"));
  ArchiveReader reader(text);
  EXPECT_THROW(reader(random), ArchiveError);
}

}  // namespace
}  // namespace zenosphere
