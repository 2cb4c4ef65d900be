# What `cmake --install build --prefix P` puts where: the program, the Python package, manual pages,
# completion, examples and licences (docs/installation.md). P can be moved afterwards.

install(TARGETS zenosphere RUNTIME)
install(DIRECTORY ${CMAKE_SOURCE_DIR}/python/zenosphere DESTINATION ${ZENOSPHERE_PYTHON_FOLDER}
        PATTERN "__pycache__" EXCLUDE)
install(FILES ${CMAKE_SOURCE_DIR}/CITATION.cff DESTINATION ${ZENOSPHERE_PYTHON_FOLDER}/zenosphere)
if(TARGET zenosphere_module)
  install(TARGETS zenosphere_module LIBRARY DESTINATION ${ZENOSPHERE_PYTHON_FOLDER}/zenosphere)
endif()
install(DIRECTORY ${CMAKE_SOURCE_DIR}/examples/ DESTINATION ${CMAKE_INSTALL_DOCDIR}/examples
        PATTERN "__pycache__" EXCLUDE)
install(FILES ${CMAKE_SOURCE_DIR}/LICENSE ${CMAKE_SOURCE_DIR}/CITATION.cff
              ${CMAKE_SOURCE_DIR}/README.md ${CMAKE_SOURCE_DIR}/CHANGELOG.md
              ${CMAKE_SOURCE_DIR}/packaging/copyright
        DESTINATION ${CMAKE_INSTALL_DOCDIR})

# Manual pages and completion come from the program's own table of arguments.
set(manual_folder ${CMAKE_BINARY_DIR}/man)
set(completion_folder ${CMAKE_BINARY_DIR}/completion)
add_custom_command(
  OUTPUT ${manual_folder}/zenosphere.1.gz
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:zenosphere> -DMANUAL=${manual_folder}
          -DCOMPLETION=${completion_folder} -P ${CMAKE_SOURCE_DIR}/cmake/manual.cmake
  DEPENDS zenosphere ${CMAKE_SOURCE_DIR}/cmake/manual.cmake VERBATIM
  COMMENT "Writing manual pages and completion")
add_custom_target(zenosphere_manual ALL DEPENDS ${manual_folder}/zenosphere.1.gz)
install(DIRECTORY ${manual_folder}/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1)
install(FILES ${completion_folder}/zenosphere.bash RENAME zenosphere
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions)
install(FILES ${completion_folder}/zenosphere.zsh RENAME _zenosphere
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions)
install(FILES ${completion_folder}/zenosphere.fish
        DESTINATION ${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d)
