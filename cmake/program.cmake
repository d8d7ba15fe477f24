# The program glibra: the command line on top of the rooms. The window and the benchmarks are programs of their own
# (cmake/view.cmake, cmake/bench.cmake) that it starts.

file(GLOB cli_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/cli/*.cpp)
add_executable(glibra_program ${cli_sources})
set_target_properties(glibra_program PROPERTIES OUTPUT_NAME glibra RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
glibra_compile_options(glibra_program)
glibra_quick_to_compile(glibra_program)
glibra_precompile(glibra_program glibra_program <CLI/CLI.hpp>)
# Programs that glibra starts, glibra-view and glibra-bench, are installed in GLIBRA_PROGRAMS_DIR.
target_compile_definitions(glibra_program PRIVATE GLIBRA_VERSION="${PROJECT_VERSION}"
                                                  GLIBRA_PROGRAMS_DIR="${CMAKE_INSTALL_LIBDIR}/glibra")
target_link_libraries(glibra_program PRIVATE glibra_suite glibra_render glibra_expression CLI11::CLI11)
