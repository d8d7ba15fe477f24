# cmake --install, in components:
#   runtime  the programs, their modules, example scenes with all that they read, manual pages, what shells
#            complete with, grammars for editors, and the window's entry for desktops
#   library  the shared library
#   devel    its headers, CMake package and pkg-config file

include(CMakePackageConfigHelpers)

# The library: the rooms library and classic, and what the linker takes for them from the other rooms. BUILD_SHARED_LIBS=OFF makes
# an archive that has these rooms inside; programs link the libraries of others besides, which the packages name.
set(glibra_objects $<TARGET_OBJECTS:glibra_library> $<TARGET_OBJECTS:glibra_classic>)
set(glibra_dependencies "")
set(glibra_pc_requires "")
if(DEFINED BUILD_SHARED_LIBS AND NOT BUILD_SHARED_LIBS)
    glibra_rooms_of(rooms glibra_library)
    foreach(room ${rooms} glibra_glad)
        list(APPEND glibra_objects $<TARGET_OBJECTS:${room}>)
    endforeach()
    add_library(glibra STATIC ${glibra_objects})
    target_link_libraries(glibra PRIVATE fmt::fmt tomlplusplus::tomlplusplus PkgConfig::deflate PkgConfig::spng Threads::Threads
                                         ${seccomp_target} ${CMAKE_DL_LIBS})
    set(glibra_pc_requires "Requires: fmt tomlplusplus libdeflate spng")
    if(seccomp_target)
        string(APPEND glibra_pc_requires " libseccomp")
        set(glibra_seccomp_dependency "pkg_check_modules(seccomp REQUIRED IMPORTED_TARGET libseccomp)")
    endif()
    set(glibra_dependencies "include(CMakeFindDependencyMacro)
find_dependency(fmt)
find_dependency(tomlplusplus)
find_dependency(Threads)
find_dependency(PkgConfig)
pkg_check_modules(deflate REQUIRED IMPORTED_TARGET libdeflate)
pkg_check_modules(spng REQUIRED IMPORTED_TARGET spng)
${glibra_seccomp_dependency}")
else()
    add_library(glibra SHARED ${glibra_objects})
    target_link_libraries(glibra PRIVATE $<BUILD_INTERFACE:glibra_view>)
    if(GLIBRA_SYSTEM STREQUAL "windows")
        # glibra.dll; its import library apart from those that the linker makes of the programs.
        foreach(room library classic)
            target_compile_definitions(glibra_${room} PRIVATE GLIBRA_EXPORTS)
        endforeach()
        set_target_properties(glibra PROPERTIES PREFIX "" IMPORT_PREFIX lib RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}
                                                ARCHIVE_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/library)
        glibra_module_on_windows(glibra)
    else()
        # Templates of the standard library and functions of static libraries stay inside, too.
        target_link_options(glibra PRIVATE LINKER:--version-script=${PROJECT_SOURCE_DIR}/tools/cmake/glibra.map)
        set_property(TARGET glibra APPEND PROPERTY LINK_DEPENDS ${PROJECT_SOURCE_DIR}/tools/cmake/glibra.map)
    endif()
endif()
add_library(glibra::glibra ALIAS glibra)
add_executable(glibra::program ALIAS glibra_program)
glibra_compile_options(glibra)
set_target_properties(glibra PROPERTIES LINKER_LANGUAGE CXX VERSION ${GLIBRA_ABI}.${PROJECT_VERSION} SOVERSION ${GLIBRA_ABI})
target_compile_features(glibra PUBLIC cxx_std_20)
target_include_directories(glibra PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                         $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
                                         $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

set(program ${PROJECT_BINARY_DIR}/glibra${CMAKE_EXECUTABLE_SUFFIX})
set(share ${CMAKE_INSTALL_DATADIR}/glibra)
# The program is part of the package: glibra_add_golden_test() runs it as glibra::program.
set_target_properties(glibra_program PROPERTIES EXPORT_NAME program)
install(TARGETS glibra_program EXPORT glibraProgramTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT runtime)
foreach(target glibra_window glibra_bench_program)
    if(TARGET ${target})
        install(TARGETS ${target} RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibra COMPONENT runtime)
    endif()
endforeach()
if(TARGET glibra_openimageio)
    install(TARGETS glibra_openimageio LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibra COMPONENT runtime)
endif()
if(TARGET glibra_server)
    install(TARGETS glibra_server LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibra COMPONENT runtime)
endif()
# The runtime of live pages, which another compiler makes (tools/web), if there is one.
set(GLIBRA_PAGE_RUNTIME ${PROJECT_SOURCE_DIR}/build/web/glibra.wasm CACHE FILEPATH "The runtime of live pages, which is installed if it exists")
install(FILES ${GLIBRA_PAGE_RUNTIME} DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibra COMPONENT runtime OPTIONAL)
# The example scenes with all they read, as a library root; the shaders that glibra itself draws with, for reading; and the
# samples of README.md and of the pages.
install(DIRECTORY ${PROJECT_SOURCE_DIR}/glib ${PROJECT_SOURCE_DIR}/shaders ${PROJECT_SOURCE_DIR}/textures
                  ${PROJECT_SOURCE_DIR}/docs/examples
        DESTINATION ${share} COMPONENT runtime)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes/models DESTINATION ${share}/scenes COMPONENT runtime)

