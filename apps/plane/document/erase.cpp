#include "apps/plane/document/erase.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "apps/plane/document/points.h"

namespace plane {

using femoop::plane::DrawnKind;
using femoop::plane::DrawnPlace;
using femoop::plane::DrawnShape;

namespace {

bool goes(const std::vector<bool>& erased, std::size_t i) { return i < erased.size() && erased[i]; }

/// Where the entries of a list come to stand once some have gone.
class NewPlaces {
public:
    NewPlaces(const std::vector<bool>& erased, std::size_t n) : places_(n)
    {
        std::uint32_t next = 0;
        for (std::size_t i = 0; i < n; ++i)
            if (!goes(erased, i)) places_[i] = next++;
    }

    template <class Id> bool lost(const Id& id) const { return id.index >= places_.size() || !places_[id.index]; }
    template <class Id> void renumber(Id& id) const
    {
        if (!lost(id)) id.index = *places_[id.index];
    }
    template <class Id> void renumber(std::optional<Id>& id) const
    {
        if (id) renumber(*id);
    }
    template <class Id> bool lost(const std::optional<Id>& id) const { return id && lost(*id); }
    /// \returns whether the list was not empty, and is now
    template <class Id> bool filter(std::vector<Id>& ids) const
    {
        const bool had_some = !ids.empty();
        std::erase_if(ids, [this](const Id& id) { return lost(id); });
        for (Id& id : ids) renumber(id);
        return had_some && ids.empty();
    }

private:
    std::vector<std::optional<std::uint32_t>> places_;
};

template <class Entries> void take_away(Entries& entries, const std::vector<bool>& erased)
{
    std::size_t i = 0;
    std::erase_if(entries, [&](const auto&) { return goes(erased, i++); });
}

class EntryEraser {
public:
    EntryEraser(PlaneModel& model, const Erased& erased)
        : model_(model),
          points_(erased.points, model.points.size()),
          curves_(erased.curves, model.curves.size()),
          regions_(erased.regions, model.regions.size()),
          materials_(erased.materials, model.materials.size())
    {
        erase_cases(erased.cases);
        take_away(model.points, erased.points);
        take_away(model.curves, erased.curves);
        take_away(model.regions, erased.regions);
        take_away(model.materials, erased.materials);
    }

    void run()
    {
        for (auto& curve : model_.curves)
            if (curve.shape) renumber(*curve.shape);
        points_.filter(model_.mesh.corners);
        for (auto& region : model_.regions) {
            points_.filter(region.mesh.corners);
            materials_.renumber(region.material);
        }
        for (auto& load_case : model_.load_cases) filter(load_case);
        std::erase_if(model_.expected, [this](const auto& check) {
            return points_.lost(check.point) || curves_.lost(check.curve) || regions_.lost(check.region);
        });
        for (auto& check : model_.expected) {
            points_.renumber(check.point);
            curves_.renumber(check.curve);
            regions_.renumber(check.region);
        }
    }

private:
    void renumber(DrawnShape& shape)
    {
        for (DrawnPlace& place : shape.places) points_.renumber(place.point);
        if (shape.center) points_.renumber(shape.center->point);
    }

    void filter(femoop::plane::PlaneLoadCase& load_case)
    {
        std::erase_if(load_case.points, [this](const auto& load) { return points_.lost(load.node); });
        for (auto& load : load_case.points) points_.renumber(load.node);
        std::erase_if(load_case.curves, [this](auto& load) { return curves_.filter(load.curves); });
        std::erase_if(load_case.regions, [this](auto& load) { return regions_.filter(load.regions); });
        std::erase_if(load_case.settlements, [this](auto& settlement) {
            return points_.lost(settlement.point) || curves_.filter(settlement.curves);
        });
        for (auto& settlement : load_case.settlements) points_.renumber(settlement.point);
    }

