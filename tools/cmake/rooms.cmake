# A room is a folder of src with its sub-folders: one static library of all its .cpp files. Every room sees include/
# and src/, so that an include reads "room/file.h".

if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
    # GCC 12 reports overlaps and overflows in std::string that do not exist (GCC bugs 105651 and 105329),
    # most of all where headers are precompiled.
    set(GLIBRA_FALSE_WARNINGS -Wno-restrict -Wno-stringop-overflow -Wno-array-bounds)
endif()
if(CMAKE_CXX_COMPILER_ID MATCHES "Clang")
    # libstdc++'s std::stable_sort calls a deprecated function of its own, and Clang reports that at our call. GCC
    # reports deprecated functions that we call ourselves.
    set(GLIBRA_FALSE_WARNINGS -Wno-deprecated-declarations)
endif()
set(GLIBRA_WARNINGS -Wall -Wextra -Wpedantic -Wconversion -Wshadow ${GLIBRA_FALSE_WARNINGS})
if(GLIBRA_SYSTEM STREQUAL "web")  # 32-bit sizes: what converts there was checked where it was read
    set(GLIBRA_WARNINGS -Wall -Wextra -Wno-unused-parameter -Wno-unused-private-field ${GLIBRA_FALSE_WARNINGS})
endif()
if(GLIBRA_WERROR)
    list(APPEND GLIBRA_WARNINGS -Werror)
endif()

# GCC collects its garbage from this many kB on; with its default of 128 MB a tenth of its time goes there.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    set(GLIBRA_COMPILER_MEMORY --param=ggc-min-heapsize=600000)
endif()

function(glibra_compile_options target)
    # No fused multiply-add: geometry and noise are the same bits on every processor.
    target_compile_options(${target} PRIVATE ${GLIBRA_WARNINGS} ${GLIBRA_COMPILER_MEMORY} -ffp-contract=off)
    # A library exports what include/glibra marks, and nothing else. Modules are found by their names.
    get_target_property(type ${target} TYPE)
    if(NOT type STREQUAL "MODULE_LIBRARY")
        set_target_properties(${target} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    endif()
    if(GLIBRA_SANITIZE)
        target_compile_options(${target} PRIVATE -fsanitize=${GLIBRA_SANITIZE} -fno-sanitize-recover=all
                                                 -fno-omit-frame-pointer)
        target_link_options(${target} PUBLIC -fsanitize=${GLIBRA_SANITIZE})
    endif()
    if(GLIBRA_FUZZ)  # the fuzzer sees which edges of this target an input reaches
        target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
        target_link_options(${target} PUBLIC -fsanitize=fuzzer-no-link)
    endif()
endfunction()

# glibra_quick_to_compile(TARGET LEVEL): for tests, the command line and rooms that do nothing per pixel, vertex or
# texel. They use libraries that consist of headers; full optimisation would add half to their compile time and save
# no measurable run time. LEVEL is -Og, which takes a tenth less time than -O1 and gives pictures as fast; -O1 for tests that
# compute; or -O0 for the tests of the rooms. With sanitizers, only the last are not compiled as the preset says, because
# code runs long there. For Windows -Os takes the place of -Og: its code is half as large, and every program there has all of it.
function(glibra_quick_to_compile target level)
    if(level STREQUAL "-Og" AND GLIBRA_SYSTEM STREQUAL "windows")
        set(level -Os)
    endif()
    if(GLIBRA_SYSTEM STREQUAL "web")
        return()  # all of a page is as small as can be
    endif()
    if(level STREQUAL "-O0" OR NOT (GLIBRA_SANITIZE OR CMAKE_BUILD_TYPE STREQUAL "Debug"))
        target_compile_options(${target} PRIVATE ${level})
        if(level MATCHES "-O[gs]" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
            target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized)  # false at this level: GCC bug 80635
        endif()
    endif()
endfunction()

# The headers that most files of all rooms include are compiled once; that halves the compile time of a room. Every
# file names what it includes all the same, and compiles without this (CMAKE_DISABLE_PRECOMPILE_HEADERS=ON).
set(GLIBRA_COMMON_HEADERS
    <algorithm> <array> <cmath> <filesystem> <functional> <limits> <map> <memory> <optional> <set> <span> <string>
    <string_view> <system_error> <utility> <variant> <vector> <fmt/format.h> <glm/geometric.hpp> <glm/mat4x4.hpp>)

# glibra_precompile(TARGET OWNER [HEADER...]): OWNER is the target whose precompiled headers are shared; the first
# target to name itself. All targets of one owner have the same compile options.
function(glibra_precompile target owner)
    if(target STREQUAL owner)
        target_precompile_headers(${target} PRIVATE ${GLIBRA_COMMON_HEADERS} ${ARGN})
    else()
        target_precompile_headers(${target} REUSE_FROM ${owner})
    endif()
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -fpch-preprocess)  # for ccache
    else()
        # A header that ccache has kept remembers times; an update of the system may change them and nothing else.
        target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
    endif()
