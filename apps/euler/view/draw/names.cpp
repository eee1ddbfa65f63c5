#include "apps/euler/view/draw/names.h"

#include "apps/euler/view/shapes/entity_name.h"
#include "apps/euler/view/shapes/name_places.h"
#include "ui/paint/label_placement.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace euler {

using topology::EntityKind;

namespace {

constexpr double most_names = 240.0, most_of_many = 40.0; // of a solid of thousands of edges
constexpr std::size_t most_pieces = 600;                  // for which places inside are looked for
constexpr double least_edge = 30.0;  // [px] of an edge that has room for its name, typically and by itself
constexpr double roomy_edge = 80.0;  // [px] typically, where hidden things are named too
constexpr double beside_side = 16.0; // [px] from a polygon's side to what is inside its half-edges
constexpr double least_room = 9.0;   // [px] about the middle of a face that has room for its name

/// A name that wants to be written.
struct Request {
    std::string text;
    ui::TextStyle style;
    ui::Label label;
    bool is_area = false; ///< it names what lies below it and needs no leader
};

class Names {
public:
    Names(ui::Painter& painter, const Shapes& shapes, std::span<const Subject> subjects, const Palette& palette,
          const Look& look)
        : painter_(painter),
          shapes_(shapes),
          subjects_(subjects),
          palette_(palette),
          look_(look),
          symbol_(palette.theme().symbol_scale()),
          typical_(typical_edge(shapes)),
          placer_({.room = painter.sheet(), .leader_after = 18.0 * symbol_})
    {}

    void write()
    {
        collect();
        if (requests_.empty()) return;
        add_obstacles();
        std::stable_sort(requests_.begin(), requests_.end(),
                         [](const Request& a, const Request& b) { return a.label.priority > b.label.priority; });
        const double most = std::lerp(most_names, most_of_many, thinning(shapes_.edges.size()));
        requests_.resize(std::min(requests_.size(), static_cast<std::size_t>(most)));
        std::vector<ui::Label> labels;
        for (const Request& request : requests_) labels.push_back(request.label);
        const ui::LabelPlacement placement = placer_.place(labels);
        for (std::size_t i = 0; i < requests_.size(); ++i)
            if (placement.labels[i]) write(requests_[i], *placement.labels[i]);
    }

private:
    bool wants(EntityKind kind) const { return look_.names.contains(kind); }

    /// Of several places of one entity, as in an exploded view, the one in front has the name.
    bool is_first(const Part& part) { return named_.insert(part).second; }

    /// A face without area is named beside one of its half-edges.
    void find_places()
    {
        if (shapes_.pieces.size() > most_pieces) return;
        for (const Shapes::Piece& piece : shapes_.pieces) {
            const Shapes::Face& face = shapes_.faces[piece.face];
            NamePlaces places = places_inside(piece.area);
            NamePlaces& best = places_[{face.subject, face.face}];
            if (best.all.empty() || places.room > best.room) best = std::move(places);
        }
        for (const Shapes::Arrow& arrow : shapes_.arrows) {
            const Part face{arrow.subject, palette_.solid(arrow.subject).face(arrow.half_edge)};
            if (!places_.contains(face)) places_[face] = {{beside(arrow, 14.0), beside(arrow, -14.0)}, least_edge};
        }
    }

    void collect()
    {
        if (wants(EntityKind::Face)) find_places();
        if (wants(EntityKind::Vertex))
            for (auto v = shapes_.vertices.rbegin(); v != shapes_.vertices.rend(); ++v) ask(*v);
        if (wants(EntityKind::Face))
            for (const Shapes::Face& face : shapes_.faces) ask(face);
        if (wants(EntityKind::Edge))
            for (auto e = shapes_.edges.rbegin(); e != shapes_.edges.rend(); ++e) ask(*e);
        if (wants(EntityKind::HalfEdge) || wants(EntityKind::Loop))
            for (const Shapes::Arrow& arrow : shapes_.arrows) ask(arrow);
    }

    void ask(const Shapes::Vertex& vertex)
    {
        const Part part{vertex.subject, vertex.vertex};
        const topology::Solid& solid = palette_.solid(part.subject);
        const bool is_lone = solid.mate(solid.half_edge(vertex.vertex)) == solid.half_edge(vertex.vertex);
        if (typical_ < least_edge * symbol_ && !is_lone && !is_marked(part)) return;
        std::vector<ui::Point> wishes;
        if (vertex.toward != ui::Point{}) wishes.push_back(vertex.at + 14.0 * symbol_ * vertex.toward);
        ask(part, vertex.at, std::move(wishes), vertex.is_hidden,
            {.clearance = is_lone ? 16.0 : 5.0, .priority = 40.0});
    }

    void ask(const Shapes::Face& face)
    {
        const Part part{face.subject, face.face};
        const auto found = places_.find(part);
        if (found == places_.end()) return;
        const NamePlaces& places = found->second;
        if (places.room < least_room * symbol_ && !is_marked(part)) return;
        ask(part, places.all.front(), places.all, face.is_back,
            {.clearance = 4.0, .priority = 30.0, .room = room_in_polygon(part, places)});
    }

    /// Between the half-edges of a polygon, whose sides tell by their colours which of them are one edge. Where there
    /// are rings there is room beside them.
    double room_in_polygon(const Part& face, const NamePlaces& places) const
    {
        const topology::Solid& solid = palette_.solid(face.subject);
        const auto loops = solid.loops(topology::FaceId{face.entity.index});
        if (!shapes_.is_repeated || ++loops.begin() != loops.end()) return 0.0;
        return 2.0 * std::max(least_room * symbol_, places.room - beside_side * symbol_);
    }

