#include "apps/frame/window/canvas.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "apps/drawing/draw.h"
#include "apps/drawing/reading.h"
#include "apps/drawing/results/envelope_band.h"
#include "apps/drawing/truss/beside_truss.h"
#include "apps/frame/session/free_body_commands.h"
#include "apps/frame/session/funicular_commands.h"
#include "apps/frame/session/load_commands.h"
#include "apps/frame/session/snapping.h"
#include "apps/frame/session/train_commands.h"
#include "apps/frame/session/truss_commands.h"
#include "apps/frame/session/virtual_work_commands.h"
#include "apps/frame/session/work.h"
#include "apps/frame/tools/kept_settings.h"
#include "apps/frame/tools/load_tool.h"
#include "apps/frame/tools/predict_tool.h"
#include "apps/frame/tools/tool_loads.h"
#include "apps/frame/view/kept_view.h"
#include "apps/frame/view/motion_words.h"
#include "apps/frame/view/predict/guess_picture.h"
#include "apps/frame/window/banner.h"
#include "apps/frame/window/blank_picture.h"
#include "apps/frame/window/explained_step.h"
#include "apps/frame/window/hand_picture.h"
#include "apps/frame/window/number_of_picture.h"
#include "apps/frame/window/train_envelope_panel.h"
#include "femoop/result/components.h"

