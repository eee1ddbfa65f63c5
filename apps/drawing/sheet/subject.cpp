#include "apps/drawing/sheet/subject.h"

#include "apps/drawing/draw.h"
#include "apps/drawing/loads/loads.h"
#include "apps/drawing/results/counting_marks.h"
#include "apps/drawing/results/deformed.h"
#include "apps/drawing/results/diagram.h"
#include "apps/drawing/results/envelope_cases.h"
#include "apps/drawing/results/envelope_reactions.h"
#include "apps/drawing/results/free_body_picture.h"
#include "apps/drawing/results/funicular_picture.h"
#include "apps/drawing/results/influence_picture.h"
#include "apps/drawing/results/mechanism_picture.h"
#include "apps/drawing/results/reactions.h"
#include "apps/drawing/results/thrust_line.h"
#include "apps/drawing/results/work_picture.h"
#include "apps/drawing/sheet/diagram_overlay.h"
#include "apps/drawing/sheet/legend.h"
#include "apps/drawing/structure/dimensions.h"
#include "apps/drawing/structure/drawn_dimensions.h"
#include "apps/drawing/structure/members.h"
#include "apps/drawing/structure/node_numbers.h"
#include "apps/drawing/structure/supports.h"
#include "apps/drawing/truss/beside_truss.h"
#include "apps/drawing/truss/truss_drawing.h"
#include "femoop/io/counting/counting_text.h"
#include "femoop/io/virtual_work/virtual_work_text.h"
#include "ui/paint/wrapped_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

namespace drawing {

namespace {

constexpr std::array diagrams{Show::N, Show::V, Show::Vy, Show::Vz, Show::M, Show::T, Show::My, Show::Mz};
constexpr double edge = 14.0;                                        // [px] kept free around a fitted picture
constexpr double clearly = 1.02;                                     // larger
constexpr ui::World2 empty_least{-1.0, -1.0}, empty_most{11.0, 7.0}; // corners of an empty sheet
constexpr ui::World3 empty_corner{-1.0, -1.0, 0.0}, full_corner{9.0, 9.0, 5.0}; // of one in space

bool shows_any(const ShowSet& show, std::span<const Show> items)
{
    return std::any_of(items.begin(), items.end(), [&](Show item) { return show.contains(item); });
}

/// Draws what one panel shows, part by part, and collects the heads that stand over it.
class PanelPicture {
public:
    /// \param line  the influence line that it shows, if it shows one; null: none
    PanelPicture(const Scene& scene, const DrawInput& input, ui::Size size, const InfluencePicture* line)
        : scene_(scene), input_(input), size_(size), line_(line)
    {}

    /// The overlay goes with the moments; where they are not shown at all it stands by itself.
    void draw_overlay_alone() { is_overlay_alone_ = true; }

    /// \param envelope  drawn in place of the case; none where it is null
    void draw_solved(const SolvedCase* solved, const EnvelopePicture* envelope)
    {
        const bool is_behind = solved && scene_.shows(Show::Deformed) && !shows_any(scene_.show, diagrams);
        draw_highlights(scene_);
        draw_members(scene_, is_behind ? Presence::Behind : Presence::Subject);
        if (scene_.shows(Show::Influence) && line_ != nullptr) draw_influence_line(*line_);
        if (envelope != nullptr) draw_bands(*envelope);
        else if (solved) draw_results(*solved);
        if (is_overlay_alone_ && envelope == nullptr && has_overlay()) draw_overlay();
        draw_structure();
        if (scene_.shows(Show::Loads)) draw_loads(scene_);
        if (scene_.shows(Show::Reactions)) {
            if (envelope != nullptr) draw_reaction_ranges(scene_, *envelope);
            else if (solved) draw_reactions(scene_, *solved);
        }
        finish();
    }

    void draw_lifted(const FreeBodyPicture& lifted)
    {
        draw_highlights(scene_);
        draw_members(scene_, Presence::Behind);
        draw_structure();
        draw_free_body(scene_, lifted);
        heads_.push_back({.name = scene_.options.tr("Free body"), .note = {}});
        finish();
    }

    void draw_worked(const TrussPicture& picture)
    {
        if (scene_.shows(Show::Truss)) {
            const ui::Box panel = ui::box_at(scene_.projection.shift(), size_);
            draw_beside_truss(scene_, picture, panel);
            heads_.push_back(beside_truss_head(scene_, picture, panel));
            return;
        }
        draw_highlights(scene_);
        draw_truss(scene_, picture);
        heads_.push_back(truss_head(scene_, picture));
        draw_structure();
        finish();
    }

    void draw_funicular_beside(const FunicularPicture& picture)
    {
        if (scene_.shows(Show::ForcePolygon)) {
            const ui::Box panel = ui::box_at(scene_.projection.shift(), size_);
            draw_force_polygon(scene_, picture, panel);
            heads_.push_back(force_polygon_head(scene_, picture, panel));
            return;
        }
        draw_highlights(scene_);
        draw_members(scene_, Presence::Subject);
        draw_funicular(scene_, picture);
        heads_.push_back(funicular_head(scene_, picture));
        draw_structure();
        if (scene_.shows(Show::Loads)) draw_loads(scene_);
        finish();
    }

    /// One side of virtual work: under the loads, or under the unit load.
    void draw_side(const SolvedCase* solved)
    {
        draw_solved(solved, nullptr);
        const bool is_unit = scene_.shows(Show::UnitLoad);
        const ui::Catalogue& tr = scene_.options.tr;
        heads_.front().name = is_unit ? tr("Under the unit load: f") : tr("Under the loads: F");
        constexpr double narrow = 24.0, low = 11.0; // [em]: a note of signs would take two lines from the diagram
        const double em = scene_.sketch.theme().type().normal;
        if (std::min(size_.width / narrow, size_.height / low) < em) heads_.back().note.clear();
        if (size_.height < low * em && heads_.size() == 2) merge_heads();
    }

