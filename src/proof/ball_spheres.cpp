#include "proof/ball_spheres.hpp"

namespace zenosphere {

namespace {

Ball dot(const std::vector<Ball>& a, const std::vector<Ball>& b) {
  Ball sum;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k] * b[k];
  return sum;
}

std::vector<Ball> difference(const std::vector<Ball>& a, const std::vector<Ball>& b) {
  std::vector<Ball> result;
  for (std::size_t k = 0; k < a.size(); ++k) result.push_back(a[k] - b[k]);
  return result;
}

std::vector<Ball> at(const std::vector<Ball>& p, const std::vector<Ball>& v, const Ball& time) {
  std::vector<Ball> result;
  for (std::size_t k = 0; k < p.size(); ++k) result.push_back(p[k] + v[k] * time);
  return result;
}

std::vector<Ball> balls(const std::vector<Rational>& values) {
  std::vector<Ball> result;
  for (const Rational& value : values) result.emplace_back(value);
  return result;
}

}  // namespace

BallSpheres::BallSpheres(std::span<const ExactSphere> spheres,
                         const PairRestitutions& restitutions) {
  for (const ExactSphere& sphere : spheres) {
    spheres_.push_back({balls(sphere.position), balls(sphere.velocity)});
  }
  const int count = static_cast<int>(spheres_.size());
  for (int i = 0; i < count; ++i) {
    for (int j = i + 1; j < count; ++j) {
      const ExactSphere& a = spheres[i];
      const ExactSphere& b = spheres[j];
      const Rational sigma = a.radius + b.radius;
      const Rational share = (1 + restitutions.rows[i][j]) / ((a.mass + b.mass) * sigma * sigma);
      predict(meetings_.emplace_back(Meeting{
          {i, j}, Ball(sigma), Ball(Rational(share * b.mass)), Ball(Rational(share * a.mass))}));
    }
  }
}

BallSpheres::Motion BallSpheres::motion(const Pair& pair) const {
  const Sphere& i = spheres_[pair.first];
  const Sphere& j = spheres_[pair.second];
  return {difference(j.p, i.p), difference(j.v, i.v)};
}

Ball BallSpheres::Motion::approach_at(const Ball& time) const { return dot(at(dp, dv, time), dv); }

Ball BallSpheres::Motion::gap_at(const Ball& time, const Ball& sigma) const {
  const std::vector<Ball> dr = at(dp, dv, time);
  const Ball square = dot(dr, dr);
  return (square - sigma * sigma) / ((square_root(square) + sigma) * sigma);
}

/// |dp + dv t| = sigma: the earlier root, for a pair that approaches.
void BallSpheres::predict(Meeting& meeting) const {
  const Motion pair = motion(meeting.pair);
  meeting.is_certain = true;
  meeting.time.reset();
  if (pair.approach_at(now_).is_positive()) return;
  const Ball a = dot(pair.dv, pair.dv);
  const Ball b = dot(pair.dp, pair.dv);
  const Ball& sigma = meeting.sigma;
  const Ball discriminant = b * b - a * (dot(pair.dp, pair.dp) - sigma * sigma);
  if (discriminant.is_negative()) return;
  meeting.is_certain = discriminant.is_positive() && pair.approach_at(now_).is_negative();
  if (meeting.is_certain) meeting.time = (Ball(0) - b - square_root(discriminant)) / a;
}

BallSpheres::Event BallSpheres::next_event() {
  const Meeting* next = nullptr;
  for (const Meeting& meeting : meetings_) {
    if (!meeting.is_certain) return Event::not_certain;
    if (meeting.time && (!next || seems_less(*meeting.time, *next->time))) next = &meeting;
  }
  if (!next) return Event::none_left;
  for (const Meeting& meeting : meetings_) {
    const bool is_later = &meeting == next || !meeting.time || is_less(*next->time, *meeting.time);
    if (!is_later) return Event::not_certain;
  }
  collide(*next);
  return Event::collision;
}

void BallSpheres::move_epoch_to_now() {
  const Ball step = now_.midpoint();
  for (Sphere& sphere : spheres_) sphere.p = at(sphere.p, sphere.v, step);
  for (Meeting& meeting : meetings_) {
    if (meeting.time) *meeting.time -= step;
  }
  now_ -= step;
  epoch_ += step;
}

void BallSpheres::collide(const Meeting& meeting) {
  Motion pair = motion(meeting.pair);
  gap_ = pair.gap_at(now_, meeting.sigma);
  now_ = *meeting.time;
  pair_ = meeting.pair;
  move_epoch_to_now();
  pair = motion(pair_);
  const std::vector<Ball> normal = at(pair.dp, pair.dv, now_);
  const Ball approach = dot(normal, pair.dv);
  const Ball change_i = meeting.share_i * approach;
  const Ball change_j = meeting.share_j * approach;
  Sphere& i = spheres_[pair_.first];
  Sphere& j = spheres_[pair_.second];
  for (std::size_t k = 0; k < normal.size(); ++k) {
    const Ball step_i = change_i * normal[k];
    const Ball step_j = change_j * normal[k];
    i.v[k] += step_i;
    j.v[k] -= step_j;
    i.p[k] -= step_i * now_;  // the place at `now` stays
    j.p[k] += step_j * now_;
  }
  for (Meeting& other : meetings_) {
    const auto [a, b] = other.pair;
    const bool is_affected =
        a == pair_.first || a == pair_.second || b == pair_.first || b == pair_.second;
    if (is_affected) predict(other);
  }
}

}  // namespace zenosphere
