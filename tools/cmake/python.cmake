# The Python package: a module on top of the library's rooms, which are inside of it, and the files of src/python/glibra.
# In the build tree it is a whole package: PYTHONPATH=BUILD/python.
if(NOT GLIBRA_PYTHON)
    return()
endif()
find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
find_package(pybind11)
glibra_refuse_without(GLIBRA_PYTHON pybind11 "${pybind11_FOUND}")
pybind11_add_module(glibra_python NO_EXTRAS ${PROJECT_SOURCE_DIR}/src/python/core.cpp)
target_compile_options(glibra_python PRIVATE -Wall -Wextra ${GLIBRA_FALSE_WARNINGS} -ffp-contract=off)
target_link_libraries(glibra_python PRIVATE glibra_library)
set(python_package ${PROJECT_BINARY_DIR}/python/glibra)
set_target_properties(glibra_python PROPERTIES OUTPUT_NAME _core LIBRARY_OUTPUT_DIRECTORY ${python_package})
file(GLOB python_files CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/python/glibra/*)
list(FILTER python_files EXCLUDE REGEX "__pycache__")
foreach(file ${python_files})
    get_filename_component(name ${file} NAME)
    configure_file(${file} ${python_package}/${name} COPYONLY)
endforeach()
# By this, pytest finds its plugin and pip the package.
set(python_info ${PROJECT_BINARY_DIR}/python/glibra-${PROJECT_VERSION}.dist-info)
file(CONFIGURE OUTPUT ${python_info}/METADATA CONTENT "Metadata-Version: 2.1
Name: glibra
Version: ${PROJECT_VERSION}
Summary: Renders GLIB shader scenes to NumPy arrays
License: MIT
Requires-Python: >=3.9
Requires-Dist: numpy
")
file(CONFIGURE OUTPUT ${python_info}/entry_points.txt CONTENT "[pytest11]\nglibra = glibra.pytest_plugin\n")
set(GLIBRA_PYTHON_DIR "lib/python${Python3_VERSION_MAJOR}.${Python3_VERSION_MINOR}/site-packages"
    CACHE STRING "Where the Python package is installed, below the prefix; Debian's packages use lib/python3/dist-packages")
install(TARGETS glibra_python LIBRARY DESTINATION ${GLIBRA_PYTHON_DIR}/glibra COMPONENT python)
install(FILES ${python_files} DESTINATION ${GLIBRA_PYTHON_DIR}/glibra COMPONENT python)
install(DIRECTORY ${python_info} DESTINATION ${GLIBRA_PYTHON_DIR} COMPONENT python)