    void draw_mechanism(const femoop::Mechanism& mechanism)
    {
        draw_highlights(scene_);
        draw_members(scene_, Presence::Behind);
        draw_motion(scene_, mechanism);
        draw_structure();
        finish();
    }

    const std::vector<PanelHead>& heads() const { return heads_; }

private:
    /// One line where the panel has no room for two: the name of the side with the scale of its diagram.
    void merge_heads()
    {
        heads_.back().name = heads_.front().name;
        heads_.erase(heads_.begin());
    }

    bool shows_forces() const { return scene_.shows(Show::Loads) || scene_.shows(Show::Reactions); }

    void draw_bands(const EnvelopePicture& envelope)
    {
        for (const Show item : diagrams) {
            if (!scene_.shows(item)) continue;
            std::vector<Diagram> drawn;
            for (const femoop::MemberComponent component : components(item, scene_.model.analysis))
                if (const EnvelopeBands* const bands = envelope.find(component))
                    drawn.push_back(make_diagram(scene_, component, bands->largest(), size_));
            if (drawn.empty()) continue;
            use_one_scale(drawn);
            for (const Diagram& diagram : drawn) draw_envelope(scene_, envelope, diagram);
            heads_.push_back(diagram_head(scene_, drawn));
            if (item == Show::M && has_overlay()) heads_.push_back(input_.overlay->head(scene_));
        }
    }

    bool has_overlay() const { return input_.overlay != nullptr && !input_.overlay->is_empty(); }

    void draw_overlay()
    {
        input_.overlay->draw_alone(scene_);
        heads_.push_back(input_.overlay->head(scene_));
    }

    void draw_overlay_beside(const SolvedCase& solved, const Diagram& moments)
    {
        input_.overlay->draw_beside(scene_, solved, moments);
        heads_.push_back(input_.overlay->head(scene_));
    }

    // What the unit load on the path does where the line is asked for.
    void mark_effect_of(const femoop::MovingEffect& effect, const SolvedCase& solved, const std::vector<Diagram>& drawn)
    {
        for (const Diagram& diagram : drawn)
            if (effect.member && effect.at && effect.component == diagram.component)
                mark_effect(scene_, solved, diagram, effect);
    }

    // The former solution of the same case, to the scale of the present one or a part of it. Returns its denominator.
    int draw_former(const std::vector<Diagram>& present)
    {
        if (input_.reference == nullptr) return 1;
        const femoop::Model& model = input_.reference->model;
        const auto counterpart = input_.reference->counterpart(scene_.model, scene_.options.load_case);
        const auto solved = counterpart ? solved_case(input_.reference->results, *counterpart) : std::nullopt;
        if (!solved || model.analysis != scene_.model.analysis) return 1;
        const StructureShape shape = shape_of(model);
        const Scene former{model,        shape,         scene_.projection, scene_.options, scene_.state,
                           scene_.units, scene_.sketch, scene_.detail,     scene_.show};
        if (!std::exchange(has_former_members_, true)) draw_reference_members(former, scene_);
        double most_before = 0.0, most_now = 0.0;
        for (const Diagram& diagram : present) {
            most_before = std::max(most_before, largest_value(*solved, diagram.component, shape.size));
            most_now = std::max(most_now, diagram.largest);
        }
        if (!(most_now > 0.0)) return 1;
        const int part = part_of_scale(most_before, most_now);
        for (const Diagram& diagram : present) draw_reference(former, *solved, diagram, 1.0 / part);
        return part;
    }

    void draw_results(const SolvedCase& solved)
    {
        for (const Show item : diagrams) {
            if (!scene_.shows(item)) continue;
            std::vector<Diagram> drawn;
            for (const femoop::MemberComponent component : components(item, scene_.model.analysis))
                drawn.push_back(make_diagram(scene_, solved, component, size_));
            if (drawn.empty()) continue;
            use_one_scale(drawn);
            const int part = draw_former(drawn);
            for (const Diagram& diagram : drawn) draw_diagram(scene_, solved, diagram);
            if (input_.influence != nullptr) mark_effect_of(input_.influence->line.effect, solved, drawn);
            heads_.push_back(diagram_head(scene_, drawn));
            if (part > 1)
                heads_.back().note += " · " + scene_.options.tr("before: to 1/{count} of this scale",
                                                                {{"count", std::to_string(part)}});
            const bool is_of_moments = item == Show::M && input_.influence == nullptr;
            if (is_of_moments && has_overlay()) draw_overlay_beside(solved, drawn.front());
        }
        if (scene_.shows(Show::Thrust)) heads_.push_back(thrust_head(scene_, draw_thrust(scene_, solved)));
        if (!scene_.shows(Show::Deformed)) return;
        const double scale = deformation_scale(scene_, solved, size_);
        draw_deformed(scene_, solved, scale);
        heads_.push_back(deformed_head(scene_, scale));
    }

    void draw_influence_line(const InfluencePicture& picture)
    {
        const InfluenceScale scale = influence_scale(scene_, picture, size_);
        draw_influence(scene_, picture, scale);
        heads_.push_back(influence_head(scene_, picture, scale));
        if (&picture != input_.influence || !has_overlay()) return;
        input_.overlay->draw_on_line(scene_, picture, scale);
        heads_.push_back(input_.overlay->head(scene_));
    }

    // My and Mz in one picture are compared by eye.
    static void use_one_scale(std::vector<Diagram>& list)
    {
        double largest = 0.0;
        double scale = 0.0;
        for (const Diagram& diagram : list) {
            if (diagram.largest <= largest) continue;
            largest = diagram.largest;
            scale = diagram.pixels_per_unit;
        }
        for (Diagram& diagram : list) diagram.pixels_per_unit = diagram.largest > 0.0 ? scale : 0.0;
        std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.largest > b.largest; });
    }

    void draw_structure()
    {
        {
            const ui::LayerScope layer(scene_.sketch.painter(), ui::Layer::Symbols);
            draw_supports(scene_);
        }
        draw_joints(scene_);
    }

