#include "apps/cross/view/block_layout.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace cross {

namespace {

constexpr double past_middle = 0.7;
constexpr double still_legible = 0.7; // of the largest type: rather so than where it misleads

/// How many columns may stand one behind another, seen from their member. On the inside of an upright member the one
/// behind looks like one of the beam's above it.
struct Rows {
    enum class Inside : std::uint8_t { Allowed, Avoided };
    std::size_t n = 1;
    Inside inside = Inside::Allowed;
};

/// Columns of one size, put beside their ends one after the other.
class Trial {
public:
    enum class Side : std::uint8_t { Below, Above }; // of a beam, where both have room

    Trial(const BlockRequest& request, double type, std::size_t n_lines, Side side, Rows rows = {})
        : request_(request), type_(type), down_(side == Side::Below ? 1.0 : -1.0), rows_(rows)
    {
        layout_ = {.boxes = {}, .type = type, .n_lines = n_lines};
        width_ = request.width_of(type);
    }

    /// Nothing as soon as one finds no room.
    std::optional<BlockLayout> run_whole()
    {
        for (const EndPlace& place : request_.places)
            if (!layout_.boxes.emplace_back(found(place))) return std::nullopt;
        return std::move(layout_);
    }

    BlockLayout run()
    {
        for (const EndPlace& place : request_.places) layout_.boxes.push_back(found(place));
        return std::move(layout_);
    }

private:
    std::optional<ui::Box> found(const EndPlace& place) const
    {
        for (std::size_t row = 0; row < rows_.n; ++row)
            for (const double apart : {0.3, 1.0}) {
                if (const auto box = found_in(row, apart, place)) return box;
                if (row == 0) break;
            }
        return std::nullopt;
    }

    std::optional<ui::Box> found_in(std::size_t row, double apart, const EndPlace& place) const
    {
        const double share = rows_.n > 1 ? past_middle : 0.5; // of the member: how far from its joint
        const ui::Size size = size_of(place);
        const double most = std::max(0.0, share * place.length - 0.5 * extent(place.along, size));
        for (const double shift : {0.0, 0.5, 1.0, 1.6, 2.4, 3.5, 5.0, 7.0}) {
            if (shift > 0.0 && shift * type_ > most) break;
            for (const ui::Point side : sides(place, row)) {
                const double drop = static_cast<double>(row) * (extent(side, size) + apart * type_);
                const ui::Box box = at(place, side, shift * type_, drop);
                if (is_free(box) && (row == 0 || is_in_sight(at(place, side, shift * type_, 0.0), box))) return box;
            }
        }
        return std::nullopt;
    }

    /// On the side of a beam that is tried first, outside a column; then on the other.
    std::vector<ui::Point> sides(const EndPlace& place, std::size_t row) const
    {
        const ui::Point normal = ui::left_normal(place.along);
        const bool is_flat = std::abs(place.along.y) < 0.5;
        const ui::Point wanted = is_flat ? ui::Point{0.0, down_} : place.joint - request_.middle;
        const ui::Point first = ui::dot(normal, wanted) >= -1e-6 ? normal : -normal;
        if (is_flat && place.side != BeamSide::Either)
            return {(first.y > 0.0) == (place.side == BeamSide::Below) ? first : -first};
        if (row > 0 && !is_flat && rows_.inside == Rows::Inside::Avoided) return {first};
        return {first, -first};
    }

    ui::Size size_of(const EndPlace& place) const
    {
        constexpr double least = -1.0; // a head and one line
        const double lines = std::max(least, static_cast<double>(layout_.n_lines) - static_cast<double>(place.n_spare));
        const double head = place.has_box ? head_height : bare_head_height;
        return {width_, type_ * (head + line_height * lines + total_height)};
    }

    static double extent(ui::Point d, ui::Size size)
    {
        return std::abs(d.x) * size.width + std::abs(d.y) * size.height;
    }

    ui::Box at(const EndPlace& place, ui::Point side, double shift, double drop) const
    {
        const double gap = column_gap * type_;
        const ui::Size size = size_of(place);
        const ui::Point middle = place.joint + (gap + shift + 0.5 * extent(place.along, size)) * place.along +
                                 (gap + drop + 0.5 * extent(side, size)) * side;
        return ui::box_at({middle.x - 0.5 * size.width, middle.y - 0.5 * size.height}, size);
    }