namespace frame {

namespace {

// A standing train's loads are none of the document's: who grips them holds the train.
void hold_train(Aim& aim)
{
    aim.is_on_train = aim.grip && !aim.support && !aim.dimension;
    aim.grip.reset();
}

// The panel of a number that was asked after may push the picture away from under a pointer that rests.
std::optional<PointedNumber> still_meant(const Workspace& workspace)
{
    const auto& asked = workspace.asked_number;
    const auto effect = asked ? effect_in(workspace.session.model(), *asked) : std::nullopt;
    return effect ? std::optional(PointedNumber{*effect}) : std::nullopt;
}

// While a line is kept from sight nothing stands on it.
bool stands_train(const Session& session)
{
    return session.shown_line() != nullptr && !session.hidden && session.influence.standing() != nullptr;
}

// An influence line belongs to no case either: it stands alone on the structure, or with a train. Under a unit load
// that traces it the structure's own diagram stands beside it.
DrawOptions with_influence(DrawOptions options, const Session& session, bool has_train)
{
    options.show = options.show & ShowSet{Show::Values,          Show::NodeNames, Show::MemberNames, Show::Dimensions,
                                          Show::DrawnDimensions, Show::LocalAxes, Show::Legend};
    options.show.insert(Show::Influence);
    options.is_envelope = false;
    if (!has_train) return options;
    options.show.insert(Show::Loads); // of the train, which is the only load case then
    options.load_case = femoop::CaseId(0);
    if (!session.influence.is_traced()) return options;
    options.layout = drawing::Layout::LoadsOnFirst;
    options.show.insert(drawing::show_of(*session.influence.effect(session.model()), session.model().analysis));
    return options;
}

// A free body stands alone before the structure, with all that acts on it.
DrawOptions with_free_body(DrawOptions options)
{
    options.show = options.show & ShowSet{Show::Values, Show::MemberNames, Show::LocalAxes, Show::Legend};
    return options;
}

// A truss that is worked out says all that there is; names of bars would stand where their forces do.
DrawOptions with_truss(DrawOptions options)
{
    options.show = options.show & ShowSet{Show::Values, Show::NodeNames, Show::Legend};
    options.show.insert(Show::Truss);
    options.is_envelope = false;
    return options;
}

// Beside the force polygon stand the loads alone.
DrawOptions with_funicular(DrawOptions options)
{
    options.show = options.show & ShowSet{Show::Values, Show::NodeNames, Show::DrawnDimensions, Show::Legend};
    for (const Show item : {Show::Loads, Show::ForcePolygon}) options.show.insert(item);
    return options;
}

// The terms of the count stand where diagrams and loads would; the sum is of the structure alone.
DrawOptions with_counting(DrawOptions options)
{
    options.show = options.show &
                   ShowSet{Show::Counting, Show::NodeNames, Show::DrawnDimensions, Show::LocalAxes, Show::Legend};
    options.is_envelope = false;
    return options;
}

// The steps beside the structure say what its head would, in the room that it needs; so do reactions that are not asked
// for, on the projector.
DrawOptions with_node_numbers(DrawOptions options, const DerivationShow& steps)
{
    options.show.insert(Show::NodeNumbers);
    options.show.erase(Show::Legend);
    const auto* const derivation = steps.derivation();
    const bool is_of_reaction = derivation != nullptr &&
                                derivation->effect.quantity == femoop::ExpectedQuantity::Reaction;
    if (options.theme == ui::ThemeName::Projector && !is_of_reaction) options.show.erase(Show::Reactions);
    return options;
}

/// Whose motion is shown in place of the results; null where none is.
const RefusedRelease* shown_refusal(const Workspace& workspace)
{
    const auto& refused = workspace.refused_release;
    return refused && refused->moves(workspace.session) && workspace.session.shown_results() ? &*refused : nullptr;
}

// How a structure moves, and nothing that it carries.
DrawOptions with_motion(DrawOptions options)
{
    options.show = options.show & ShowSet{Show::NodeNames, Show::Legend};
    options.is_envelope = false;
    return options;
}

/// Of trains; null where none is shown.
const drawing::EnvelopePicture* shown_envelope(const Session& session)
{
    if (!session.shows_train_envelope()) return nullptr;
    return session.train_envelope.picture(session.model(), session.generation(), session.results_view());
}

/// The same; one without bands while it is looked for, or where it was refused: that of the cases would be taken for it.
const drawing::EnvelopePicture* drawn_envelope(const Session& session)
{
    static const drawing::EnvelopePicture none{};
    const auto* const shown = shown_envelope(session);
    return shown == nullptr && session.shows_train_envelope() ? &none : shown;
}

// An envelope belongs to no case, so it has neither loads nor a deformed shape.
DrawOptions looked_at(const Workspace& workspace)
{
    const Session& session = workspace.session;
    DrawOptions options = session.results_view();
    if (shown_refusal(workspace) != nullptr) return with_motion(std::move(options));
    if (session.influence.is_on(session.model())) {
        const bool has_train = stands_train(session);
        return with_influence(std::move(options), session, has_train);
    }
    if (lifted_body(session) != nullptr) return with_free_body(std::move(options));
    if (shown_truss(session) != nullptr) return with_truss(std::move(options));
    if (shown_funicular(session) != nullptr) return with_funicular(std::move(options));
    if (shown_work(session) != nullptr) return with_unit_load(std::move(options), session.model().analysis);
    if (options.show.contains(Show::Counting)) return with_counting(std::move(options));
    if (options.is_envelope) options.show = options.show - ShowSet{Show::Loads, Show::Deformed};
    if (explained_step(workspace) != nullptr) return with_node_numbers(std::move(options), workspace.derivation);
    return options;
}

bool is_sketched(const Session& session) { return session.hidden || !session.prediction.is_empty(); }

// Judged where the whole line is seen.
GuessPicture guess_of_line(const Session& session, const InfluencePicture& line)
{
    const GuessedLine shown{.is_stale = session.prediction.is_stale(session.model(), line.line.effect),
                            .is_traced = !session.hidden && line.traced};
    const bool is_judged = !session.hidden && !shown.is_traced && !shown.is_stale;
    auto assessment = is_judged ? assess(session.prediction, line.line, line.path) : std::nullopt;
    return GuessPicture(session.prediction, std::move(assessment), shown);
}

// Judged where the moments of one case are seen, or the influence line.
std::optional<GuessPicture> guess_picture(const Session& session, const DrawOptions& options)
{
    if (!is_sketched(session)) return std::nullopt;
    if (const auto* const line = session.shown_line()) return guess_of_line(session, *line);
    const femoop::Results* const results = session.shown_results();
    const bool is_judged = results && !options.is_envelope && options.show.contains(Show::M);
    if (!is_judged) return GuessPicture(session.prediction);
    return GuessPicture(session.prediction, assess(session.prediction, *results, options.load_case));
}

// While members are drawn the structure is not complete yet, so no motion is played.
std::optional<std::size_t> shown_mechanism(const Workspace& workspace)
{
    const std::size_t n = workspace.session.shown_mechanisms().size();
    return workspace.tool_controller.can_type() || n == 0 ? std::nullopt
                                                          : std::optional(std::min(workspace.session.mechanism, n - 1));
}

DrawInput input_of(const Workspace& workspace, const DrawOptions& options, const std::optional<GuessPicture>& guess,
                   std::span<const NodeNumbers> numbers)
{
    const Session& session = workspace.session;
    if (const auto* const refused = shown_refusal(workspace))
        return {.model = refused->primary,
                .motion = drawing::MotionChoice{refused->motions, 0, options.tr(refused->reason)}};
    if (const auto* const line = session.shown_line()) {
        const bool has_train = stands_train(session);
        const bool is_traced = has_train && session.influence.is_traced();
        std::vector<const InfluencePicture*> kept;
        if (!session.hidden)
            for (const InfluencePicture& one : session.influence.kept_pictures()) kept.push_back(&one);
        return {.model = has_train ? session.influence.loaded() : session.model(),
                .results = is_traced ? &session.influence.results() : nullptr,
                .dimensions = session.document().companion.dimensions,
                .overlay = guess ? &*guess : nullptr,
                .influence = line,
                .kept_lines = std::move(kept)};
    }
    if (const auto* const body = lifted_body(session))
        return {.model = session.model(),
                .results = session.shown_results(),
                .dimensions = session.document().companion.dimensions,
                .free_body = body};
    if (const auto* const truss = shown_truss(session))
        return {.model = session.model(), .results = session.shown_results(), .truss = truss};
    if (const auto* const funicular = shown_funicular(session))
        return {.model = session.model(),
                .results = session.shown_results(),
                .dimensions = session.document().companion.dimensions,
                .funicular = funicular};
    if (const auto* const work = shown_work(session))
        return {.model = session.model(), .results = session.shown_results(), .work = work};
    DrawInput input{.model = session.model(),
                    .reference = session.reference.get(),
                    .dimensions = session.document().companion.dimensions,
                    .overlay = guess ? &*guess : nullptr,
                    .numbers = numbers};
    if (options.show.contains(Show::Counting))
        input.counting = session.counting.of(session.model(), session.generation());
    if (const auto i = shown_mechanism(workspace)) {
        input.motion = motion_choice(session.shown_mechanisms(), *i, options.tr);
        return input;
    }
    input.results = session.shown_results();
    input.envelope = drawn_envelope(session);
    input.reasons = why_blank(session);
    if (input.reasons.empty()) input.reasons = why_no_truss_shown(session);
    if (input.reasons.empty()) input.reasons = why_no_funicular_shown(session);
    if (input.reasons.empty()) input.reasons = why_no_work_shown(session);
    if (input.reasons.empty()) input.reasons = why_no_train_values(session);
    return input;
}

void follow_derivation(Workspace& workspace)
{
    if (workspace.bottom.shows(BottomContent::Derivation)) workspace.derivation.follow(workspace.session);
}

ui::World3 middle_of(const StructureShape& shape)
{
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const Eigen::Vector3d& node : shape.nodes) sum += node;
    if (!shape.nodes.empty()) sum /= static_cast<double>(shape.nodes.size());
    return {sum.x(), sum.y(), sum.z()};
}

// That was moved by hand, in the plane; null where there is none.
const ui::PlaneCamera* plane_camera(const Session& session)
{
    const auto& camera = session.draw_state.camera;
    return camera ? std::get_if<ui::PlaneCamera>(&*camera) : nullptr;
}

Region region_in(const ui::PlaneCamera& camera, ui::Size panel)
{
    const ui::World2 centre = camera.to_world({0.5 * panel.width, 0.5 * panel.height});
    return {.centre = {centre.x, centre.y}, .height = panel.height / camera.scale()};
}

/// No stroke of it could miss its place as the picture moves.
bool only_asks(ToolKind tool)
{
    constexpr std::array asking{ToolKind::Select, ToolKind::Influence, ToolKind::FreeBody, ToolKind::Funicular,
                                ToolKind::VirtualWork};
    return std::ranges::find(asking, tool) != asking.end();
}

} // namespace

