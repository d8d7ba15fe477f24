# The window: a room that needs no display (src/view), and a program of its own that shows it (src/view/window), so
# that the program glibra needs neither GLFW nor ImGui.
if(NOT GLIBRA_WINDOW)
    return()
endif()
pkg_check_modules(glfw REQUIRED IMPORTED_TARGET glfw3)
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui)

glibra_room(view ROOMS render suite source image noise LINK nlohmann_json::nlohmann_json)

file(GLOB debug_shaders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/view/debug_view/shaders/*)
glibra_embed(glibra_view debug_shaders ${debug_shaders})

file(GLOB_RECURSE window_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/view/window/*.cpp)
add_executable(glibra_window ${window_sources})
set_target_properties(glibra_window PROPERTIES OUTPUT_NAME glibra-view RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
glibra_compile_options(glibra_window)
glibra_quick_to_compile(glibra_window -O1)
glibra_precompile(glibra_window glibra_window)
target_link_libraries(glibra_window PRIVATE glibra_view glibra_cli PkgConfig::imgui PkgConfig::glfw Threads::Threads)
install(TARGETS glibra_window RUNTIME DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibra)
