#include "apps/plane/document/regions.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "apps/plane/document/erase.h"
#include "apps/plane/document/fresh_id.h"

namespace plane {

using discretize::Drawing;
using femoop::plane::PlaneRegion;

namespace {

/// The material of a hole.
constexpr MaterialId nothing(std::numeric_limits<std::uint32_t>::max());

std::array<femoop::Quantity, 2> typed(const FlatPoint& at) { return {femoop::Quantity(at.x), femoop::Quantity(at.y)}; }

MaterialId some_material(PlaneModel& model)
{
    if (model.materials.empty()) {
        const double pascals = femoop::newtons(model.units.force) /
                               (femoop::metres(model.units.length) * femoop::metres(model.units.length));
        model.materials.push_back({.id = "steel",
                                   .E = femoop::Quantity(200e9 / pascals, "200 GPa"),
                                   .nu = femoop::Quantity(0.3),
                                   .G = {},
                                   .alpha = {},
                                   .density = {},
                                   .fy = {}});
    }
    return MaterialId(model.materials.size() - 1);
}

/// What a face is made of where nobody has said anything yet: as the last region, else steel, 10 mm thick.
void make_solid(PlaneModel& model, PlaneRegion& region)
{
    const auto last = std::find_if(model.regions.rbegin(), model.regions.rend(),
                                   [](const PlaneRegion& other) { return !other.is_hole; });
    region.is_hole = false;
    region.material = last != model.regions.rend() ? last->material : some_material(model);
    if (model.analysis != femoop::StressState::PlaneStress || region.thickness) return;
    if (last != model.regions.rend() && last->thickness) region.thickness = last->thickness;
    else region.thickness = femoop::Quantity(0.01 / femoop::metres(model.units.length), "10 mm");
}

void drop_places_in(PlaneRegion& region, const Drawing& drawing, std::size_t face)
{
    std::erase_if(region.at, [&](const auto& at) { return drawing.face_at({at[0], at[1]}) == face; });
}

/// Entries alike but for their names and places.
bool are_alike(PlaneRegion a, PlaneRegion b)
{
    for (PlaneRegion* region : {&a, &b}) {
        region->id.clear();
        region->at.clear();
        region->is_listed = false;
        if (!region->is_hole) continue;
        region->material = nothing;
        region->thickness.reset();
    }
    return a == b;
}

void erase_region(PlaneModel& model, RegionId region)
{
    Erased erased;
    erased.regions.resize(model.regions.size());
    erased.regions[region.index] = true;
    erase_entries(model, erased);
}

/// A curve of the model on the left or the right hand side of a face's outline.
using Side = std::pair<CurveId, bool>;
using Sides = std::set<Side>;

Sides sides_of(const Drawing& drawing, std::size_t face)
{
    Sides sides;
    const topology::PlanarSubdivision& plane = drawing.subdivision();
    const topology::Solid& solid = plane.solid();
    for (const topology::LoopId l : solid.loops(drawing.faces()[face].id))
        for (const topology::HalfEdgeId h : solid.chain(l)) {
            const auto edge = solid.edge(h);
            if (!edge) continue;
            for (const topology::CurvePart& part : plane.carriers(*edge)) {
                const bool is_along = (solid.plus(*edge) == h) == (part.span.from <= part.span.to);
                sides.insert({drawing.owner(part.curve), is_along});
            }
        }
    return sides;
}

std::size_t n_common(const Sides& a, const Sides& b)
{
    return static_cast<std::size_t>(std::ranges::count_if(a, [&](const Side& side) { return b.contains(side); }));
}

/// Shared sides over all sides: 1 where faces have the same outline.
double likeness(const Sides& a, const Sides& b)
{
    const auto n = static_cast<double>(n_common(a, b));
    return n > 0.0 ? n / (static_cast<double>(a.size() + b.size()) - n) : 0.0;
}

/// Lets the entries of a model follow its faces from one drawing to the next. Curves are known by their names, since
/// their places in the list change when one goes.
class FaceFollower {
public:
    FaceFollower(PlaneModel& model, const Drawing& before, const Drawing& now)
        : model_(model), before_(before), now_(now), claims_(now.faces().size())
    {
        match_curves();
        for (std::size_t i = 0; i < before.faces().size(); ++i) sides_before_.push_back(sides_now(i));
        for (std::size_t i = 0; i < now.faces().size(); ++i) sides_.push_back(sides_of(now, i));
    }

