#include "femoop/io/writer/part_text.h"

#include "femoop/io/reader/names.h"

namespace femoop {

void add_if(ObjectText& object, std::string_view key, const std::optional<Quantity>& value)
{
    if (value) object.add(key, *value);
}

std::string text_of(const Units& units)
{
    return ObjectText()
        .add("length", word(names::lengths, units.length))
        .add("force", word(names::forces, units.force))
        .str();
}

std::string text_of(const Material& material)
{
    ObjectText object;
    object.add_text("id", material.id).add("E", material.E);
    add_if(object, "nu", material.nu);
    add_if(object, "G", material.G);
    add_if(object, "alpha", material.alpha);
    add_if(object, "density", material.density);
    add_if(object, "fy", material.fy);
    return object.str();
}

std::string text_of(DofSet dofs)
{
    Lines names;
    for (const Dof dof : all_dofs)
        if (dofs.contains(dof)) names.push_back(quoted_json(name(dof)));
    return json_list(names);
}

std::string text_of(const std::vector<Spring>& springs)
{
    ObjectText object;
    for (const Spring& spring : springs) object.add(name(spring.dof), spring.stiffness);
    return object.str();
}

std::string list_of(const std::vector<Quantity>& quantities)
{
    Lines texts;
    for (const Quantity& quantity : quantities) texts.push_back(json_text(quantity));
    return json_list(texts);
}

std::string lines_text(const Lines& lines, std::size_t indent)
{
    if (lines.empty()) return "[]";
    const std::string margin(indent, ' ');
    std::string text = "[";
    for (const std::string& line : lines) text += (text.size() > 1 ? ",\n" : "\n") + margin + "  " + line;
    return text + '\n' + margin + ']';
}

std::string with_lists(ObjectText object, const NamedLists& lists)
{
    std::string narrow = object.str();
    narrow.pop_back();
    std::size_t width = narrow.size();
    for (const auto& [key, lines] : lists) {
        if (lines.empty()) continue;
        narrow += ",\n     \"" + std::string(key) + "\": " + lines_text(lines, 5);
        const std::string list = json_list(lines);
        width += key.size() + 6 + list.size();
        if (width < line_width) object.add(key, list);
    }
    return width < line_width ? object.str() : narrow + '}';
}

std::string combination_text(const Combination& combination, const std::function<std::string(CaseId)>& case_name)
{
    ObjectText factors;
    for (const Combination::Term& term : combination.terms) factors.add(case_name(term.of), json_text(term.factor));
    return ObjectText().add_text("id", combination.id).add("factors", factors.str()).str();
}

} // namespace femoop
