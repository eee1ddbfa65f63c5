#include <sstream>

#include "apps/plane/document/fault_words.h"
#include "apps/plane/session/session.h"
#include "apps/plane/view/plate_words.h"
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
        for (const auto& load_case : model_.load_cases)
            text_ << '\n'
                  << tr_("Load case {id}", {{"id", load_case.id}}) << ": "
                  << tr_("loads on points: {points}, on curves: {curves}, in regions: {regions}; "
                         "settlements: {settlements}",
                         {{"points", std::to_string(load_case.points.size())},
                          {"curves", std::to_string(load_case.curves.size())},
                          {"regions", std::to_string(load_case.regions.size())},
                          {"settlements", std::to_string(load_case.settlements.size())}})
                  << '\n';
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
