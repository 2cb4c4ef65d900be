#include "cli/python_process.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "model/errors.hpp"

namespace zenosphere {

namespace {

namespace fs = std::filesystem;

/// Folder that holds the Python package: beside the program in a build, where it or Debian's
/// package is installed, or around the program where pip has put it into the package. Empty where
/// there is none: Python's own path may have it.
fs::path python_folder() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  if (error) return {};
  const fs::path here = program.parent_path();
  const fs::path prefix = here.parent_path();
  for (const fs::path& folder : {here / "python", prefix / ZENOSPHERE_PYTHON_FOLDER,
                                 prefix / "lib/python3/dist-packages", prefix.parent_path()}) {
    if (fs::exists(folder / "zenosphere" / "__init__.py", error)) return folder.lexically_normal();
  }
  return {};
}

/// Makes Python find the package of this program before any other.
void lead_path_to(const fs::path& folder) {
  if (folder.empty()) return;
  const char* const given = std::getenv("PYTHONPATH");
  const std::string path = folder.string() + (given && *given ? ':' + std::string(given) : "");
  setenv("PYTHONPATH", path.c_str(), 1);
}

}  // namespace

void become_python(const std::string& command, const std::vector<std::string>& words) {
  const char* const chosen = std::getenv("ZENOSPHERE_PYTHON");
  const std::string python = chosen && *chosen ? chosen : ZENOSPHERE_PYTHON;
  lead_path_to(python_folder());
  setenv("ZENOSPHERE_COMMAND", "zenosphere", 1);
  std::vector<std::string> line{python, "-m", "zenosphere", command};
  line.insert(line.end(), words.begin(), words.end());
  std::vector<char*> arguments;
  for (std::string& word : line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execvp(python.c_str(), arguments.data());
  throw InputError(
      fmt::format("zenosphere {}: {} cannot be started ({}), and this command is one of the Python "
                  "package; install python3, python3-numpy, python3-scipy, python3-h5py and "
                  "python3-matplotlib, or "
                  "name an interpreter that has them in ZENOSPHERE_PYTHON",
                  command, python, std::strerror(errno)));
}

}  // namespace zenosphere
