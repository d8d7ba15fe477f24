# Part of the installed CMake package: golden-image tests of a project of its own.
#
#   glibra_add_golden_test(NAME SUITE file.toml
#                          [ONLY pattern...] [DRIVER auto|egl|egl-device|osmesa] [JOBS n] [LABELS label...])
#
# adds the CTest test NAME, which renders the shots of a suite (a TOML file, or a folder of scenes) with the installed
# program and compares them with their golden pictures. In the current binary folder, NAME-report/index.html is a page that
# shows the shots that failed, and NAME-results/junit.xml has the results for a CI server. The target NAME-update accepts
# pictures that differ as the new goldens.

function(glibra_add_golden_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "" "SUITE;DRIVER;JOBS" "ONLY;LABELS")
    if(arg_UNPARSED_ARGUMENTS OR arg_KEYWORDS_MISSING_VALUES)
        message(FATAL_ERROR "glibra_add_golden_test(${name}): cannot read '${arg_UNPARSED_ARGUMENTS} "
                            "${arg_KEYWORDS_MISSING_VALUES}'; it takes NAME SUITE file [ONLY pattern...] [DRIVER name] "
                            "[JOBS n] [LABELS label...]")
    endif()
    if(NOT arg_SUITE)
        message(FATAL_ERROR "glibra_add_golden_test(${name}): SUITE is missing")
    endif()
    get_filename_component(suite "${arg_SUITE}" ABSOLUTE BASE_DIR "${CMAKE_CURRENT_SOURCE_DIR}")
    if(NOT EXISTS "${suite}")
        message(FATAL_ERROR "glibra_add_golden_test(${name}): there is no suite ${suite}")
    endif()

    set(options)
    foreach(pattern IN LISTS arg_ONLY)
        list(APPEND options --only "${pattern}")
    endforeach()
    if(arg_DRIVER)
        list(APPEND options --driver "${arg_DRIVER}")
    endif()
    if(arg_JOBS)
        list(APPEND options --jobs "${arg_JOBS}")
    endif()

    set(results "${CMAKE_CURRENT_BINARY_DIR}/${name}-results")
    set(report "${CMAKE_CURRENT_BINARY_DIR}/${name}-report")
    add_test(NAME "${name}"
             COMMAND glibra::program test "${suite}" ${options} --results "${results}" --report "${report}"
                     --junit "${results}/junit.xml")
    set_tests_properties("${name}" PROPERTIES LABELS "glibra;${arg_LABELS}" ATTACHED_FILES_ON_FAIL
                                                                            "${results}/junit.xml")
    if(arg_JOBS)
        set_tests_properties("${name}" PROPERTIES PROCESSORS "${arg_JOBS}")
    endif()
    add_custom_target("${name}-update"
                      COMMAND glibra::program test "${suite}" ${options} --results "${results}" --update
                              --allow-outside # the project names the suite itself
                      COMMENT "Golden pictures of ${name}"
                      USES_TERMINAL VERBATIM)
endfunction()
