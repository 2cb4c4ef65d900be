# Precompiled headers: two thirds of the time of a build went into reading Boost.Multiprecision anew
# for every source.
#
#   zenosphere_precompile(target [OWNER other] [HEADERS header...])
#
# OWNER: another target of the same flags whose precompiled header is used; without it the target
# gets one of its own, with further HEADERS.
option(ZENOSPHERE_PRECOMPILE "Precompile the headers that every source includes" ON)
# GCC 12 forgets that what it read from a precompiled header was a system header, and warns of moved
# strings in there (its bugs 105329 and 105651).
if(ZENOSPHERE_PRECOMPILE AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(zenosphere_options INTERFACE -Wno-array-bounds -Wno-restrict)
endif()
function(zenosphere_precompile target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "OWNER" "HEADERS")
  if(NOT ZENOSPHERE_PRECOMPILE)
    return()
  elseif(arg_OWNER AND NOT arg_OWNER STREQUAL target)
    target_precompile_headers(${target} REUSE_FROM ${arg_OWNER})
  else()
    target_precompile_headers(${target} PRIVATE ${CMAKE_SOURCE_DIR}/cmake/precompiled.hpp
                              ${arg_HEADERS})
  endif()
endfunction()
