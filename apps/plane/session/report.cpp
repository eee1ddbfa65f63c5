#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>
#include <vector>

#include "apps/plane/document/fault_words.h"
#include "apps/plane/document/load_cases.h"
#include "apps/plane/document/number.h"
#include "apps/plane/session/part_commands.h"
#include "apps/plane/session/session.h"
#include "apps/plane/view/plate_words.h"
#include "femoop/io/plane/field_text.h"
#include "ui/text/number_format.h"

namespace plane {

namespace {

using femoop::plane::DrawnKind;
using ui::Measure;
using ui::translatable;

/// "12,5" of a length, an area counted in its square.
class DescriptionText {
public:
    explicit DescriptionText(const Session& session)
        : session_(session), model_(session.model()), tr_(session.tr()), units_(session.units())
    {}

    std::string run()
    {
        text_ << session_.name() << '\n' << status_text(session_) << '\n';
        tell_curves();
        tell_faces();
        tell_cases();
        tell_results();
        tell_faults();
        return text_.str();
    }

private:
    /// What a point or a curve itself has of a load case.
    inline static const std::vector<std::string_view> of_holder{
        "fx", "fy", "settlement ux", "settlement ux end", "settlement uy", "settlement uy end"};

    void tell_curves()
    {
        if (model_.curves.empty()) return;
        text_ << '\n' << tr_("Curves") << '\n';
        for (const auto& curve : model_.curves) {
            text_ << "  " << curve.id;
            if (curve.shape) text_ << ": " << tr_(word_of(curve.shape->kind)) << ends_of(*curve.shape);
            if (curve.support) text_ << ", " << tr_("held");
            text_ << '\n';
        }
    }

    std::string ends_of(const femoop::plane::DrawnShape& shape) const
    {
        std::string names;
        for (const auto& place : shape.places)
            names += (names.empty() ? " " : "–") + (place.point ? model_[*place.point].id : std::string("·"));
        return names;
    }

    void tell_faces()
    {
        const discretize::Drawing* const drawing = session_.drawing();
        if (drawing == nullptr || drawing->faces().empty()) return;
        text_ << '\n' << tr_("Faces") << '\n';
        for (const auto& face : drawing->faces()) {
            const double factor = units_.unit(Measure::Length).factor;
            const std::string area = ui::number_text(face.area * factor * factor, units_.format()) + " " +
                                     units_.unit(Measure::Length).name + "²";
            text_ << "  " << made_of(face.region) << ", " << tr_("area {area}", {{"area", area}}) << '\n';
        }
    }

    std::string made_of(const std::optional<RegionId>& id) const
    {
        if (!id) return tr_("no region");
        const auto& region = model_[*id];
        if (region.is_hole) return region.id + ": " + tr_("hole");
        std::string text = region.id;
        if (region.material.index < model_.materials.size()) text += ": " + model_[region.material].id;
        if (region.thickness) text += ", " + units_.text(*region.thickness, Measure::Length);
        return text;
    }

    void tell_cases()
    {
        for (std::size_t i = 0; i < model_.n_cases(); ++i) {
            text_ << '\n' << tr_(title(session_, femoop::CaseId(i))) << '\n';
            tell_numbers("", numbers(model_, femoop::CaseId(i)));
            if (i < model_.load_cases.size()) tell_loads(i);
        }
    }

    void tell_loads(std::size_t i)
    {
        const femoop::plane::PlaneLoadCase& loads = model_.load_cases[i];
        for (std::size_t p = 0; p < model_.points.size(); ++p)
            tell_numbers(model_.points[p].id + ": ", numbers(model_, NodeId(p), i), of_holder);
        for (std::size_t c = 0; c < model_.curves.size(); ++c)
            tell_numbers(model_.curves[c].id + ": ", numbers(model_, CurveId(c), i), of_holder);
        for (std::size_t l = 0; l < loads.curves.size(); ++l)
            tell_numbers(names_of(loads.curves[l].curves) + ": " + tr_(word_of(loads.curves[l])),
                         numbers(model_, i, l, loads.curves[l].curves.front()));
        for (std::size_t l = 0; l < loads.regions.size(); ++l) {
            const auto& regions = loads.regions[l].regions;
            const std::string names = regions.empty() ? tr_("all regions") : names_of(regions);
            tell_numbers(names + ": " + tr_(word_of(loads.regions[l])),
                         numbers(model_, i, l, regions.empty() ? RegionId(0U) : regions.front()));
        }
    }

