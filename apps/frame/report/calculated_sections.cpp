#include "apps/frame/report/calculated_sections.h"

#include <algorithm>
#include <optional>

#include "femoop/section/profile.h"
#include "femoop/section/section_properties.h"
#include "femoop/section/shape.h"

namespace frame {

using namespace femoop;

namespace {

bool can_be_calculated(const Section& section)
{
    if (section.shape) return !why_not(*section.shape);
    return section.profile && find_profile(*section.profile) != nullptr;
}

bool is_sheared(const Model& model, SectionId section)
{
    return std::ranges::any_of(model.members, [&](const Member& member) {
        return member.section == section && member.theory == BeamTheory::Timoshenko && !member.unshearable;
    });
}

void write_out(std::optional<Quantity>& typed, const std::optional<double>& calculated)
{
    if (!typed && calculated) typed = *calculated;
}

Section calculated(const Model& model, SectionId id)
{
    Section section = model[id];
    const SectionProperties of = section_properties(section, model.units);
    const bool is_in_space = model.analysis == AnalysisKind::Frame3d;
    write_out(section.A, of.A);
    write_out(section.h, of.h);
    if (is_truss(model.analysis)) return section;
    write_out(section.Iz, of.Iz);
    if (is_in_space) write_out(section.Iy, of.Iy);
    if (is_in_space || model.analysis == AnalysisKind::Grillage) write_out(section.J, of.J);
    if (!is_sheared(model, id)) return section;
    write_out(section.Asy, of.Asy);
    if (is_in_space) write_out(section.Asz, of.Asz);
    return section;
}

} // namespace

Model with_calculated_sections(Model model)
{
    for (std::size_t i = 0; i < model.sections.size(); ++i)
        if (can_be_calculated(model.sections[i])) model.sections[i] = calculated(model, SectionId(i));
    return model;
}

} // namespace frame
