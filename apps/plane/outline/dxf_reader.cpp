#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <string>

#include "apps/plane/outline/dxf_curves.h"
#include "apps/plane/outline/dxf_tags.h"
#include "apps/plane/outline/gathering.h"
#include "femoop/model/fault/translator.h"
#include "topology/text/line_error.h"

namespace outline {

using femoop::LengthUnit;
using femoop::translatable;
using topology::LineError;

namespace {

constexpr double degree = std::numbers::pi / 180.0;

/// The entities of a section or a block, and where it is put by.
struct DxfBlock {
    Place base = Place::Zero();
    std::vector<DxfEntity> entities{};
};

/// A file, sorted: what is drawn, the blocks that are inserted in it, and the layers that are not seen.
class DxfFile {
public:
    explicit DxfFile(const std::vector<DxfTag>& tags)
    {
        for (const DxfTag& tag : tags) {
            if (tag.code == 0) take_entity(DxfEntity{.type = tag.value, .line = tag.line});
            else current_.tags.push_back(tag);
        }
        take_entity({});
    }

    const DxfBlock& drawn() const { return drawn_; }
    const DxfBlock* block(std::string_view name) const
    {
        const auto found = blocks_.find(name);
        return found != blocks_.end() ? &found->second : nullptr;
    }
    bool is_seen(std::string_view layer) const { return !unseen_.contains(layer); }
    std::optional<LengthUnit> unit() const { return unit_; }

private:
    /// What was read so far is whole.
    void take_entity(DxfEntity next)
    {
        if (current_.type == "ENDSEC") {
            section_ = {};
        } else if (current_.type == "ENDBLK") {
            block_ = nullptr;
        } else if (current_.type == "SECTION") {
            section_ = current_.text(2);
            if (section_ == "HEADER") read_header(current_.tags);
        } else if (section_ == "TABLES" && current_.type == "LAYER") {
            constexpr int frozen = 1;
            if ((current_.flags(70) & frozen) != 0 || current_.number(62, 0.0) < 0.0) unseen_.insert(current_.text(2));
        } else if (section_ == "BLOCKS" && current_.type == "BLOCK") {
            block_ = &blocks_[current_.text(2)];
            block_->base = current_.place(10);
        } else if (section_ == "BLOCKS" && block_ != nullptr) {
            block_->entities.push_back(std::move(current_));
        } else if (section_ == "ENTITIES") {
            drawn_.entities.push_back(std::move(current_));
        }
        current_ = std::move(next);
    }

    void read_header(const std::vector<DxfTag>& tags)
    {
        const auto variable = std::ranges::find(tags, "$INSUNITS", &DxfTag::value);
        if (variable == tags.end() || variable + 1 == tags.end()) return;
        const std::map<double, LengthUnit> units{{1, LengthUnit::in}, {2, LengthUnit::ft}, {4, LengthUnit::mm},
                                                 {5, LengthUnit::cm}, {6, LengthUnit::m},  {7, LengthUnit::km}};
        if (const auto unit = units.find(number(*(variable + 1))); unit != units.end()) unit_ = unit->second;
    }

    DxfBlock drawn_;
    std::map<std::string_view, DxfBlock> blocks_;
    std::set<std::string_view> unseen_;
    std::optional<LengthUnit> unit_;
    std::string_view section_;
    DxfBlock* block_ = nullptr;
    DxfEntity current_;
};

/// Makes curves of entities.
class DxfReader {
public:
    explicit DxfReader(const DxfFile& file) : file_(file) {}

    Outline take()
    {
        if (file_.unit()) found_.set_unit(*file_.unit());
        draw(file_.drawn(), Affine::Identity(), 0);
        return found_.take();
    }

private:
    using Entities = std::vector<DxfEntity>;

