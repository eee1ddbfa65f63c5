#include "apps/plane/view/plate_picture.h"

#include <algorithm>
#include <limits>

#include "apps/drawing/sheet/legend.h"
#include "apps/plane/view/comparison.h"
#include "apps/plane/view/cut_panel.h"
#include "apps/plane/view/direction_marks.h"
#include "apps/plane/view/error_curve.h"
#include "apps/plane/view/field_picture.h"
#include "apps/plane/view/geometry_marks.h"
#include "apps/plane/view/load_marks.h"
#include "apps/plane/view/mesh_marks.h"
#include "apps/plane/view/mesher_picture.h"
#include "apps/plane/view/plate_scene.h"
#include "apps/plane/view/probe_marks.h"
#include "apps/plane/view/probe_panel.h"
#include "apps/plane/view/reaction_marks.h"
#include "apps/plane/view/singular_notice.h"
#include "apps/plane/view/support_marks.h"
#include "femoop/plane/mesh/mesh_geometry.h"

namespace plane {

namespace {

using Eigen::Vector2d;

constexpr double edge_margin = 14.0; // [px] about what is drawn
constexpr double flatness = 0.01;    // [px] that a curve may stray
constexpr int n_fits = 3;

void append(std::string& line, const std::string& part)
{
    if (!part.empty()) line += "  ·  " + part;
}

void draw_backdrop(const PlateScene& scene)
{
    const Backdrop* const backdrop = scene.input.backdrop;
    if (backdrop == nullptr) return;
    const auto [low, low_right, high_right, high] = backdrop->corners();
    const auto on_sheet = [&](const FlatPoint& p) { return scene.place({p.x, p.y}); };
    const ui::Point corner = on_sheet(high);
    const ui::LayerScope layer(scene.sketch.painter(), ui::Layer::Background);
    scene.sketch.painter().photo(backdrop->photo, {.corner = corner,
                                                   .right = on_sheet(high_right) - corner,
                                                   .down = on_sheet(low) - corner,
                                                   .opacity = backdrop->opacity});
}

/// The place whose state has a panel of its own.
std::optional<Vector2d> circled_probe(const PlateOptions& options)
{
    if (!options.circle || *options.circle >= options.probes.size()) return std::nullopt;
    return options.probes[*options.circle];
}

/// One sheet: where its head ends, and what is drawn below.
class PlateSheet {
public:
    PlateSheet(const PlateInput& input, const PlateOptions& options, const PlateState& state, ui::Size sheet,
               const ui::Fonts& fonts)
        : input_(input),
          options_(options),
          state_(state),
          theme_(options.theme),
          units_(display_units(input.model, options)),
          fonts_(fonts),
          mesh_(mesh_of(input))
    {
        find_result();
        find_fields();
        if (result_ != nullptr)
            for (const femoop::plane::Cut& cut : options.cuts)
                cuts_.push_back(cut_picture(*input.results, *result_, cut));
        decide_on_panels(sheet);
        if (shows(PlateShow::Legend)) head_ = {.title = input.model.title, .line = head_line()};
        const double top = head_.title.empty() && head_.line.empty()
                               ? 0.0
                               : drawing::head_height(head_, theme_, fonts, sheet.width);
        room_ = {{0.0, std::min(top, 0.4 * sheet.height)}, {sheet.width, sheet.height}};
        if (has_probe_panel_) room_.max.x -= probe_width_;
        right_ = room_.max.x;
        if (input.player != nullptr) room_.max.y -= step_foot_height(theme_);
        if (has_panels_below_)
            room_.max.y -= std::min(cut_panel_height(theme_),
                                    std::max(0.0, most_of_sheet * sheet.height - room_.min.y));
        room_.max.x -= width_of_legends(sheet);
        if (is_beside()) leave_left_half();
    }

    /// Fits the body, draws it unseen, and fits it again with the room that its marks took.
    ui::PlaneCamera fitted() const
    {
        const std::vector<ui::World2> body = places_of_body();
        if (body.empty()) return {};
        ui::Margins margins = margins_about({room_});
        ui::PlaneCamera camera;
        const ui::Size sheet{room_.max.x, room_.max.y};
        camera.fit(body, sheet, margins);
        for (int i = 0; i < n_fits; ++i) {
            ui::Painter unseen(sheet, fonts_);
            drawing::Sketch sketch({.painter = &unseen, .theme = &theme_, .room = room_, .is_measured = true});
            draw_marks(sketch, camera, Pass::Measured);
            margins = margins_for(sketch, bounds_of(body, camera));
            camera.fit(body, sheet, margins);
        }
        return camera;
    }

