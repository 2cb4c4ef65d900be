#include "model/archive.hpp"

#include <cstdlib>
#include <cstring>

#include "model/precision.hpp"

namespace zenosphere {

namespace {

constexpr std::size_t extended_bytes = 10;  // of the 16 that a long double is stored in
constexpr int digits_exponent_limit = 1 << 30;

}  // namespace

void archive_detail::refuse(const char* what) { throw ArchiveError(what); }

void ArchiveWriter::raw(const void* data, std::size_t size) {
  const auto* begin = static_cast<const std::uint8_t*>(data);
  bytes_.insert(bytes_.end(), begin, begin + size);
}

void ArchiveWriter::write(const bool& value) { bytes_.push_back(value ? 1 : 0); }

void ArchiveWriter::write(const Extended& value) { raw(&value, extended_bytes); }

void ArchiveWriter::write(const Quad& value) { raw(&value, sizeof value); }

void ArchiveWriter::write(const Digits& value) {
  const auto parts = parts_of(value);
  (*this)(static_cast<std::uint8_t>(parts.kind), parts.negative, parts.exponent);
  raw(parts.words.data(), parts.words.size() * sizeof parts.words.front());
}

void ArchiveWriter::write(const std::string& text) {
  write(std::uint64_t{text.size()});
  raw(text.data(), text.size());
}

void ArchiveReader::raw(void* data, std::size_t size) {
  require_archived(size <= rest_.size(), "fewer bytes than its state takes");
  if (size > 0) std::memcpy(data, rest_.data(), size);
  rest_ = rest_.subspan(size);
}

std::size_t ArchiveReader::length(std::size_t size) {
  const auto count = next<std::uint64_t>();
  require_archived(count <= rest_.size() / size, "fewer bytes than its state takes");
  return static_cast<std::size_t>(count);
}

void ArchiveReader::read(bool& value) {
  const auto byte = next<std::uint8_t>();
  require_archived(byte <= 1, "a truth value that is neither");
  value = byte == 1;
}

void ArchiveReader::read(Extended& value) {
  if (is_promoting()) return promote(value);
  value = 0;  // the bytes of padding too
  raw(&value, extended_bytes);
}

void ArchiveReader::read(Quad& value) {
  if (is_promoting()) return promote(value);
  raw(&value, sizeof value);
}

void ArchiveReader::read(Digits& value) {
  if (is_promoting()) return promote(value);
  value = digits(WorkingPrecision::bits());
}

void ArchiveReader::read(std::string& text) {
  text.resize(length(1));
  raw(text.data(), text.size());
}

Digits ArchiveReader::digits(int bits) {
  DigitsParts parts;
  const auto kind = next<std::uint8_t>();
  (*this)(parts.negative, parts.exponent);
  parts.words.resize(words_of_bits(bits));
  raw(parts.words.data(), parts.words.size() * sizeof parts.words.front());
  require_archived(kind <= 2 && std::abs(std::int64_t{parts.exponent}) < digits_exponent_limit,
                   "a number that there is not");
  parts.kind = NumberKind{kind};
  const auto number = composed(parts, bits);
  require_archived(number.has_value(), "a number that there is not");
  return *number;
}

template <class Real>
void ArchiveReader::promote(Real& value) {
  const int bits = std::exchange(written_bits_, 0);
  if (bits == Precision::double_precision.bits()) {
    value = Real(next<double>());
  } else if (bits == Precision::extended.bits()) {
    value = Real(next<Extended>());
  } else if constexpr (!std::is_same_v<Real, Extended>) {
    if (bits == Precision::quad.bits()) {
      value = Real(next<Quad>());
    } else if constexpr (std::is_same_v<Real, Digits>) {
      value = digits(bits).in_working_precision();
    } else {
      value = Real(digits(bits));
    }
  }
  written_bits_ = bits;
}

}  // namespace zenosphere
