#pragma once

#include <cstdint>
#include <limits>

namespace zenosphere {

/// What a sphere is going to meet, and when: as foreseen at one moment.
template <class Real>
class Meeting {
 public:
  Real time = std::numeric_limits<Real>::infinity();  ///< remainder of the clock; infinity: none
  std::uint32_t partner_collisions = 0;               ///< those of the partner up to that moment

  /// None.
  Meeting() = default;
  /// \param overlapping  the two overlap already
  Meeting(const Real& when, std::int32_t partner, std::uint32_t collisions_of_partner,
          bool overlapping)
      : time(when),
        partner_collisions(collisions_of_partner),
        who_(static_cast<std::uint32_t>(partner + 1) | (overlapping ? overlap_bit : 0)) {}

  /// A sphere, or a wall; -1: none.
  std::int32_t partner() const { return static_cast<std::int32_t>(who_ & partner_bits) - 1; }
  bool has_partner() const { return partner() >= 0; }
  bool is_overlap() const { return (who_ & overlap_bit) != 0; }

  /// Whether no other is met after it.
  bool is_last() const { return (who_ & last_bit) != 0; }
  void set_last(bool last) { who_ = last ? who_ | last_bit : who_ & ~last_bit; }

  /// Of equal times the lower partner's comes first, so that the order of neighbours has no effect.
  bool is_before(const Meeting& other) const {
    return time < other.time || (time == other.time && partner() < other.partner());
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.time, self.partner_collisions, self.who_);
  }

 private:
  static constexpr std::uint32_t overlap_bit = std::uint32_t{1} << 30;
  static constexpr std::uint32_t last_bit = std::uint32_t{1} << 31;
  static constexpr std::uint32_t partner_bits = overlap_bit - 1;

  std::uint32_t who_ = 0;  ///< the partner + 1, and two bits
};

/// The first two meetings of a sphere. When the partner of the first has met another one, the
/// second takes its place, which spares most predictions.
template <class Real>
class NextMeetings {
 public:
  /// None is met.
  NextMeetings() { second_.set_last(true); }

  /// \param is_all  there is no third meeting, and no second if that is none
  NextMeetings(const Meeting<Real>& first, const Meeting<Real>& second, bool is_all) {
    set(first, second, is_all);
  }
  void set(const Meeting<Real>& first, Meeting<Real> second, bool is_all) {
    second.set_last(is_all);
    first_ = first;
    second_ = second;
  }

  const Meeting<Real>& first() const { return first_; }
  const Meeting<Real>& second() const { return second_; }
  bool is_all() const { return second_.is_last(); }

  /// Adds a meeting, if it is among the first two. Where the second is not known, what comes after
  /// the first need not be the second.
  void add(const Meeting<Real>& meeting) {
    const bool has_second = second_.has_partner();
    const bool was_all = is_all();
    if (meeting.is_before(first_)) {
      second_ = first_;
      first_ = meeting;
    } else if ((has_second || was_all) && meeting.is_before(second_)) {
      second_ = meeting;
    }
    second_.set_last(was_all && !has_second);
  }

  /// Adds meetings of which the first two are known, or all.
  void add(const NextMeetings& others) {
    if (others.first_.has_partner()) add(others.first_);
    if (others.second_.has_partner()) add(others.second_);
    if (!others.is_all()) second_.set_last(false);
  }

  /// Lets the second take the place of the first.
  void drop_first() {
    const bool was_all = is_all();
    first_ = second_;
    second_ = {};
    second_.set_last(was_all);
  }

  void shift_times(const Real& span) {
    first_.time -= span;
    second_.time -= span;
  }

  template <class Self, class Archive>
  static void archive_state(Self& self, Archive& archive) {
    archive(self.first_, self.second_);
  }

 private:
  Meeting<Real> first_;
  Meeting<Real> second_;
};

}  // namespace zenosphere
