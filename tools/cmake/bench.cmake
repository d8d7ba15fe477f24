# The measurements of run time against error: a room (src/bench), and a program of their own that `glibra bench` and
# `glibra info --precision` start, so that the program glibra needs neither the room nor Boost.
if(NOT GLIBRA_BENCH_PROGRAM)
    return()
endif()
find_package(Boost 1.74 CONFIG)  # headers: Multiprecision, for references with 100 digits
glibra_refuse_without(GLIBRA_BENCH_PROGRAM "Boost 1.74" "${Boost_FOUND}")

glibra_room(bench ROOMS render LINK Boost::headers nlohmann_json::nlohmann_json)

set(bench_page_files page.html bench.css bench.js)
list(TRANSFORM bench_page_files PREPEND ${PROJECT_SOURCE_DIR}/src/bench/report/page/)
glibra_embed(glibra_bench bench_page ${bench_page_files})
file(GLOB bench_shaders CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/bench/shaders/*)
glibra_embed(glibra_bench bench_shaders ${bench_shaders})

file(GLOB bench_program_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/bench/program/*.cpp)
add_executable(glibra_bench_program ${bench_program_sources})
set_target_properties(glibra_bench_program PROPERTIES OUTPUT_NAME glibra-bench RUNTIME_OUTPUT_DIRECTORY
                                                                               ${PROJECT_BINARY_DIR})
glibra_compile_options(glibra_bench_program)
glibra_quick_to_compile(glibra_bench_program -Og)
target_link_libraries(glibra_bench_program PRIVATE glibra_bench glibra_cli)
glibra_on_windows(glibra_bench_program)
