# The page that `zenosphere report` fills: bundled from page/ with the libraries in its lock file,
# and put into the program. Without npm the program is built without it and says so when asked.
option(ZENOSPHERE_PAGE "Build the page of zenosphere report (needs npm and its registry)" ON)
find_program(ZENOSPHERE_NPM npm)
find_program(ZENOSPHERE_NODE NAMES node nodejs)

enable_language(ASM)
set(page_folder ${CMAKE_BINARY_DIR}/page)
target_sources(zenosphere_report PRIVATE ${CMAKE_SOURCE_DIR}/src/report/page_template.S)
if(ZENOSPHERE_PAGE AND ZENOSPHERE_NPM AND ZENOSPHERE_NODE)
  set(ZENOSPHERE_HAS_PAGE ON CACHE INTERNAL "")
  set(page ${page_folder}/page.html)
  file(GLOB_RECURSE page_sources CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/page/src/*)
  add_custom_command(
    OUTPUT ${page}
    COMMAND ${ZENOSPHERE_NODE} build.mjs ${ZENOSPHERE_NPM} ${page_folder}
    DEPENDS ${page_sources} ${CMAKE_SOURCE_DIR}/page/build.mjs
            ${CMAKE_SOURCE_DIR}/page/package-lock.json
    WORKING_DIRECTORY ${CMAKE_SOURCE_DIR}/page
    COMMENT "Bundling the report page")
else()
  set(ZENOSPHERE_HAS_PAGE OFF CACHE INTERNAL "")
  set(page ${page_folder}/none.html)
  file(WRITE ${page} "")
  message(STATUS "No npm, or ZENOSPHERE_PAGE=OFF: zenosphere report is built without its page")
endif()
set_source_files_properties(${CMAKE_SOURCE_DIR}/src/report/page_template.S PROPERTIES
  COMPILE_DEFINITIONS "ZENOSPHERE_PAGE=\"${page}\"" OBJECT_DEPENDS ${page})
