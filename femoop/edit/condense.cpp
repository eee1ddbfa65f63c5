#include "femoop/edit/condense.h"

#include <algorithm>
#include <vector>

#include "femoop/edit/erase.h"
#include "femoop/section/profile.h"
#include "femoop/section/shape.h"

namespace femoop {

namespace {

void drop_text(Quantity& number) { number = number.value(); }
void drop_text(std::optional<Quantity>& number)
{
    if (number) drop_text(*number);
}

/// The material by its numbers alone.
Material bare(Material material)
{
    material.id.clear();
    drop_text(material.E);
    for (auto* number : {&material.nu, &material.G, &material.alpha, &material.density, &material.fy})
        drop_text(*number);
    return material;
}

/// The section by its numbers alone, its profile as the tables name it.
Section bare(Section section)
{
    section.id.clear();
    for (auto* number :
         {&section.A, &section.Iz, &section.Iy, &section.J, &section.Asy, &section.Asz, &section.h, &section.yc})
        drop_text(*number);
    if (section.shape)
        for (const ShapeDimension& dimension : shape_dimensions()) drop_text((*section.shape).*dimension.value);
    if (const Profile* profile = section.profile ? find_profile(*section.profile) : nullptr)
        section.profile = profile->name;
    return section;
}

/// Of each entry the earliest one like it.
template <class Entry> std::vector<std::size_t> earliest_alike(const std::vector<Entry>& list)
{
    std::vector<Entry> bares;
    std::vector<std::size_t> earliest;
    for (const Entry& entry : list) {
        bares.push_back(bare(entry));
        const auto found = std::ranges::find(bares, bares.back());
        earliest.push_back(static_cast<std::size_t>(found - bares.begin()));
    }
    return earliest;
}

template <class Id> void refer(std::optional<Id>& id, const std::vector<std::size_t>& earliest)
{
    if (id) id = Id(earliest[id->index]);
}

/// Those that are like an earlier one, or that nobody uses.
template <class Id>
std::vector<Id> needless(const Model& model, const std::vector<std::size_t>& earliest, Condensed& condensed)
{
    std::vector<Id> found;
    for (std::size_t i = 0; i < earliest.size(); ++i) {
        const bool is_equal = earliest[i] != i;
        if (!is_equal && is_used(model, Id(i))) continue;
        ++(is_equal ? condensed.n_equal : condensed.n_unused);
        found.emplace_back(i);
    }
    return found;
}

} // namespace

bool are_alike(const Material& a, const Material& b) { return bare(a) == bare(b); }
bool are_alike(const Section& a, const Section& b) { return bare(a) == bare(b); }

Condensed condense(Model& model)
{
    const std::vector<std::size_t> material = earliest_alike(model.materials), section = earliest_alike(model.sections);
    for (Member& member : model.members) {
        refer(member.material, material);
        refer(member.section, section);
    }
    Condensed condensed;
    const auto materials = needless<MaterialId>(model, material, condensed);
    const auto sections = needless<SectionId>(model, section, condensed);
    erase(model, {.materials = materials, .sections = sections});
    return condensed;
}

} // namespace femoop
