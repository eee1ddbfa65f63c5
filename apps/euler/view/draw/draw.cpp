#include "apps/euler/view/draw/draw.h"

#include "apps/euler/view/draw/hatching.h"
#include "apps/euler/view/draw/names.h"
#include "apps/euler/view/draw/palette.h"
#include "apps/euler/view/shapes/outline.h"

#include <algorithm>
#include <vector>

namespace euler {

namespace {

constexpr double dot_radius = 3.6, hidden_dot_radius = 2.6, lone_dot_radius = 5.0; // [px]
constexpr double halo_more = 8.0;                                                  // [px] broader than what it is about
constexpr double head_length = 9.0;                                                // [px] of a half-edge's arrow
constexpr double hatch_spacing = 8.0;                                              // [px]
constexpr double least_hatched = 300.0;                                            // [px^2] of a piece's box
constexpr double crowded = 12.0; // [px] of a typical edge, below which vertices have no dots

/// The indices of shapes by the number of pieces that they are painted after.
template <class List> std::vector<std::vector<std::size_t>> by_turn(const List& shapes, std::size_t n_pieces)
{
    std::vector<std::vector<std::size_t>> turns(n_pieces + 1);
    for (std::size_t i = 0; i < shapes.size(); ++i) turns[std::min(shapes[i].after, n_pieces)].push_back(i);
    return turns;
}

class Drawing {
public:
    Drawing(ui::Painter& painter, const Shapes& shapes, const Palette& palette, const Look& look)
        : painter_(painter),
          shapes_(shapes),
          palette_(palette),
          look_(look),
          symbol_(palette.theme().symbol_scale()),
          is_crowded_(typical_edge(shapes) < crowded)
    {}

    void draw()
    {
        const std::size_t n = shapes_.pieces.size();
        const auto edges = by_turn(shapes_.edges, n), arrows = by_turn(shapes_.arrows, n),
                   vertices = by_turn(shapes_.vertices, n);
        for (std::size_t turn = 0; turn <= n; ++turn) {
            if (turn > 0 && look_.faces) draw(shapes_.pieces[turn - 1]);
            for (const std::size_t i : edges[turn]) draw(shapes_.edges[i]);
            if (look_.half_edges)
                for (const std::size_t i : arrows[turn]) draw(shapes_.arrows[i]);
            for (const std::size_t i : vertices[turn]) draw(shapes_.vertices[i]);
        }
    }

private:
    void draw(const Shapes::Piece& piece)
    {
        const Shapes::Face& face = shapes_.faces[piece.face];
        const ui::Color color = palette_.face(face.subject, face.face);
        if (piece.area.size() == 1) painter_.polygon(piece.area.front(), color);
        else painter_.region(piece.area, color);
        if (!piece.is_back || !look_.hatching || is_small(piece.area)) return;
        hatch(painter_, piece.area, hatch_spacing * symbol_,
              {.color = palette_.hatching(face.subject, face.face), .width = symbol_});
    }

    static bool is_small(const Region& area)
    {
        const ui::Box box = bounds_of(area);
        return box.width() * box.height() < least_hatched;
    }

    void draw(const Shapes::Edge& edge)
    {
        const Part part{edge.subject, edge.edge};
        const ui::Stroke stroke = palette_.edge(part, edge.is_hidden, edge.series);
        if (const auto halo = palette_.halo(part))
            painter_.polyline(edge.line, {.color = *halo,
                                          .width = stroke.width + halo_more * symbol_,
                                          .cap = ui::Cap::Round,
                                          .join = ui::Join::Round});
        painter_.polyline(edge.line, stroke);
    }

    void draw(const Shapes::Arrow& arrow)
    {
        const Part part{arrow.subject, arrow.half_edge};
        const ui::Stroke stroke = palette_.arrow(arrow.subject, arrow.half_edge, arrow.is_hidden);
        if (const auto halo = palette_.halo(part))
            painter_.polyline(arrow.line, {.color = *halo,
                                           .width = stroke.width + halo_more * symbol_,
                                           .cap = ui::Cap::Round,
                                           .join = ui::Join::Round});
        painter_.polyline(arrow.line, stroke);
        draw_head(arrow.line, stroke.color);
    }

    void draw_head(const std::vector<ui::Point>& line, ui::Color color)
    {
        const ui::Point tip = line.back();
        const double length = head_length * symbol_;
        const ui::Point before = line.size() > 3 ? line[line.size() - 4] : line.front();
        const ui::Point back = -length * ui::direction(tip - before), aside = 0.36 * ui::left_normal(back);
        painter_.polygon({tip, tip + back + aside, tip + back - aside}, color);
    }

    void draw(const Shapes::Vertex& vertex)
    {
        const Part part{vertex.subject, vertex.vertex};
        const MarkTable& marks = palette_.marks(vertex.subject);
        if (is_crowded_ && !marks.is_marked(part.entity) && !is_lone(vertex)) return;
        const double radius = symbol_ * (is_lone(vertex)    ? lone_dot_radius
                                         : vertex.is_hidden ? hidden_dot_radius
                                                            : dot_radius);
        if (const auto halo = palette_.halo(part)) painter_.disc(vertex.at, radius + 0.8 * halo_more * symbol_, *halo);
        const double grown = marks.is_created(part.entity) || marks.is_killed(part.entity) ? 1.4 : 1.0;
        painter_.disc(vertex.at, grown * radius, palette_.vertex(part, vertex.is_hidden));
    }

    bool is_lone(const Shapes::Vertex& vertex) const
    {
        const topology::Solid& solid = palette_.solid(vertex.subject);
        return solid.mate(solid.half_edge(vertex.vertex)) == solid.half_edge(vertex.vertex);
    }

    ui::Painter& painter_;
    const Shapes& shapes_;
    const Palette& palette_;
    const Look& look_;
    double symbol_;
    bool is_crowded_;
};

void write_sentences(ui::Painter& painter, const Shapes& shapes, const ui::Theme& theme)
{
    const double line = 1.6 * theme.type().normal;
    ui::Point at{line, line};
    for (const std::string& sentence : shapes.sentences) {
        painter.text(at, sentence, theme.text(ui::Role::Label, ui::Anchor::Left));
        at.y += line;
    }
}

} // namespace

void draw(ui::Painter& painter, const Shapes& shapes, std::span<const Subject> subjects, const Look& look)
{
    const Palette palette(subjects, look);
    const ui::LayerScope layer(painter, ui::Layer::Lines);
    Drawing(painter, shapes, palette, look).draw();
    painter.set_layer(ui::Layer::Labels);
    write_names(painter, shapes, subjects, palette, look);
    write_sentences(painter, shapes, palette.theme());
}

ui::Picture picture(const Shapes& shapes, std::span<const Subject> subjects, const Look& look, ui::Size sheet,
                    const ui::Fonts& fonts)
{
    ui::Painter painter(sheet, fonts);
    draw(painter, shapes, subjects, look);
    return painter.picture();
}

ui::Color background(const Look& look) { return ui::Theme(look.theme).background(); }

} // namespace euler