void Canvas::fit(Session& session)
{
    session.draw_state.camera.reset();
    fitted_for_.reset();
}

bool Canvas::FittedFor::serves(const FittedFor& wanted) const
{
    const bool is_line_closed = has_line && !wanted.has_line;
    const bool has_room = !is_line_closed && (has_pencil || !wanted.has_pencil) && (has_train || !wanted.has_train) &&
                          free_body == wanted.free_body && funicular == wanted.funicular && work == wanted.work &&
                          n_lines == wanted.n_lines && lent <= wanted.lent;
    const bool is_tight = std::ranges::equal(factors, wanted.factors, std::ranges::less_equal());
    return session == wanted.session && sheet == wanted.sheet && layout == wanted.layout && theme == wanted.theme &&
           is_in_space == wanted.is_in_space && has_diagram == wanted.has_diagram && has_room && is_tight;
}

Canvas::FittedFor Canvas::wanted_fit(const Session& session, const DrawOptions& options) const
{
    return {session.number(),
            whole_sheet(),
            options.layout,
            options.theme,
            is_seen_in_space(session.model().analysis),
            is_sketched(session),
            session.influence.is_on(session.model()),
            session.influence.standing() != nullptr,
            lifted_body(session) != nullptr ? session.free_body.number() : 0,
            options.show.contains(Show::ForcePolygon) ? session.funicular.number() : 0,
            options.show.contains(Show::UnitLoad) ? session.virtual_work.number() + 1 : 0,
            options.show.contains(Show::Truss) || options.show.contains(Show::ForcePolygon),
            session.shown_line() != nullptr ? session.influence.kept_pictures().size() : 0,
            {options.diagram_factor, options.load_factor, options.symbol_factor},
            lent_};
}

