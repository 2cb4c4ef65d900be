#include <fmt/format.h>

#include <cstdio>
#include <exception>

#include "cli/commands.hpp"
#include "model/errors.hpp"
#include "text/printable.hpp"

namespace {

int fail(const std::exception& error, int exit_code) {
  // Not fmt::print, which throws where the standard error is closed.
  std::fputs((zenosphere::printable(error.what()) + '\n').c_str(), stderr);
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  using namespace zenosphere;
  try {
    return run_command_line(argc, argv);
  } catch (const InputError& error) {
    return fail(error, exit_code::wrong_input);
  } catch (const OutputError& error) {
    return fail(error, exit_code::output_failed);
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "zenosphere: out of memory; use fewer spheres\n");
    return exit_code::internal_error;
  } catch (const std::exception& error) {
    fmt::print(stderr, "zenosphere: internal error: {}\n", error.what());
    return exit_code::internal_error;
  }
}
