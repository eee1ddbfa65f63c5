#include <algorithm>

#include "apps/frame/tables/columns.h"
#include "apps/frame/tables/name_column.h"
#include "ui/text/catalogue.h"

namespace frame {

using namespace femoop;
using ui::Measure;
using ui::translatable;

namespace {

template <class Field> Column material_column(std::string_view heading, Measure measure, Field Material::*field)
{
    return field_column(heading, measure, [field](auto& model, const Part& part) {
        return &(model.materials[std::get<MaterialId>(part).index].*field);
    });
}

constexpr auto section_of = [](auto& model, const Part& part) -> auto&
{
    return model.sections[std::get<SectionId>(part).index];
};

Column section_column(std::string_view heading, Measure measure, std::optional<Quantity> Section::*field)
{
    return field_column(heading, measure,
                        [field](auto& model, const Part& part) { return &(section_of(model, part).*field); });
}

Column size_column(std::string_view heading, std::optional<Quantity> SectionShape::*field)
{
    return field_column(heading, Measure::SectionLength, [field](auto& model, const Part& part) {
        auto& shape = section_of(model, part).shape;
        return shape ? &((*shape).*field) : nullptr;
    });
}

Column profile_column()
{
    Column column{.heading = translatable("Profile"), .read = {}};
    column.read = [](const Model& model, const Part& part) -> CellValue {
        const std::optional<std::string>& profile = section_of(model, part).profile;
        if (!profile) return {};
        return *profile;
    };
    column.write = [](Document& document, const Part& part, const CellText& entry) -> Refusal {
        std::optional<std::string>& profile = section_of(document.model, part).profile;
        profile.reset();
        if (!entry.is_empty()) profile = std::string(entry.text);
        return std::nullopt;
    };
    return column;
}

/// In the order of SectionShapeKind.
constexpr std::array shapes{translatable("rectangle"), translatable("circle"), translatable("tube"),
                            translatable("box"),       std::string_view("I"),  std::string_view("T"),
                            std::string_view("L"),     std::string_view("C")};

CellValue shape_value(const Model& model, const Part& part)
{
    const std::optional<SectionShape>& shape = section_of(model, part).shape;
    if (!shape) return {};
    return ui::Message(shapes.at(static_cast<std::size_t>(shape->kind)));
}

Refusal write_shape(Document& document, const Part& part, const CellText& entry)
{
    std::optional<SectionShape>& shape = section_of(document.model, part).shape;
    if (entry.is_empty()) {
        shape.reset();
        return std::nullopt;
    }
    const auto* const kind = std::ranges::find_if(shapes, [&](std::string_view word) { return says(entry, word); });
    if (kind == shapes.end()) {
        std::string words;
        for (const std::string_view word : shapes) words += (words.empty() ? "" : ", ") + entry.manner.tr(word);
        return entry.manner.tr("\"{text}\" is none of {words}", {{"text", entry.text}, {"words", words}});
    }
    if (!shape) shape = SectionShape{};
    shape->kind = static_cast<SectionShapeKind>(kind - shapes.begin());
    return std::nullopt;
}

Column turned_column()
{
    return word_column(translatable("Turned"),
                       {.words = {translatable("no"), translatable("yes")},
                        .get = [](const Model& model, const Part& part) -> std::size_t {
                            return section_of(model, part).turned ? 1 : 0;
                        },
                        .set = [](Document& document, const Part& part,
                                  std::size_t word) { section_of(document.model, part).turned = word == 1; }});
}

} // namespace

std::vector<Column> material_columns()
{
    std::vector<Column> all{name_column<MaterialId>(translatable("Material"), &Model::materials),
                            material_column("E", Measure::Stress, &Material::E),
                            material_column("ν", Measure::Plain, &Material::nu),
                            material_column("G", Measure::Stress, &Material::G),
                            material_column("α", Measure::Expansion, &Material::alpha),
                            material_column("ρ", Measure::Density, &Material::density),
                            material_column("fy", Measure::Stress, &Material::fy)};
    all[0].need = all[1].need = Need::Required;
    return all;
}

std::vector<Column> section_columns()
{
    std::vector<Column> all{name_column<SectionId>(translatable("Section"), &Model::sections),
                            section_column("A", Measure::Area, &Section::A),
                            section_column("Iz", Measure::SecondMoment, &Section::Iz),
                            section_column("Iy", Measure::SecondMoment, &Section::Iy),
                            section_column("J", Measure::SecondMoment, &Section::J),
                            section_column("Asy", Measure::Area, &Section::Asy),
                            section_column("Asz", Measure::Area, &Section::Asz),
                            section_column(translatable("Depth h"), Measure::SectionLength, &Section::h),
                            section_column("yc", Measure::SectionLength, &Section::yc),
                            profile_column(),
                            {.heading = translatable("Shape"), .read = shape_value, .write = write_shape},
                            size_column("b", &SectionShape::b),
                            size_column("h", &SectionShape::h),
                            size_column("d", &SectionShape::d),
                            size_column("t", &SectionShape::t),
                            size_column("bf", &SectionShape::bf),
                            size_column("tf", &SectionShape::tf),
                            size_column("tw", &SectionShape::tw),
                            turned_column()};
    all[0].need = Need::Required;
    return all;
}

} // namespace frame