// Below the legend a low sheet, as over a table on the projector, would leave the structure no room.
DrawOptions Canvas::seen_options(const Workspace& workspace) const
{
    constexpr double least_lines = 24.0;
    DrawOptions options = looked_at(workspace);
    const double n_lines = whole_sheet().height / ui::Theme(options.theme).type().normal;
    if (n_lines < least_lines) options.show = options.show - ShowSet{Show::Legend};
    return options;
}

void Canvas::follow_structure(Workspace& workspace)
{
    Session& session = workspace.session;
    const bool is_same = session_ == session.number();
    if (!is_same || generation_ != session.generation()) shape_ = shape_of(session.model());
    session_ = session.number();
    generation_ = session.generation();
    follow_derivation(workspace);
    const DrawOptions options = seen_options(workspace);
    const std::vector<NodeNumbers> numbers = node_numbers(workspace);
    DrawState state = session.draw_state;
    state.phase = 1.0; // room for the whole motion
    const std::optional<GuessPicture> guess = guess_picture(session, options);
    const FittedFor wanted = wanted_fit(session, options);
    const bool must_rest = is_working_ || session.history().is_dragging();
    const bool can_rest = fitted_for_ && fitted_for_->session == session_ && fitted_for_->sheet == whole_sheet();
    const bool is_resting = must_rest && can_rest;
    const bool is_fitted = is_resting || (fitted_for_ && fitted_for_->serves(wanted) && is_all_in_sight(workspace));
    is_just_fitted_ = !state.camera && !is_fitted;
    if (!state.camera && is_fitted) state.camera = plan_.camera;
    if (is_just_fitted_) fitted_for_ = wanted;
    if (session.draw_state.camera) fitted_for_.reset();
    const Subject::Plan before = std::exchange(
        plan_, Subject(input_of(workspace, options, guess, numbers), options, state).plan(sheet(), fonts()));
    if (is_same && !is_just_fitted_) hold_still(session, before);
    fit_new_body(session);
}

// A model in space that was turned by hand stays turned so; the body that has come must not stand beside the sheet. When
// it has gone all is as large as it was.
void Canvas::fit_new_body(Session& session)
{
    constexpr double room = 80.0; // [px], for labels
    const drawing::FreeBodyPicture* const body = lifted_body(session);
    const std::size_t number = body != nullptr ? session.free_body.number() : 0;
    auto* const orbit = session.draw_state.camera ? std::get_if<ui::OrbitCamera>(&*session.draw_state.camera) : nullptr;
    if (std::exchange(body_in_sight_, number) == number || orbit == nullptr || plan_.panels.empty()) return;
    const auto kept = std::exchange(fitted_for_body_, std::nullopt);
    const ui::OrbitCamera before = kept && kept->fitted == *orbit ? kept->before : *orbit;
    *orbit = before;
    if (body != nullptr) {
        const ui::Size size = plan_.panels.front().box.size();
        const ui::Box sheet{{room, room}, {size.width - room, size.height - room}};
        std::vector<ui::World3> places;
        const auto add = [&](const Eigen::Vector3d& place) { places.push_back({place.x(), place.y(), place.z()}); };
        std::ranges::for_each(shape_.nodes, add);
        std::ranges::for_each(places_of(*body, shape_), add);
        const auto is_seen = [&](const ui::World3& place) { return sheet.contains(orbit->to_sheet(place)); };
        if (!std::ranges::all_of(places, is_seen)) orbit->fit(places, size, {room, room, room, room});
        fitted_for_body_ = FittedForBody{before, *orbit};
    }
    plan_.camera = *orbit;
}

// Where the legend takes a line more or less the picture stays where it is.
void Canvas::hold_still(Session& session, const Subject::Plan& before)
{
    if (before.panels.empty() || plan_.panels.empty()) return;
    if (before.panels.size() != plan_.panels.size()) { // higher or lower ones, in which the same is looked at
        const auto* const by_hand = plane_camera(session);
        if (by_hand == nullptr) return;
        const Region seen = region_in(*by_hand, before.panels.front().box.size());
        plan_.camera = camera_on(seen, plan_.panels.front().box.size());
        session.draw_state.camera = plan_.camera;
        return;
    }
    const ui::Point shift = before.panels.front().box.min - plan_.panels.front().box.min;
    if (shift == ui::Point{}) return;
    std::visit([&](auto& camera) { camera.pan(shift); }, plan_.camera);
    if (session.draw_state.camera) session.draw_state.camera = plan_.camera;
}

