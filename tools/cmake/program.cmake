# The program glibra: the command line on top of the rooms. The window and the benchmarks are programs of their own
# (tools/cmake/view.cmake, tools/cmake/bench.cmake) that it starts, and that share files of src/cli with it.

file(GLOB cli_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/cli/*.cpp)
list(REMOVE_ITEM cli_sources ${PROJECT_SOURCE_DIR}/src/cli/main.cpp)
add_library(glibra_cli STATIC ${cli_sources})
glibra_compile_options(glibra_cli)
glibra_quick_to_compile(glibra_cli -Og)
# Programs that glibra starts, glibra-view and glibra-bench, are installed in GLIBRA_PROGRAMS_DIR.
target_compile_definitions(glibra_cli PUBLIC GLIBRA_VERSION="${PROJECT_VERSION}"
                                      PRIVATE GLIBRA_PROGRAMS_DIR="${CMAKE_INSTALL_LIBDIR}/glibra")
target_link_libraries(glibra_cli PUBLIC glibra_editor glibra_gallery glibra_page glibra_classroom glibra_suite glibra_render PRIVATE glibra_expression CLI11::CLI11)
glibra_precompile(glibra_cli ${GLIBRA_QUICK_OWNER})
file(GLOB command_pages CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/cli/pages/*)
glibra_embed(glibra_cli command_pages ${command_pages})

add_executable(glibra_program ${PROJECT_SOURCE_DIR}/src/cli/main.cpp)
set_target_properties(glibra_program PROPERTIES OUTPUT_NAME glibra RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
glibra_compile_options(glibra_program)
target_link_libraries(glibra_program PRIVATE glibra_cli)
glibra_on_windows(glibra_program)