    /// No member stands between the place beside the own one and this.
    bool is_in_sight(const ui::Box& beside, const ui::Box& box) const
    {
        const ui::Box between = ui::united(beside, box);
        return std::ranges::none_of(request_.walls, [&](const ui::Box& wall) { return wall.overlaps(between); });
    }

    bool is_free(const ui::Box& box) const
    {
        const auto is_hit = [&](const ui::Box& other) { return other.overlaps(box); };
        const auto is_taken = [&](const std::optional<ui::Box>& other) { return other && other->overlaps(box); };
        return request_.room.contains(box) && std::ranges::none_of(request_.obstacles, is_hit) &&
               std::ranges::none_of(layout_.boxes, is_taken);
    }

    const BlockRequest& request_;
    double type_, down_;
    Rows rows_;
    double width_ = 0.0;
    BlockLayout layout_;
};

auto n_left_out(const BlockLayout& layout)
{
    return std::ranges::count_if(layout.boxes, [](const auto& box) { return !box; });
}

} // namespace

namespace {

double clarity(Rows rows)
{
    if (rows.n == 1) return 1.0;
    return rows.inside == Rows::Inside::Avoided ? still_legible : BlockLayout().clarity;
}

/// Sizes of type from the largest down; the least of the request is tried too.
std::vector<double> types_tried(const BlockRequest& request, double least_type)
{
    std::vector<double> types;
    for (double type = request.largest_type; type > std::max(least_type, request.least_type); type *= 0.9)
        types.push_back(type);
    if (least_type <= request.least_type) types.push_back(request.least_type);
    return types;
}

/// As large as they are whole, down to a size of type.
std::optional<BlockLayout> whole(const BlockRequest& request, double least_type, Rows rows)
{
    for (const double type : types_tried(request, least_type))
        for (std::size_t n = request.most_lines + 1; n-- > request.fewest_lines;)
            for (const Trial::Side side : {Trial::Side::Below, Trial::Side::Above})
                if (auto layout = Trial(request, type, n, side, rows).run_whole()) {
                    layout->clarity = clarity(rows);
                    return layout;
                }
    return std::nullopt;
}

BlockLayout laid_out_inside(const BlockRequest& request)
{
    if (request.n_rows > 1) {
        if (auto layout = whole(request, request.hardly_smaller * request.largest_type, {})) return *layout;
        const Rows outside{.n = request.n_rows, .inside = Rows::Inside::Avoided};
        if (auto layout = whole(request, still_legible * request.largest_type, outside)) return *layout;
        if (auto layout = whole(request, request.least_type, {.n = request.n_rows})) return *layout;
    } else if (auto layout = whole(request, request.least_type, {})) {
        return *layout;
    }
    const double least = request.least_type;
    BlockLayout below = Trial(request, least, request.last_resort, Trial::Side::Below).run();
    BlockLayout above = Trial(request, least, request.last_resort, Trial::Side::Above).run();
    return n_left_out(above) < n_left_out(below) ? above : below;
}

/// The places and obstacles that lie within the room.
BlockRequest inside(const BlockRequest& request, std::vector<std::size_t>& kept)
{
    BlockRequest part = request;
    part.places.clear();
    for (std::size_t i = 0; i < request.places.size(); ++i) {
        const ui::Point at = request.places[i].joint;
        if (!request.room.contains(at)) continue;
        part.places.push_back(request.places[i]);
        kept.push_back(i);
    }
    for (std::vector<ui::Box>* const boxes : {&part.obstacles, &part.walls})
        std::erase_if(*boxes, [&](const ui::Box& box) { return !box.overlaps(request.room); });
    return part;
}

} // namespace

bool is_better(const BlockLayout& a, const BlockLayout& b)
{
    const double clearly = a.clarity > b.clarity ? 1.0 : 1.15;
    if (n_left_out(a) != n_left_out(b)) return n_left_out(a) < n_left_out(b);
    return a.clarity * a.type > clearly * b.clarity * b.type;
}

BlockLayout laid_out(const BlockRequest& request)
{
    std::vector<std::size_t> kept;
    BlockLayout layout = laid_out_inside(inside(request, kept));
    std::vector<std::optional<ui::Box>> boxes(request.places.size());
    for (std::size_t i = 0; i < kept.size(); ++i) boxes[kept[i]] = layout.boxes[i];
    layout.boxes = std::move(boxes);
    return layout;
}

bool is_whole(const BlockLayout& layout)
{
    return std::ranges::all_of(layout.boxes, [](const auto& box) { return box.has_value(); });
}

} // namespace cross
