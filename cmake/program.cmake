# The program, and the objects of the library: all rooms but the command line.

set(glibra_library_rooms glib geometry noise glsl image scene plan budget gpu render)
set(glibra_objects)
foreach(room ${glibra_library_rooms})
    if(TARGET glibra_${room}_objects)
        list(APPEND glibra_objects $<TARGET_OBJECTS:glibra_${room}_objects>)
    endif()
endforeach()

file(GLOB cli_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/cli/*.cpp)
if(NOT cli_sources)
    return()
endif()
add_executable(glibra_program ${cli_sources})
set_target_properties(glibra_program PROPERTIES OUTPUT_NAME glibra RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR})
glibra_compile_options(glibra_program)
glibra_quick_to_compile(glibra_program)
# Programs that glibra starts, glibra-view and glibra-bench, are installed in this folder.
target_compile_definitions(glibra_program PRIVATE GLIBRA_VERSION="${PROJECT_VERSION}"
                                                  GLIBRA_PROGRAMS_DIR="${CMAKE_INSTALL_LIBDIR}/glibra")
target_link_libraries(glibra_program PRIVATE glibra_suite glibra_view glibra_render CLI11::CLI11)
if(TARGET glibra_openimageio)
    add_dependencies(glibra_program glibra_openimageio)
endif()
