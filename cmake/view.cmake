# The window: a room that needs no display (src/view), and a program of its own that shows it (src/view/window), so
# that the program glibra stays free of GLFW and ImGui.
glibra_room(view ROOMS render suite image noise LINK nlohmann_json::nlohmann_json)

file(GLOB debug_shaders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/view/debug_view/shaders/*)
glibra_embed(glibra_view_objects debug_shaders ${debug_shaders})

pkg_check_modules(glfw IMPORTED_TARGET glfw3)
pkg_check_modules(imgui IMPORTED_TARGET imgui)
file(GLOB_RECURSE window_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/view/window/*.cpp)
if(NOT TARGET PkgConfig::glfw OR NOT TARGET PkgConfig::imgui)
    message(STATUS "GLFW or Dear ImGui is missing: glibra view is not built")
elseif(window_sources)
    add_executable(glibra_window ${window_sources})
    set_target_properties(glibra_window PROPERTIES OUTPUT_NAME glibra-view RUNTIME_OUTPUT_DIRECTORY
                                                                            ${PROJECT_BINARY_DIR})
    glibra_compile_options(glibra_window)
    glibra_quick_to_compile(glibra_window)
    target_compile_definitions(glibra_window PRIVATE GLIBRA_VERSION="${PROJECT_VERSION}")
    target_link_libraries(glibra_window PRIVATE glibra_view PkgConfig::imgui PkgConfig::glfw CLI11::CLI11
                                                Threads::Threads)
    if(TARGET glibra_program)
        if(NOT GLIBRA_SANITIZE)
            add_dependencies(glibra_program glibra_window)
        endif()
        target_compile_definitions(glibra_program PRIVATE GLIBRA_VIEW_INSTALL_DIR="${CMAKE_INSTALL_LIBDIR}/glibra")
    endif()
    install(TARGETS glibra_window RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibra)
endif()
