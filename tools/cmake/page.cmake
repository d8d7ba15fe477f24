# The runtime of live pages: a module of WebAssembly.
glibra_room(page ROOMS render LINK nlohmann_json::nlohmann_json)
add_executable(glibra_page_runtime ${PROJECT_SOURCE_DIR}/src/page/program/main.cpp)
