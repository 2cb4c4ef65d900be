#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "case/case_file.hpp"
#include "python/bindings.hpp"
#include "start/derived.hpp"

namespace zenosphere {

namespace py = pybind11;
using Texts = std::vector<std::string>;

void bind_case(py::module_& module) {
  py::class_<Case>(module, "Case")
      .def_static(
          "read",
          [](const std::string& file, const Texts& overrides) {
            return read_case(file, overrides);
          },
          py::arg("file"), py::arg("overrides"))
      .def_static(
          "parse",
          [](const std::string& text, const std::string& name, const Texts& overrides) {
            return parse_case(text, name, overrides);
          },
          py::arg("text"), py::arg("name"), py::arg("overrides"))
      .def_static(
          "parse_written",
          [](const std::string& text, const std::string& name, const Texts& overrides) {
            return parse_written_case(text, name, overrides);
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
      .def_property_readonly("derived", &derived_text);
}

}  // namespace zenosphere