// Drawing must not move the picture under the hand; it moves where a node would be lost, and with no tool in the hand
// that draws where other marks would be. A line that is carried on may have a node beside the legend.
bool Canvas::is_all_in_sight(const Workspace& workspace) const
{
    if (plan_.panels.empty()) return false;
    const bool is_at_rest = only_asks(workspace.tool_controller.kind()) && !shown_mechanism(workspace) && lent_ <= 0.0;
    if (is_at_rest && was_whole_ && !drawn_.is_whole) return false;
    const Tool& tool = workspace.tool_controller.tool();
    const bool is_carried_on = tool.from() || tool.from_in_space();
    const ui::Box panel = plan_.panels.front().box;
    const ui::Box box = is_carried_on ? ui::box_at({0.0, 0.0}, sheet()) : panel;
    const Projection projection(plan_.camera, panel.min);
    return std::ranges::all_of(shape_.nodes, [&](const auto& node) { return box.contains(projection(node)); });
}

ui::Point Canvas::corner_of_panel(ui::Point at) const
{
    for (const Panel& panel : plan_.panels) {
        if (panel.box.contains(at) && !is_diagram(panel)) return panel.box.min;
    }
    return plan_.panels.empty() ? ui::Point{} : plan_.panels.front().box.min;
}

Projection Canvas::projection_at(ui::Point at) const { return Projection(plan_.camera, corner_of_panel(at)); }

std::optional<Region> Canvas::region(const Session& session) const
{
    const auto* const camera = plane_camera(session);
    if (camera == nullptr || plan_.panels.empty()) return std::nullopt;
    return region_in(*camera, plan_.panels.front().box.size());
}

// A view under a name is put into the picture as large as it is now.
void Canvas::look_at_region(Workspace& workspace)
{
    const std::optional<Region> region = std::exchange(workspace.session.look_at, std::nullopt);
    if (!region || plan_.panels.empty() || !std::holds_alternative<ui::PlaneCamera>(plan_.camera)) return;
    workspace.session.draw_state.camera = camera_on(*region, plan_.panels.front().box.size());
    follow_structure(workspace);
}

void Canvas::zoom(Session& session, double factor) const
{
    if (plan_.panels.empty()) return;
    const ui::Size size = plan_.panels.front().box.size();
    Camera changed = plan_.camera;
    std::visit([&](auto& camera) { camera.zoom({0.5 * size.width, 0.5 * size.height}, factor); }, changed);
    session.draw_state.camera = changed;
}

// Logical pixels of a unit of length along the member, as it is seen.
double Canvas::pixels_along(const Projection& projection, const Cut& cut) const
{
    const MemberShape& member = shape_[cut.member];
    const double seen = distance(projection(member.start), projection(member.end));
    return member.length > 0.0 ? seen / member.length : 0.0;
}

std::optional<ui::Point> Canvas::in_window(const Eigen::Vector3d& place) const
{
    if (plan_.panels.empty()) return std::nullopt;
    return corner() + projection_at(plan_.panels.front().box.min)(place);
}

std::optional<ui::Point> Canvas::in_window(const Cut& cut) const
{
    if (cut.member.index >= shape_.members.size()) return std::nullopt;
    return in_window(shape_[cut.member].at(cut.x));
}

void Canvas::show(Workspace& workspace, ui::ImGuiSession& gui)
{
    if (!begin(gui, any_button)) return;
    const auto told = banner(workspace);
    lent_ = told ? static_cast<double>(ui::height(*told) - ui::status_height()) / gui.scale() : 0.0;
    follow_structure(workspace);
    look_at_region(workspace);

    const ImGuiIO& io = ImGui::GetIO();
    const bool is_followed = is_over() || is_active() || is_working_; // a button may be released beside the picture
    follow(workspace, {.at = pointer(), .is_over = is_followed, .adds = io.KeyShift, .is_exact = io.KeyAlt});
    follow_derivation(workspace); // the hand may have changed the document
    paint([&](ui::Painter& painter) { paint_all(workspace, painter); });
    end(gui);
}

