#include <pybind11/pybind11.h>

#include <exception>
#include <string>

#include "model/errors.hpp"
#include "python/bindings.hpp"
#include "storage/build_info.hpp"
#include "text/printable.hpp"

namespace zenosphere {

namespace {

namespace py = pybind11;

/// Raises an exception of zenosphere.errors, its text as the program prints it but for the names of
/// options, which are keyword arguments in Python.
void raise_in_python(const char* name, const std::exception& error) {
  const std::string text = printable(error.what());
  const auto shown = py::reinterpret_steal<py::object>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
  const auto errors = py::module_::import("zenosphere.errors");
  PyErr_SetObject(errors.attr(name).ptr(), errors.attr("in_python_words")(shown).ptr());
}

/// Makes the errors of the program those of zenosphere.errors, with the same texts.
void bind_errors() {
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const InputError& error) {
      raise_in_python("InputError", error);
    } catch (const OutputError& error) {
      raise_in_python("OutputError", error);
    }
  });
}

}  // namespace

}  // namespace zenosphere

PYBIND11_MODULE(_core, module) {
  module.doc() = "The simulator; zenosphere.Case and zenosphere.Run are its front.";
  module.attr("version") = zenosphere::build_info::program_version;
  module.attr("git_hash") = zenosphere::build_info::git_hash;
  zenosphere::bind_errors();
  zenosphere::bind_case(module);
  zenosphere::bind_run(module);
  zenosphere::bind_output(module);
}
