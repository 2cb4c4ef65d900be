#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <string>
#include <vector>

#include "python/bindings.hpp"
#include "python/collision_rows.hpp"
#include "python/driven_run.hpp"

namespace zenosphere {

namespace py = pybind11;

namespace {

using Output = std::optional<std::string>;

std::unique_ptr<DrivenRun> run_of(const Case& values, const Output& output) {
  return std::make_unique<DrivenRun>(values, output, Existing::refuse);
}

std::unique_ptr<DrivenRun> replacing_run_of(const Case& values, const Output& output) {
  return std::make_unique<DrivenRun>(values, output, Existing::replace);
}

std::unique_ptr<DrivenRun> run_from(const std::string& file,
                                    const std::vector<std::string>& overrides) {
  return std::make_unique<DrivenRun>(file, overrides);
}

}  // namespace

void bind_run(py::module_& module) {
  module.attr("collision_dtype") = collision_dtype();
  py::class_<DrivenRun>(module, "Run")
      .def_static("start", &run_of, py::arg("case"), py::arg("output"))
      .def_static("start_replacing", &replacing_run_of, py::arg("case"), py::arg("output"))
      .def_static("resume", &run_from, py::arg("file"), py::arg("overrides"))
      .def("advance", &DrivenRun::advance, py::arg("collisions"), py::arg("until"))
      .def("skip", &DrivenRun::skip, py::arg("collisions"), py::arg("until"))
      .def("save", &DrivenRun::save)
      .def("finish", &DrivenRun::finish)
      .def("stop", &DrivenRun::stop)
      .def("summary", &DrivenRun::summary)
      .def("state", &DrivenRun::state)
      .def_property_readonly("is_over", &DrivenRun::is_over)
      .def_property_readonly("collisions", &DrivenRun::collisions)
      .def_property_readonly("time", &DrivenRun::time)
      .def_property_readonly("case", &DrivenRun::values);
}

}  // namespace zenosphere
