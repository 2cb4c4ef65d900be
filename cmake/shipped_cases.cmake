# Writes OUTPUT, a C++ source with every case and sweep file of EXAMPLES: what `zenosphere new` and
# `zenosphere examples` copy. Run at build time.
#
# -D: EXAMPLES, OUTPUT

file(GLOB_RECURSE files RELATIVE ${EXAMPLES} ${EXAMPLES}/*.toml)
list(SORT files)
set(rows "")
foreach(file ${files})
  file(READ ${EXAMPLES}/${file} text)
  string(REGEX REPLACE "\\.toml$" "" name ${file})
  string(APPEND rows "    {\"${name}\", R\"toml(${text})toml\"},\n")
endforeach()
file(WRITE ${OUTPUT}.new "#include \"cli/shipped_cases.hpp\"

namespace zenosphere {
namespace {

constexpr ShippedCase cases[]{
${rows}};

}  // namespace

std::span<const ShippedCase> shipped_cases() { return cases; }

}  // namespace zenosphere
")
file(COPY_FILE ${OUTPUT}.new ${OUTPUT} ONLY_IF_DIFFERENT)
