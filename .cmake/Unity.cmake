# The sources of a target are compiled a dozen at a time (CREMONA_UNITY), so what they keep in unnamed namespaces must have
# a name of its own in its target. These do not yet, and are compiled each by itself: give a shared constant or function
# one home, or a name that says more, and take the source off this list.
function(cremona_compile_alone target)
  if(TARGET ${target})
    list(TRANSFORM ARGN PREPEND "${PROJECT_SOURCE_DIR}/")
    set_source_files_properties(${ARGN} TARGET_DIRECTORY ${target} PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
  endif()
endfunction()

cremona_compile_alone(topology topology/halfedge/check/validate.cpp)
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
cremona_compile_alone(ui
  ui/context/start_program.cpp
  ui/context/window.cpp)
cremona_compile_alone(ui_paint
  ui/paint/label/full_cells.cpp
  ui/paint/label/obstacle_map.cpp
  ui/paint/label/obstacles.cpp
  ui/report/html.cpp)
cremona_compile_alone(cremona_cli apps/cli/solve.cpp)
cremona_compile_alone(drawing
  apps/drawing/results/diagram.cpp
  apps/drawing/structure/space_supports.cpp)
cremona_compile_alone(cross_model
  apps/cross/document/pupil_file.cpp
  apps/cross/document/worked_file.cpp)
cremona_compile_alone(cross_app apps/cross/window/method_panel.cpp)
cremona_compile_alone(euler_session
  apps/euler/session/operator_commands.cpp
  apps/euler/session/script_commands.cpp
  apps/euler/session/step_commands.cpp)
cremona_compile_alone(euler_view
  apps/euler/view/pointers/pointer_drawing.cpp
  apps/euler/view/polygons/plane_model.cpp
  apps/euler/view/solid/arrow_line.cpp
  apps/euler/view/solid/paint_order.cpp)
cremona_compile_alone(euler_app apps/euler/window/script_panel.cpp)
cremona_compile_alone(frame_model apps/frame/document/fault/sentence.cpp)
cremona_compile_alone(frame_predict apps/frame/predict/profile.cpp)
cremona_compile_alone(frame_session
  apps/frame/session/edit_commands.cpp
  apps/frame/session/fault_target.cpp
  apps/frame/session/load_commands.cpp
  apps/frame/session/plane_commands.cpp
  apps/frame/session/section_draft.cpp)
cremona_compile_alone(frame_tools
  apps/frame/tools/select_tool.cpp
  apps/frame/tools/snap.cpp)
cremona_compile_alone(frame_view
  apps/frame/view/solver/factor_pictures.cpp
  apps/frame/view/solver/solver_scene.cpp
  apps/frame/view/solver/structure_walk.cpp)
cremona_compile_alone(frame_app
  apps/frame/window/named_set_rows.cpp
  apps/frame/window/number_row.cpp
  apps/frame/window/properties_panel.cpp
  apps/frame/window/status_bar.cpp
  apps/frame/window/tables_panel.cpp)
cremona_compile_alone(mohr_model
  apps/mohr/document/solution.cpp
  apps/mohr/exercise/answer.cpp
  apps/mohr/exercise/exercise.cpp
  apps/mohr/exercise/slips.cpp
  apps/mohr/exercise/space_slips.cpp)
cremona_compile_alone(mohr_view
  apps/mohr/view/locus_picture.cpp
  apps/mohr/view/section_picture.cpp
  apps/mohr/view/space_picture.cpp)
cremona_compile_alone(test_cross_scenes tests/apps/cross/scene_test.cpp)
cremona_compile_alone(test_euler_model
  tests/apps/euler/draft_test.cpp
  tests/apps/euler/stepper_test.cpp)
cremona_compile_alone(test_euler_view
  tests/apps/euler_view/paint_order_test.cpp
  tests/apps/euler_view/pick_test.cpp
  tests/apps/euler_view/planar_test.cpp
  tests/apps/euler_view/pointer_drawing_test.cpp)
cremona_compile_alone(test_frame_session
  tests/apps/frame/named_sets_test.cpp
  tests/apps/frame/other_programs_test.cpp
  tests/apps/frame/predict_commands_test.cpp
  tests/apps/frame/section_draft_test.cpp
  tests/apps/frame/session_test.cpp
  tests/apps/frame/solver_show_test.cpp)
cremona_compile_alone(test_frame_model tests/apps/frame/tools_test.cpp)
cremona_compile_alone(test_frame_predict tests/apps/frame_predict/score_test.cpp)
cremona_compile_alone(test_frame_tables tests/apps/frame_tables/result_table_test.cpp)
cremona_compile_alone(test_drawing tests/apps/drawing/results_test.cpp)
cremona_compile_alone(test_frame_window tests/apps/frame_window/window_test.cpp)
cremona_compile_alone(test_mohr tests/apps/mohr/exercise_test.cpp)
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
cremona_compile_alone(test_femoop_mohr
  tests/femoop/methods/mohr/criterion_test.cpp
  tests/femoop/methods/mohr/locus_test.cpp
  tests/femoop/methods/mohr/plane_state_test.cpp
  tests/femoop/methods/mohr/rosette_test.cpp
  tests/femoop/methods/mohr/rounding_test.cpp
  tests/femoop/methods/mohr/space_construction_test.cpp)
cremona_compile_alone(test_femoop_section tests/femoop/section/shape_properties_test.cpp)
cremona_compile_alone(test_femoop_solver
  tests/femoop/solver/factorization_control_test.cpp
  tests/femoop/solver/indefinite_test.cpp
  tests/femoop/solver/multifrontal_test.cpp
  tests/femoop/solver/refinement_test.cpp
  tests/femoop/solver/system_pattern_test.cpp)
cremona_compile_alone(test_topology_script tests/topology/script/reference_test.cpp)
cremona_compile_alone(test_ui_files
  tests/ui/files/draft_test.cpp
  tests/ui/files/linked_copy_test.cpp)
cremona_compile_alone(test_ui_paint tests/ui/paint/mesh_test.cpp)

# A test puts a team of its own in the place of this one, so this is a member of the library by itself.
cremona_compile_alone(femoop femoop/solver/multifrontal/team.cpp)
