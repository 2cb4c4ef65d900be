#pragma once

#include <string>

namespace CLI {
class App;
class ParseError;
}  // namespace CLI

namespace zenosphere {

/// What is wrong with a command line that could not be parsed, in one line:
/// `zenosphere run: unknown option --overwite; did you mean --overwrite? See zenosphere run
/// --help`.
std::string usage_problem(const CLI::App& app, const CLI::ParseError& error);

}  // namespace zenosphere
