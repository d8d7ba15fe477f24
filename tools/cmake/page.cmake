# The runtime of live pages: a module of WebAssembly.
file(GLOB page_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/page/runtime/*.cpp)
add_executable(glibra_page_runtime ${page_sources})
glibra_compile_options(glibra_page_runtime)
target_link_libraries(glibra_page_runtime PRIVATE glibra_render glibra_source nlohmann_json::nlohmann_json)