    void draw(ui::Painter& painter) const
    {
        {
            const ui::ClipScope clip(painter, room_);
            drawing::Sketch sketch({.painter = &painter, .theme = &theme_, .room = room_});
            draw_marks(sketch, state_.camera ? *state_.camera : fitted(), Pass::Drawn);
            sketch.write_captions();
        }
        if (is_beside()) {
            draw_kept(painter, state_.camera ? *state_.camera : fitted());
            write_titles(painter);
        }
        if (!head_.line.empty()) drawing::draw_head(painter, head_, theme_);
        if (input_.player != nullptr)
            draw_step_foot(painter, step_sentence(*input_.player, options_.tr), theme_, room_);
        if (has_panels_below_) draw_panels_below(painter);
        draw_circle_panel(painter);
        if (fields_.empty() || !shows(PlateShow::Legend)) return;
        const double share = room_.height() / static_cast<double>(fields_.size());
        for (std::size_t i = 0; i < fields_.size(); ++i) {
            const double top = room_.min.y + share * static_cast<double>(i);
            draw_legend(painter, fields_[i], units_, theme_, {{room_.max.x, top}, {right_, top + share}});
        }
    }

    const ui::Box& room() const { return room_; }

private:
    enum class Pass : std::uint8_t { Measured, Drawn };

    /// The share of a sheet's width or height that what stands beside the body may take.
    static constexpr double most_of_sheet = 0.54, at_most_of_sheet = 0.58;

    double width_of_legends(ui::Size sheet) const
    {
        if (fields_.empty() || !shows(PlateShow::Legend)) return 0.0;
        double width = 0.0;
        for (const FieldPicture& field : fields_) width = std::max(width, legend_width(field, units_, theme_, fonts_));
        return std::min(width, 0.4 * sheet.width);
    }

    /// Panels that would leave too little of the body, or none of their own type, are left out.
    void decide_on_panels(ui::Size sheet)
    {
        const double head = shows(PlateShow::Legend)
                                ? drawing::head_height({.title = input_.model.title, .line = head_line()}, theme_,
                                                       fonts_, sheet.width)
                                : 0.0;
        const double legends = width_of_legends(sheet), wanted = probe_panel_width(theme_, sheet.width);
        probe_width_ = std::max(least_probe_panel, std::min(wanted, most_of_sheet * sheet.width - legends));
        const bool is_wide = probe_width_ + legends <= at_most_of_sheet * sheet.width;
        const bool is_high = 0.7 * cut_panel_height(theme_) + head <= most_of_sheet * sheet.height &&
                             sheet.width >= 0.7 * cut_panel_width(theme_);
        has_probe_panel_ = circled_probe(options_).has_value() && is_wide;
        has_panels_below_ = wants_panels_below() && is_high;
        lacks_room_ = (circled_probe(options_).has_value() && !is_wide) || (wants_panels_below() && !is_high);
    }

    bool shows(PlateShow item) const { return options_.show.set.contains(item); }

    void find_result()
    {
        mode_ = shown_mode(input_, options_);
        if (input_.result != nullptr) result_ = input_.result;
        else if (input_.results != nullptr && options_.load_case.index < input_.results->n_cases() &&
                 (options_.show.needs_results() || !options_.probes.empty() || !options_.cuts.empty()))
            result_ = &made_result_.emplace((*input_.results)[options_.load_case]);
        if (mesh_ == nullptr) return;
        places_ = femoop::plane::positions(*mesh_);
        if (mode_ != nullptr) {
            places_ = moved_by(*mesh_, mode_->shape, state_.phase);
            widest_places_ = moved_by(*mesh_, mode_->shape, 1.0);
        }
        if (input_.motion != nullptr) places_ = moved_by(*mesh_, *input_.motion, state_.phase);
        if (is_beside()) kept_places_ = femoop::plane::positions(input_.kept_results->model());
        if (result_ == nullptr || !shows(PlateShow::Deformed)) return;
        magnification_ = magnification(input_, *result_, options_);
        places_ = displaced(*mesh_, *result_, magnification_ * state_.phase);
        if (input_.is_compared())
            kept_places_ = displaced(input_.kept_results->model(), *input_.kept_result, magnification_ * state_.phase);
    }

