#pragma once

#include <optional>
#include <vector>

#include "femoop/io/reader/file_reader.h"
#include "femoop/plane/model/field.h"

namespace femoop::plane {

/// Reads what may vary in the plane: a number, `[a, b]`, a polynomial or a table (courseware/reference/plane-model-file.md).
class FieldReader : protected FileReader {
protected:
    std::optional<Field> field_value(JsonValue value, Dimension dimension, const Place& place);
    std::vector<Quantity> location(JsonValue value, const Place& place); ///< x and y; empty when absent

private:
    Field::Ends ends(JsonValue value, Dimension dimension, const Place& place);
    Field::Polynomial polynomial(JsonValue value, Dimension dimension, const Place& place);
    std::optional<Field::Term> term(JsonValue value, Dimension dimension, const Place& place);
    Field::Table table(JsonValue about, JsonValue along, JsonValue rows, Dimension dimension, const Place& place);
};

} // namespace femoop::plane