    void finish()
    {
        if (scene_.shows(Show::LocalAxes)) draw_local_axes(scene_);
        if (scene_.shows(Show::Counting) && input_.counting != nullptr) draw_counting(scene_, *input_.counting);
        draw_names(scene_);
        if (scene_.shows(Show::NodeNumbers)) draw_node_numbers(scene_, input_.numbers);
        if (scene_.shows(Show::DrawnDimensions)) draw_drawn_dimensions(scene_, input_.dimensions);
        if (scene_.shows(Show::Dimensions)) draw_dimensions(scene_);
        if (heads_.empty() || (!scene_.shows(Show::Influence) && shows_forces()))
            heads_.insert(heads_.begin(), structure_head(scene_));
    }

    const Scene& scene_;
    const DrawInput& input_;
    ui::Size size_;
    const InfluencePicture* line_;
    std::vector<PanelHead> heads_;
    bool is_overlay_alone_ = false, has_former_members_ = false;
};

/// Without what a kind of model does not have, such as N in a grillage.
ShowSet without_absent(ShowSet show, femoop::AnalysisKind kind)
{
    for (const Show item : diagrams)
        if (components(item, kind).empty()) show.erase(item);
    if (kind != femoop::AnalysisKind::Frame2d) show.erase(Show::Thrust);
    return show;
}

/// Where panels get small, so do type, lines and symbols, as far as they can still be read.
/// \param aspect  of the structure: the side of the panel that it does not fill may be shorter
ui::Theme theme_for(const ui::Theme& theme, ui::Size panel, double aspect)
{
    constexpr double least_share = 0.75, least_type = 11.0;
    const bool is_wide = aspect * panel.height > panel.width;
    const ui::Size ample = is_wide ? ui::Size{400.0, 180.0} : ui::Size{250.0, 280.0}; // for symbols of scale 1
    const double share = std::min(panel.width / ample.width, panel.height / ample.height) / theme.symbol_scale();
    const double least = std::max(least_share, least_type / theme.type().normal);
    return share < 1.0 ? theme.scaled(std::max(least, share)) : theme;
}

} // namespace

namespace {

bool has_results_of_its_own(const DrawInput& input)
{
    return input.results && input.results->n_members() == input.model.members.size() &&
           input.results->n_nodes() == input.model.nodes.size();
}

} // namespace

Subject::Subject(DrawInput input, const DrawOptions& options, const DrawState& state)
    : input_(std::move(input)),
      options_(options),
      state_(state),
      theme_(options.theme),
      units_(display_units(input_.model, options)),
      shape_(shape_of(input_.model))
{
    is_solved_ = has_results_of_its_own(input_) && options.load_case.index < input_.results->n_cases();
}

const Subject::Cases& Subject::cases() const
{
    if (cases_) return *cases_;
    Cases& read = cases_.emplace();
    if (is_solved_) read.shown = solved_case(*input_.results, options_.load_case);
    const bool has_cases = input_.model.n_cases() > 0; // or trains alone
    if (options_.is_envelope && input_.envelope == nullptr && has_results_of_its_own(input_) && has_cases)
        read.envelope = envelope_of_cases();
    return read;
}

EnvelopePicture Subject::envelope_of_cases() const
{
    std::vector<SolvedCase> all;
    for (const femoop::CaseId id : envelope_cases(input_.model, options_))
        all.push_back(*solved_case(*input_.results, id));
    EnvelopePicture envelope{.title = envelope_text(input_.model, options_), .names = names_of(all)};
    for (const femoop::MemberComponent component : shown_components(options_.show, input_.model.analysis)) {
        envelope.bands.push_back(bands_of(all, component));
        const bool is_zero = std::ranges::none_of(
            all, [&](const SolvedCase& solved) { return largest_value(solved, component, shape_.size) > 0.0; });
        if (is_zero) envelope.bands.back().members.clear();
    }
    if (options_.show.contains(Show::Reactions)) envelope.reactions = reaction_bands_of(all, input_.model.nodes.size());
    return envelope;
}

const EnvelopePicture* Subject::envelope() const
{
    if (input_.envelope != nullptr && options_.is_envelope) return input_.envelope;
    return cases().envelope ? &*cases().envelope : nullptr;
}

Camera Subject::starting_camera() const { return state_.camera ? *state_.camera : usual_camera(); }

Camera Subject::usual_camera() const
{
    if (is_seen_in_space(input_.model.analysis)) return ui::OrbitCamera();
    return ui::PlaneCamera();
}

double Subject::aspect(const Camera& camera) const
{
    const Projection projection(camera);
    if (shape_.nodes.empty()) return 1.0;
    ui::Box box{projection(shape_.nodes.front()), projection(shape_.nodes.front())};
    for (const Eigen::Vector3d& node : shape_.nodes) box = ui::united(box, {projection(node), projection(node)});
    const double least = 1e-3 * std::max(box.width(), box.height());
    return std::max(box.width(), least) / std::max({box.height(), least, 1e-12});
}

ui::Box Subject::area(ui::Size sheet, const ui::Fonts& fonts) const
{
    ui::Box area{{0.0, 0.0}, {sheet.width, sheet.height}};
    if (options_.show.contains(Show::Legend))
        area.min.y += head_height(sheet_head(input_, options_), theme_, fonts, sheet.width);
    const double foot_height = most_foot_height(sheet, fonts);
    if (foot_height > 0.0) area.max.y -= 14.0 + foot_height;
    if (has_curve()) area.max.y -= curve_height(theme_, sheet);
    if (shows_work()) area.max.y -= work_table(sheet, fonts).height();
    return area;
}

// Lines that are kept stand first, each for itself.
std::vector<ShowSet> Subject::contents(std::size_t n_kept) const
{
    const ShowSet of_line = (options_.show & ShowSet{Show::Values, Show::NodeNames, Show::Legend}) |
                            ShowSet{Show::Influence};
    std::vector<ShowSet> all(n_kept, of_line);
    const std::vector<ShowSet> own = panel_contents({.show = without_absent(options_.show, input_.model.analysis),
                                                     .layout = options_.layout,
                                                     .has_results = is_solved_ || envelope() != nullptr});
    all.insert(all.end(), own.begin(), own.end());
    return all;
}

