#include "apps/frame/document/section_command.h"

#include <algorithm>
#include <utility>
#include <variant>

#include "apps/frame/document/naming.h"
#include "femoop/edit/condense.h"
#include "femoop/edit/naming.h"
#include "femoop/model/quantity/in_units.h"
#include "femoop/model/quantity/quantity_parser.h"
#include "ui/text/catalogue.h"
#include "ui/text/number_format.h"

namespace frame {

using namespace femoop;
using ui::translatable;

namespace {

template <class Id> std::vector<MemberId> members_where(const Model& model, std::optional<Id> Member::*property, Id id)
{
    std::vector<MemberId> found;
    for (std::size_t i = 0; i < model.members.size(); ++i)
        if (model.members[i].*property == id) found.emplace_back(i);
    return found;
}

/// A dimension of a usual size [mm].
double usual_size(SectionShapeKind kind, std::string_view key)
{
    const bool is_solid = kind == SectionShapeKind::Rectangle;
    const bool is_i = kind == SectionShapeKind::I, is_tee = kind == SectionShapeKind::T,
               is_angle = kind == SectionShapeKind::L;
    if (key == "h") return is_solid ? 500 : is_i || kind == SectionShapeKind::Box ? 300 : is_angle ? 120 : 200;
    if (key == "b") return is_angle ? 80 : 200;
    if (key == "bf") return is_i ? 150 : is_tee ? 200 : 75;
    if (key == "tf") return is_tee ? 16 : 11;
    if (key == "tw") return is_tee ? 10 : is_i ? 7 : 8.5;
    if (key == "d") return kind == SectionShapeKind::Tube ? 220 : 300;
    return 10; // t
}

// Adds a material or section that the members use from then on.
template <class Entry, class Use>
auto add_for(Model& model, Entry entry, Use Member::*use, std::span<const MemberId> members)
{
    for (const MemberId member : members) (void)model.members.at(member.index); // throws before anything is changed
    const auto id = model.add(std::move(entry));
    for (const MemberId member : members) model.members[member.index].*use = id;
    return id;
}

// Of what comes, what is like nothing that is there.
template <class Entry> std::vector<Entry> strangers(const std::vector<Entry>& there, const std::vector<Entry>& coming)
{
    std::vector<Entry> found;
    for (const Entry& entry : coming) {
        const auto is_like = [&](const Entry& other) { return are_alike(other, entry); };
        if (std::ranges::none_of(there, is_like) && std::ranges::none_of(found, is_like)) found.push_back(entry);
    }
    return found;
}

} // namespace

void put_section(Document& document, SectionId id, Section section)
{
    Section& there = document.model.sections.at(id.index);
    const std::string wanted = section.id;
    section.id = there.id;
    if (!why_not_rename(document.model, id, wanted)) section.id = wanted;
    there = std::move(section);
}

SectionId add_section(Document& document, Section section, std::span<const MemberId> members)
{
    section.id = fresh_id(document.model.sections, section.id);
    return add_for(document.model, std::move(section), &Member::section, members);
}

MaterialId add_material(Document& document, Material material, std::span<const MemberId> members)
{
    material.id = fresh_id(document.model.materials, material.id);
    return add_for(document.model, std::move(material), &Member::material, members);
}

std::optional<ui::Message> why_not_rename(const Model& model, SectionId id, std::string_view name)
{
    return objection(model.sections, &Section::id, id.index, name);
}

std::optional<ui::Message> why_not_rename(const Model& model, MaterialId id, std::string_view name)
{
    return objection(model.materials, &Material::id, id.index, name);
}

void rename(Document& document, SectionId id, std::string name)
{
    document.model.sections.at(id.index).id = std::move(name);
}

void rename(Document& document, MaterialId id, std::string name)
{
    document.model.materials.at(id.index).id = std::move(name);
}

std::vector<MemberId> members_with(const Model& model, SectionId id)
{
    return members_where(model, &Member::section, id);
}

std::vector<MemberId> members_with(const Model& model, MaterialId id)
{
    return members_where(model, &Member::material, id);
}

SectionShape usual_shape(SectionShapeKind kind, const Units& units)
{
    SectionShape shape{.kind = kind};
    for (const ShapeDimension& dimension : dimensions(kind)) {
        std::string text = ui::number_text(usual_size(kind, dimension.key)) + " mm";
        const auto value = parse_quantity(text, dimension::length, units);
        shape.*dimension.value = Quantity(std::get<double>(value), std::move(text));
    }
    return shape;
}

ui::Message sentence_of(const ShapeFault& fault, const ui::DisplayUnits& units)
{
    const ui::Message::Argument key{"key", std::string(fault.key)};
    if (fault.flaw != ShapeFlaw::TooLarge) return {translatable("{key} must be a positive length"), {key}};
    return {
        translatable("{key} must be less than {limit} = {value}"),
        {key, {"limit", std::string(fault.limit_key)}, {"value", units.text(fault.limit, ui::Measure::SectionLength)}}};
}

std::size_t import_properties(Document& document, const Model& other)
{
    Model bare = other;
    bare.extra.clear();
    const Model counted = in_units(bare, document.model.units);
    const std::vector<Material> materials = strangers(document.model.materials, counted.materials);
    const std::vector<Section> sections = strangers(document.model.sections, counted.sections);
    for (const Material& material : materials) add_material(document, material);
    for (const Section& section : sections) add_section(document, section);
    return materials.size() + sections.size();
}

} // namespace frame
