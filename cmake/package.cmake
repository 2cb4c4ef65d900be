# `cpack --config build/CPackConfig.cmake` makes the Debian package (docs/installation.md).
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME zenosphere)
set(CPACK_PACKAGE_VENDOR "the Zenosphere authors")
set(CPACK_PACKAGE_CONTACT "the Zenosphere authors <zenosphere@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "event-driven inelastic hard spheres and their collapse")
set(CPACK_PACKAGE_DESCRIPTION
"Simulates inelastic hard spheres, disks and rods event by event, sheared, cooling,
 kicked or falling, and tells whether a granular system collapsed (infinitely many
 collisions in a finite time) or whether the arithmetic did.")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_DEPENDS "python3, python3-numpy, python3-scipy, python3-h5py, python3-matplotlib")
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
include(CPack)
