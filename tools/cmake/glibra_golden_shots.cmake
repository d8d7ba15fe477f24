# Part of the installed CMake package. ctest reads it for glibra_add_golden_test(... PER_SHOT) with the variables name,
# program, suite, only, options, results, report, processors and labels: adds a test for each shot that the program lists.
execute_process(COMMAND "${program}" test "${suite}" ${only} ${options} --list OUTPUT_VARIABLE shots RESULT_VARIABLE status
                ERROR_VARIABLE problem)
if(NOT status EQUAL 0)
    # A suite that cannot be read is a test that fails, with the message.
    add_test("${name}" "${program}" test "${suite}" ${only} ${options} --results "${results}")
    set_tests_properties("${name}" PROPERTIES LABELS "${labels}")
    return()
endif()
string(REGEX MATCHALL "[^\n]+" shots "${shots}")
foreach(shot IN LISTS shots)
    string(FIND "${shot}" "/" slash)
    math(EXPR begin "${slash} + 1")
    string(SUBSTRING "${shot}" ${begin} -1 shot_name)  # without the suite
    string(REPLACE "/" "_" folder "${shot_name}")
    add_test("${name}.${shot}" "${program}" test "${suite}" ${options} --only "${shot_name}" --results "${results}/${folder}"
             --report "${report}/${folder}" --junit "${results}/${folder}/junit.xml")
    set_tests_properties("${name}.${shot}" PROPERTIES PROCESSORS "${processors}" LABELS "${labels}"
                                                      ATTACHED_FILES_ON_FAIL "${results}/${folder}/junit.xml")
endforeach()
