#include "ui/command/argument.h"

#include <algorithm>

#include "ui/scenario/words.h"
#include "ui/text/number_format.h"

namespace ui {

std::vector<std::string> Argument::words() const { return words_of(text); }

std::optional<double> Argument::number() const { return number_typed(text); }

std::optional<std::vector<double>> Argument::numbers(std::size_t count) const
{
    std::string plain(text);
    std::ranges::replace_if(
        plain, [](char c) { return c == ',' || c == '(' || c == ')'; }, ' ');
    std::vector<double> values;
    for (const std::string& word : words_of(plain))
        if (const auto value = number_typed(word)) values.push_back(*value);
    return values.size() == count ? std::optional(values) : std::nullopt;
}

Message Argument::wanted(std::string_view what) const
{
    return {"{command}: found \"{found}\", wanted {what}",
            {{"command", std::string(id)}, {"found", std::string(text)}, {"what", std::string(what)}}};
}

} // namespace ui
