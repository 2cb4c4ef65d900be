#pragma once

#include <atomic>
#include <cstdint>
#include <string>

#include "proof/certificate.hpp"
#include "proof/exact_rods.hpp"

namespace zenosphere {

/// How far rods are followed, and how narrow the enclosure shall be.
struct RodLimits {
  std::int64_t contacts = 20000;
  int digits = 30;  ///< after the decimal point, of the time unit
  /// Of the longest number: c and u grow by log2(2 x the denominator of e) bits a contact, and the
  /// time of all contacts with the square of their number.
  std::int64_t bits = 1000000;
  std::string until{};  ///< decimal, time since the start: what comes later is not asked for
  const std::atomic<bool>* interrupt = nullptr;
};

/// Follows rods on a line in exact arithmetic and proves that they collapse, or that they never
/// will.
///
/// `proven`: neighbouring rods go on for ever with one word of contacts, whose infinitely many
/// contacts are over between `lower` and `upper`; no rod besides reaches them before. `escapes`: no
/// two rods approach each other any more. `finite`: they do, on a periodic line they nearly always
/// will, but the next contact is after `until`. `exact_contact`: three rods touch at one instant.
/// Source: docs/decisions/0019.
///
/// \throws InputError  as ExactRods does
Certificate certify_rods(const RodsStart& start, const RodLimits& limits = {});

}  // namespace zenosphere
