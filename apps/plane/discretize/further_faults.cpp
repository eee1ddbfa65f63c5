#include "apps/plane/discretize/further_faults.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include "apps/plane/discretize/drawing.h"
#include "apps/plane/discretize/fault_place.h"
#include "apps/plane/discretize/meshed_drawing.h"
#include "femoop/model/fault/errors_among.h"
#include "femoop/plane/check/plane_check.h"

namespace discretize {

namespace {

using femoop::Fault;
using femoop::plane::DrawnKind;
using femoop::plane::PlaneExpected;
using femoop::plane::PlaneModel;
using femoop::plane::PlaneQuantity;

/// Puts something right in the place of what is not, entry by entry, so that all others keep their numbers.
class Mend {
public:
    explicit Mend(PlaneModel& model) : model_(model) {}

    /// \returns whether each of the faults was of an entry that it could put right
    bool run(const std::vector<Fault>& faults)
    {
        return std::ranges::all_of(
            faults, [&](const Fault& fault) { return !fault.arguments.empty() && mend(fault.arguments.front()); });
    }
    bool has_replaced_curves() const { return has_replaced_curves_; }

private:
    bool mend(const std::string& place)
    {
        const auto entry = entry_of(place);
        if (!entry) return false;
        const auto is_of = [&](std::string_view list, const auto& entries) {
            return entry->list == list && entry->index < entries.size();
        };
        const std::size_t i = entry->index;
        if (is_of("materials", model_.materials)) {
            auto& material = model_.materials[i];
            material = {.id = material.id, .E = 1.0, .nu = 0.2, .G = {}, .alpha = {}, .density = {}, .fy = {}};
            return true;
        }
        if (is_of("regions", model_.regions)) return mend_region(i);
        if (is_of("points", model_.points)) {
            model_.points[i].support.reset();
            model_.points[i].size.reset();
            return true;
        }
        if (is_of("curves", model_.curves)) return mend_curve(i);
        if (is_of("load_cases", model_.load_cases)) {
            auto& load_case = model_.load_cases[i];
            load_case.points.clear();
            load_case.curves.clear();
            load_case.regions.clear();
            load_case.settlements.clear();
            return true;
        }
        if (is_of("expected", model_.expected)) {
            PlaneExpected harmless;
            harmless.quantity = PlaneQuantity::Count;
            harmless.counted = "vertices";
            model_.expected[i] = harmless;
            return true;
        }
        return false;
    }

    bool mend_region(std::size_t i)
    {
        auto& region = model_.regions[i];
        const auto before = region;
        region.thickness.reset();
        if (!region.is_hole && model_.analysis != femoop::StressState::Axisymmetric)
            region.thickness = femoop::Quantity(1.0);
        region.mesh = {};
        return !(region == before);
    }

    /// First what it carries goes; if that is not what is wrong, another line runs along one that is right.
    bool mend_curve(std::size_t i)
    {
        auto& curve = model_.curves[i];
        const auto before = curve;
        curve.support.reset();
        curve.tie = {};
        if (curve.shape) curve.shape->divide.clear();
        if (curve.shape) curve.shape->is_divided_by_piece = false;
        if (!(curve == before)) return true;
        for (std::size_t k = 0; k < model_.curves.size(); ++k) {
            const auto& other = model_.curves[k].shape;
            const bool is_right = k != i && other && other->kind == DrawnKind::Line && !is_replaced(k);
            if (!is_right || !is_alone_sound(k)) continue;
            curve.shape = other;
            replaced_.push_back(i);
            return has_replaced_curves_ = true;
        }
        return false;
    }

    bool is_replaced(std::size_t i) const { return std::ranges::find(replaced_, i) != replaced_.end(); }
    bool is_alone_sound(std::size_t i) const
    {
        PlaneModel alone;
        alone.analysis = model_.analysis;
        alone.units = model_.units;
        alone.is_drawn = true;
        alone.points = model_.points;
        alone.curves = {model_.curves[i]};
        if (!femoop::errors_among(femoop::plane::check(alone)).empty()) return false;
        return Drawing(alone).is_sound();
    }

    PlaneModel& model_;
    std::vector<std::size_t> replaced_;
    bool has_replaced_curves_ = false;
};

} // namespace

std::vector<Fault> further_faults(PlaneModel model, std::vector<Fault> known)
{
    constexpr int most_rounds = 8;
    const std::vector<Fault> of_entries = femoop::errors_among(femoop::plane::check(model));
    const auto is_of_entries = [&](const Fault& fault) {
        return std::ranges::find(of_entries, fault) != of_entries.end();
    };
    known = femoop::errors_among(std::move(known));
    if (!model.is_drawn || !std::ranges::all_of(known, is_of_entries)) return {};
    known.insert(known.end(), of_entries.begin(), of_entries.end()); // reading excused what follows from another fault
    std::vector<Fault> further;
    Mend mend(model);
    const auto take = [&](const std::vector<Fault>& found) {
        for (const Fault& fault : found) {
            const bool is_known = std::ranges::find(known, fault) != known.end();
            if (is_known || (mend.has_replaced_curves() && is_of_faces(fault.kind))) continue;
            known.push_back(fault);
            further.push_back(fault);
        }
    };
    for (int round = 0; round < most_rounds; ++round) {
        std::vector<Fault> found = femoop::errors_among(femoop::plane::check(model));
        take(found);
        if (found.empty()) {
            const Drawing drawing(model);
            found = femoop::errors_among(drawing.faults());
            take(found);
            if (found.empty()) {
                if (!mend.has_replaced_curves()) take(femoop::errors_among(MeshedDrawing(drawing).faults()));
                break;
            }
        }
        if (!mend.run(found)) break;
    }
    return further;
}

} // namespace discretize