// Where there is no room for all kept lines those that were kept last.
std::vector<Panel> Subject::panels_of(std::size_t n_kept, const ui::Box& room, std::size_t columns) const
{
    std::vector<Panel> list = panels(contents(n_kept), room, columns);
    const std::size_t first = input_.kept_lines.size() - n_kept;
    for (std::size_t i = 0; i < n_kept; ++i) list[i].line = input_.kept_lines[first + i];
    return list;
}

// A beam is seen on a low panel, and compared place by place with the next one; any other structure is a blob there.
bool Subject::is_flat_row() const
{
    constexpr double flat = 4.0; // width of its height
    return !is_seen_in_space(input_.model.analysis) && aspect(starting_camera()) >= flat;
}

// So many that each panel is as high as its heads and the structure with its marks need.
std::size_t Subject::n_kept_with_room(const ui::Box& room, std::size_t columns) const
{
    const double structure = is_flat_row() ? 4.5 : 10.0; // lines of text
    const double least = (1.6 + structure) * theme_.type().normal + 1.4 * theme_.type().small;
    const std::size_t n_kept = input_.kept_lines.size(), n_own = contents(0).size();
    const std::size_t n_rows = std::max<std::size_t>(1, static_cast<std::size_t>(room.height() / least));
    const std::size_t n_panels = n_rows * columns;
    return n_panels > n_own ? std::min(n_kept, n_panels - n_own) : 0;
}

// Beside one another, as a class compares them; a flat truss over its diagram, where it does not become smaller there.
Subject::Plan Subject::plan_with_diagram(const ui::Box& room, const ui::Fonts& fonts) const
{
    const auto laid_out = [&](std::size_t columns) {
        std::vector<Panel> both = panels(contents(0), room, columns);
        Camera camera = fitted(both, fonts);
        return Plan{std::move(both), std::move(camera)};
    };
    Plan plan = laid_out(is_stacked(room) ? 1 : 2);
    if (shows_truss() && is_stacked(room)) {
        Plan beside = laid_out(2);
        if (Projection(beside.camera).scale() > clearly * Projection(plan.camera).scale()) plan = std::move(beside);
    }
    if (state_.camera) plan.camera = *state_.camera;
    return plan;
}

// Panels beside one another only where the structure becomes clearly larger by it, or more of the lines that are kept
// have room; those of a beam are compared place by place, one below the other.
Subject::Plan Subject::plan(ui::Size sheet, const ui::Fonts& fonts) const
{
    const ui::Box room = area(sheet, fonts);
    if (has_diagram()) return plan_with_diagram(room, fonts);
    std::size_t n_kept = n_kept_with_room(room, 1);
    std::vector<Panel> list = panels_of(n_kept, room, 1);
    const bool has_kept = !input_.kept_lines.empty();
    const std::size_t n_panels = contents(input_.kept_lines.size()).size();
    if (n_panels == 1 && state_.camera) return {std::move(list), *state_.camera};
    Camera camera = fitted(list, fonts);
    const std::size_t most_columns = !has_kept ? n_panels : is_flat_row() ? 1 : 2;
    for (std::size_t columns = 2; columns <= most_columns; ++columns) {
        const std::size_t n_there = n_kept_with_room(room, columns);
        std::vector<Panel> others = panels_of(n_there, room, columns);
        Camera other = fitted(others, fonts);
        const bool is_larger = Projection(other).scale() > clearly * Projection(camera).scale();
        if (n_there < n_kept || (n_there == n_kept && !is_larger)) continue;
        n_kept = n_there;
        list = std::move(others);
        camera = std::move(other);
    }
    return {std::move(list), state_.camera ? *state_.camera : std::move(camera)};
}

// A flat truss over the joint that it is taken apart at has twice the room.
bool Subject::is_stacked(const ui::Box& room) const
{
    if (room.width() <= room.height()) return true;
    if (!shows_truss() || shape_.nodes.empty()) return false;
    constexpr double flat = 2.2;   // width of its height
    constexpr double lines = 30.0; // of text that the two need
    constexpr double square = 2.0; // width of the room's height in which a Cremona diagram is no larger beside it
    Eigen::Vector3d least = shape_.nodes.front(), most = least;
    for (const Eigen::Vector3d& node : shape_.nodes) {
        least = least.cwiseMin(node);
        most = most.cwiseMax(node);
    }
    if (most.x() - least.x() <= flat * (most.y() - least.y())) return false;
    return input_.truss->diagram ? room.width() < square * room.height() : room.height() > lines * theme_.type().normal;
}

std::vector<Eigen::Vector3d> Subject::fitted_points() const
{
    std::vector<Eigen::Vector3d> points = shape_.nodes;
    if (input_.free_body) std::ranges::move(places_of(*input_.free_body, shape_), std::back_inserter(points));
    if (shows_funicular()) std::ranges::move(places_of(*input_.funicular), std::back_inserter(points));
    if (has_curve()) std::ranges::move(ends_of_curve(), std::back_inserter(points));
    if (options_.show.contains(Show::DrawnDimensions)) {
        const std::vector<Eigen::Vector3d> ends = ends_of_dimensions(input_.model, input_.dimensions);
        points.insert(points.end(), ends.begin(), ends.end());
    }
    if (!options_.show.contains(Show::Dimensions) || !is_seen_in_space(input_.model.analysis)) return points;
    const std::vector<Eigen::Vector3d> corners = dimensioned_corners(shape_);
    points.insert(points.end(), corners.begin(), corners.end());
    return points;
}

void Subject::fit(Camera& camera, ui::Size panel, const ui::Margins& margins) const
{
    if (auto* plane = std::get_if<ui::PlaneCamera>(&camera)) {
        std::vector<ui::World2> points;
        for (const Eigen::Vector3d& p : fitted_points()) points.push_back({p.x(), p.y()});
        if (points.empty()) points = {empty_least, empty_most};
        plane->fit(points, panel, margins);
        return;
    }
    std::vector<ui::World3> points;
    for (const Eigen::Vector3d& p : fitted_points()) points.push_back({p.x(), p.y(), p.z()});
    if (points.empty()) points = {empty_corner, full_corner};
    std::get<ui::OrbitCamera>(camera).fit(points, panel, margins);
}