    void run()
    {
        for (std::size_t i = 0; i < model_.regions.size(); ++i) follow(RegionId(i));
        keep_split_faces();
        join_equal_claims();
        drop_lost_entries();
    }

private:
    /// Where each curve of before stands now, by its name, and whether each of now was there.
    void match_curves()
    {
        std::map<std::string_view, CurveId> by_name;
        for (std::size_t i = 0; i < model_.curves.size(); ++i) by_name.emplace(model_.curves[i].id, CurveId(i));
        was_there_.resize(model_.curves.size());
        for (const auto& curve : before_.model().curves) {
            const auto now = by_name.find(curve.id);
            now_of_.push_back(now != by_name.end() ? std::optional(now->second) : std::nullopt);
            if (now != by_name.end()) was_there_[now->second.index] = true;
        }
    }

    /// A face's sides as the curves are numbered now; what has gone is left out.
    Sides sides_now(std::size_t face) const
    {
        Sides sides;
        for (const auto& [curve, is_left] : sides_of(before_, face))
            if (const auto now = now_of_[curve.index]) sides.insert({*now, is_left});
        return sides;
    }

    void follow(RegionId id)
    {
        PlaneRegion& region = model_.regions[id.index];
        if (region.at.empty()) return; // it takes whatever is left
        std::vector<std::array<femoop::Quantity, 2>> kept;
        bool has_outline = false;
        for (const auto& at : region.at) {
            const auto was = before_.face_at({at[0], at[1]});
            has_outline = has_outline || !was || !sides_before_[*was].empty();
            const auto face = face_for(at, was);
            if (face) claim(*face, id);
            if (face && now_.face_at({at[0], at[1]}) != face) kept.push_back(typed(now_.faces()[*face].inside));
            else if (!was || !sides_before_[*was].empty()) kept.push_back(at);
        }
        if (has_outline) region.at = kept.empty() ? std::vector{region.at.front()} : std::move(kept);
        else lost_.insert(id);
    }

    void claim(std::size_t face, RegionId id)
    {
        if (std::ranges::find(claims_[face], id) == claims_[face].end()) claims_[face].push_back(id);
    }

    /// Where the place lies now if that face has something of its old outline, else the face that is most like it.
    std::optional<std::size_t> face_for(const std::array<femoop::Quantity, 2>& at, std::optional<std::size_t> was) const
    {
        const auto there = now_.face_at({at[0], at[1]});
        if (!was) return there;
        if (there && n_common(sides_[*there], sides_before_[*was]) > 0) return there;
        std::optional<std::size_t> best;
        double most = 0.0;
        for (std::size_t i = 0; i < sides_.size(); ++i)
            if (const double share = likeness(sides_[i], sides_before_[*was]); share > most) {
                most = share;
                best = i;
            }
        return best;
    }

    /// A face without a claim that lies in what was a region is a part of it.
    void keep_split_faces()
    {
        for (std::size_t i = 0; i < claims_.size(); ++i) {
            if (!claims_[i].empty()) continue;
            const auto was = before_.face_at(now_.faces()[i].inside);
            const auto region = was ? before_.faces()[*was].region : std::nullopt;
            if (!region || region->index >= model_.regions.size() || model_[*region].at.empty()) continue;
            if (!is_part_of(i, *was)) continue;
            model_.regions[region->index].at.push_back(typed(now_.faces()[i].inside));
            model_.regions[region->index].is_listed = true;
            claim(i, *region);
        }
    }

    /// It has a side of the old face, or lies within it as a whole, as what a new curve encloses.
    bool is_part_of(std::size_t face, std::size_t was) const
    {
        if (n_common(sides_[face], sides_before_[was]) > 0) return true;
        return std::ranges::none_of(sides_[face], [&](const Side& side) { return was_there_[side.first.index]; });
    }

    void join_equal_claims()
    {
        for (std::size_t i = 0; i < claims_.size(); ++i) {
            std::vector<RegionId>& claims = claims_[i];
            for (std::size_t k = 1; k < claims.size(); ++k) {
                if (!are_alike(model_[claims.front()], model_[claims[k]])) continue;
                drop_places_in(model_.regions[claims[k].index], now_, i);
                if (model_[claims[k]].at.empty()) lost_.insert(claims[k]);
            }
            for (const RegionId id : claims) keep_one_place(model_.regions[id.index], i);
        }
    }

