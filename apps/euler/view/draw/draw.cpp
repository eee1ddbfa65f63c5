#include "apps/euler/view/draw/draw.h"

#include "apps/euler/view/draw/arrow_head.h"
#include "apps/euler/view/draw/hatching.h"
#include "apps/euler/view/draw/names.h"
#include "apps/euler/view/draw/palette.h"
#include "apps/euler/view/shapes/outline.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ui/paint/wrapped_lines.h"

namespace euler {

namespace {

constexpr double dot_radius = 3.6, hidden_dot_radius = 2.6, lone_dot_radius = 5.0; // [px]
constexpr double halo_more = 8.0;                                                  // [px] broader than what it is about
constexpr double head_length = 9.0;                                                // [px] of a half-edge's arrow
constexpr double hatch_spacing = 8.0;                                              // [px]
constexpr double pale = 0.6;                   // share of a bent face's colour, which only hints where it is
constexpr double least_hatched = 300.0;        // [px^2] of a piece's box
constexpr double crowded = 40.0;               // [px] of a typical edge, below which there is less of everything
constexpr double crowded_of_many = 80.0;       // likewise, of a solid of thousands of edges
constexpr double half_thinned = 0.5;           // from where on hidden edges are left out where it is crowded
constexpr double least_hatched_there = 1500.0; // [px^2]

/// Shapes by the number of pieces that they are painted after, taken from there turn by turn.
template <class Shape> class Turns {
public:
    explicit Turns(const std::vector<Shape>& shapes) : order_(shapes.size())
    {
        for (std::size_t i = 0; i < shapes.size(); ++i) order_[i] = &shapes[i];
        std::stable_sort(order_.begin(), order_.end(),
                         [](const Shape* a, const Shape* b) { return a->after < b->after; });
    }
    /// Those of this turn and of any before that were not taken yet.
    template <class Draw> void take(std::size_t turn, const Draw& draw)
    {
        for (; next_ < order_.size() && order_[next_]->after <= turn; ++next_) draw(*order_[next_]);
    }

private:
    std::vector<const Shape*> order_;
    std::size_t next_ = 0;
};

class Drawing {
public:
    Drawing(ui::Painter& painter, const Shapes& shapes, const Palette& palette, const Look& look)
        : painter_(painter),
          shapes_(shapes),
          palette_(palette),
          look_(look),
          symbol_(palette.theme().symbol_scale()),
          thinning_(thinning(shapes.edges.size())),
          is_crowded_(typical_edge(shapes) < symbol_ * std::lerp(crowded, crowded_of_many, thinning_))
    {}

    void draw()
    {
        Turns edges(shapes_.edges);
        Turns arrows(shapes_.arrows);
        Turns vertices(shapes_.vertices);
        const auto draw_one = [&](const auto& shape) { draw(shape); };
        for (std::size_t turn = 0; turn <= shapes_.pieces.size(); ++turn) {
            if (turn > 0 && look_.faces) draw_piece(turn - 1);
            edges.take(turn, draw_one);
            if (look_.half_edges) arrows.take(turn, draw_one);
            vertices.take(turn, draw_one);
        }
    }

private:
    void draw_piece(std::size_t place)
    {
        const Shapes::Piece& piece = shapes_.pieces[place];
        const Shapes::Face& face = shapes_.faces[piece.face];
        ui::Color color = palette_.face(face.subject, face.face);
        if (face.is_bent) color = ui::with_opacity(color, pale * color.a / 255.0);
        if (piece.area.size() == 1) painter_.polygon(piece.area.front(), color);
        else painter_.region(piece.area, color);
        if (!piece.is_back || face.is_bent || !look_.hatching || is_small(piece.area)) return;
        hatch(painter_, piece.area, front_pieces_over(place), hatch_spacing * symbol_,
              {.color = palette_.hatching(face.subject, face.face), .width = symbol_});
    }

    /// Whoever looks at these from outside must not take them for what lies behind.
    std::vector<const Region*> front_pieces_over(std::size_t place)
    {
        if (bounds_.empty())
            for (const Shapes::Piece& piece : shapes_.pieces) bounds_.push_back(bounds_of(piece.area));
        std::vector<const Region*> covers;
        for (std::size_t i = place + 1; i < bounds_.size(); ++i)
            if (!shapes_.pieces[i].is_back && bounds_[i].overlaps(bounds_[place]))
                covers.push_back(&shapes_.pieces[i].area);
        return covers;
    }

    bool is_small(const Region& area) const
    {
        const ui::Box box = bounds_of(area);
        return box.width() * box.height() < (is_crowded_ ? least_hatched_there : least_hatched);
    }

    /// Thin, and with blunt ends, which take a few triangles less each.
    static void make_slim(ui::Stroke& stroke)
    {
        stroke.width *= 0.6;
        stroke.cap = ui::Cap::Butt;
    }

    void draw(const Shapes::Edge& edge)
    {
        const Part part{edge.subject, edge.edge};
        ui::Stroke stroke = palette_.edge(part, edge.is_hidden, edge.series);
        if (is_crowded_ && !palette_.marks(edge.subject).is_marked(part.entity)) {
            if (edge.is_hidden && thinning_ > half_thinned) return;
            make_slim(stroke);
        }
        draw_line(part, edge.line, stroke);
    }

    /// On its halo, where it has one.
    void draw_line(const Part& part, const std::vector<ui::Point>& line, const ui::Stroke& stroke)
    {
        if (const auto halo = palette_.halo(part))
            painter_.polyline(line, {.color = *halo,
                                     .width = stroke.width + halo_more * symbol_,
                                     .cap = ui::Cap::Round,
                                     .join = ui::Join::Round});
        painter_.polyline(line, stroke);
    }

    void draw(const Shapes::Arrow& arrow)
    {
        const Part part{arrow.subject, arrow.half_edge};
        const ui::Stroke stroke = palette_.arrow(arrow.subject, arrow.half_edge, arrow.is_hidden);
        draw_line(part, arrow.line, stroke);
        draw_head(painter_, arrow.line, head_length * symbol_, stroke.color);
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
    double thinning_;
    bool is_crowded_;
    std::vector<ui::Box> bounds_{}; ///< by piece, once something is hatched
};

void write_sentences(ui::Painter& painter, const Shapes& shapes, const ui::Theme& theme)
{
    const double line = 1.6 * theme.type().normal;
    ui::TextStyle style = theme.text(ui::Role::Label, ui::Anchor::Left);
    style.plate = ui::with_opacity(theme.background(), 0.8); // maps of other shells lie below
    ui::Point at{line, line};
    for (const std::string& sentence : shapes.sentences) {
        const double room = painter.sheet().width() - 2.0 * line;
        for (const std::string& words : ui::wrapped_lines(painter.fonts(), sentence, style, room)) {
            painter.text(at, words, style);
            at.y += line;
        }
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
