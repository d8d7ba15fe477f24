# The GL loader, generated at build time from Debian's python3-glad (its Khronos registry comes with the package, so
# this works offline). EGL itself is opened at run time, like OSMesa, and only a dozen of its functions are needed, so only
# the header of its loader is used, for types and numbers. --debug adds a table of wrappers to the table of functions;
# gpu/context/call_counter.h uses them to count calls.

find_program(GLAD_PROGRAM glad REQUIRED)
set(glad_dir ${PROJECT_BINARY_DIR}/glad)
set(glad_extensions
    GL_ARB_robustness
    GL_ARB_shading_language_include
    GL_ARB_texture_filter_anisotropic
    GL_EXT_texture_filter_anisotropic
    GL_KHR_debug
    GL_KHR_parallel_shader_compile
    GL_KHR_robustness
    GL_ARB_pipeline_statistics_query
    GL_MESA_pack_invert
    EGL_EXT_platform_base
    EGL_EXT_platform_device
    EGL_EXT_device_base
    EGL_EXT_device_enumeration
    EGL_EXT_device_query
    EGL_EXT_device_drm
    EGL_MESA_platform_surfaceless
    EGL_KHR_create_context
    EGL_KHR_surfaceless_context
    EGL_KHR_no_config_context)
list(JOIN glad_extensions "," glad_extension_list)
add_custom_command(
    OUTPUT ${glad_dir}/src/gl.c ${glad_dir}/include/glad/gl.h ${glad_dir}/include/glad/egl.h
    COMMAND ${GLAD_PROGRAM} --quiet --reproducible --api gl:core=4.6,egl=1.5 --extensions ${glad_extension_list}
            --out-path ${glad_dir} c --debug
    COMMENT "Generating the GL loader"
    VERBATIM)
add_library(glibra_glad STATIC ${glad_dir}/src/gl.c)
target_include_directories(glibra_glad SYSTEM PUBLIC $<BUILD_INTERFACE:${glad_dir}/include>)
target_link_libraries(glibra_glad PUBLIC ${CMAKE_DL_LIBS})
# Exceptions pass through its wrappers (gpu/context/driver_reports.h).
target_compile_options(glibra_glad PRIVATE -fexceptions)