ui::Margins Subject::needed_margins(const std::vector<Panel>& panels, const Camera& camera, const ui::Fonts& fonts,
                                    Fit fit) const
{
    ui::Margins margins{edge, edge, edge, edge};
    const ui::Size size = panels.front().box.size();
    for (const Panel& panel : panels) {
        if (is_diagram(panel)) continue; // which fits itself
        ui::Painter scratch(size, fonts);
        const Panel at_origin{ui::box_at({}, size), panel.show, panel.line};
        const Drawn drawn = draw_panel(scratch, at_origin, camera, Pass::Measure);
        const auto& marks = fit == Fit::Roomy ? drawn.bounds : drawn.tight_bounds;
        if (!marks) continue;
        const Projection projection(camera);
        ui::Box nodes = *marks;
        bool is_first = true;
        for (const Eigen::Vector3d& node : fitted_points()) {
            const ui::Box at{projection(node), projection(node)};
            nodes = is_first ? at : ui::united(nodes, at);
            is_first = false;
        }
        margins.left = std::max(margins.left, nodes.min.x - marks->min.x + edge);
        margins.right = std::max(margins.right, marks->max.x - nodes.max.x + edge);
        margins.top = std::max(margins.top, nodes.min.y - marks->min.y + edge + drawn.heads_height);
        margins.bottom = std::max(margins.bottom, marks->max.y - nodes.max.y + edge);
    }
    if (input_.overlay && !options_.show.contains(Show::M)) { // room to sketch in
        const double room = 0.2 * std::min(size.width, size.height);
        for (double* const margin : {&margins.left, &margins.right, &margins.top, &margins.bottom})
            *margin = std::max(*margin, room);
    }
    if (input_.motion) { // it moves to both sides
        margins.left = margins.right = std::max(margins.left, margins.right);
        margins.top = margins.bottom = std::max(margins.top, margins.bottom);
    }
    const auto limit = [](double& a, double& b, double room) {
        const double factor = std::min(1.0, 0.96 * room / (a + b));
        a *= factor;
        b *= factor;
    };
    limit(margins.left, margins.right, size.width);
    limit(margins.top, margins.bottom, size.height);
    return margins;
}

Camera Subject::fitted(const std::vector<Panel>& panels, const ui::Fonts& fonts, Fit fit) const
{
    Camera camera = starting_camera();
    const ui::Size size = panels.front().box.size();
    const double border = 0.16 * std::min(size.width, size.height);
    this->fit(camera, size, {border, border, border, border});
    // Marks keep their size on the sheet, so the room that they take changes little from one scale to the next.
    const auto needed = [&] { return Need{Projection(camera).scale(), needed_margins(panels, camera, fonts, fit)}; };
    Need before = needed();
    this->fit(camera, size, before.margins);
    Need now = needed();
    this->fit(camera, size, now.margins);
    // But for large diagrams, which grow with the structure: then it is found where both have room.
    constexpr int most_tries = 3;
    constexpr double good = 0.9;
    for (int i = 0; i < most_tries; ++i) {
        const Need then = needed();
        Camera next = camera;
        this->fit(next, size, then.margins);
        if (Projection(next).scale() > good * then.scale) break;
        before = std::exchange(now, then);
        fit_between(camera, size, before, now);
    }
    return camera;
}

void Subject::fit_between(Camera& camera, ui::Size panel, const Need& a, const Need& b) const
{
    const auto margins_at = [&](double scale) {
        const double t = a.scale == b.scale ? 1.0 : (scale - a.scale) / (b.scale - a.scale);
        const auto at = [t](double from, double to) { return std::max(edge, from + t * (to - from)); };
        return ui::Margins{.left = at(a.margins.left, b.margins.left),
                           .top = at(a.margins.top, b.margins.top),
                           .right = at(a.margins.right, b.margins.right),
                           .bottom = at(a.margins.bottom, b.margins.bottom)};
    };
    double least = 0.0, most = std::max(a.scale, b.scale);
    for (int i = 0; i < 20; ++i) {
        const double middle = 0.5 * (least + most);
        fit(camera, panel, margins_at(middle));
        (Projection(camera).scale() > middle ? least : most) = middle;
    }
}

Camera Subject::fitted(const std::vector<Panel>& panels, const ui::Fonts& fonts) const
{
    constexpr double worth_while = 1.3; // labels find other places then
    const Camera roomy = fitted(panels, fonts, Fit::Roomy), tight = fitted(panels, fonts, Fit::Tight);
    return Projection(tight).scale() > worth_while * Projection(roomy).scale() ? tight : roomy;
}