    /// Cases are counted with the combinations behind them.
    void erase_cases(const std::vector<bool>& erased)
    {
        const NewPlaces cases(erased, model_.n_cases());
        const std::size_t n_load_cases = std::min(erased.size(), model_.load_cases.size());
        const std::vector<bool> erased_combinations(erased.begin() + static_cast<std::ptrdiff_t>(n_load_cases),
                                                    erased.end());
        take_away(model_.combinations, erased_combinations);
        take_away(model_.load_cases, erased);
        for (auto& combination : model_.combinations) {
            std::erase_if(combination.terms, [&](const auto& term) { return cases.lost(term.of); });
            for (auto& term : combination.terms) cases.renumber(term.of);
        }
        std::erase_if(model_.expected, [&](const auto& check) { return cases.lost(check.load_case); });
        for (auto& check : model_.expected) cases.renumber(check.load_case);
    }

    PlaneModel& model_;
    NewPlaces points_, curves_, regions_, materials_;
};

/// Of a line that is closed three places are left at least, else two, of a spline three.
std::size_t fewest_places(const DrawnShape& shape)
{
    if (shape.kind == DrawnKind::Line) return shape.is_closed ? 3 : 2;
    return shape.kind == DrawnKind::Spline ? 3 : shape.places.size();
}

/// What goes when parts are erased.
class PartEraser {
public:
    explicit PartEraser(Document& document) : model_(document.model)
    {
        erased_.points.resize(model_.points.size());
        erased_.curves.resize(model_.curves.size());
        erased_.regions.resize(model_.regions.size());
        was_drawn_by_.resize(model_.points.size());
    }

    void run(std::span<const Part> parts)
    {
        for (const Part& part : parts) {
            if (const auto* const point = std::get_if<NodeId>(&part)) erased_.points[point->index] = true;
            if (const auto* const curve = std::get_if<CurveId>(&part)) erased_.curves[curve->index] = true;
        }
        for (std::size_t i = 0; i < model_.curves.size(); ++i)
            if (model_.curves[i].shape) do_without_points(i, *model_.curves[i].shape);
        erase_lone_points();
        erase_entries(model_, erased_);
    }

private:
    bool is_gone(const DrawnPlace& place) const { return place.point && erased_.points[place.point->index]; }

    void do_without_points(std::size_t i, DrawnShape& shape)
    {
        if (erased_.curves[i]) return note_points(shape);
        const auto n_gone = static_cast<std::size_t>(
            std::ranges::count_if(shape.places, [this](const DrawnPlace& place) { return is_gone(place); }));
        if (n_gone > 0 && shape.places.size() < fewest_places(shape) + n_gone) {
            erased_.curves[i] = true;
            return note_points(shape);
        }
        std::erase_if(shape.places, [this](const DrawnPlace& place) { return is_gone(place); });
        if (shape.center && is_gone(*shape.center)) {
            const FlatPoint at = place_of(model_, *shape.center->point);
            shape.center = DrawnPlace{std::nullopt, {femoop::Quantity(at.x), femoop::Quantity(at.y)}};
        }
    }

    void note_points(const DrawnShape& shape)
    {
        for (const DrawnPlace& place : shape.places)
            if (place.point) was_drawn_by_[place.point->index] = true;
        if (shape.center && shape.center->point) was_drawn_by_[shape.center->point->index] = true;
    }

    /// Those that drew an erased curve, and neither draw another one nor carry anything.
    void erase_lone_points()
    {
        std::vector<bool> stays(model_.points.size());
        const auto keep = [&](const DrawnPlace& place) {
            if (place.point) stays[place.point->index] = true;
        };
        for (std::size_t i = 0; i < model_.curves.size(); ++i) {
            const auto& shape = model_.curves[i].shape;
            if (!shape || erased_.curves[i]) continue;
            std::ranges::for_each(shape->places, keep);
            if (shape->center) keep(*shape->center);
        }
        for (const auto& load_case : model_.load_cases) {
            for (const auto& load : load_case.points) stays[load.node.index] = true;
            for (const auto& settlement : load_case.settlements)
                if (settlement.point) stays[settlement.point->index] = true;
        }
        for (std::size_t i = 0; i < model_.points.size(); ++i)
            if (was_drawn_by_[i] && !stays[i] && !model_.points[i].support) erased_.points[i] = true;
    }

    PlaneModel& model_;
    Erased erased_;
    std::vector<bool> was_drawn_by_; ///< an erased curve
};

} // namespace

void erase_entries(PlaneModel& model, const Erased& erased) { EntryEraser(model, erased).run(); }

void erase_parts(Document& document, std::span<const Part> parts) { PartEraser(document).run(parts); }

} // namespace plane
