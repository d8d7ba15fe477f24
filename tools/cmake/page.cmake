# The runtime of live pages: glibra.wasm, a module of WebAssembly.
file(GLOB page_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/page/runtime/*.cpp)
add_executable(glibra_page_linked ${page_sources})
glibra_compile_options(glibra_page_linked)
set_target_properties(glibra_page_linked PROPERTIES SUFFIX .wasm)
target_link_libraries(glibra_page_linked PRIVATE glibra_render glibra_source nlohmann_json::nlohmann_json)
target_link_libraries(glibra_page_linked PRIVATE -lwasi-emulated-signal -lwasi-emulated-process-clocks -lwasi-emulated-mman)
# A page calls functions of the module, which has no main. Its stack lies below its data, so that an overflow traps, and
# nothing else uses the first kilobyte. With -O0 clang itself runs no wasm-opt.
target_link_options(glibra_page_linked PRIVATE
    -O0 -mexec-model=reactor -L/usr/lib/llvm-19/lib/wasm32-wasi
    LINKER:--gc-sections,--stack-first,-z,stack-size=2097152,--max-memory=2147483648,--lto-O3,--error-limit=0)

find_program(WASM_OPT wasm-opt REQUIRED)
add_custom_command(
    OUTPUT ${PROJECT_BINARY_DIR}/glibra.wasm
    COMMAND ${WASM_OPT} -Oz --low-memory-unused --strip-debug --strip-producers --enable-bulk-memory --enable-sign-ext --enable-mutable-globals
            --enable-nontrapping-float-to-int $<TARGET_FILE:glibra_page_linked> -o ${PROJECT_BINARY_DIR}/glibra.wasm
    DEPENDS glibra_page_linked
    VERBATIM)
add_custom_target(glibra_page_runtime ALL DEPENDS ${PROJECT_BINARY_DIR}/glibra.wasm)