# The program writes its own pages for shells and man.
if(NOT CMAKE_CROSSCOMPILING)
    set(manual ${PROJECT_BINARY_DIR}/man/glibra.1)  # and the pages of the subcommands beside it
    add_custom_command(OUTPUT ${manual} COMMAND glibra_program manual --all ${PROJECT_BINARY_DIR}/man DEPENDS glibra_program
                       VERBATIM)
    install(DIRECTORY ${PROJECT_BINARY_DIR}/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT runtime)
    set(bash_place bash-completion/completions/glibra)
    set(zsh_place zsh/vendor-completions/_glibra)
    set(fish_place fish/vendor_completions.d/glibra.fish)
    set(completions)
    foreach(shell bash zsh fish)
        set(file ${PROJECT_BINARY_DIR}/completion/glibra.${shell})
        add_custom_command(OUTPUT ${file} COMMAND glibra_program completion ${shell} -o ${file} DEPENDS glibra_program VERBATIM)
        list(APPEND completions ${file})
        get_filename_component(folder ${${shell}_place} DIRECTORY)
        get_filename_component(name ${${shell}_place} NAME)
        install(FILES ${file} DESTINATION ${CMAKE_INSTALL_DATADIR}/${folder} RENAME ${name} COMPONENT runtime)
    endforeach()
    # The grammars of editors, which the program writes from its tables.
    set(grammars)
    foreach(editor vscode vim kate)
        set(folder ${PROJECT_BINARY_DIR}/editors/${editor})
        add_custom_command(OUTPUT ${folder}/stamp
                           COMMAND glibra_program language --grammar ${editor} -o ${folder}
                           COMMAND ${CMAKE_COMMAND} -E touch ${folder}/stamp DEPENDS glibra_program VERBATIM)
        list(APPEND grammars ${folder}/stamp)
    endforeach()
    install(DIRECTORY ${PROJECT_BINARY_DIR}/editors DESTINATION ${share} COMPONENT runtime PATTERN stamp EXCLUDE)
    file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/man ${PROJECT_BINARY_DIR}/completion ${PROJECT_BINARY_DIR}/editors)
    add_custom_target(glibra_pages ALL DEPENDS ${manual} ${completions} ${grammars})
endif()

# What desktops and file managers show: the window's entry, its icon, the type of .glib files and their thumbnails.
if(TARGET glibra_window)
    set(desktop ${PROJECT_SOURCE_DIR}/src/view/desktop)
    install(FILES ${desktop}/glibra.desktop DESTINATION ${CMAKE_INSTALL_DATADIR}/applications COMPONENT runtime)
    install(FILES ${desktop}/glibra.metainfo.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/metainfo COMPONENT runtime)
    install(FILES ${desktop}/glibra.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/mime/packages COMPONENT runtime)
    install(FILES ${desktop}/glibra.thumbnailer DESTINATION ${CMAKE_INSTALL_DATADIR}/thumbnailers COMPONENT runtime)
    install(FILES ${desktop}/glibra.png DESTINATION ${CMAKE_INSTALL_DATADIR}/icons/hicolor/256x256/apps COMPONENT runtime)
endif()

install(TARGETS glibra EXPORT glibraLibraryTargets
        LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT library NAMELINK_COMPONENT devel
        RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT library
        ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR} COMPONENT devel)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/glibra ${PROJECT_BINARY_DIR}/include/glibra
        DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT devel FILES_MATCHING PATTERN "*.h")
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/glibra)
foreach(set Library Program)
    install(EXPORT glibra${set}Targets NAMESPACE glibra:: DESTINATION ${package_dir} COMPONENT devel)
endforeach()
# The package works in the build tree as well: cmake -Dglibra_DIR=BUILD.
export(EXPORT glibraLibraryTargets NAMESPACE glibra:: FILE ${PROJECT_BINARY_DIR}/glibraLibraryTargets.cmake)
export(EXPORT glibraProgramTargets NAMESPACE glibra:: FILE ${PROJECT_BINARY_DIR}/glibraProgramTargets.cmake)
foreach(part glibra_golden_test glibra_golden_shots)
    configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/${part}.cmake ${PROJECT_BINARY_DIR}/${part}.cmake COPYONLY)
endforeach()
set(glibra_program ${program})
configure_package_config_file(${PROJECT_SOURCE_DIR}/tools/cmake/glibraConfig.cmake.in ${PROJECT_BINARY_DIR}/glibraConfig.cmake
                              INSTALL_DESTINATION ${PROJECT_BINARY_DIR} INSTALL_PREFIX ${PROJECT_BINARY_DIR}
                              PATH_VARS glibra_program)
set(glibra_program ${CMAKE_INSTALL_BINDIR}/glibra${CMAKE_EXECUTABLE_SUFFIX})
configure_package_config_file(${PROJECT_SOURCE_DIR}/tools/cmake/glibraConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/install/glibraConfig.cmake INSTALL_DESTINATION ${package_dir}
                              PATH_VARS glibra_program)
write_basic_package_version_file(${PROJECT_BINARY_DIR}/glibraConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/install/glibraConfig.cmake ${PROJECT_BINARY_DIR}/glibraConfigVersion.cmake
              ${PROJECT_SOURCE_DIR}/tools/cmake/glibra_golden_test.cmake
              ${PROJECT_SOURCE_DIR}/tools/cmake/glibra_golden_shots.cmake
        DESTINATION ${package_dir} COMPONENT devel)
file(RELATIVE_PATH glibra_prefix_from_pc /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" glibra_prefix_from_pc "${glibra_prefix_from_pc}")
configure_file(${PROJECT_SOURCE_DIR}/tools/cmake/glibra.pc.in ${PROJECT_BINARY_DIR}/glibra.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/glibra.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig COMPONENT devel)
