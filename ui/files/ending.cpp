#include "ui/files/ending.h"

#include <algorithm>
#include <cctype>

#include "ui/text/catalogue.h"

namespace ui {

namespace {

std::string in_small_letters(std::string text)
{
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

} // namespace

bool has_ending(const std::filesystem::path& file, std::string_view ending)
{
    return in_small_letters(file.filename().string()).ends_with(ending);
}

std::optional<Message> why_not_ending(const std::filesystem::path& file, Endings endings)
{
    if (std::ranges::any_of(endings, [&](const std::string& ending) { return has_ending(file, ending); }))
        return std::nullopt;
    std::string list;
    for (const std::string& ending : endings) list += (list.empty() ? "" : ", ") + ending;
    return Message(translatable("{file} was not written: its name must end in one of {endings}"),
                   {{"file", file.filename().string()}, {"endings", list}});
}

} // namespace ui
