#pragma once

#include <pybind11/pybind11.h>

namespace zenosphere {

/// Adds the class `Case`: a checked case.
void bind_case(pybind11::module_& module);

/// Adds the class `Run`, and the type of a row of the collision log.
void bind_run(pybind11::module_& module);

/// Adds the class `Output`: what a run has recorded.
void bind_output(pybind11::module_& module);

}  // namespace zenosphere
