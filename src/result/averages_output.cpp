#include "result/averages_output.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>
#include <vector>

#include "result/field_json.hpp"
#include "result/summary_line.hpp"
#include "result/uncertain.hpp"

namespace zenosphere {
namespace {

/// D arrays of D.
Json matrix(const std::vector<double>& values, int dimension) {
  assert(values.size() == static_cast<std::size_t>(dimension * dimension));
  Json result = Json::array();
  for (auto row = values.begin(); row != values.end(); row += dimension) {
    result.push_back(std::vector<double>(row, row + dimension));
  }
  return result;
}

Json json_of(double number, Shape, int) { return number; }
Json json_of(const std::optional<double>& number, Shape, int) { return or_null(number); }
Json json_of(const std::vector<double>& numbers, Shape shape, int dimension) {
  return shape == Shape::matrix ? matrix(numbers, dimension) : Json(numbers);
}

/// Whether a system does not have an observable. The pressure on walls was always listed.
bool is_absent(std::string_view, double) { return false; }
bool is_absent(std::string_view, const std::optional<double>& number) { return !number; }
bool is_absent(std::string_view name, const std::vector<double>& numbers) {
  return numbers.empty() && name != "wall_pressure";
}

/// Each observable that there is under its name; null what is no number.
Json json_of(const Observables& observables, int dimension) {
  Json result = Json::object();
  Observables::fields(observables, [&](const char* name, const auto& member, Shape shape, Mean) {
    if (!is_absent(name, member)) result[name] = json_of(member, shape, dimension);
  });
  return result;
}

/// The same object with null in the place of each value.
Json nulls(Json object) {
  for (auto& value : object) value = nullptr;
  return object;
}

/// A mean of independent numbers is known to about one part in the root of how many they are: as
/// many digits as that tells, and one more.
int digits_of_averages(std::int64_t collisions) {
  const double decades = std::log10(static_cast<double>(std::max<std::int64_t>(collisions, 1)));
  return std::clamp(2 + static_cast<int>(decades / 2), 2, 6);
}

/// Averages as lines, each with its error, or with so many digits where that is not known.
class AverageLines {
 public:
  AverageLines(const Averages& averages, int digits)
      : a_(averages), errors_(averages.standard_error.value_or(Observables{})), digits_(digits) {}

  std::string text(std::size_t dimension) const {
    std::string text = head();
    text +=
        number("granular temperature", &Observables::granular_temperature, " (diameter/time)^2");
    text += line("  along each axis", row(&Observables::temperature_diagonal, 0, dimension));
    text += number("pressure", &Observables::pressure, "");
    for (std::size_t n = 0; n < dimension; ++n) {
      text += line(n == 0 ? "  tensor" : "",
                   row(&Observables::pressure_tensor, n * dimension, dimension));
    }
    if (!a_.normal_stress_differences.empty()) {
      text += line("  normal differences", row(&Observables::normal_stress_differences, 0,
                                               a_.normal_stress_differences.size()));
    }
    text += number("compressibility factor", &Observables::compressibility_factor, "");
    text += number("collision rate", &Observables::collision_rate, " per sphere and time");
    text += number("normal speed", &Observables::normal_speed, " diameter/time");
    text += number("dissipation", &Observables::dissipation, " per volume and time");
    text += number("shear work", &Observables::shear_work, " per volume and time");
    if (a_.other_work != 0) {
      text += number("other work", &Observables::other_work, " per volume and time");
    }
    if (!a_.wall_pressure.empty()) {
      text += line("wall pressure", row(&Observables::wall_pressure, 0, a_.wall_pressure.size()));
    }
    if (!a_.wall_work.empty()) {
      text += line("work of walls",
                   row(&Observables::wall_work, 0, a_.wall_work.size()) + " per area and time");
    }
    return text + sonine_line() + streak_line() + a_.steady_reason +
           (a_.steady_reason.empty() ? "" : "\n");
  }

 private:
  std::string head() const {
    const bool is_known = a_.standard_error && std::isfinite(errors_.collision_rate);
    return fmt::format("averages from time {:.6g} to {:.6g}, {}\n", a_.from_time, a_.to_time,
                       is_known ? "with standard errors: 1.23(4) is 1.23 +- 0.04"
                                : "too short for standard errors");
  }
  std::string sonine_line() const {
    if (!a_.sonine_a2 || std::isnan(*a_.sonine_a2)) return "";
    return line("Sonine a2",
                with_error(*a_.sonine_a2, errors_.sonine_a2.value_or(std::nan("")), 3));
  }
  std::string streak_line() const {
    if (!a_.streak_amplitude) return "";
    const auto strongest = std::max_element(a_.streak_modes.begin(), a_.streak_modes.end());
    const auto mode = strongest - a_.streak_modes.begin();
    const double error = errors_.streak_modes.empty()
                             ? std::nan("")
                             : errors_.streak_modes.at(static_cast<std::size_t>(mode));
    return line("streak amplitude",
                with_error(*a_.streak_amplitude, error, digits_) + " diameter/time");
  }
  /// "none" for what there is only where spheres have met, or move.
  std::string number(std::string_view name, double Observables::*member,
                     std::string_view unit) const {
    const double value = a_.*member;
    const double error = a_.standard_error ? errors_.*member : std::nan("");
    return line(name,
                std::isnan(value) ? "none" : with_error(value, error, digits_) + std::string(unit));
  }
  std::string row(std::vector<double> Observables::*member, std::size_t first,
                  std::size_t count) const {
    const auto& errors = errors_.*member;
    std::string text;
    for (std::size_t k = first; k < first + count; ++k) {
      const double error = k < errors.size() ? errors[k] : std::nan("");
      text += fmt::format("{:<13} ", with_error((a_.*member)[k], error, digits_));
    }
    return text.substr(0, text.find_last_not_of(' ') + 1);
  }

  const Averages& a_;
  Observables errors_;
  int digits_;
};

}  // namespace

Json json_of(const std::optional<Averages>& averages, int dimension) {
  Averages a = averages.value_or(Averages{});
  if (!averages) {
    a.temperature_diagonal.resize(static_cast<std::size_t>(dimension));
    a.pressure_tensor.resize(static_cast<std::size_t>(dimension * dimension));
  }
  Json result = json_of(static_cast<const Observables&>(a), dimension);
  Json errors = a.standard_error ? json_of(*a.standard_error, dimension) : nulls(result);
  Averages::remarks(
      a, [&](const Field& field, const auto& member) { result[field.name] = field_json(member); });
  if (!averages) result = nulls(std::move(result));
  result["standard_error"] = std::move(errors);
  return result;
}

std::string text_of(const Averages& averages, std::int64_t collisions, int dimension) {
  return AverageLines(averages, digits_of_averages(collisions))
      .text(static_cast<std::size_t>(dimension));
}

}  // namespace zenosphere
