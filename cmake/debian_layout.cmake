# Run by CPack on the folder that becomes the Debian package: puts in order what Debian has a rule for.
set(root ${CPACK_TEMPORARY_INSTALL_DIRECTORY}/usr)
set(documents ${root}/share/doc/zenosphere)

# Debian's Python looks in one folder for all its minor versions.
set(python ${root}/lib/python3/dist-packages)
if(NOT CPACK_ZENOSPHERE_PYTHON_FOLDER STREQUAL lib/python3/dist-packages)
  file(MAKE_DIRECTORY ${python})
  file(RENAME ${root}/${CPACK_ZENOSPHERE_PYTHON_FOLDER}/zenosphere ${python}/zenosphere)
  cmake_path(GET CPACK_ZENOSPHERE_PYTHON_FOLDER PARENT_PATH version_folder)
  file(REMOVE_RECURSE ${root}/${version_folder})
endif()

# Debian's libraries are found without a path.
file(GLOB modules ${python}/zenosphere/*.so)
foreach(binary ${root}/bin/zenosphere ${modules})
  file(RPATH_REMOVE FILE ${binary})
endforeach()

file(STRINGS ${CPACK_ZENOSPHERE_SOURCE_DIR}/CITATION.cff released REGEX "^date-released:")
string(REGEX REPLACE "^date-released: *" "" released "${released}")
execute_process(COMMAND date --utc --rfc-email --date=${released} OUTPUT_VARIABLE released
                OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
file(WRITE ${documents}/changelog
"zenosphere (${CPACK_PACKAGE_VERSION}) stable; urgency=medium

  * See CHANGELOG.md.

 -- ${CPACK_PACKAGE_CONTACT}  ${released}
")
execute_process(COMMAND gzip -9nf ${documents}/changelog ${documents}/CHANGELOG.md
                COMMAND_ERROR_IS_FATAL ANY)
file(REMOVE ${documents}/LICENSE)  # its text is in copyright