    void keep_one_place(PlaneRegion& region, std::size_t face)
    {
        bool has_one = false;
        std::erase_if(region.at, [&](const auto& at) {
            return now_.face_at({at[0], at[1]}) == face && std::exchange(has_one, true);
        });
    }

    void drop_lost_entries()
    {
        for (auto id = lost_.rbegin(); id != lost_.rend(); ++id) erase_region(model_, *id);
    }

    PlaneModel& model_;
    const Drawing &before_, &now_;
    std::vector<std::optional<CurveId>> now_of_; ///< of each curve of before
    std::vector<bool> was_there_;                ///< each curve of now
    std::vector<Sides> sides_before_, sides_;
    std::vector<std::vector<RegionId>> claims_; ///< of each face
    std::set<RegionId> lost_;
};

} // namespace

RegionId make_region(Document& document, const FlatPoint& at)
{
    PlaneModel& model = document.model;
    PlaneRegion region{
        .id = fresh_id(model.regions, "R1"), .material = {}, .at = {typed(at)}, .thickness = {}, .mesh = {}};
    make_solid(model, region);
    model.regions.push_back(std::move(region));
    return RegionId(model.regions.size() - 1);
}

std::vector<std::vector<std::size_t>> faces_of_regions(const Drawing& drawing)
{
    std::vector<std::vector<std::size_t>> faces(drawing.model().regions.size());
    for (std::size_t i = 0; i < drawing.faces().size(); ++i)
        if (const auto region = drawing.faces()[i].region) faces[region->index].push_back(i);
    return faces;
}

RegionId part_off(Document& document, const Drawing& drawing, std::size_t face)
{
    PlaneModel& model = document.model;
    const auto region = drawing.faces()[face].region;
    if (!region) return make_region(document, drawing.faces()[face].inside);
    if (faces_of_regions(drawing)[region->index].size() < 2) return *region;
    PlaneRegion own = model[*region];
    own.id = fresh_id(model.regions, own.id);
    own.at = {typed(drawing.faces()[face].inside)};
    own.is_listed = false;
    if (!model[*region].at.empty()) drop_places_in(model.regions[region->index], drawing, face);
    model.regions.push_back(std::move(own));
    return RegionId(model.regions.size() - 1);
}

void set_hole(Document& document, const Drawing& drawing, std::size_t face, bool is_hole)
{
    const RegionId id = part_off(document, drawing, face);
    PlaneRegion& region = document.model.regions[id.index];
    if (!is_hole) return make_solid(document.model, region);
    region.is_hole = true;
    region.material = nothing;
    region.thickness.reset();
    region.mesh = {};
    for (auto& load_case : document.model.load_cases)
        std::erase_if(load_case.regions,
                      [&](auto& load) { return std::erase(load.regions, id) > 0 && load.regions.empty(); });
}

void follow_faces(Document& document, const Drawing& before)
{
    const PlaneModel now = document.model;
    const Drawing drawing(now);
    if (drawing.faces().empty() && drawing.subdivision().n_regions() > 0) return;
    FaceFollower(document.model, before, drawing).run();
}

std::optional<Dispute> dispute_in(const PlaneModel& model, const Drawing& drawing)
{
    for (std::size_t i = 0; i < model.regions.size(); ++i)
        for (const auto& at : model.regions[i].at) {
            const auto face = drawing.face_at({at[0], at[1]});
            if (!face) continue;
            const auto owner = drawing.faces()[*face].region;
            if (owner && owner->index != i) return Dispute{*owner, RegionId(i), {at[0], at[1]}};
        }
    return std::nullopt;
}

void settle_dispute(Document& document, const Drawing& drawing, const Dispute& dispute, RegionId keeps)
{
    const RegionId loses = keeps == dispute.first ? dispute.second : dispute.first;
    PlaneModel& model = document.model;
    if (const auto face = drawing.face_at(dispute.at)) drop_places_in(model.regions[loses.index], drawing, *face);
    if (model[loses].at.empty()) erase_region(model, loses);
}

} // namespace plane
