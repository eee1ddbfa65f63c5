# cremona_test(NAME name SOURCES a.cpp... LINK t... [LABELS l...])
# A doctest program. Each TEST_CASE is a CTest test of its own, in a process of its own, labelled "one_case" and with its
# TEST_SUITE; one more test, name.any_order, labelled "whole", runs them all in one process and in random order, and begins
# before the others, which fill up what the longest leave.
# Tests run in the top folder; tests/source_folder.h names it too.
function(cremona_test)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME" "SOURCES;LINK;LABELS")
  set(program "test_${arg_NAME}")
  add_executable(${program} ${arg_SOURCES})
  target_link_libraries(${program} PRIVATE cremona_test_main ${arg_LINK} cremona_warnings)
  cremona_precompile(${program} test)

  set(list "${CMAKE_CURRENT_BINARY_DIR}/${program}_tests.cmake")
  if(NOT CMAKE_CROSSCOMPILING) # else it runs as a whole alone
    add_custom_command(TARGET ${program} POST_BUILD
      BYPRODUCTS "${list}"
      COMMAND "${CMAKE_COMMAND}" "-Dprogram=$<TARGET_FILE:${program}>" "-Dname=${arg_NAME}" "-Dlist=${list}"
              "-Ddirectory=${PROJECT_SOURCE_DIR}" "-Dlabels=${arg_LABELS}"
              -P "${PROJECT_SOURCE_DIR}/.cmake/DiscoverTests.cmake"
      VERBATIM)
    set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES "${list}")
  endif()

  add_test(NAME ${arg_NAME}.any_order COMMAND ${program} --order-by=rand --reporters=titles,console ${CREMONA_TESTS_LEFT_OUT}
    WORKING_DIRECTORY "${PROJECT_SOURCE_DIR}")
  set_tests_properties(${arg_NAME}.any_order PROPERTIES
    LABELS "whole;${arg_LABELS}" COST 10 FAIL_REGULAR_EXPRESSION "test cases:[ ]+0 ")
endfunction()
