# Asks a test program for its cases (the reporter "ctest" of tests/main.cpp) and writes them as CTest tests.
execute_process(
  COMMAND "${CMAKE_COMMAND}" -E env "CREMONA_CTEST_LIST=${list}" "CREMONA_CTEST_NAME=${name}"
          "CREMONA_CTEST_LABELS=${labels}" "CREMONA_CTEST_DIRECTORY=${directory}" "ASAN_OPTIONS=detect_leaks=0"
          "${program}" --list-test-cases --reporters=ctest
  RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
if(NOT result EQUAL 0)
  file(REMOVE "${list}")
  message(FATAL_ERROR "${program} could not list its test cases (${result}):\n${output}")
endif()
