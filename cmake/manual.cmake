# Writes the manual pages, gzipped, and the completion scripts that PROGRAM prints.
#
# -D: PROGRAM, MANUAL and COMPLETION (folders)

function(output_of file)
  execute_process(COMMAND ${PROGRAM} ${ARGN} OUTPUT_FILE ${file} COMMAND_ERROR_IS_FATAL ANY)
endfunction()

file(MAKE_DIRECTORY ${MANUAL} ${COMPLETION})
foreach(shell bash zsh fish)
  output_of(${COMPLETION}/zenosphere.${shell} completion ${shell})
endforeach()

execute_process(COMMAND ${PROGRAM} manual --list OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
string(STRIP "${commands}" commands)
string(REPLACE "\n" ";" commands "${commands}")
foreach(command IN LISTS commands)
  string(REPLACE " " "-" page zenosphere-${command})
  separate_arguments(words UNIX_COMMAND "${command}")
  output_of(${MANUAL}/${page}.1 manual ${words})
  execute_process(COMMAND gzip -9nf ${MANUAL}/${page}.1 COMMAND_ERROR_IS_FATAL ANY)
endforeach()
output_of(${MANUAL}/zenosphere.1 manual)
execute_process(COMMAND gzip -9nf ${MANUAL}/zenosphere.1 COMMAND_ERROR_IS_FATAL ANY)