    template <class Id> std::string names_of(const std::vector<Id>& ids) const
    {
        std::string names;
        for (const Id id : ids) names += (names.empty() ? "" : ", ") + model_[id].id;
        return names;
    }

    /// "right: Traction, qx 100 N/mm²": those that are given, of these where some are named.
    void tell_numbers(const std::string& whose, const std::vector<Number>& all,
                      const std::vector<std::string_view>& wanted = {})
    {
        std::string words = whose;
        for (const Number& number : all) {
            const bool is_wanted = wanted.empty() || std::ranges::find(wanted, number.id) != wanted.end();
            if (!is_wanted || (!number.value && !number.field)) continue;
            if (number.id == "self-weight" && number.value->value() == 0.0) continue;
            const bool is_end = number.id.ends_with(" end"); // of what begins with the one before
            if (!words.empty() && !words.ends_with(": ") && !is_end) words += ", ";
            words += is_end ? " … " + value_of(number) : tr_(number.label) + " " + value_of(number);
        }
        if (!words.empty() && !words.ends_with(": ")) text_ << "  " << words << '\n';
    }

    std::string value_of(const Number& number) const
    {
        if (number.field) return tr_(form_of(*number.field)) + " " + femoop::plane::field_text(*number.field);
        return units_.text(*number.value, number.measure);
    }

    void tell_results()
    {
        const std::string results = results_in_words(session_.input(), session_.options());
        if (!results.empty()) text_ << '\n' << tr_("Results") << '\n' << results;
    }

    void tell_faults()
    {
        if (session_.solution().faults().empty()) return;
        text_ << '\n' << tr_("Problems") << '\n';
        for (const auto& fault : session_.solution().faults()) text_ << "  " << sentence(fault, model_, tr_) << '\n';
    }

    const Session& session_;
    const PlaneModel& model_;
    const ui::Catalogue& tr_;
    ui::DisplayUnits units_;
    std::ostringstream text_;
};

} // namespace

std::string_view word_of(DrawnKind kind)
{
    switch (kind) {
    case DrawnKind::Line: return translatable("line");
    case DrawnKind::Arc: return translatable("arc");
    case DrawnKind::Circle: return translatable("circle");
    case DrawnKind::Ellipse: return translatable("ellipse");
    case DrawnKind::Bezier: return translatable("Bézier curve");
    case DrawnKind::Spline: break;
    }
    return translatable("spline");
}

std::string_view word_of(const femoop::plane::CurveLoad& load)
{
    switch (load.kind) {
    case femoop::plane::CurveLoadKind::Traction: return translatable("Traction");
    case femoop::plane::CurveLoadKind::Line: return translatable("Force per length");
    case femoop::plane::CurveLoadKind::Pressure: break;
    }
    return translatable("Pressure");
}

std::string_view word_of(const femoop::plane::RegionLoad& load)
{
    constexpr std::array words{translatable("Body force"), translatable("Rise of temperature"),
                               translatable("Steady rotation")}; // in the order of its forms
    return words.at(load.load.index());
}

std::string status_text(const Session& session)
{
    const ui::Catalogue& tr = session.tr();
    const discretize::Drawing* const drawing = session.drawing();
    std::string text = tr("points: {points}, curves: {curves}",
                          {{"points", std::to_string(session.model().points.size())},
                           {"curves", std::to_string(session.model().curves.size())}});
    if (session.is_refining())
        return tr("refining the mesh: {count} meshes left   (Esc stops)",
                  {{"count", std::to_string(session.n_refinements_left())}});
    if (drawing != nullptr) {
        std::size_t n_empty = 0;
        for (const auto& face : drawing->faces()) n_empty += face.region ? 0 : 1;
        text += "   " + tr("faces: {faces}", {{"faces", std::to_string(drawing->faces().size())}});
        if (n_empty > 0) text += ", " + tr("without a region: {count}", {{"count", std::to_string(n_empty)}});
    }
    return text;
}

std::string description(const Session& session) { return DescriptionText(session).run(); }

} // namespace plane
