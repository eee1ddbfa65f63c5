#include "ui/workbench/file_sentences.h"

namespace ui {

namespace {

Phrase of_file(std::string_view sentence, const std::filesystem::path& path, Phrase reason)
{
    return {sentence, {{"file", path.filename().string()}, {"reason", std::move(reason)}}};
}

} // namespace

Phrase not_opened(const std::filesystem::path& path, const Phrase& reason)
{
    return of_file(translatable("{file} was not opened: {reason}"), path, reason);
}

Phrase not_saved(const std::filesystem::path& path, const std::error_code& hindrance)
{
    return of_file(translatable("{file} was not saved: {reason}"), path, Phrase(hindrance.message()));
}

Phrase saved(const std::filesystem::path& path)
{
    return {translatable("{file} was saved"), {{"file", path.filename().string()}}};
}

Phrase not_written(const std::filesystem::path& path, const std::string& reason)
{
    return of_file(translatable("{file} was not written: {reason}"), path, Phrase(reason));
}

std::string file_name(const std::optional<std::filesystem::path>& path, const Catalogue& tr)
{
    return path ? path->filename().string() : tr("Untitled");
}

} // namespace ui