Subject::Drawn Subject::draw_panel(ui::Painter& painter, const Panel& panel, const Camera& camera, Pass pass) const
{
    const ui::ClipScope clip(painter, panel.box);
    const ui::Theme theme = keeps_type() ? theme_ : theme_for(theme_, panel.box.size(), aspect(usual_camera()));
    const Projection projection(camera, panel.box.min);
    const LevelOfDetail detail(shape_, projection);
    Sketch sketch({.painter = &painter,
                   .theme = &theme,
                   .room = panel.box.grown(-4.0),
                   .symbol_factor = options_.symbol_factor * detail.symbol_share(),
                   .is_reduced = detail.is_reduced(),
                   .is_measured = pass == Pass::Measure});
    const Side side = side_of(panel);
    const Scene scene{side.model, shape_, projection, side.options, side.state, side.units, sketch, detail, panel.show};
    PanelPicture picture(scene, input_, panel.box.size(), panel.line ? panel.line : input_.influence);
    const bool has_place = options_.show.contains(Show::M) || input_.influence != nullptr;
    if (!has_place && !shows_any(panel.show, diagrams)) picture.draw_overlay_alone();
    if (input_.free_body != nullptr) picture.draw_lifted(*input_.free_body);
    else if (shows_truss()) picture.draw_worked(*input_.truss);
    else if (shows_funicular()) picture.draw_funicular_beside(*input_.funicular);
    else if (shows_work()) picture.draw_side(side.solved);
    else if (const auto& motion = input_.motion) picture.draw_mechanism(motion->all[motion->shown]);
    else picture.draw_solved(cases().shown ? &*cases().shown : nullptr, envelope());
    Drawn drawn{.bounds = sketch.bounds(), .tight_bounds = sketch.tight_bounds(), .mark_bounds = sketch.mark_bounds()};
    const std::vector<ui::Box> rows = head_rows(picture.heads(), theme, painter.fonts(), panel);
    if (!rows.empty()) drawn.heads_height = rows.back().max.y - panel.box.min.y;
    if (pass == Pass::Measure) return drawn;
    for (const ui::Box& row : rows) sketch.reserve(row);
    sketch.write_captions();
    for (std::size_t i = 0; i < rows.size(); ++i) draw_panel_head(painter, picture.heads()[i], theme, rows[i]);
    drawn.n_left_out = sketch.n_left_out();
    drawn.grips = sketch.grips();
    if (panel.show.contains(Show::UnitLoad)) drawn.grips = {}; // no load of the model, and no number of its results
    return drawn;
}

Subject::Side Subject::side_of(const Panel& panel) const
{
    if (!shows_work() || !panel.show.contains(Show::UnitLoad))
        return {input_.model, options_, state_, units_, cases().shown ? &*cases().shown : nullptr};
    const UnitSide& unit = unit_side();
    return {input_.work->work.unit_model, unit.options, unit.state, unit.units, unit.solved ? &*unit.solved : nullptr};
}

const Subject::UnitSide& Subject::unit_side() const
{
    if (unit_side_) return *unit_side_;
    unit_side_ = {.options = options_,
                  .state = state_,
                  .units = units_.per(unit_load_measure(*input_.work)),
                  .solved = solved_case(input_.work->work.under_unit, femoop::CaseId(0))};
    unit_side_->options.load_case = femoop::CaseId(0);
    unit_side_->state.locked_scale.reset();
    return *unit_side_;
}

// The diagrams keep the larger part of what heads and foot leave.
const SheetTable& Subject::work_table(ui::Size sheet, const ui::Fonts& fonts) const
{
    constexpr double share_of_diagrams = 0.45; // of the sheet's height
    if (work_table_) return *work_table_;
    const auto rows = [this](std::size_t most) {
        return femoop::virtual_work::work_table(input_.work->work, input_.model, options_.tr, most);
    };
    double height = (1.0 - share_of_diagrams) * sheet.height;
    if (options_.show.contains(Show::Legend))
        height -= head_height(sheet_head(input_, options_), theme_, fonts, sheet.width);
    height -= 14.0 + foot(sheet, fonts).height();
    const auto& folded = femoop::virtual_work::foldable_columns;
    const auto& formulas = femoop::virtual_work::formula_columns;
    return work_table_.emplace(rows,
                               TableRoom{.width = sheet.width - 32.0,
                                         .height = height,
                                         .folded = {std::begin(folded), std::end(folded)},
                                         .shortened = {std::begin(formulas), std::end(formulas)}},
                               theme_, fonts);
}

std::vector<ui::Box> Subject::head_rows(const std::vector<PanelHead>& heads, const ui::Theme& theme,
                                        const ui::Fonts& fonts, const Panel& panel) const
{
    if (!panel.show.contains(Show::Legend) || input_.motion) return {};
    const double width = panel.box.width();
    std::vector<ui::Box> rows;
    ui::Point corner = panel.box.min;
    for (const PanelHead& head : heads) {
        rows.push_back(ui::box_at(corner, {width, head_height(head, theme, fonts, width)}));
        corner.y = rows.back().max.y;
    }
    return rows;
}

namespace {

void append(Grips& grips, const Grips& more)
{
    grips.loads.insert(grips.loads.end(), more.loads.begin(), more.loads.end());
    grips.supports.insert(grips.supports.end(), more.supports.begin(), more.supports.end());
    grips.dimensions.insert(grips.dimensions.end(), more.dimensions.begin(), more.dimensions.end());
    grips.numbers.insert(grips.numbers.end(), more.numbers.begin(), more.numbers.end());
}

bool holds(const ui::Box& box, const std::optional<ui::Box>& bounds) { return !bounds || box.contains(*bounds); }

} // namespace

Subject::Picture Subject::draw(ui::Painter& painter) const
{
    Picture picture{.plan = plan(painter.size(), painter.fonts())};
    const auto& [panels, camera] = picture.plan;
    if (options_.show.contains(Show::Legend)) draw_head(painter, sheet_head(input_, options_), theme_);
    std::size_t n_left_out = 0;
    for (const Panel& panel : panels) {
        const Drawn drawn = draw_panel(painter, panel, camera, Pass::Write);
        if (&panel == &panels.front()) picture.legend_bottom = panel.box.min.y + drawn.heads_height;
        n_left_out += drawn.n_left_out;
        append(picture.grips, drawn.grips);
        // A mark below the heads is not seen; a caption finds another place.
        const ui::Box below_heads{panel.box.min + ui::Point{0.0, drawn.heads_height}, panel.box.max};
        picture.is_whole = picture.is_whole && holds(panel.box, drawn.tight_bounds) &&
                           holds(below_heads, drawn.mark_bounds);
    }
    draw_foot(painter, picture.plan);
    const auto is_of_kept = [](const Panel& panel) { return panel.line != nullptr; };
    const auto n_kept = static_cast<std::size_t>(std::ranges::count_if(panels, is_of_kept));
    if (n_kept < input_.kept_lines.size())
        draw_left_out(painter, options_.tr("kept lines without room: {count}",
                                           {{"count", std::to_string(input_.kept_lines.size() - n_kept)}}));
    if (n_left_out > 0)
        draw_left_out(painter, options_.tr("labels without room: {count}", {{"count", std::to_string(n_left_out)}}));
    return picture;
}

