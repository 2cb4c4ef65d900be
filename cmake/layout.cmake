# Which Python, and where things are installed, from the prefix: the program looks for its Python
# package there.
include(GNUInstallDirs)

if(NOT DEFINED Python_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python_EXECUTABLE /usr/bin/python3)  # another one on the PATH may lack numpy
endif()
find_package(Python COMPONENTS Interpreter OPTIONAL_COMPONENTS Development.Module QUIET)
if(NOT Python_EXECUTABLE)
  set(Python_EXECUTABLE python3)
endif()

# Debian's Python looks in /usr/lib/python3/dist-packages and /usr/local/lib/python3.11/dist-packages.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr" OR NOT Python_FOUND)
  set(python_folder lib/python3/dist-packages)
else()
  set(python_folder lib/python${Python_VERSION_MAJOR}.${Python_VERSION_MINOR}/dist-packages)
endif()
set(ZENOSPHERE_PYTHON_FOLDER ${python_folder} CACHE STRING
    "Folder of the Python package, from the prefix")
