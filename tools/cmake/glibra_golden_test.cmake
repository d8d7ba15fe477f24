# Part of the installed CMake package: golden-image tests of a project of its own.
#
#   glibra_add_golden_test(NAME SUITE file.toml
#                          [ONLY pattern...] [DRIVER auto|egl|egl-device|osmesa] [JOBS n] [PROCESSORS n]
#                          [LABELS label...] [PER_SHOT])
#
# adds the CTest test NAME, which renders the shots of a suite (a TOML file, or a folder of scenes) with the installed
# program and compares them with their golden pictures. In the current binary folder, NAME-report/index.html is a page that
# shows the shots that failed, and NAME-results/junit.xml has the results for a CI server. The target NAME-update accepts
# pictures that differ as the new goldens. PROCESSORS says how many ctest counts for a test (JOBS, or else 1).
#
# With PER_SHOT there is a test NAME.SUITE/SHOT for each shot, and ctest asks the program for them when it starts.

function(glibra_add_golden_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "PER_SHOT" "SUITE;DRIVER;JOBS;PROCESSORS" "ONLY;LABELS")
    if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
        message(FATAL_ERROR "glibra_add_golden_test(${name}): cannot read '${arg_UNPARSED_ARGUMENTS} "
                            "${arg_KEYWORDS_MISSING_VALUES}'; it takes NAME SUITE file [ONLY pattern...] [DRIVER name] "
                            "[JOBS n] [PROCESSORS n] [LABELS label...] [PER_SHOT]")
    endif()
    if(NOT arg_SUITE)
        message(FATAL_ERROR "glibra_add_golden_test(${name}): SUITE is missing")
    endif()
    get_filename_component(suite "${arg_SUITE}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
    if(NOT EXISTS "${suite}")
        message(FATAL_ERROR "glibra_add_golden_test(${name}): there is no suite ${suite}")
    endif()

    set(only)
    foreach(pattern IN LISTS arg_ONLY)
        list(APPEND only --only "${pattern}")
    endforeach()
    set(options)
    if(arg_DRIVER)
        list(APPEND options --driver "${arg_DRIVER}")
    endif()
    if(arg_JOBS)
        list(APPEND options --jobs "${arg_JOBS}")
    endif()

    if(NOT arg_PROCESSORS)
        set(arg_PROCESSORS "${arg_JOBS}")
    endif()
    if(NOT arg_PROCESSORS)
        set(arg_PROCESSORS 1)
    endif()

    set(results "${CMAKE_CURRENT_BINARY_DIR}/${name}-results")
    set(report "${CMAKE_CURRENT_BINARY_DIR}/${name}-report")
    if(arg_PER_SHOT)
        # Read by ctest before it lists its tests.
        set(list "${CMAKE_CURRENT_BINARY_DIR}/${name}-shots.cmake")
        foreach(words only options)
            list(TRANSFORM ${words} REPLACE "(.+)" "[==[\\1]==]" OUTPUT_VARIABLE quoted_${words})
            list(JOIN quoted_${words} " " quoted_${words})
        endforeach()
        file(GENERATE OUTPUT "${list}" CONTENT "set(name [==[${name}]==])
set(program [==[$<TARGET_FILE:glibra::program>]==])
set(suite [==[${suite}]==])
set(only ${quoted_only})
set(options ${quoted_options})
set(results [==[${results}]==])
set(report [==[${report}]==])
set(processors [==[${arg_PROCESSORS}]==])
set(labels [==[glibra;${arg_LABELS}]==])
include([==[${CMAKE_CURRENT_FUNCTION_LIST_DIR}/glibra_golden_shots.cmake]==])
")
        set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${list}")
    else()
        add_test(NAME "${name}"
                 COMMAND glibra::program test "${suite}" ${only} ${options} --results "${results}" --report "${report}"
                         --junit "${results}/junit.xml")
        set_tests_properties("${name}" PROPERTIES LABELS "glibra;${arg_LABELS}" ATTACHED_FILES_ON_FAIL
                                                                                "${results}/junit.xml"
                                                  PROCESSORS "${arg_PROCESSORS}")
    endif()
    add_custom_target("${name}-update"
                      COMMAND glibra::program test "${suite}" ${only} ${options} --results "${results}" --update
                              --allow-outside # the project names the suite itself
                      COMMENT "Golden pictures of ${name}"
                      USES_TERMINAL VERBATIM)
endfunction()