namespace {

struct Spot {
    ui::Point at;
    ui::Anchor anchor;
};

/// For a line of text at the sheet's rim: its corners and the middle of its foot, then down the sides, beside the heads
/// first.
std::vector<Spot> spots_at_rim(const ui::Box& sheet, double line_height)
{
    using enum ui::Anchor;
    std::vector<Spot> spots{{sheet.max, BottomRight},
                            {{sheet.min.x, sheet.max.y}, BottomLeft},
                            {{sheet.max.x, sheet.min.y}, TopRight},
                            {{0.5 * (sheet.min.x + sheet.max.x), sheet.max.y}, Bottom}};
    for (double y = sheet.min.y + line_height; y < sheet.max.y - line_height; y += line_height) {
        spots.push_back({{sheet.max.x, y}, TopRight});
        spots.push_back({{sheet.min.x, y}, TopLeft});
    }
    return spots;
}

} // namespace

// In the first place at the rim where it covers no other string; at the right foot where there is none.
void Subject::draw_left_out(ui::Painter& painter, const std::string& words) const
{
    const std::vector<ui::Box> taken = painter.picture().text_boxes(painter.fonts());
    const auto style_at = [&](const Spot& spot) {
        ui::TextStyle style = theme_.text(ui::Role::FaintLabel, spot.anchor);
        style.size = theme_.type().small;
        style.plate = theme_.background();
        return style;
    };
    const auto is_free = [&](const Spot& spot) {
        ui::Painter trial(painter.size(), painter.fonts());
        trial.text(spot.at, words, style_at(spot));
        const ui::Box own = trial.picture().text_boxes(painter.fonts()).front().grown(3.0);
        return std::none_of(taken.begin(), taken.end(), [&](const ui::Box& box) { return own.overlaps(box); });
    };
    const std::vector<Spot> spots = spots_at_rim(painter.sheet().grown(-7.0), theme_.type().small);
    const auto found = std::find_if(spots.begin(), spots.end(), is_free);
    const Spot& chosen = found != spots.end() ? *found : spots.front();
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    painter.text(chosen.at, words, style_at(chosen));
}

bool Subject::shows_truss() const { return input_.truss != nullptr && options_.show.contains(Show::Truss); }
bool Subject::shows_funicular() const
{
    return input_.funicular != nullptr && options_.show.contains(Show::ForcePolygon);
}
bool Subject::shows_work() const
{
    return input_.work != nullptr && is_solved_ && options_.show.contains(Show::UnitLoad);
}
bool Subject::has_diagram() const { return shows_truss() || shows_funicular(); }

// The one picture of a window on the projector: a class reads its numbers, not those of the panels around it. Of virtual
// work a low structure stands twice over the table.
bool Subject::keeps_type() const
{
    const bool is_one = options_.layout == Layout::Overlay && !(shows_work() && is_flat_row());
    return is_one && theme_.name() == ui::ThemeName::Projector;
}

bool Subject::has_curve() const { return input_.influence != nullptr && input_.influence->curve; }

std::optional<Subject::LevelPath> Subject::level_path() const
{
    constexpr double nearness = 1e-6; // of the length
    const femoop::influence::PathLayout& path = input_.influence->path;
    if (path.members.empty() || is_seen_in_space(input_.model.analysis)) return std::nullopt;
    const auto end_of = [&](const femoop::influence::PathMember& on, double s) -> Eigen::Vector3d {
        const MemberShape& member = shape_[on.member];
        return member.start + on.x_of(s) * member.x();
    };
    const LevelPath found{end_of(path.members.front(), 0.0), end_of(path.members.back(), path.length())};
    const Eigen::Vector3d along = found.end - found.begin;
    const double slack = nearness * path.length();
    const bool is_level = std::abs(along.y()) <= slack && std::abs(along.norm() - path.length()) <= slack;
    return is_level && path.length() > 0.0 ? std::optional(found) : std::nullopt;
}

// Of a train that is longer than half the path the curve has the width of the sheet, and the path too.
std::vector<Eigen::Vector3d> Subject::ends_of_curve() const
{
    constexpr double most_beyond = 0.5; // of the path's length
    const auto path = level_path();
    const auto [from, to] = positions(*input_.influence->curve);
    const double length = input_.influence->path.length();
    if (!path || std::max(-from, to - length) > most_beyond * length) return {};
    const Eigen::Vector3d along = (path->end - path->begin) / length;
    return {path->begin + from * along, path->begin + to * along};
}

std::optional<PathOnSheet> Subject::path_on_sheet(const Plan& plan) const
{
    const auto path = level_path();
    const auto shows_line = [](const Panel& panel) { return panel.show.contains(Show::Influence); };
    const auto panel = std::ranges::find_if(plan.panels, shows_line);
    if (!path || panel == plan.panels.end()) return std::nullopt;
    const Projection projection(plan.camera, panel->box.min);
    return PathOnSheet{projection(path->begin).x, projection(path->end).x};
}

bool Subject::has_overlay_text() const
{
    return input_.overlay && is_solved_ && !options_.is_envelope && options_.show.contains(Show::M);
}

ui::TextStyle Subject::foot_style(const FootText& of, double type_size) const
{
    ui::TextStyle style = theme_.text(of.role, ui::Anchor::BottomLeft);
    style.size = type_size;
    style.weight = of.weight;
    return style;
}

namespace {

// The picture keeps the larger part of the sheet.
template <class Line> void cut_short(std::vector<Line>& lines, double line_height, double sheet_height)
{
    constexpr double share = 0.4;
    constexpr std::size_t least = 2;
    const std::size_t most = std::max(least, static_cast<std::size_t>(share * sheet_height / line_height));
    if (lines.size() <= most) return;
    lines.resize(most);
    lines.back().text += " …";
}

} // namespace