    void draw(const DxfBlock& block, const Affine& map, std::size_t depth)
    {
        for (auto entity = block.entities.begin(); entity != block.entities.end(); ++entity) {
            const auto end = last_of(entity, block.entities.end());
            try {
                if (is_seen(*entity)) draw(Entities(entity, end), map, depth);
            } catch (const LineError& fault) {
                throw fault.number() > 0 ? fault : fault.at(entity->line, entity->type);
            }
            entity = end - 1;
        }
    }

    /// Behind an entity and what belongs to it: a polyline's corners, an insertion's texts.
    static Entities::const_iterator last_of(Entities::const_iterator entity, Entities::const_iterator end)
    {
        const bool has_parts = entity->type == "POLYLINE" || (entity->type == "INSERT" && entity->flags(66) == 1);
        auto next = entity + 1;
        if (!has_parts) return next;
        while (next != end && (next->type == "VERTEX" || next->type == "ATTRIB")) ++next;
        return next != end && next->type == "SEQEND" ? next + 1 : next;
    }

    bool is_seen(const DxfEntity& entity) const
    {
        return entity.flags(67) == 0 && entity.flags(60) == 0 && file_.is_seen(entity.text(8));
    }

    void draw(const Entities& parts, const Affine& map, std::size_t depth)
    {
        const DxfEntity& entity = parts.front();
        const double up = entity.number(230, 1.0);
        if (std::abs(up) < 0.999) return found_.leave_out(std::string(entity.type)); // it stands in space
        if (entity.type == "LINE") return add(Polyline{{entity.place(10), entity.place(11)}}, map);
        if (entity.type == "ELLIPSE") return add_ellipse(entity, up, map);
        if (entity.type == "SPLINE") return add_spline(entity, map);
        // The others are drawn in axes of their own, of which x is turned round where they are seen from behind.
        Affine own = map;
        if (up < 0.0) own = map * Eigen::Scaling(-1.0, 1.0);
        if (entity.type == "CIRCLE") add(circle(entity), own);
        else if (entity.type == "ARC") add_arc(entity, own);
        else if (entity.type == "LWPOLYLINE") add_light_polyline(entity, own);
        else if (entity.type == "POLYLINE") add_polyline(parts, own);
        else if (entity.type == "INSERT") insert(entity, own, depth);
        else found_.leave_out(std::string(entity.type));
    }

    void add(const Curve& curve, const Affine& map) { found_.add(curve, map); }

    static EllipticArc circle(const DxfEntity& entity)
    {
        const double r = std::abs(entity.number(40, 0.0));
        return {.center = entity.place(10), .u = {r, 0.0}, .v = {0.0, r}};
    }

    void add_arc(const DxfEntity& entity, const Affine& map)
    {
        EllipticArc arc = circle(entity);
        arc.from = entity.number(50, 0.0) * degree;
        arc.to = entity.number(51, 360.0) * degree;
        add(forwards(arc), map);
    }

    /// Angles run forwards, however they are written.
    static EllipticArc forwards(EllipticArc arc)
    {
        constexpr double turn = 2.0 * std::numbers::pi;
        const double angle = std::remainder(arc.to - arc.from, turn);
        arc.to = arc.from + (angle > 1e-12 ? angle : angle + turn);
        return arc;
    }

    void add_ellipse(const DxfEntity& entity, double up, const Affine& map)
    {
        const Eigen::Vector2d u = entity.place(11);
        const double ratio = entity.number(40, 1.0) * (up < 0.0 ? -1.0 : 1.0);
        EllipticArc arc{.center = entity.place(10), .u = u, .v = ratio * Eigen::Vector2d(-u.y(), u.x())};
        arc.from = entity.number(41, arc.from);
        arc.to = entity.number(42, arc.to);
        add(forwards(arc), map);
    }

