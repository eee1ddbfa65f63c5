#include "femoop/model/fault.h"

#include <cstddef>
#include <utility>

namespace femoop {

namespace {

constexpr char list_separator = '\x1f'; // the unit separator of ASCII: no id contains it

/// A file's own control characters must not reach a terminal: they are written as JSON writes them.
std::string printable(std::string_view text)
{
    static constexpr std::string_view hex = "0123456789abcdef";
    std::string shown;
    for (const char c : text) {
        const auto code = static_cast<unsigned char>(c);
        if (code >= 0x20U && code != 0x7FU) shown += c;
        else shown += {'\\', 'u', '0', '0', hex[code / 16U], hex[code % 16U]};
    }
    return shown;
}

std::string spelled_out(const std::string& argument, std::string_view conjunction)
{
    std::string text;
    const std::size_t last = argument.rfind(list_separator);
    for (std::size_t i = 0; i < argument.size(); ++i) {
        if (argument[i] != list_separator) text += argument[i];
        else if (i == last) text.append(" ").append(conjunction).append(" ");
        else text += ", ";
    }
    return printable(text);
}

} // namespace

std::string listed(const std::vector<std::string>& names)
{
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : std::string(1, list_separator)) + name;
    return text;
}

std::string fill(std::string_view pattern, const std::vector<std::string>& arguments, std::string_view conjunction)
{
    std::string text;
    for (std::size_t i = 0; i < pattern.size(); ++i) {
        const bool is_place = pattern[i] == '{' && i + 2 < pattern.size() && pattern[i + 2] == '}';
        const auto place = is_place ? static_cast<std::size_t>(pattern[i + 1] - '0') : arguments.size();
        if (place < arguments.size()) {
            text += spelled_out(arguments[place], conjunction);
            i += 2;
        } else {
            text += pattern[i];
        }
    }
    return text;
}

std::string message(const Fault& fault) { return fill(pattern(fault.kind), fault.arguments); }

namespace {

std::string sentences(const std::vector<Fault>& faults)
{
    std::string text;
    for (const Fault& fault : faults) text += (text.empty() ? "" : "\n") + message(fault);
    return text;
}

} // namespace

ModelError::ModelError(std::vector<Fault> faults) : std::runtime_error(sentences(faults)), faults_(std::move(faults)) {}

} // namespace femoop
