#include "fuzz/readers.hpp"

#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/run_case.hpp"
#include "case/case_file.hpp"
#include "case/case_tree.hpp"
#include "fuzz/memory_file.hpp"
#include "model/errors.hpp"
#include "result/summary.hpp"
#include "start/derived.hpp"
#include "start/start_file.hpp"
#include "storage/info.hpp"
#include "storage/integrity.hpp"
#include "storage/output_info.hpp"
#include "storage/run_reader.hpp"
#include "storage/sandboxed_read.hpp"
#include "storage/stored_info.hpp"
#include "verify/verify.hpp"

namespace zenosphere::fuzz {
namespace {

std::string text_of(Bytes bytes) { return {bytes.begin(), bytes.end()}; }

/// Ends the process where what must hold does not.
void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "fuzz: %s\n", what);
  std::abort();
}

/// Reads, and takes a refusal for an answer.
template <class Action>
void attempt(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    require(!std::string_view(error.what()).empty(), "a refusal has a text");
  }
}

/// A box of 10 diameters along each axis whose spheres come from a file.
Case case_with_start(int dimension, std::int64_t spheres, const MemoryFile& file) {
  Case values;
  values.system.dimension = dimension;
  values.system.spheres = spheres;
  values.system.sides.assign(static_cast<std::size_t>(dimension), 10.0);
  values.start.arrangement = Arrangement::file;
  values.start.file = file.path().string();
  return values;
}

/// Whether a sweep file names the file of its base case.
bool names_a_file(const std::string& text) {
  for (const auto& table : case_format::tree_of(text, "sweep.toml", "case")) {
    for (const auto& key : table.children) {
      if (table.name == "sweep" && key.name == "case") return true;
    }
  }
  return false;
}

}  // namespace

void case_file(Bytes bytes) {
  std::vector<std::string> parts{""};
  for (const std::uint8_t byte : bytes) {
    if (byte != 0) {
      parts.back() += static_cast<char>(byte);
    } else {
      parts.emplace_back();
    }
  }
  const std::vector<std::string> overrides(parts.begin() + 1, parts.end());
  attempt([&] {
    const Case values = parse_case(parts.front(), "case.toml", overrides);
    const std::string resolved = resolved_toml(values);
    // A case with an override may write longer lines than a file can hold.
    if (!overrides.empty() || values.start.arrangement == Arrangement::given) return;
    const Case again = parse_case(resolved, "case.toml", {});
    require(resolved_toml(again) == resolved, "a resolved case resolves to itself");
    if (values.start.arrangement != Arrangement::file) derived_text(values);
  });
}

void sweep_file(Bytes bytes) {
  const std::string text = text_of(bytes);
  attempt([&] {
    if (names_a_file(text)) return;
    const Sweep sweep = parse_sweep(text, "sweep.toml");
    const CaseTemplate kept(case_format::entries_of(sweep.base_text, "store"), "store");
    const auto overrides = overrides_of(sweep, 0);
    const Case first = case_of_run(sweep.base, sweep.stop, overrides);
    const Case again = case_of_run(kept, sweep.stop, overrides);
    require(resolved_toml(first) == resolved_toml(again), "a store keeps the base case");
  });
}

void summary(Bytes bytes) {
  for (const int dimension : {1, 2, 3}) {
    attempt([&] {
      const Summary found = summary_from_json(text_of(bytes), dimension);
      const std::string written = to_json(found, dimension);
      const std::string again = to_json(summary_from_json(written, dimension), dimension);
      require(again == written, "a summary is read as it was written");
      to_text(found, dimension);
    });
  }
}

void start_text(Bytes bytes) {
  const MemoryFile file(bytes);
  for (const int dimension : {1, 2, 3}) {
    attempt([&] { given_start(case_with_start(dimension, 2, file)); });
  }
}

void start_output(Bytes bytes) {
  const MemoryFile file(bytes);
  attempt([&] { given_start(case_with_start(2, 3, file)); });
}

void output_file(Bytes bytes) {
  const MemoryFile file(bytes);
  attempt([&] { checked_integrity(file.path()); });
  attempt([&] {
    const OutputInfo info = read_output_info(file.path());
    to_text(info, file.path().string());
    to_json(info);
  });
  attempt([&] { read_checkpoint(file.path()); });
}

void verified_file(Bytes bytes) {
  const MemoryFile file(bytes);
  attempt([&] { to_text(verify_file(file.path()), "out.h5"); });
  const auto read_for_a_page = [&] {
    const RunReader run(file.path());
    run.anatomy();
  };
  attempt([&] {
    sandboxed_read(file.path(), static_cast<std::int64_t>(bytes.size()), read_for_a_page);
    read_for_a_page();
  });
}

}  // namespace zenosphere::fuzz