    /// Errors in place of bands: both fill the body.
    std::vector<FieldPicture> fields_of(const femoop::plane::PlaneCase& result, const PlateOptions& options) const
    {
        std::vector<FieldPicture> fields;
        if (shows(PlateShow::Error)) fields.push_back(error_picture(result, options));
        for (const FieldShow& show : options.show.fields)
            if (show.style == FieldStyle::Contours || !shows(PlateShow::Error))
                fields.push_back(field_picture(show, result, options, units_));
        const bool has_stresses = !fields.empty() && shows_stresses(options);
        if (const auto note = has_stresses && input_.drawing != nullptr ? singular_note(*input_.drawing, options)
                                                                        : std::nullopt)
            fields.front().notes.push_back(*note);
        std::ranges::stable_sort(fields, {}, &FieldPicture::style); // lines over bands
        return fields;
    }

    void find_fields()
    {
        if (result_ == nullptr) return;
        fields_ = fields_of(*result_, options_);
        if (!is_beside()) return;
        kept_fields_ = fields_of(*input_.kept_result, options_);
        if (fields_.size() == 1 && !options_.range) share_range();
    }

    /// Both bodies in the same colours: from the least to the largest value of both.
    void share_range()
    {
        const FieldPicture &now = fields_.front(), &kept = kept_fields_.front();
        PlateOptions options = options_;
        options.range = {now.shown * std::min(now.levels.front(), kept.levels.front()),
                         now.shown * std::max(now.levels.back(), kept.levels.back())};
        fields_ = fields_of(*result_, options);
        kept_fields_ = fields_of(*input_.kept_result, options);
        for (std::string& note : fields_.front().notes)
            if (note == options.tr("fixed range")) note = options.tr("one range for both");
    }

    /// What is drawn of a body.
    struct Body {
        const PlateInput& input;
        const femoop::plane::PlaneModel* mesh;
        const femoop::plane::PlaneCase* result;
        const PlaceLine& places;
    };
    PlateScene scene_of(const Body& body, const PlateOutline& outline, const ui::PlaneCamera& camera,
                        drawing::Sketch& sketch) const
    {
        return {.input = body.input,
                .options = options_,
                .state = state_,
                .outline = outline,
                .camera = camera,
                .units = units_,
                .sketch = sketch,
                .mesh = body.mesh,
                .result = body.result,
                .places = &body.places,
                .magnification = magnification_ * state_.phase};
    }

    // ---- two bodies side by side

    bool is_beside() const { return options_.is_beside && input_.is_compared(); }

    void leave_left_half()
    {
        beside_ = 0.5 * room_.width();
        room_.min.x += beside_;
        room_.min.y += 2.0 * theme_.type().small;
    }

    /// The kept body as a mesh of its own, as far to the left as it has room.
    void draw_kept(ui::Painter& painter, ui::PlaneCamera camera) const
    {
        const ui::Box box{{room_.min.x - beside_, room_.min.y}, {room_.min.x, room_.max.y}};
        const ui::ClipScope clip(painter, box);
        drawing::Sketch sketch({.painter = &painter, .theme = &theme_, .room = box});
        camera.pan({-beside_, 0.0});
        const PlateInput kept{
            .model = input_.kept_results->model(), .results = input_.kept_results, .result = input_.kept_result};
        const PlateOutline outline = joined(outline_of(kept, flatness / camera.scale()));
        const PlateScene scene = scene_of({kept, &kept.model, kept.result, kept_places_}, outline, camera, sketch);
        if (shows(PlateShow::Regions) && magnification_ == 0.0 && kept_fields_.empty()) draw_regions(scene);
        for (const FieldPicture& field : kept_fields_) draw_field(scene, field);
        if (shows(PlateShow::Mesh)) draw_mesh(scene);
        if (magnification_ > 0.0) draw_deformed(scene);
        else if (shows(PlateShow::Geometry)) draw_geometry(scene);
        if (shows(PlateShow::Principal)) draw_principal(scene);
        if (shows(PlateShow::Trajectories)) draw_trajectories(scene);
        if (shows(PlateShow::Vectors)) draw_vectors(scene);
        if (shows(PlateShow::Supports)) draw_supports(scene);
        if (shows(PlateShow::Loads) && mode_ == nullptr) draw_loads(scene);
        sketch.write_captions();
    }

