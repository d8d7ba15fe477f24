# The runtime of live pages: a module of WebAssembly.
file(GLOB page_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/page/runtime/*.cpp)
add_executable(glibra_page_runtime ${page_sources})
glibra_compile_options(glibra_page_runtime)
set_target_properties(glibra_page_runtime PROPERTIES OUTPUT_NAME glibra_linked SUFFIX .wasm)
target_link_libraries(glibra_page_runtime PRIVATE glibra_render glibra_source nlohmann_json::nlohmann_json)
# A page calls functions of the module; it has no main. Its stack lies below its data, so that an overflow traps.
target_link_options(glibra_page_runtime PRIVATE
    -mexec-model=reactor -L/usr/lib/llvm-19/lib/wasm32-wasi
    LINKER:--gc-sections,--stack-first,-z,stack-size=2097152,--max-memory=2147483648
    LINKER:--error-limit=0 LINKER:--lto-O3 LINKER:--lto-CGO2)
target_link_libraries(glibra_page_runtime PRIVATE -lwasi-emulated-signal -lwasi-emulated-process-clocks -lwasi-emulated-mman)
