#include "flow/samples.hpp"

#include <utility>

#include "flow/intervals_to_next.hpp"
#include "model/instantiate.hpp"

namespace zenosphere {
namespace {

// What every row begins with.
enum Own : std::size_t { samples_in_row, span_of_row, own_columns };

std::size_t total(const std::vector<SampledColumn>& columns) {
  std::size_t size = 0;
  for (const SampledColumn& column : columns) size += column.size();
  return size;
}

}  // namespace

template <int Dim, class Real>
Samples<Dim, Real>::Samples(const Simulation<Dim, Real>& simulation, const SampleTimes& times)
    : system_(SampledSystem<Dim>::of(simulation)),
      when_(times),
      moments_(system_),
      displacements_(system_),
      collisions_(system_, simulation),
      columns_{{"samples"}, {"span"}},
      last_(times.from_time) {
  for (auto&& columns : {moments_.columns(), displacements_.columns()}) {
    columns_.insert(columns_.end(), columns.begin(), columns.end());
  }
  first_of_collisions_ = total(columns_);
  const auto of_collisions = collisions_.columns();
  columns_.insert(columns_.end(), of_collisions.begin(), of_collisions.end());
  width_ = total(columns_);
  current_.resize(width_);
  const double first = std::max(std::ceil(times.from_time / times.interval), 1.0);
  multiple_ =
      first < static_cast<double>(most_counted) ? static_cast<std::int64_t>(first) : most_counted;
}

template <int Dim, class Real>
double Samples<Dim, Real>::next() const {
  constexpr auto most = static_cast<double>(std::int64_t{1} << 53);  // multiples are exact up to it
  const auto multiple = static_cast<double>(multiple_);
  return multiple < most ? multiple * when_.interval : std::numeric_limits<double>::infinity();
}

template <int Dim, class Real>
void Samples<Dim, Real>::observe(const Collision<Dim, Real>& collision,
                                 const Simulation<Dim, Real>& simulation) {
  const bool counts = simulation.time() >= when_.from_time;
  collisions_.observe(collision, simulation,
                      counts ? current_.data() + first_of_collisions_ : nullptr);
}

template <int Dim, class Real>
void Samples<Dim, Real>::take(const Simulation<Dim, Real>& simulation) {
  const auto moment = SampledMoment<Dim>::of(simulation);
  const double now = next();
  current_[samples_in_row] += 1;
  current_[span_of_row] += now - std::exchange(last_, now);
  SumsOfColumns sums(current_.data() + own_columns);
  moments_.add(moment, sums);
  displacements_.add(moment, moments_.template of<VelocitySums>().peculiar(moment), multiple_,
                     when_.interval, sums);
  schedule_next(simulation);
  if (current_[samples_in_row] < static_cast<double>(in_a_row_)) return;
  sums_.insert(sums_.end(), current_.begin(), current_.end());
  ends_.push_back(now);
  steps_.push_back(simulation.collisions());
  current_.assign(width_, 0);
  if (steps_.size() == most_rows) put_together();
}

template <int Dim, class Real>
void Samples<Dim, Real>::schedule_next(const Simulation<Dim, Real>& simulation) {
  do {
    multiple_ += when_.clock_is_limited ? 1 : intervals_to_next(multiple_);
  } while (simulation.has_reached(next()));
}

/// Makes one row of two and two.
template <int Dim, class Real>
void Samples<Dim, Real>::put_together() {
  const std::size_t rows = steps_.size() / 2;
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t n = 0; n < width_; ++n) {
      sums_[row * width_ + n] = sums_[2 * row * width_ + n] + sums_[(2 * row + 1) * width_ + n];
    }
    ends_[row] = ends_[2 * row + 1];
    steps_[row] = steps_[2 * row + 1];
  }
  sums_.resize(rows * width_);
  ends_.resize(rows);
  steps_.resize(rows);
  in_a_row_ *= 2;
}

template <int Dim, class Real>
std::vector<SampledEdges> Samples<Dim, Real>::edges() const {
  std::vector<SampledEdges> edges;
  for (auto&& of_part :
       {moments_.edges(), displacements_.edges(when_.interval), collisions_.edges()}) {
    edges.insert(edges.end(), of_part.begin(), of_part.end());
  }
  return edges;
}

template <int Dim, class Real>
std::vector<double> Samples<Dim, Real>::values(std::size_t number) const {
  std::size_t first = 0;
  for (std::size_t n = 0; n < number; ++n) first += columns_[n].size();
  const std::size_t size = columns_[number].size();
  std::vector<double> values;
  for (std::size_t row = 0; row < steps_.size(); ++row) {
    const double* const begin = sums_.data() + row * width_ + first;
    values.insert(values.end(), begin, begin + size);
  }
  return values;
}

#define ZENOSPHERE_INSTANTIATE(Dim, Real) template class Samples<Dim, Real>;
ZENOSPHERE_FOR_EACH_ENGINE(ZENOSPHERE_INSTANTIATE)
#undef ZENOSPHERE_INSTANTIATE

}  // namespace zenosphere