    void write_titles(ui::Painter& painter) const
    {
        const ui::LayerScope layer(painter, ui::Layer::Overlay);
        ui::TextStyle title = theme_.text(ui::Role::Label, ui::Anchor::BottomLeft);
        title.weight = ui::Weight::Bold;
        title.size = theme_.type().small;
        for (const bool is_kept : {true, false})
            painter.text({room_.min.x - (is_kept ? beside_ : 0.0) + edge_margin, room_.min.y},
                         mesh_title(is_kept, input_, options_), title);
    }

    bool wants_panels_below() const { return !cuts_.empty() || input_.cycle != nullptr || input_.is_compared(); }

    /// Of cuts, and at the right what is compared and the error's curve. Where not all have room, the last cuts.
    void draw_panels_below(ui::Painter& painter) const
    {
        const std::size_t n_others = (input_.cycle != nullptr ? 1 : 0) + (input_.is_compared() ? 1 : 0);
        const std::size_t most = std::max<std::size_t>(most_cuts(theme_, right_), 1 + n_others) - n_others;
        const std::size_t n = std::min(cuts_.size(), most), first = cuts_.size() - n;
        const double width = right_ / static_cast<double>(std::max<std::size_t>(n + n_others, 1));
        const auto box = [&](std::size_t i) {
            const double left = width * static_cast<double>(i);
            return ui::Box{{left, room_.max.y + 8.0}, {left + width, painter.size().height}};
        };
        for (std::size_t i = first; i < cuts_.size(); ++i)
            draw_cut_panel(painter, cuts_[i], i + 1, options_, units_, box(i - first));
        if (input_.is_compared()) draw_comparison(painter, input_, options_, box(n));
        if (input_.cycle != nullptr)
            draw_error_curve(painter, *input_.cycle, input_.model, options_, box(n + n_others - 1));
    }

    void draw_circle_panel(ui::Painter& painter) const
    {
        const auto at = circled_probe(options_);
        if (!at || !has_probe_panel_) return;
        ProbePanel panel{.at = *at, .n = *options_.circle + 1, .has_results = result_ != nullptr, .state = {}};
        if (result_ != nullptr) panel.state = probe_state(*input_.results, *result_, *at);
        draw_probe_panel(painter, panel, options_, units_, state_.circle_frame,
                         {{right_, room_.min.y}, {painter.size().width, painter.size().height}});
    }

    std::string head_line() const
    {
        const ui::Catalogue& tr = options_.tr;
        std::string line = mode_ != nullptr ? state_and_mode(input_, options_) : state_and_case(input_.model, options_);
        if (input_.player != nullptr) append(line, mesher_note(*input_.player, options_, input_.model));
        if (input_.cycle != nullptr && input_.cycle->sizes()) append(line, tr("mesh refined by the error"));
        if (lacks_room_) append(line, tr("a larger window has room for its panels"));
        if (magnification_ > 0.0)
            append(line, tr("displacements × {scale}", {{"scale", ui::number_text(magnification_, options_.numbers)}}));
        if (!kept_places_.empty() && !is_beside())
            append(line, tr("dashes: {name}", {{"name", tr("the results that were kept")}}));
        if (result_ != nullptr && shows(PlateShow::Principal)) append(line, principal_note(tr));
        if (result_ != nullptr && shows(PlateShow::Trajectories)) append(line, trajectories_note(tr));
        if (result_ != nullptr && shows(PlateShow::Vectors))
            append(line,
                   vectors_note(units_.text(largest_displacement(*mesh_, *result_), ui::Measure::Displacement), tr));
        if (result_ != nullptr && shows(PlateShow::Reactions))
            for (const std::string& equation : equilibrium_lines(*result_, units_)) append(line, equation);
        return line;
    }

