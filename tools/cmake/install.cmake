# cmake --install: the program, the library with its headers and CMake package, the module for picture formats, the
# example scenes, and the shaders that glibra itself draws with (the program has them inside; these are for reading).

include(CMakePackageConfigHelpers)

# The library: what include/glibra declares is defined in one file. The linker takes from the rooms what that file uses.
# In a unity build that file stays an object of its own in its room, or the linker would take it from there as well.
add_library(glibra SHARED ${PROJECT_SOURCE_DIR}/src/render/renderer.cpp)
set_source_files_properties(${PROJECT_SOURCE_DIR}/src/render/renderer.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
add_library(glibra::glibra ALIAS glibra)
glibra_compile_options(glibra)
set_target_properties(glibra PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
target_compile_features(glibra PUBLIC cxx_std_20)
target_include_directories(glibra PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
target_link_libraries(glibra PRIVATE $<BUILD_INTERFACE:glibra_render>)

# The program is part of the package: glibra_add_golden_test() runs it as glibra::program.
set_target_properties(glibra_program PROPERTIES EXPORT_NAME program)
install(TARGETS glibra_program EXPORT glibraTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS glibra EXPORT glibraTargets)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/glibra DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# The example scenes with all they read, as a library root.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/glib ${PROJECT_SOURCE_DIR}/shaders ${PROJECT_SOURCE_DIR}/textures
        DESTINATION ${CMAKE_INSTALL_DATADIR}/glibra)
# The samples of README.md and of the pages.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs/examples DESTINATION ${CMAKE_INSTALL_DATADIR}/glibra)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/models DESTINATION ${CMAKE_INSTALL_DATADIR}/glibra/scenes)
if(TARGET glibra_openimageio)
    install(TARGETS glibra_openimageio LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibra)
endif()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/glibra)
install(EXPORT glibraTargets NAMESPACE glibra:: DESTINATION ${package_dir})
file(WRITE ${PROJECT_BINARY_DIR}/glibraConfig.cmake
     "include(\${CMAKE_CURRENT_LIST_DIR}/glibraTargets.cmake)\n"
     "include(\${CMAKE_CURRENT_LIST_DIR}/glibra_golden_test.cmake)\n")
write_basic_package_version_file(${PROJECT_BINARY_DIR}/glibraConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/glibraConfig.cmake ${PROJECT_BINARY_DIR}/glibraConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/tools/cmake/glibra_golden_test.cmake
        DESTINATION ${package_dir})
