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
    glibra_module_on_windows(glibra_server glibraServerVersion glibraServerOpen glibraServerRun glibraServerStop
                             glibraServerClose)
    set_target_properties(glibra_server PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
endif()

# The image module: the picture formats that libraries of others read. src/image loads it when a file needs it: OpenImageIO,
# OpenEXR and libwebp; or, without OpenImageIO, libjpeg and libtiff for the two formats that are left.

# The program looks for the module beside itself first, so that an installation may be moved, then in both folders,
# whether or not this build makes it.
target_compile_definitions(glibra_image PRIVATE GLIBRA_MODULE_BUILD_DIR="${PROJECT_BINARY_DIR}"
                                                GLIBRA_MODULE_LIBRARY_DIR="${CMAKE_INSTALL_LIBDIR}/glibra"
                                                GLIBRA_MODULE_INSTALL_DIR="${CMAKE_INSTALL_FULL_LIBDIR}/glibra")
if(NOT GLIBRA_IMAGE_MODULE)
    return()
endif()
file(GLOB module_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/image/module/*.cpp)
if(GLIBRA_OPENIMAGEIO)
    list(FILTER module_sources EXCLUDE REGEX "/without_openimageio[.]cpp$")
    # By pkg-config: Debian's CMake package of OpenImageIO requires OpenCV's headers, which it does not depend on.
    pkg_check_modules(openimageio IMPORTED_TARGET OpenImageIO)
    glibra_refuse_without(GLIBRA_IMAGE_MODULE OpenImageIO "${openimageio_FOUND}")
    set(module_libraries PkgConfig::openimageio)
else()
    list(FILTER module_sources EXCLUDE REGEX "/openimageio[.]cpp$")
    pkg_check_modules(jpeg IMPORTED_TARGET libjpeg)
    glibra_refuse_without(GLIBRA_IMAGE_MODULE libjpeg "${jpeg_FOUND}")
    pkg_check_modules(tiff IMPORTED_TARGET libtiff-4)
    glibra_refuse_without(GLIBRA_IMAGE_MODULE libtiff "${tiff_FOUND}")
    set(module_libraries PkgConfig::tiff PkgConfig::jpeg)
endif()
pkg_check_modules(openexr IMPORTED_TARGET OpenEXR)
glibra_refuse_without(GLIBRA_IMAGE_MODULE OpenEXR "${openexr_FOUND}")
pkg_check_modules(webp IMPORTED_TARGET libwebp libwebpdemux)
glibra_refuse_without(GLIBRA_IMAGE_MODULE libwebp "${webp_FOUND}")
add_library(glibra_openimageio MODULE ${module_sources})
glibra_compile_options(glibra_openimageio)
target_include_directories(glibra_openimageio PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(glibra_openimageio PRIVATE glibra_system ${module_libraries} PkgConfig::openexr PkgConfig::webp)
glibra_module_on_windows(glibra_openimageio glibraModuleVersion glibraReadPicture glibraWritePicture)
set_target_properties(glibra_openimageio PROPERTIES PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
