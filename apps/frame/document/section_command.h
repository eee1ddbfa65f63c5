#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/frame/document/document.h"
#include "femoop/section/shape.h"
#include "ui/text/display_units.h"
#include "ui/text/message.h"

namespace frame {

/// Commands on the named property sets of a document: sections and materials. They throw std::out_of_range, with the
/// document as it was, where one is not there.

/// The section becomes this one; its name is made fresh where another has it.
void put_section(Document& document, femoop::SectionId id, femoop::Section section);
/// A new section at the end of the list, which these members get. \returns its id
femoop::SectionId add_section(Document& document, femoop::Section section,
                              std::span<const femoop::MemberId> members = {});
femoop::MaterialId add_material(Document& document, femoop::Material material,
                                std::span<const femoop::MemberId> members = {});

/// Why it cannot have this name; nothing where it can.
std::optional<ui::Message> why_not_rename(const femoop::Model& model, femoop::SectionId id, std::string_view name);
std::optional<ui::Message> why_not_rename(const femoop::Model& model, femoop::MaterialId id, std::string_view name);
/// \pre why_not_rename gives no reason. What refers to it follows, since references are no names.
void rename(Document& document, femoop::SectionId id, std::string name);
void rename(Document& document, femoop::MaterialId id, std::string name);

/// The members that have this section.
std::vector<femoop::MemberId> members_with(const femoop::Model& model, femoop::SectionId id);
std::vector<femoop::MemberId> members_with(const femoop::Model& model, femoop::MaterialId id);

/// A shape of a usual size (a steel I 300 mm high, a concrete rectangle 200 by 500 mm), its dimensions typed in mm.
femoop::SectionShape usual_shape(femoop::SectionShapeKind kind, const femoop::Units& units);

/// What is wrong with a shape, as a sentence for a field.
ui::Message sentence_of(const femoop::ShapeFault& fault, const ui::DisplayUnits& units);

/// The materials and sections of another model, in the units of the document: those that are like one that is there
/// stay out, names that are taken are made fresh. \returns how many came
std::size_t import_properties(Document& document, const femoop::Model& other);

} // namespace frame
