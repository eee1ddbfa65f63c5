#include "apps/cli/model_input.h"

#include <cstdio>
#include <iostream>
#include <iterator>

namespace cli {

std::string display_name(const std::string& file, const ui::Catalogue& tr)
{
    return file == "-" ? tr("standard input") : file;
}

std::string standard_input(const ui::Catalogue& tr)
{
    std::string text{std::istreambuf_iterator<char>(std::cin), std::istreambuf_iterator<char>()};
    if (std::ferror(stdin) != 0) throw UsageError(tr("standard input cannot be read: is it a folder?"));
    return text;
}

namespace {

void require_name(const std::string& file, const ui::Catalogue& tr)
{
    if (file.empty()) throw UsageError(tr("the name of the file is empty"));
}

} // namespace

femoop::AnyReading examine_any(const std::string& file, const ui::Catalogue& tr)
{
    require_name(file, tr);
    return file != "-" ? femoop::examine_any_file(file) : femoop::examine_any(standard_input(tr));
}

femoop::ModelReading examine(const std::string& file, const ui::Catalogue& tr)
{
    require_name(file, tr);
    if (file != "-") return femoop::examine_model_file(file);
    return femoop::examine_model(standard_input(tr));
}

std::optional<femoop::Model> load_model(const std::string& file, const Console& console)
{
    femoop::ModelReading reading = examine(file, console.tr());
    console.report(display_name(file, console.tr()), reading.faults);
    if (!reading.is_sound()) return std::nullopt;
    return std::move(reading.model);
}

} // namespace cli
