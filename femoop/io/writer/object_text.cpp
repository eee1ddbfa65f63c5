#include "femoop/io/writer/object_text.h"

#include <cmath>
#include <stdexcept>

#include "femoop/model/quantity/number_text.h"

namespace femoop {

std::string json_text(double value)
{
    if (!std::isfinite(value))
        throw std::invalid_argument("write_model: a number is not finite; check(model) says which");
    return number_text(value);
}

std::string json_text(const Quantity& value)
{
    return value.has_text() ? quoted_json(value.text()) : json_text(value.value());
}

std::string json_list(const std::vector<std::string>& values)
{
    std::string text = "[";
    for (const std::string& value : values) text += (text.size() > 1 ? ", " : "") + value;
    return text + ']';
}

} // namespace femoop
