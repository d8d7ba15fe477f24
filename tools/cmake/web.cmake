# clang for WebAssembly with the libraries that Debian has for it. tools/web/setup.sh builds the others into
# build/web-libraries.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR wasm32)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)
set(CMAKE_C_COMPILER clang-19)
set(CMAKE_CXX_COMPILER clang++-19)
set(CMAKE_C_COMPILER_TARGET wasm32-wasi)
set(CMAKE_CXX_COMPILER_TARGET wasm32-wasi)
set(CMAKE_AR llvm-ar-19)
set(CMAKE_RANLIB llvm-ranlib-19)
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}/../.." ABSOLUTE)
# All browsers that have WebGL 2 today have both extensions of WebAssembly. Nothing is caught: what throws ends the run of the module, and the page that holds it goes on.
set(CMAKE_CXX_FLAGS_INIT "-fexceptions -fignore-exceptions -fexperimental-library -nostdinc++ -isystem \"${root}/tools/web/libcxx\" \
-isystem /usr/lib/llvm-19/include/wasm32-wasi/c++/v1 -fno-rtti -fno-threadsafe-statics -mbulk-memory -mnontrapping-fptoint \
-D_WASI_EMULATED_SIGNAL -D_WASI_EMULATED_PROCESS_CLOCKS -D_WASI_EMULATED_MMAN")
set(CMAKE_CXX_STANDARD_LIBRARIES "")
set(CMAKE_HAVE_LIBC_PTHREAD TRUE CACHE INTERNAL "")  # one thread, and no library for more
set(libraries ${root}/build/web-libraries)
set(CMAKE_FIND_ROOT_PATH ${libraries})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
set(ENV{PKG_CONFIG_LIBDIR} ${libraries}/lib/pkgconfig)
