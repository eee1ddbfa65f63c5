#include <cmath>

#include "femoop/element/beam.h"
#include "femoop/model/check/checker.h"
#include "femoop/section/profile.h"
#include "femoop/section/section_properties.h"
#include "femoop/section/shape.h"

namespace femoop {

namespace {

bool has_properties(const Section& section)
{
    return (!section.shape || !why_not(*section.shape)) &&
           (!section.profile || find_profile(*section.profile) != nullptr);
}

Beam beam_of(const Material& material, const SectionProperties& section, const Member& member)
{
    const bool shears = member.theory == BeamTheory::Timoshenko && !member.unshearable && section.Asy;
    return {.EI = material.E * section.Iz,
            .shear_flexibility = shears ? 1.0 / (material.shear_modulus() * *section.Asy) : 0.0};
}

} // namespace

void Checker::check_foundation(const Member& member, const Entry& place)
{
    require_stiffness(place, "foundation", *member.foundation, dimension::stress);
    if (member.bar || is_truss(model_.analysis)) return add(FaultKind::FoundationOfBar, place, {});
    if (member.rigid || !member.material || !member.section || !is_located(member)) return;
    if (!is_readable(*member.material) || !is_readable(*member.section)) return;
    const Section& section = model_[*member.section];
    if (!has_properties(section)) return;
    const Beam beam = beam_of(model_[*member.material], section_properties(section, model_.units), member);
    const double length = axis(member).length;
    if (!(beam.EI > 0.0) || !(length > 0.0)) return;
    const double stiffest = beam.stiffest_foundation(length);
    if (!(*member.foundation > stiffest)) return;
    const double round = std::pow(10.0, std::floor(std::log10(stiffest)));
    add(FaultKind::FoundationTooStiff, place,
        {shown(*member.foundation, dimension::stress), shown(Quantity(length), dimension::length),
         shown(Quantity(round), dimension::stress)});
}

} // namespace femoop
