#include <pybind11/pybind11.h>

#include <memory>
#include <string>

#include "python/bindings.hpp"
#include "python/read_output.hpp"

namespace zenosphere {

namespace py = pybind11;

void bind_output(py::module_& module) {
  py::class_<ReadOutput>(module, "Output")
      .def_static(
          "open", [](const std::string& file) { return std::make_unique<ReadOutput>(file); },
          py::arg("file"))
      .def("collisions", &ReadOutput::collisions)
      .def("series", &ReadOutput::series)
      .def("samples", &ReadOutput::samples)
      .def("snapshot", &ReadOutput::snapshot, py::arg("n"))
      .def_property_readonly("info", &ReadOutput::info)
      .def_property_readonly("resolved", &ReadOutput::resolved_case)
      .def_property_readonly("text", &ReadOutput::case_text)
      .def_property_readonly("has_every_collision", &ReadOutput::has_every_collision)
      .def_property_readonly("snapshots", &ReadOutput::snapshots);
}

}  // namespace zenosphere