// Of a bar that is pointed at it says what is known.
std::vector<std::string> Subject::truss_sentences() const
{
    const TrussPicture& truss = *input_.truss;
    for (const femoop::MemberId bar : state_.hover.members)
        if (bar.index < truss.bar_sentences.size() && truss.is_found(bar)) return {truss.bar_sentences[bar.index]};
    return truss.stage().lines;
}

// The picture keeps its place from stage to stage.
double Subject::most_foot_height(ui::Size sheet, const ui::Fonts& fonts) const
{
    if (!shows_truss()) return foot(sheet, fonts).height();
    const double size = theme_.type().normal;
    std::size_t most = 0;
    for (const TrussStage& stage : input_.truss->stages)
        most = std::max(most, wrapped_foot(headed(stage.lines), size, sheet, fonts).size());
    for (const std::string& sentence : input_.truss->bar_sentences)
        most = std::max(most, wrapped_foot(headed({sentence}), size, sheet, fonts).size());
    return 1.4 * size * static_cast<double>(most);
}

// Long equations stand in small type, and are cut short where even so they would leave the picture too little.
Subject::Foot Subject::foot(ui::Size sheet, const ui::Fonts& fonts) const
{
    constexpr double share = 0.18; // of the sheet's height
    Foot found = foot_in(theme_.type().normal, sheet, fonts);
    if (!input_.free_body && !shows_work()) return found;
    if (found.height() > share * sheet.height) found = foot_in(theme_.type().small, sheet, fonts);
    shorten(found, sheet);
    return found;
}

Subject::Foot Subject::foot_in(double type_size, ui::Size sheet, const ui::Fonts& fonts) const
{
    return {wrapped_foot(foot_sentences(), type_size, sheet, fonts), type_size};
}

// Virtual work has a table beside it, whose last row the first line says.
void Subject::shorten(Foot& foot, ui::Size sheet) const
{
    const double share = shows_work() ? 0.13 : 0.3; // of the sheet's height
    const auto most = std::max<std::size_t>(2, static_cast<std::size_t>(share * sheet.height / foot.line_height()));
    if (foot.lines.size() <= most) return;
    const std::size_t n_left_out = foot.lines.size() - most + 1;
    foot.lines.resize(most);
    foot.lines.back().text = options_.tr("… {n} more lines: in the description in words",
                                         {{"n", std::to_string(n_left_out)}});
}

std::vector<std::string> Subject::method_sentences() const
{
    if (input_.free_body) return input_.free_body->equations;
    if (shows_truss()) return truss_sentences();
    if (shows_funicular()) return input_.funicular->sentences;
    if (shows_work()) return work_sentences(*input_.work, input_.model, units_, options_.tr);
    if (input_.influence) return line_sentences();
    if (has_overlay_text()) return input_.overlay->foot({input_.model, shape_, units_, options_.tr});
    return {};
}

// What comes first is the number, or what it all says. That there are no results is told as an error, and nothing else.
std::vector<Subject::FootText> Subject::foot_sentences() const
{
    std::vector<FootText> all;
    if (input_.motion) all.push_back({.text = input_.motion->sentence, .role = ui::Role::Error});
    else
        for (const std::string& reason : input_.reasons) all.push_back({.text = reason, .role = ui::Role::Error});
    std::vector<std::string> sentences;
    if (all.empty()) sentences = method_sentences();
    const bool is_plain = input_.free_body || shows_funicular();
    if (input_.counting && options_.show.contains(Show::Counting))
        std::ranges::move(femoop::counting::sum_lines(*input_.counting, input_.model, options_.tr),
                          std::back_inserter(sentences));
    std::vector<FootText> below = headed(sentences);
    if (is_plain && !below.empty()) below.front().weight = ui::Weight::Regular;
    std::ranges::move(below, std::back_inserter(all));
    return all;
}

/// The first one in bold.
std::vector<Subject::FootText> Subject::headed(const std::vector<std::string>& sentences)
{
    std::vector<FootText> all;
    for (const std::string& one : sentences)
        all.push_back({.text = one, .weight = all.empty() ? ui::Weight::Bold : ui::Weight::Regular});
    return all;
}

std::vector<std::string> Subject::line_sentences() const
{
    std::vector<std::string> sentences = input_.influence->sentences;
    if (input_.overlay)
        std::ranges::move(input_.overlay->foot({input_.model, shape_, units_, options_.tr}),
                          std::back_inserter(sentences));
    return sentences;
}

std::vector<Subject::FootText> Subject::wrapped_foot(const std::vector<FootText>& sentences, double type_size,
                                                     ui::Size sheet, const ui::Fonts& fonts) const
{
    std::vector<FootText> lines;
    for (const FootText& one : sentences)
        for (const std::string& line :
             ui::wrapped_lines(fonts, one.text, foot_style(one, type_size), sheet.width - 32.0))
            lines.push_back({.text = line, .role = one.role, .weight = one.weight});
    if (!input_.reasons.empty()) cut_short(lines, 1.4 * theme_.type().normal, sheet.height);
    return lines;
}

void Subject::draw_foot(ui::Painter& painter, const Plan& plan) const
{
    const ui::LayerScope layer(painter, ui::Layer::Overlay);
    const Foot foot = this->foot(painter.size(), painter.fonts());
    const double height = foot.height();
    double y = painter.sheet().max.y - 10.0 - height + foot.line_height();
    for (const FootText& line : foot.lines) {
        painter.text({16.0, y}, line.text, foot_style(line, foot.type_size));
        y += foot.line_height();
    }
    if (shows_work()) {
        const SheetTable& table = work_table(painter.size(), painter.fonts());
        table.draw(painter, {16.0, painter.sheet().max.y - 14.0 - height - table.height()});
    }
    if (!has_curve() || curve_height(theme_, painter.size()) <= 0.0) return;
    const double bottom = painter.sheet().max.y - 14.0 - height;
    draw_position_curve(painter, *input_.influence->curve,
                        {{0.0, bottom - curve_height(theme_, painter.size())}, {painter.size().width, bottom}},
                        {.theme = theme_, .units = units_, .tr = options_.tr, .path = path_on_sheet(plan)});
}

} // namespace drawing
