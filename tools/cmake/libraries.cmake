# Libraries that are built for other systems, static, from the unpacked sources of their Debian packages in SOURCES, and that
# all of these systems need. Installs them, their headers and what pkg-config says about them.

# source_of(RESULT PACKAGE): the folder of a package, whatever its version.
function(source_of result package)
    file(GLOB found LIST_DIRECTORIES true ${SOURCES}/${package}-*)
    list(FILTER found EXCLUDE REGEX "[.](xz|gz|bz2)$")
    list(LENGTH found count)
    if(NOT count EQUAL 1)
        message(FATAL_ERROR "${count} folders of ${package} in ${SOURCES}")
    endif()
    set(${result} ${found} PARENT_SCOPE)
endfunction()

# library(NAME DEFINITIONS text HEADERS file... SOURCES file... INCLUDE folder... LINK text): one that is a few files.
# DEFINITIONS are also those of its users; LINK is what they link besides; KNOWN_AS is its name for pkg-config, if
# that is another one.
function(library name)
    cmake_parse_arguments(arg "" "DEFINITIONS;LINK;FOLDER;KNOWN_AS" "HEADERS;SOURCES;INCLUDE" ${ARGN})
    add_library(${name} STATIC ${arg_SOURCES})
    target_include_directories(${name} PRIVATE ${arg_INCLUDE})
    separate_arguments(definitions UNIX_COMMAND "${arg_DEFINITIONS}")
    target_compile_options(${name} PRIVATE ${definitions})
    install(TARGETS ${name} ARCHIVE DESTINATION lib)
    install(FILES ${arg_HEADERS} DESTINATION include/${arg_FOLDER})
    set(known_as ${name})
    if(arg_KNOWN_AS)
        set(known_as ${arg_KNOWN_AS})
    endif()
    file(WRITE ${CMAKE_BINARY_DIR}/${known_as}.pc
         "prefix=${CMAKE_INSTALL_PREFIX}\nName: ${name}\nDescription: ${name}\nVersion: 1\n"
         "Cflags: -I\${prefix}/include/${arg_FOLDER} -I\${prefix}/include ${arg_DEFINITIONS}\n"
         "Libs: -L\${prefix}/lib -l${name} ${arg_LINK}\n")
    install(FILES ${CMAKE_BINARY_DIR}/${known_as}.pc DESTINATION lib/pkgconfig)
endfunction()

source_of(fmt fmtlib)
set(FMT_TEST OFF)
set(FMT_DOC OFF)
set(FMT_INSTALL ON)
add_subdirectory(${fmt} fmt)

source_of(deflate libdeflate)
file(GLOB deflate_sources ${deflate}/lib/*.c ${deflate}/lib/x86/*.c)
library(deflate SOURCES ${deflate_sources} HEADERS ${deflate}/libdeflate.h INCLUDE ${deflate} KNOWN_AS libdeflate)

source_of(spng libspng)
library(spng SOURCES ${spng}/spng/spng.c HEADERS ${spng}/spng/spng.h DEFINITIONS "-DSPNG_STATIC" LINK "-lz")

source_of(xxhash xxhash)
install(FILES ${xxhash}/xxhash.h ${xxhash}/xxh3.h DESTINATION include)
