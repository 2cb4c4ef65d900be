# Writes OUTPUT from TEMPLATE; run at each build, so that the git hash is that of the build.
# Leaves OUTPUT untouched where nothing changed, so that nothing is compiled or linked again.
#
# -D: SOURCE_DIR, TEMPLATE, OUTPUT, PROGRAM_VERSION, COMPILER, COMPILER_FLAGS

function(git_output variable)
  execute_process(COMMAND git --no-optional-locks ${ARGN} WORKING_DIRECTORY ${SOURCE_DIR}
                  OUTPUT_VARIABLE output OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
                  RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    set(output "")
  endif()
  set(${variable} "${output}" PARENT_SCOPE)
endfunction()

set(GIT_HASH unknown)
git_output(prefix rev-parse --show-prefix)  # empty at the top: not the repository around a tarball
git_output(hash rev-parse --verify HEAD)
if(hash AND NOT prefix)
  git_output(changes status --porcelain -- CMakeLists.txt cmake src)
  if(changes)
    string(APPEND hash -dirty)
  endif()
  set(GIT_HASH ${hash})
endif()

file(READ ${SOURCE_DIR}/CITATION.cff CITATION)
string(STRIP "${COMPILER_FLAGS}" COMPILER_FLAGS)
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
