#include "femoop/io/plane/field_text.h"

#include <optional>
#include <utility>

#include "femoop/io/json/json_document.h"
#include "femoop/io/plane/field_reader.h"
#include "femoop/io/plane/plane_names.h"
#include "femoop/io/reader/names.h"
#include "femoop/io/writer/part_text.h"

namespace femoop::plane {

namespace {

std::string form_text(const Quantity& constant) { return json_text(constant); }
std::string form_text(const Field::Ends& ends) { return json_list({json_text(ends.start), json_text(ends.end)}); }
std::string form_text(const Field::Polynomial& terms)
{
    Lines texts;
    for (const Field::Term& term : terms)
        texts.push_back(json_list({json_text(term.factor), std::to_string(term.i), std::to_string(term.j)}));
    return ObjectText().add("polynomial", json_list(texts)).str();
}
std::string form_text(const Field::Table& table)
{
    Lines rows;
    for (const auto& [at, value] : table.rows) rows.push_back(json_list({json_text(at), json_text(value)}));
    ObjectText object;
    object.add("along", word(names::along, table.along));
    if (!table.about.empty()) object.add("about", list_of(table.about));
    return object.add("table", json_list(rows)).str();
}

class LoneFieldReader : private FieldReader {
public:
    explicit LoneFieldReader(const Units& units) { reader_.set_units(units); }

    std::optional<Field> read(JsonValue value, Dimension dimension) { return field_value(value, dimension, {}); }
    std::vector<Fault> faults() { return reader_.collect_faults(); }
};

} // namespace

std::string field_text(const Field& field)
{
    return std::visit([](const auto& form) { return form_text(form); }, field.form);
}

std::variant<Field, std::vector<Fault>> read_field(std::string_view text, Dimension dimension, const Units& units)
{
    const JsonReading json = parse_json(text);
    if (!json.document || !json.faults.empty()) return json.faults;
    LoneFieldReader reader(units);
    std::optional<Field> field = reader.read(json.document->root(), dimension);
    if (std::vector<Fault> faults = reader.faults(); !faults.empty()) return faults;
    return std::move(field).value();
}

} // namespace femoop::plane