    void add_spline(const DxfEntity& entity, const Affine& map)
    {
        constexpr int closed = 1;
        const std::vector<Place> control = entity.places(10);
        const std::vector<double> knots = entity.numbers(40), weights = entity.numbers(41);
        const int p = entity.flags(71);
        const bool has_weights = std::ranges::any_of(weights, [&](double w) { return w != weights.front(); });
        if (control.empty()) {
            const std::vector<Place> through = entity.places(11);
            if (!through.empty()) add(SplineThrough{through, (entity.flags(70) & closed) != 0}, map);
            return;
        }
        if (has_weights || p < 1 || p > 3) return found_.leave_out(std::string(entity.type));
        if (control.size() <= static_cast<std::size_t>(p) ||
            knots.size() != control.size() + static_cast<std::size_t>(p) + 1 || !std::ranges::is_sorted(knots))
            throw LineError(
                translatable("this spline of degree {0} has {1} control points and {2} knots; wanted ascending "
                             "knots, as many as the points, the degree and 1 together"),
                {std::to_string(p), std::to_string(control.size()), std::to_string(knots.size())});
        add(bspline(control, knots, p), map);
    }

    void add_bulged(const std::vector<BulgedCorner>& corners, bool is_closed, const Affine& map)
    {
        for (const Curve& curve : bulged_polyline(corners, is_closed)) add(curve, map);
    }

    void add_light_polyline(const DxfEntity& entity, const Affine& map)
    {
        std::vector<BulgedCorner> corners;
        for (const DxfTag& tag : entity.tags) {
            if (tag.code == 10) corners.push_back({{number(tag), 0.0}});
            if (corners.empty()) continue;
            if (tag.code == 20) corners.back().at.y() = number(tag);
            if (tag.code == 42) corners.back().bulge = number(tag);
        }
        add_bulged(corners, (entity.flags(70) & 1) != 0, map);
    }

    void add_polyline(const Entities& parts, const Affine& map)
    {
        constexpr int closed = 1, in_space = 8 | 16 | 64, frame_of_spline = 16;
        const int flags = parts.front().flags(70);
        if ((flags & in_space) != 0) return found_.leave_out(std::string(parts.front().type));
        std::vector<BulgedCorner> corners;
        for (const DxfEntity& part : parts)
            if (part.type == "VERTEX" && (part.flags(70) & frame_of_spline) == 0)
                corners.push_back({part.place(10), part.number(42, 0.0)});
        add_bulged(corners, (flags & closed) != 0, map);
    }

    /// A block, in rows and columns.
    void insert(const DxfEntity& entity, const Affine& map, std::size_t depth)
    {
        constexpr std::size_t deepest = 16;
        const DxfBlock* const block = file_.block(entity.text(2));
        if (block == nullptr) return found_.leave_out("INSERT");
        if (depth == deepest || ++n_inserted_ > most_pieces)
            throw LineError(translatable("block \"{0}\" is inserted in itself, more than {1} deep, or too often"),
                            {std::string(entity.text(2)), std::to_string(deepest)});
        const double columns = entity.number(70, 1.0), rows = entity.number(71, 1.0);
        if (columns * rows > static_cast<double>(most_pieces) || columns * rows < 1.0)
            throw LineError(translatable("block \"{0}\" is inserted in {1} columns and {2} rows"),
                            {std::string(entity.text(2)), std::string(entity.text(70)), std::string(entity.text(71))});
        const Affine turned = map * Eigen::Translation2d(entity.place(10)) *
                              Eigen::Rotation2Dd(entity.number(50, 0.0) * degree);
        const Affine in_block = Eigen::Scaling(entity.number(41, 1.0), entity.number(42, 1.0)) *
                                Eigen::Translation2d(-block->base);
        for (double column = 0.0; column < columns; ++column)
            for (double row = 0.0; row < rows; ++row) {
                const Eigen::Vector2d step(column * entity.number(44, 0.0), row * entity.number(45, 0.0));
                draw(*block, turned * Eigen::Translation2d(step) * in_block, depth + 1);
            }
    }

    const DxfFile& file_;
    Gathering found_;
    std::size_t n_inserted_ = 0;
};

} // namespace

Outline read_dxf(std::string_view text)
{
    const std::vector<DxfTag> tags = dxf_tags(text);
    return DxfReader(DxfFile(tags)).take();
}

} // namespace outline
