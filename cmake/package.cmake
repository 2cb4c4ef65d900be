# `cpack --config build/CPackConfig.cmake` makes the Debian package (docs/installation.md).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME zenosphere)
set(CPACK_PACKAGE_VENDOR "the Zenosphere authors")
set(CPACK_PACKAGE_CONTACT "the Zenosphere authors <zenosphere@zenosphere.invalid>")  # has no address
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "event-driven inelastic hard spheres and their collapse")
set(CPACK_PACKAGE_DESCRIPTION
"Simulates inelastic hard spheres, disks and rods event by event, sheared,
cooling, kicked or falling, and tells whether a granular system collapsed
(infinitely many collisions in a finite time) or whether the arithmetic did.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_SOURCE_DIR}/cmake/debian_layout.cmake)
set(CPACK_ZENOSPHERE_SOURCE_DIR ${CMAKE_SOURCE_DIR})
set(CPACK_ZENOSPHERE_PYTHON_FOLDER ${ZENOSPHERE_PYTHON_FOLDER})
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(python_range "python3")
if(TARGET zenosphere_module)  # compiled for one minor version
  math(EXPR next_minor "${Python_VERSION_MINOR} + 1")
  set(python_range "python3 (>= 3.${Python_VERSION_MINOR}), python3 (<< 3.${next_minor})")
endif()
set(CPACK_DEBIAN_PACKAGE_DEPENDS
    "${python_range}, python3-numpy, python3-scipy, python3-h5py, python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "ffmpeg, openmpi-bin")
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA ${CMAKE_SOURCE_DIR}/packaging/postinst
                                       ${CMAKE_SOURCE_DIR}/packaging/prerm)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