endfunction()

# The owner for what glibra_quick_to_compile() compiles at -Og. From version 13 on, GCC takes no headers that were precompiled
# at another level; none takes them for -Os.
set(GLIBRA_QUICK_OWNER glibra_system)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND
   (CMAKE_CXX_COMPILER_VERSION VERSION_GREATER_EQUAL 13 OR GLIBRA_SYSTEM STREQUAL "windows"))
    set(GLIBRA_QUICK_OWNER glibra_glib)  # the first of these rooms
endif()

# The files of the room system: one folder per implementation, and linux replaces files of posix that have the same names.
function(glibra_files_of_system result system)
    file(GLOB sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/system/${system}/*.cpp)
    list(REMOVE_ITEM sources ${PROJECT_SOURCE_DIR}/src/system/windows/programs.cpp)  # of each program
    if(NOT sources)
        message(FATAL_ERROR "GLIBRA_SYSTEM is '${system}': there is no src/system/${system}.")
    endif()
    if(system STREQUAL "linux")
        file(GLOB plain CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/system/posix/*.cpp)
        foreach(file ${plain})
            get_filename_component(name ${file} NAME)
            if(NOT ${PROJECT_SOURCE_DIR}/src/system/linux/${name} IN_LIST sources)
                list(APPEND sources ${file})
            endif()
        endforeach()
    endif()
    if(system STREQUAL "web")  # and what its standard library lacks
        file(GLOB plain CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/tools/web/libcxx/*.cpp)
        list(APPEND sources ${plain})
    endif()
    set(${result} ${sources} ${PROJECT_SOURCE_DIR}/src/system/common.cpp PARENT_SCOPE)
endfunction()

# glibra_room(NAME [SYSTEM system] [QUICK_TO_COMPILE [OFTEN_RUN pattern...]] [ROOMS room...] [WITHOUT name...]
#             [LINK library...])
# ROOMS are the rooms whose headers this one may include; their own rooms come with them. OFTEN_RUN are the files of a room
# that run for every pixel, vertex or draw all the same: the target glibra_NAME_often. WITHOUT are files of other systems.
function(glibra_room room)
    cmake_parse_arguments(arg "QUICK_TO_COMPILE" "SYSTEM" "OFTEN_RUN;ROOMS;WITHOUT;LINK" ${ARGN})
    # Without the sub-folders that are a module or a program of their own.
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/${room}/*.cpp)
    list(FILTER sources EXCLUDE REGEX "/src/${room}/(module|window|program|runtime)/")
    if(arg_SYSTEM)
        glibra_files_of_system(sources ${arg_SYSTEM})
    endif()
    list(TRANSFORM arg_WITHOUT PREPEND ${PROJECT_SOURCE_DIR}/src/${room}/)
    list(REMOVE_ITEM sources ${arg_WITHOUT})
    set(targets glibra_${room})
    if(arg_OFTEN_RUN)
        list(TRANSFORM arg_OFTEN_RUN PREPEND ${PROJECT_SOURCE_DIR}/src/${room}/)
        file(GLOB often CONFIGURE_DEPENDS ${arg_OFTEN_RUN})
        list(REMOVE_ITEM sources ${often})
        list(APPEND targets glibra_${room}_often)
        add_library(glibra_${room}_often STATIC ${often})
    endif()
    add_library(glibra_${room} STATIC ${sources})
    set(rooms ${arg_ROOMS})
    list(TRANSFORM rooms PREPEND glibra_)
    foreach(target ${targets})
        glibra_compile_options(${target})
        target_include_directories(${target} PUBLIC ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
        set(other ${targets})  # the two targets of a room use each other
        list(REMOVE_ITEM other ${target})
        target_link_libraries(${target} PUBLIC glm::glm fmt::fmt ${other} ${rooms} ${arg_LINK})
        if(arg_QUICK_TO_COMPILE AND target STREQUAL "glibra_${room}")
            glibra_quick_to_compile(${target} -Og)
            glibra_precompile(${target} ${GLIBRA_QUICK_OWNER})
        else()
            glibra_precompile(${target} glibra_system)
        endif()
    endforeach()
endfunction()

# glibra_on_windows(PROGRAM [WINDOW]): what a program of Windows has besides: its manifest, icon and version, the symbols by which it
# gets the fast graphics card, and no libraries of the compiler. WINDOW: no console.
function(glibra_on_windows program)
    if(NOT GLIBRA_SYSTEM STREQUAL "windows")
        return()
    endif()
    set(folder ${PROJECT_SOURCE_DIR}/src/system/windows)
    target_sources(${program} PRIVATE ${folder}/programs.cpp ${folder}/glibra.rc)
    set_source_files_properties(${folder}/programs.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON SKIP_PRECOMPILE_HEADERS ON)
    string(REPLACE "." "," numbers ${PROJECT_VERSION})
    get_target_property(name ${program} OUTPUT_NAME)
    target_compile_definitions(${program} PRIVATE $<$<COMPILE_LANGUAGE:RC>:GLIBRA_VERSION_NUMBERS=${numbers},0>
                                                  $<$<COMPILE_LANGUAGE:RC>:GLIBRA_NUMBERS=${PROJECT_VERSION}>
                                                  $<$<COMPILE_LANGUAGE:RC>:GLIBRA_PROGRAM=${name}>)
    set_source_files_properties(${folder}/glibra.rc PROPERTIES OBJECT_DEPENDS "${folder}/glibra.ico;${folder}/glibra.manifest")
    if("WINDOW" IN_LIST ARGN)
        set(no_console -mwindows)
    endif()
    glibra_module_on_windows(${program})
    target_link_options(${program} PRIVATE ${no_console})
endfunction()

# glibra_module_on_windows(TARGET [FUNCTION...]): no library of the compiler beside it, and no time inside. With FUNCTIONs it exports
# these alone; otherwise what is marked, or, where nothing is marked, all that it has.
function(glibra_module_on_windows target)
    if(NOT GLIBRA_SYSTEM STREQUAL "windows")
        return()
    endif()
    target_link_options(${target} PRIVATE -static -Wl,--no-insert-timestamp)
    if(ARGN)
        list(JOIN ARGN "\n" functions)
        file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/${target}.def CONTENT "EXPORTS\n${functions}\n" @ONLY)
        target_sources(${target} PRIVATE ${PROJECT_BINARY_DIR}/${target}.def)
    endif()
endfunction()

# glibra_rooms_of(RESULT TARGET): the rooms that a room is linked with, directly and through others.
function(glibra_rooms_of result target)
    set(found "")
    set(waiting ${target})
    while(waiting)
        list(POP_FRONT waiting each)
        get_target_property(linked ${each} LINK_LIBRARIES)
        list(FILTER linked INCLUDE REGEX "^glibra_")
        list(REMOVE_ITEM linked ${found} glibra_glad)
        list(APPEND found ${linked})
        list(APPEND waiting ${linked})
    endwhile()
    list(REMOVE_DUPLICATES found)
    set(${result} ${found} PARENT_SCOPE)
endfunction()

# glibra_refuse_without(OPTION LIBRARY FOUND): one message where a library is missing that an option needs.
function(glibra_refuse_without option library found)
    if(NOT found)
        message(FATAL_ERROR "${library} is missing. Install it, or leave out what needs it by -D${option}=OFF "
                            "(docs/packages.md).")
    endif()
endfunction()