    ui::Margins margins_about(const ui::Box& room) const
    {
        return {.left = room.min.x + edge_margin,
                .top = room.min.y + edge_margin,
                .right = edge_margin,
                .bottom = edge_margin};
    }

    std::vector<ui::World2> places_of_body() const
    {
        std::vector<ui::World2> places;
        for (const OutlinedPiece& piece : coarse_outline().pieces)
            for (const Vector2d& at : piece.line) places.push_back({at.x(), at.y()});
        for (const Vector2d& at : coarse_outline().vertices) places.push_back({at.x(), at.y()});
        if (magnification_ > 0.0)
            for (const PlaceLine* const moved : {&places_, &kept_places_})
                for (const Vector2d& at : *moved) places.push_back({at.x(), at.y()});
        for (const Vector2d& at : widest_places_) places.push_back({at.x(), at.y()});
        if (input_.backdrop != nullptr)
            for (const FlatPoint& corner : input_.backdrop->corners()) places.push_back({corner.x, corner.y});
        return places;
    }

    /// Room for all marks, and for captions as far as they leave the body large: they find other places too.
    ui::Margins margins_for(const drawing::Sketch& sketch, const ui::Box& body) const
    {
        const ui::Box marks = sketch.mark_bounds().value_or(body), all = sketch.bounds().value_or(body);
        const auto margin = [](double of_marks, double of_all, double size) {
            return edge_margin + std::clamp(std::max(of_marks, std::min(of_all, 0.14 * size)), 0.0, 0.35 * size);
        };
        const double w = room_.width(), h = room_.height();
        return {.left = room_.min.x + margin(body.min.x - marks.min.x, body.min.x - all.min.x, w),
                .top = room_.min.y + margin(body.min.y - marks.min.y, body.min.y - all.min.y, h),
                .right = margin(marks.max.x - body.max.x, all.max.x - body.max.x, w),
                .bottom = margin(marks.max.y - body.max.y, all.max.y - body.max.y, h)};
    }

    static ui::Box bounds_of(const std::vector<ui::World2>& body, const ui::PlaneCamera& camera)
    {
        ui::Box box{camera.to_sheet(body.front()), camera.to_sheet(body.front())};
        for (const ui::World2& at : body) box = ui::united(box, {camera.to_sheet(at), camera.to_sheet(at)});
        return box;
    }

    /// Good enough to find how large the body is.
    const PlateOutline& coarse_outline() const
    {
        if (!coarse_) coarse_ = outline_of(input_, std::numeric_limits<double>::infinity());
        return *coarse_;
    }

    void draw_marks(drawing::Sketch& sketch, const ui::PlaneCamera& camera, Pass pass) const
    {
        const PlateOutline outline = outline_of(input_, flatness / camera.scale());
        const PlateScene scene = scene_of({input_, mesh_, result_, places_}, outline, camera, sketch);
        const bool is_moved = mode_ != nullptr || (result_ != nullptr && shows(PlateShow::Deformed));
        const bool is_colored = std::ranges::any_of(
            fields_, [](const FieldPicture& field) { return field.style == FieldStyle::Bands; });
        if (pass == Pass::Drawn) draw_backdrop(scene);
        if (shows(PlateShow::Regions) && !is_moved && !is_colored) draw_regions(scene);
        if (pass == Pass::Drawn)
            for (const FieldPicture& field : fields_) draw_field(scene, field);
        if (pass == Pass::Drawn) draw_highlights(scene);
        if (input_.player == nullptr && shows(PlateShow::Mesh)) draw_mesh(scene);
        if (input_.player != nullptr && pass == Pass::Drawn) draw_mesher(scene); // no step moves the picture
        if (is_moved && !kept_places_.empty() && !is_beside())
            draw_kept_shape(scene, input_.kept_results->model(), kept_places_);
        if (is_moved) draw_deformed(scene);
        else if (shows(PlateShow::Geometry)) draw_geometry(scene);
        if (input_.motion != nullptr && mesh_ != nullptr) draw_mechanism(scene);
        if (pass == Pass::Drawn && shows(PlateShow::Principal)) draw_principal(scene);
        if (pass == Pass::Drawn && shows(PlateShow::Trajectories)) draw_trajectories(scene);
        if (pass == Pass::Drawn && shows(PlateShow::Vectors)) draw_vectors(scene);
        if (mode_ == nullptr && input_.player == nullptr) {
            for (std::size_t i = 0; i < options_.cuts.size(); ++i) draw_cut(scene, options_.cuts[i], i + 1);
            if (pass == Pass::Drawn) draw_probes(scene, room_);
        }
        if (shows(PlateShow::Supports)) draw_supports(scene);
        if (shows(PlateShow::Loads)) draw_loads(scene);
        if (shows(PlateShow::Reactions)) draw_reactions(scene);
    }