void Canvas::follow(Workspace& workspace, const Pointer& pointer)
{
    Session& session = workspace.session;
    session.hover.reset();
    session.draw_state.hover = {};
    if (!pointer.is_over) return;
    if (const Panel* const panel = diagram_at(pointer.at); panel != nullptr && !is_working_)
        return point_at_diagram(session, *panel, pointer.at);
    const Projection projection = projection_at(pointer.at);
    ToolSettings& settings = workspace.tool_controller.settings();
    settings.grid = typed_spacing(settings, session.model().units).value_or(grid_of(projection));
    settings.load_case = session.view.load_case;
    settings.load = entry_of(settings.load, session.model().analysis).load; // another tab may lack its direction
    settings.moment_side = session.view.moment_side;
    const bool reads_results = session.shown_results() && !session.truss.is_on() && shown_funicular(session) == nullptr;
    Pick under = pick(shape_, projection, pointer.at, reads_results ? session.view.show : ShowSet{});
    if (under.cut) under.cut = snapped(session, shape_, *under.cut, pixels_along(projection, *under.cut));
    const bool asks_for_menu = ImGui::IsMouseReleased(ImGuiMouseButton_Right) && !is_moving_view();
    move_camera(session);
    Aim aim = aim_at(work_in_hand(session).document, workspace.tool_controller, projection, pointer, under,
                     drawn_.grips);
    if (session.influence.standing() != nullptr) hold_train(aim);
    if (const auto number = number_of_picture(session, {plan_, drawn_.grips}, pointer.at, under, aim))
        workspace.pointed_number = still_meant(workspace).value_or(*number);
    workspace.tool_controller.point_at(aim);
    if (asks_for_menu) ask_for_menu(workspace, aim);
    if (is_moving_view()) return;
    if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) && under.is_nothing() &&
        !workspace.tool_controller.can_type())
        fit(session);
    if (under.node) session.draw_state.hover.nodes.push_back(*under.node);
    if (aim.points_at_support()) session.draw_state.hover.nodes.push_back(aim.support->node);
    if (aim.part() && aim.dimension) session.draw_state.hover.dimensions.push_back(*aim.dimension);
    if (aim.cut) session.draw_state.hover.members.push_back(aim.cut->member);
    session.hover = under.cut;
    hover_panel_ = corner_of_panel(pointer.at);
    work(workspace, aim, under);
    if (const auto member = workspace.tool_controller.tool().preview().member)
        session.draw_state.hover.members = {*member};
}

const Panel* Canvas::diagram_at(ui::Point at) const
{
    const auto panel = std::ranges::find_if(plan_.panels,
                                            [&](const Panel& one) { return is_diagram(one) && one.box.contains(at); });
    return panel != plan_.panels.end() ? &*panel : nullptr;
}

// The hand lights the bar of the side under it, and a click selects it; there is nothing to be drawn or moved.
void Canvas::point_at_diagram(Session& session, const Panel& panel, ui::Point at)
{
    constexpr double reach = 8.0; // [px]
    const TrussPicture* const truss = shown_truss(session);
    if (truss == nullptr) return;
    const auto bar = bar_beside_at(*truss, panel.box, ui::Theme(session.view.theme), at, reach);
    if (bar) session.draw_state.hover.members.push_back(*bar);
    if (!is_pressed()) return;
    session.selection.clear();
    if (bar) session.selection = Part(*bar);
}

// A stroke goes on from what was there before it; until one begins the hand points at what is seen.
Work Canvas::work_in_hand(Session& session) const { return is_working_ ? work_of(session) : work_seen(session); }

// A right click that was no drag: the menu of what lies there, and of what is selected together with it.
void Canvas::ask_for_menu(Workspace& workspace, const Aim& aim)
{
    Selection& selection = workspace.session.selection;
    const bool is_busy = workspace.transform || workspace.session.history().is_dragging() ||
                         workspace.tool_controller.kind() == ToolKind::Predict ||
                         workspace.tool_controller.tool().preview().window;
    if (is_busy) return;
    const std::optional<Part> part = aim.part();
    if (!part) selection.clear();
    else if (!selection.contains(*part)) selection = *part;
    workspace.menu_cut = aim.cut;
    workspace.menu_number = workspace.pointed_number;
    if (aim.cut) workspace.session.pin = aim.cut; // "at this section" is said of it
    workspace.requests.push_back(Request::ContextMenu);
}

namespace {

void carry_out(Session& session, const std::optional<Change>& change)
{
    if (change) session.change(*change);
}

// A stroke has no ordinates where the eye looks along them, as straight down on a grillage.
std::optional<ui::Message> why_not_sketch(const Workspace& workspace, const Aim& aim)
{
    const drawing::InfluencePicture* const line = workspace.session.shown_line();
    const bool is_blind = line != nullptr && workspace.session.hidden &&
                          !shows_ordinates(workspace.session.model(), *line, PencilView::of(aim));
    if (!is_blind) return std::nullopt;
    return ui::translatable("the ordinates of the line are seen end-on from here; turn the model");
}

// A load that is put where it would not be seen is none that was meant.
std::optional<ui::Message> why_not_press(const Workspace& workspace, const Aim& aim)
{
    if (workspace.tool_controller.kind() == ToolKind::Predict) return why_not_sketch(workspace, aim);
    if (workspace.tool_controller.kind() != ToolKind::Load || (!aim.node && !aim.cut)) return std::nullopt;
    if (auto reason = why_shown_case_takes_no_load(workspace.session)) return reason;
    if (!aim.node || force_of(workspace.tool_controller.settings(), workspace.session.model().analysis))
        return std::nullopt;
    return ui::translatable("a node cannot have this load; click a member, or choose another load");
}

} // namespace

