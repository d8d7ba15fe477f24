# Modules are loaded when they are needed, so that other processes never pay for the start-up of the libraries behind them.

# The server module: HTTP, for pages that glibra serves on this machine. src/suite/serve loads it.
if(GLIBRA_SERVER_MODULE)
    pkg_check_modules(cpp_httplib IMPORTED_TARGET cpp-httplib)
    if(cpp_httplib_FOUND)
        set(http_library PkgConfig::cpp_httplib)
    else()
        find_package(httplib CONFIG QUIET)
        glibra_refuse_without(GLIBRA_SERVER_MODULE cpp-httplib "${httplib_FOUND}")
        set(http_library httplib::httplib)
    endif()
    add_library(glibra_server MODULE ${PROJECT_SOURCE_DIR}/src/suite/module/server.cpp)
    glibra_compile_options(glibra_server)
    target_include_directories(glibra_server PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(glibra_server PRIVATE ${http_library} Threads::Threads)
    if(GLIBRA_SYSTEM STREQUAL "windows")
        target_link_options(glibra_server PRIVATE -static -Wl,--no-insert-timestamp)
    endif()
    set_target_properties(glibra_server PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endif()

# The image module: the picture formats that libraries of others read. src/image loads it when a file needs it: OpenImageIO,
# OpenEXR and libwebp.

# The program looks for the module beside itself first, so that an installation may be moved, then in both folders,
# whether or not this build makes it.
target_compile_definitions(glibra_image PRIVATE GLIBRA_MODULE_BUILD_DIR="${PROJECT_BINARY_DIR}"
                                                GLIBRA_MODULE_LIBRARY_DIR="${CMAKE_INSTALL_LIBDIR}/glibra"
                                                GLIBRA_MODULE_INSTALL_DIR="${CMAKE_INSTALL_FULL_LIBDIR}/glibra")
if(NOT GLIBRA_IMAGE_MODULE)
    return()
endif()
# By pkg-config: Debian's CMake package of OpenImageIO requires OpenCV's headers, which it does not depend on.
pkg_check_modules(openimageio IMPORTED_TARGET OpenImageIO)
glibra_refuse_without(GLIBRA_IMAGE_MODULE OpenImageIO "${openimageio_FOUND}")
pkg_check_modules(openexr IMPORTED_TARGET OpenEXR)
glibra_refuse_without(GLIBRA_IMAGE_MODULE OpenEXR "${openexr_FOUND}")
pkg_check_modules(webp IMPORTED_TARGET libwebp libwebpdemux)
glibra_refuse_without(GLIBRA_IMAGE_MODULE libwebp "${webp_FOUND}")
file(GLOB module_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/image/module/*.cpp)
add_library(glibra_openimageio MODULE ${module_sources})
glibra_compile_options(glibra_openimageio)
target_include_directories(glibra_openimageio PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(glibra_openimageio PRIVATE glibra_system PkgConfig::openimageio PkgConfig::openexr PkgConfig::webp)
set_target_properties(glibra_openimageio PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
