# The sources of a target are compiled a dozen at a time (CREMONA_UNITY), so what they keep in unnamed namespaces must have
# a name of its own in its target. These do not yet, and are compiled each by itself: give a shared constant or function
# one home, or a name that says more, and take the source off this list.
function(cremona_compile_alone target)
  if(TARGET ${target})
    list(TRANSFORM ARGN PREPEND "${PROJECT_SOURCE_DIR}/")
    set_source_files_properties(${ARGN} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

# Names of these are unique in a dozen of their sources, not yet in all: never more than a dozen at a time, not even where
# CREMONA_UNITY_BATCH says so.
foreach(target IN ITEMS drawing femoop frame_view)
  if(TARGET ${target} AND CREMONA_UNITY_BATCH GREATER 12)
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 12)
  endif()
endforeach()

cremona_compile_alone(frame_session apps/frame/session/other_programs.cpp)
cremona_compile_alone(test_frame_session tests/apps/frame/other_programs_test.cpp)
cremona_compile_alone(test_frame_predict tests/apps/frame_predict/score_test.cpp)
cremona_compile_alone(test_femoop_analysis
  tests/femoop/analysis/long_chain_test.cpp
  tests/femoop/analysis/trace_test.cpp)
cremona_compile_alone(test_femoop_element
  tests/femoop/element/element_contract_test.cpp
  tests/femoop/element/joint_condensation_test.cpp)
cremona_compile_alone(test_femoop_section tests/femoop/section/shape_properties_test.cpp)
cremona_compile_alone(test_femoop_solver
  tests/femoop/solver/factorization_control_test.cpp
  tests/femoop/solver/indefinite_test.cpp
  tests/femoop/solver/multifrontal_test.cpp
  tests/femoop/solver/refinement_test.cpp
  tests/femoop/solver/system_pattern_test.cpp)

# A test puts a team of its own in the place of this one, so this is a member of the library by itself.
cremona_compile_alone(femoop femoop/solver/team.cpp)