// The left button: the tool's in the hand. In space it turns the model but for what takes hold of something and for a
// window, which begins with Shift.
void Canvas::work(Workspace& workspace, const Aim& aim, const Pick& under)
{
    const bool is_window = is_pressed() && aim.adds && workspace.tool_controller.kind() == ToolKind::Select;
    const Tool& tool = workspace.tool_controller.tool();
    const bool takes_hold = is_pressed() && tool.takes_hold(work_in_hand(workspace.session), aim);
    const bool turns = is_seen_in_space(workspace.session.model().analysis) && !is_window && !takes_hold &&
                       !is_working_;
    if (turns) return click_in_space(workspace, aim, under);
    if (is_pressed()) press(workspace, aim);
    carry_out(workspace.session, workspace.tool_controller.tool().move(work_in_hand(workspace.session), aim));
    if (is_working_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) release(workspace, aim, under);
}

void Canvas::press(Workspace& workspace, const Aim& aim)
{
    is_working_ = true;
    workspace.session.settle();
    const ToolKind kind = workspace.tool_controller.kind();
    const bool asks_for_section = kind == ToolKind::Influence || kind == ToolKind::VirtualWork;
    const bool is_on_structure = aim.node || aim.cut || aim.support || aim.is_on_train; // not on a load or a dimension
    if (asks_for_section && !is_on_structure) return ask_at_diagram(workspace, aim);
    if (const auto reason = why_not_press(workspace, aim)) workspace.session.notify(*reason);
    else carry_out(workspace.session, workspace.tool_controller.tool().press(work_of(workspace.session), aim));
}

// A press on a diagram means the section that it is read at.
void Canvas::ask_at_diagram(Workspace& workspace, Aim aim)
{
    aim.cut = workspace.session.hover;
    workspace.tool_controller.tool().press(work_of(workspace.session), aim);
}

void Canvas::release(Workspace& workspace, const Aim& aim, const Pick& under)
{
    Session& session = workspace.session;
    is_working_ = false;
    const bool was_dragging = session.history().is_dragging() || workspace.tool_controller.tool().preview().window;
    carry_out(session, workspace.tool_controller.tool().release(work_of(session), aim));
    notify_uncut(session);
    session.settle();
    if (workspace.tool_controller.tool().is_done()) return workspace.tool_controller.settle();
    if (was_dragging || workspace.tool_controller.kind() != ToolKind::Select) return;
    const bool is_read = under.cut && !aim.part(); // a click on a diagram means its member
    const std::optional<Cut> section = is_read ? under.cut : aim.cut;
    if (section && shown_envelope(session) != nullptr && !session.hidden) return ask_at_envelope(workspace, *section);
    session.pin = section; // one on a support, a load or a dimension means that alone
    if (is_read && !aim.adds) session.selection = Part(under.cut->member);
    const bool is_second = ImGui::GetIO().MouseClickedLastCount[ImGuiMouseButton_Left] == 2;
    const std::optional<Part> part = aim.part();
    const bool has_numbers = part && !std::holds_alternative<femoop::MemberId>(*part); // a member's is its foundation's
    takes_number_ = is_second && has_numbers && workspace.has_panels && !aim.adds;
}

// Of the section force that is drawn under the hand; where the panel draws several, of the first one.
void Canvas::ask_at_envelope(Workspace& workspace, const Cut& section)
{
    const Session& session = workspace.session;
    ShowSet show = session.view.show;
    for (const Panel& panel : plan_.panels)
        if (panel.box.contains(pointer())) show = panel.show;
    std::vector<femoop::MemberComponent> drawn = drawing::shown_components(show, session.model().analysis);
    if (drawn.empty()) drawn = femoop::section_force_components(session.model().analysis);
    const femoop::Model& model = session.model();
    const double length = femoop::geometry_of(model, model[section.member]).length;
    ask_governing(workspace, number_at_section(section, drawn.back(), length));
}

// In space the left button turns the model, so a tool gets clicks alone.
void Canvas::click_in_space(Workspace& workspace, const Aim& aim, const Pick& under)
{
    if (workspace.tool_controller.can_type())
        carry_out(workspace.session, workspace.tool_controller.tool().move(work_in_hand(workspace.session), aim));
    if (!ImGui::IsMouseReleased(ImGuiMouseButton_Left)) return;
    press(workspace, aim);
    release(workspace, aim, under);
}

// In space the left button turns the model; with the space bar it moves the sheet everywhere.
void Canvas::move_camera(Session& session)
{
    const bool is_in_space = is_seen_in_space(session.model().analysis);
    const bool holds_space = ImGui::IsKeyDown(ImGui::GetKeyIndex(ImGuiKey_Space)) && !ImGui::GetIO().WantTextInput;
    const bool moves_view = !is_working_ && (holds_space || is_in_space);
    const ui::ViewMove hand = view_move({.left = moves_view, .move_at_once = holds_space && !is_working_});
    if (hand.wheel == 0.0 && !hand.is_drag()) return;
    Camera changed = plan_.camera;
    const ui::Point cursor = pointer() - corner_of_panel(pointer());
    std::visit([&](auto& camera) { camera.zoom(cursor, hand.zoom()); }, changed);
    auto* const orbit = std::get_if<ui::OrbitCamera>(&changed);
    if (orbit != nullptr && hand.is_left && !holds_space) orbit->orbit(hand.drag, middle_of(shape_));
    else std::visit([&](auto& camera) { camera.pan(hand.drag); }, changed);
    session.draw_state.camera = changed;
}