    const PlateInput& input_;
    const PlateOptions& options_;
    const PlateState& state_;
    ui::Theme theme_;
    ui::DisplayUnits units_;
    drawing::SheetHead head_;
    const ui::Fonts& fonts_;
    ui::Box room_;       ///< below the head
    double right_ = 0.0; ///< where the panel of a probe begins, or the sheet ends
    mutable std::optional<PlateOutline> coarse_;
    const femoop::plane::PlaneModel* mesh_;
    const femoop::plane::PlaneCase* result_ = nullptr;
    std::optional<femoop::plane::PlaneCase> made_result_;
    PlaceLine places_;        ///< of the mesh's points, as they are drawn
    PlaceLine kept_places_;   ///< of the kept mesh's, likewise; none where they are not drawn
    PlaceLine widest_places_; ///< where a mode moves it the farthest, so that it swings within the picture
    double magnification_ = 0.0;
    const femoop::plane::NaturalMode* mode_ = nullptr; ///< that is drawn
    std::vector<FieldPicture> fields_, kept_fields_;
    double beside_ = 0.0; ///< how far the kept body is to the left; 0 where it is not
    std::vector<CutPicture> cuts_;
    bool has_probe_panel_ = false, has_panels_below_ = false;
    bool lacks_room_ = false; ///< for one of those
    double probe_width_ = 0.0;
};

} // namespace

ui::Box draw(ui::Painter& painter, const PlateInput& input, const PlateOptions& options, const PlateState& state)
{
    const PlateSheet sheet(input, options, state, painter.size(), painter.fonts());
    sheet.draw(painter);
    return sheet.room();
}

ui::PlaneCamera fitted_camera(const PlateInput& input, const PlateOptions& options, ui::Size sheet,
                              const ui::Fonts& fonts)
{
    const PlateState at_rest;
    return PlateSheet(input, options, at_rest, sheet, fonts).fitted();
}

std::optional<mohr::Frame> circle_frame(const PlateInput& input, const PlateOptions& options)
{
    const auto at = circled_probe(options);
    if (!at || input.results == nullptr || input.result == nullptr) return std::nullopt;
    const auto state = probe_state(*input.results, *input.result, *at);
    if (!state) return std::nullopt;
    return mohr::frame_of(stress_point(*state, display_units(input.model, options)));
}

namespace {

/// Its displacement as it is drawn; nothing where it is drawn at rest or is not in the body.
std::optional<Vector2d> drawn_displacement(const PlateInput& input, const PlateOptions& options, const Vector2d& at)
{
    if (input.result == nullptr || !options.show.set.contains(PlateShow::Deformed)) return std::nullopt;
    const auto places = input.results->locator().find(at);
    if (places.empty()) return std::nullopt;
    const double factor = magnification(input, *input.result, options);
    return Vector2d(factor * input.result->displacement(places.front()));
}

} // namespace

Vector2d drawn_place(const PlateInput& input, const PlateOptions& options, const Vector2d& at, double phase)
{
    return at + phase * drawn_displacement(input, options, at).value_or(Vector2d::Zero());
}

Vector2d place_at_rest(const PlateInput& input, const PlateOptions& options, const Vector2d& drawn, double phase)
{
    constexpr int most_steps = 30;
    Vector2d at = drawn;
    for (int i = 0; i < most_steps; ++i) {
        const auto moved = drawn_displacement(input, options, at);
        if (!moved) return at;
        at = drawn - phase * *moved;
    }
    return at;
}

ui::Color background(const PlateOptions& options) { return ui::Theme(options.theme).background(); }

} // namespace plane
