#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <string>
#include <vector>

#include "case/case_file.hpp"
#include "case/case_grains.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "start/derived.hpp"
#include "start/start_species.hpp"

namespace zenosphere {

namespace py = pybind11;
using Texts = std::vector<std::string>;

namespace {

/// Diameters, masses, kinds and which are immobile: an entry for each sphere.
py::tuple grain_arrays(const Case& values) {
  const Grains<double> grains = grains_of(values);
  const auto spheres = static_cast<std::int32_t>(values.system.spheres);
  std::vector<double> diameters, masses;
  std::vector<std::int32_t> kinds;
  std::vector<std::uint8_t> immobile;
  for (std::int32_t i = 0; i < spheres; ++i) {
    diameters.push_back(grains.diameter(i));
    masses.push_back(grains.mass(i));
    kinds.push_back(grains.kind(i));
    immobile.push_back(grains.is_immobile(i) ? 1 : 0);
  }
  return py::make_tuple(
      owning_array(std::move(diameters), {spheres}), owning_array(std::move(masses), {spheres}),
      owning_array(std::move(kinds), {spheres}), owning_array(std::move(immobile), {spheres}));
}

}  // namespace

void bind_case(py::module_& module) {
  py::class_<Case>(module, "Case")
      .def_static(
          "read",
          [](const std::string& file, const Texts& overrides) {
            return with_species_of_start(read_case(file, overrides));
          },
          py::arg("file"), py::arg("overrides"))
      .def_static(
          "parse",
          [](const std::string& text, const std::string& name, const Texts& overrides) {
            return with_species_of_start(parse_case(text, name, overrides));
          },
          py::arg("text"), py::arg("name"), py::arg("overrides"))
      .def_static(
          "parse_written",
          [](const std::string& text, const std::string& name, const Texts& overrides) {
            return with_species_of_start(parse_written_case(text, name, overrides));
          },
          py::arg("text"), py::arg("name"), py::arg("overrides"))
      .def_static(
          "restored",
          [](const std::string& resolved, const std::string& text) {
            Case values = parse_case(resolved, "case", {});
            values.text = text;
            return values;
          },
          py::arg("resolved"), py::arg("text"))
      .def_readonly("text", &Case::text)
      .def_property_readonly("resolved", &resolved_toml)
      .def_property_readonly("derived", &derived_text)
      .def("grains", &grain_arrays);
}

}  // namespace zenosphere