namespace {

Highlight highlight(const Selection& selection)
{
    Highlight chosen;
    for (const Part& part : selection.parts()) {
        if (const auto* const node = std::get_if<femoop::NodeId>(&part)) chosen.nodes.push_back(*node);
        if (const auto* const member = std::get_if<femoop::MemberId>(&part)) chosen.members.push_back(*member);
        if (const auto* const line = std::get_if<DimensionPlace>(&part)) chosen.dimensions.push_back(*line);
    }
    return chosen;
}

} // namespace

DrawState Canvas::state(const Workspace& workspace) const
{
    const Session& session = workspace.session;
    DrawState state = session.draw_state;
    state.camera = session.draw_state.camera.value_or(plan_.camera);
    state.selection = highlight(session.selection);
    light_step(state.selection, workspace);
    return state;
}

// The structure, its results and the reading that is pinned.
Subject::Picture Canvas::draw(const Workspace& workspace, const DrawOptions& options, const DrawState& state,
                              ui::Painter& painter) const
{
    const Session& session = workspace.session;
    if (session.model().nodes.empty()) {
        if (workspace.tool_controller.kind() != ToolKind::Paste)
            ui::draw_invitation(painter, ui::Theme(options.theme),
                                {options.tr("M draws members, N nodes, S supports, L loads."),
                                 options.tr("Ctrl+O opens a file, Ctrl+K finds a command.")});
        return {};
    }
    const std::optional<GuessPicture> guess = guess_picture(session, options);
    const std::vector<NodeNumbers> numbers = node_numbers(workspace);
    Subject::Picture picture = Subject(input_of(workspace, options, guess, numbers), options, state).draw(painter);
    if (!shown_mechanism(workspace) && !picture.plan.panels.empty())
        draw_loose_part(painter, session, options, Projection(picture.plan.camera, picture.plan.panels.front().box.min),
                        shape_);
    if (session.pin && explained_step(workspace) == nullptr && shown_refusal(workspace) == nullptr &&
        !plan_.panels.empty())
        draw_cut(session, options, picture, {*session.pin, plan_.panels.front().box.min}, painter);
    return picture;
}

void Canvas::draw_cut(const Session& session, const DrawOptions& options, const Subject::Picture& picture,
                      const SeenCut& seen, ui::Painter& painter) const
{
    const bool is_method_shown = session.influence.is_on(session.model()) || session.free_body.is_on(session.model()) ||
                                 shown_truss(session) != nullptr || shown_funicular(session) != nullptr ||
                                 shown_work(session) != nullptr || options.show.contains(Show::Counting);
    if (session.hidden || is_method_shown) return;
    const ui::Point at = Projection(picture.plan.camera, seen.panel)(shape_[seen.cut.member].at(seen.cut.x));
    const drawing::ReadingCard card{.plan = picture.plan, .cut = seen.cut, .beside = at, .top = picture.legend_bottom};
    if (!session.shows_train_envelope())
        return draw_reading(painter, {session.model(), session.shown_results()}, options, card);
    if (shown_envelope(session) != nullptr)
        draw_reading(painter, session.model(), options, card, envelope_lines(session, seen.cut));
}

ui::Picture Canvas::picture_of(const Workspace& workspace) const
{
    DrawState plain = state(workspace);
    plain.hover = plain.selection = {};
    return painted([&](ui::Painter& painter) { draw(workspace, seen_options(workspace), plain, painter); });
}

void Canvas::paint_all(const Workspace& workspace, ui::Painter& painter)
{
    const Session& session = workspace.session;
    const DrawOptions shown = seen_options(workspace);
    const DrawState now = state(workspace);
    drawn_ = draw(workspace, shown, now, painter);
    if (std::exchange(is_just_fitted_, false)) was_whole_ = drawn_.is_whole;
    if (session.hover && session.hover != session.pin && !is_working_ && shown_refusal(workspace) == nullptr)
        draw_cut(session, shown, drawn_, {*session.hover, hover_panel_}, painter);
    const ui::Theme theme(shown.theme);
    if ((is_over() || is_active()) && !plan_.panels.empty())
        draw_hand(painter, session, workspace.tool_controller, Projection(*now.camera, hover_panel_), theme);
    else if (!workspace.tool_controller.typed().empty()) draw_typed(painter, workspace.tool_controller, theme);
}

} // namespace frame
