# A room is a folder of src: one object library of all its .cpp files, and a static library of the same name for
# the tests and the program. Every room sees include/ and src/, so that an include reads "room/file.h".

set(GLIBRA_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12 sees overlaps in std::string's operator+ that are not there (GCC bug 105651).
    list(APPEND GLIBRA_WARNINGS -Wno-restrict)
endif()

function(glibra_compile_options target)
    # No fused multiply-add: geometry and noise are the same bits on every processor.
    target_compile_options(${target} PRIVATE ${GLIBRA_WARNINGS} -ffp-contract=off)
    if(GLIBRA_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=${GLIBRA_SANITIZE} -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer)
        target_link_options(${target} PUBLIC -fsanitize=${GLIBRA_SANITIZE})
    endif()
endfunction()

# For tests and the command line, which do little themselves and whose libraries are all in headers: optimising them
# takes twice as long as compiling them, and nobody would notice it.
function(glibra_quick_to_compile target)
    if(GLIBRA_SANITIZE)
        target_compile_options(${target} PRIVATE -O0)
    elseif(NOT CMAKE_BUILD_TYPE STREQUAL "Debug")
        target_compile_options(${target} PRIVATE -O1)
    endif()
endfunction()

function(glibra_room room)
    cmake_parse_arguments(arg "" "" "ROOMS;LINK" ${ARGN})
    # With its sub-folders, except those that are a module or a program of their own.
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${room}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/src/${room}/(module|window|program)/")
    set(rooms ${arg_ROOMS})
    list(TRANSFORM rooms PREPEND glibra_)

    if(NOT sources)
        add_library(glibra_${room} INTERFACE)
        return()
    endif()
    add_library(glibra_${room}_objects OBJECT ${sources})
    glibra_compile_options(glibra_${room}_objects)
    target_include_directories(glibra_${room}_objects PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                               PRIVATE ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(glibra_${room}_objects PUBLIC glm::glm fmt::fmt ${rooms} ${arg_LINK})

    add_library(glibra_${room} STATIC $<TARGET_OBJECTS:glibra_${room}_objects>)
    target_include_directories(glibra_${room} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
    target_link_libraries(glibra_${room} PUBLIC glm::glm fmt::fmt ${rooms} ${arg_LINK})
    if(GLIBRA_SANITIZE)
        target_link_options(glibra_${room} PUBLIC -fsanitize=${GLIBRA_SANITIZE})
    endif()
endfunction()
