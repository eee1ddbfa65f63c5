#include "apps/plane/document/insertion.h"

#include <map>
#include <string>
#include <unordered_set>
#include <utility>
#include <vector>

#include "apps/plane/document/part.h"

namespace plane {

namespace {

/// Ids that nothing of a list has yet: P1, P2 ...
class FreeIds {
public:
    template <class Entries> FreeIds(std::string letter, const Entries& entries) : letter_(std::move(letter))
    {
        for (const auto& entry : entries) taken_.insert(entry.id);
    }
    std::string next()
    {
        std::string id;
        do id = letter_ + std::to_string(++n_);
        while (taken_.contains(id));
        return id;
    }

private:
    std::string letter_;
    std::unordered_set<std::string> taken_;
    std::size_t n_ = 0;
};

/// Where each point of a drawing is in the model, to which those are added that it has not.
std::vector<NodeId> points_in(PlaneModel& model, const PlaneModel& drawing)
{
    std::map<std::pair<double, double>, NodeId> there;
    for (std::size_t i = 0; i < model.points.size(); ++i)
        there.try_emplace({model.points[i].at[0], model.points[i].at[1]}, i);
    FreeIds ids("P", model.points);
    std::vector<NodeId> where;
    for (const femoop::plane::PlanePoint& point : drawing.points) {
        const auto [found, is_new] = there.try_emplace({point.at[0], point.at[1]}, model.points.size());
        if (is_new) model.points.push_back({.id = ids.next(), .at = point.at, .support = {}, .size = {}});
        where.push_back(found->second);
    }
    return where;
}

} // namespace

void insert_drawing(Document& document, const PlaneModel& drawing)
{
    PlaneModel& model = document.model;
    const std::vector<NodeId> where = points_in(model, drawing);
    const auto to_model = [&](femoop::plane::DrawnPlace& place) {
        if (place.point) place.point = where[place.point->index];
    };
    FreeIds ids("C", model.curves);
    for (const femoop::plane::PlaneCurve& curve : drawing.curves) {
        femoop::plane::DrawnShape shape = *curve.shape;
        for (femoop::plane::DrawnPlace& place : shape.places) to_model(place);
        if (shape.center) to_model(*shape.center);
        model.curves.push_back({.id = ids.next(), .points = {}, .shape = std::move(shape), .support = {}, .tie = {}});
    }
}

} // namespace plane
