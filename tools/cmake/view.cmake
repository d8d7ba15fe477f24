# The window: a program of its own (src/view/window) that shows what the room view has, so that the program glibra needs
# neither GLFW nor ImGui.
if(NOT GLIBRA_WINDOW)
    return()
endif()
pkg_check_modules(glfw IMPORTED_TARGET glfw3)
glibra_refuse_without(GLIBRA_WINDOW GLFW "${glfw_FOUND}")
pkg_check_modules(imgui IMPORTED_TARGET imgui)
glibra_refuse_without(GLIBRA_WINDOW "Dear ImGui" "${imgui_FOUND}")

file(GLOB_RECURSE window_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/view/window/*.cpp)
add_executable(glibra_window ${window_sources})
set_target_properties(glibra_window PROPERTIES OUTPUT_NAME glibra-view RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
glibra_compile_options(glibra_window)
glibra_quick_to_compile(glibra_window -Og)
glibra_precompile(glibra_window glibra_window)
target_compile_definitions(glibra_window PRIVATE GLFW_INCLUDE_NONE)  # OpenGL comes from glad
target_link_libraries(glibra_window PRIVATE glibra_view glibra_cli PkgConfig::imgui PkgConfig::glfw Threads::Threads)
glibra_on_windows(glibra_window WINDOW)
