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

cremona_compile_alone(femoop
  femoop/analysis/compatibility.cpp
  femoop/io/cross/cross_block.cpp
  femoop/io/cross/half_text.cpp
  femoop/io/cross/other_methods.cpp
  femoop/io/cross/sheet_check.cpp
  femoop/io/json/text_place.cpp
  femoop/io/results/solver_trace_text.cpp
  femoop/methods/cross/exercise/form.cpp
  femoop/methods/cross/props.cpp
  femoop/methods/cross/slope_deflection.cpp
  femoop/methods/cross/superposition.cpp
  femoop/methods/mohr/criterion.cpp
  femoop/methods/mohr/locus.cpp
  femoop/methods/mohr/plane_state.cpp
  femoop/methods/mohr/space_construction.cpp
  femoop/methods/mohr/typed_components.cpp
  femoop/model/expected.cpp
  femoop/result/envelope.cpp
  femoop/result/expression.cpp
  femoop/section/section_properties.cpp
  femoop/solver/cholmod_solver.cpp
  femoop/solver/multifrontal/front_factorization.cpp
  femoop/solver/multifrontal/front_memory.cpp
  femoop/solver/multifrontal/front_solution.cpp
  femoop/solver/precise_solver.cpp
  femoop/solver/solver_kind.cpp
  femoop/solver/trace/column_counts.cpp
  femoop/solver/trace/elimination_walk.cpp
  femoop/typical/space_frames.cpp)
cremona_compile_alone(drawing
  apps/drawing/results/diagram.cpp
  apps/drawing/structure/space_supports.cpp)
cremona_compile_alone(frame_view
  apps/frame/view/solver/factor_pictures.cpp
  apps/frame/view/solver/solver_scene.cpp
  apps/frame/view/solver/structure_walk.cpp)
cremona_compile_alone(frame_session apps/frame/session/other_programs.cpp)
cremona_compile_alone(test_frame_session
  tests/apps/frame/named_sets_test.cpp
  tests/apps/frame/other_programs_test.cpp
  tests/apps/frame/predict_commands_test.cpp
  tests/apps/frame/section_draft_test.cpp
  tests/apps/frame/session_test.cpp
  tests/apps/frame/solver_show_test.cpp)
cremona_compile_alone(test_frame_model tests/apps/frame/tools_test.cpp)
cremona_compile_alone(test_frame_predict tests/apps/frame_predict/score_test.cpp)
cremona_compile_alone(test_drawing tests/apps/drawing/results_test.cpp)
cremona_compile_alone(test_femoop_analysis
  tests/femoop/analysis/long_chain_test.cpp
  tests/femoop/analysis/trace_test.cpp)
cremona_compile_alone(test_femoop_cross
  tests/femoop/analysis/random_structure.cpp
  tests/femoop/methods/cross/refusal_test.cpp
  tests/femoop/methods/cross/staged_test.cpp
  tests/femoop/methods/cross/symmetry_test.cpp)
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
cremona_compile_alone(femoop femoop/solver/multifrontal/team.cpp)