    void ask(const Shapes::Edge& edge)
    {
        const Part part{edge.subject, edge.edge};
        const bool is_curve = edge.line.size() > 2;
        if (!is_curve && ui::distance(edge.line.front(), edge.line.back()) < least_edge && !is_marked(part)) return;
        const ui::Point middle = middle_of(edge.line);
        ask(part, middle, {middle}, edge.is_hidden, {.clearance = 3.0, .priority = 20.0});
    }

    void ask(const Shapes::Arrow& arrow)
    {
        const topology::Solid& solid = palette_.solid(arrow.subject);
        const topology::LoopId loop = solid.loop(arrow.half_edge);
        const ui::Point middle = middle_of(arrow.line);
        if (wants(EntityKind::HalfEdge))
            ask({arrow.subject, arrow.half_edge}, middle, {beside(arrow, 10.0), beside(arrow, -10.0)}, arrow.is_hidden,
                {.clearance = 3.0, .priority = 10.0});
        if (wants(EntityKind::Loop) && solid.half_edge(loop) == arrow.half_edge)
            ask({arrow.subject, loop}, middle, {beside(arrow, 12.0), beside(arrow, -12.0)}, arrow.is_hidden,
                {.clearance = 4.0, .priority = 25.0});
    }

    struct Manner {
        double clearance;
        double priority;
        double room = 0.0; ///< [px] of width, in which it is written smaller where it must; 0: any
    };
    void ask(const Part& part, ui::Point target, std::vector<ui::Point> wishes, bool is_hidden, const Manner& manner)
    {
        if (!is_first(part) && !shapes_.is_repeated) return;
        if (is_hidden && typical_ < roomy_edge * symbol_ && !is_marked(part)) return;
        const std::string text = entity_name(subjects_[part.subject], part.entity);
        const ui::TextStyle style = fitting(palette_.name(part, is_hidden), text, manner.room);
        const bool is_area = part.entity.kind == EntityKind::Face; // named inside, or not at all
        const double reach = is_area ? 0.0
                                     : std::clamp(0.4 * typical_, 18.0, shapes_.is_repeated ? 18.0 : 34.0) * symbol_;
        requests_.push_back({text,
                             style,
                             {.target = target,
                              .size = ui::label_size(painter_.fonts(), text, style),
                              .wishes = std::move(wishes),
                              .priority = manner.priority - (is_hidden ? 5.0 : 0.0) + (is_marked(part) ? 100.0 : 0.0),
                              .clearance = manner.clearance * symbol_,
                              .reach = reach},
                             is_area});
    }

    ui::TextStyle fitting(ui::TextStyle style, const std::string& text, double room) const
    {
        constexpr double smallest = 0.7; // that can still be read
        const double width = ui::label_size(painter_.fonts(), text, style).width;
        if (room > 0.0 && width > room) style.size *= std::max(smallest, room / width);
        return style;
    }

    bool is_marked(const Part& part) const { return palette_.marks(part.subject).is_marked(part.entity); }

    /// So many pixels to the left of the middle of a half-edge's line.
    ui::Point beside(const Shapes::Arrow& arrow, double by) const
    {
        const std::size_t n = arrow.line.size();
        const ui::Point along = ui::direction(arrow.line[n / 2] - arrow.line[(n - 1) / 2 - (n > 2 ? 1 : 0)]);
        return middle_of(arrow.line) + by * symbol_ * ui::left_normal(along);
    }

    static ui::Point middle_of(const std::vector<ui::Point>& line)
    {
        const std::size_t n = line.size();
        return 0.5 * (line[(n - 1) / 2] + line[n / 2]);
    }

    void add_obstacles()
    {
        ui::LabelObstacles& obstacles = placer_.obstacles();
        const auto is_kept_clear = [&](const auto& shape) {
            return !shape.is_hidden || typical_ >= roomy_edge * symbol_;
        };
        for (const Shapes::Vertex& vertex : shapes_.vertices)
            if (is_kept_clear(vertex))
                obstacles.add_disc(vertex.at, 4.0 * symbol_,
                                   vertex.is_hidden ? ui::Firmness::Soft : ui::Firmness::Hard);
        for (const Shapes::Edge& edge : shapes_.edges)
            if (is_kept_clear(edge)) obstacles.add_polyline(edge.line, 2.0, ui::Firmness::Soft);
        for (const Shapes::Arrow& arrow : shapes_.arrows)
            if (is_kept_clear(arrow)) obstacles.add_polyline(arrow.line, 3.0, ui::Firmness::Soft);
    }

    void write(const Request& request, const ui::PlacedLabel& place)
    {
        ui::TextStyle style = request.style;
        if (place.is_over_soft) style.plate = ui::with_opacity(palette_.theme().background(), 0.75);
        if (place.leader && !request.is_area)
            painter_.line(place.leader->from, place.leader->to, palette_.theme().stroke(ui::Role::Leader));
        ui::draw_label(painter_, place, request.text, style);
    }

    ui::Painter& painter_;
    const Shapes& shapes_;
    std::span<const Subject> subjects_;
    const Palette& palette_;
    const Look& look_;
    double symbol_;
    double typical_; ///< length of an edge on the sheet
    ui::LabelPlacer placer_;
    std::vector<Request> requests_;
    std::set<Part> named_;
    std::map<Part, NamePlaces> places_; ///< of faces
};

} // namespace

void write_names(ui::Painter& painter, const Shapes& shapes, std::span<const Subject> subjects, const Palette& palette,
                 const Look& look)
{
    Names(painter, shapes, subjects, palette, look).write();
}

} // namespace euler
