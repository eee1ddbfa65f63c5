#include "ui/workbench/file_sentences.h"

namespace ui {

namespace {

Message of_file(std::string_view sentence, const std::filesystem::path& path, Message reason)
{
    return {sentence, {{"file", path.filename().string()}, {"reason", std::move(reason)}}};
}

} // namespace

Message not_opened(const std::filesystem::path& path, const Message& reason)
{
    return of_file(translatable("{file} was not opened: {reason}"), path, reason);
}

Message not_saved(const std::filesystem::path& path, const std::error_code& hindrance)
{
    return of_file(translatable("{file} was not saved: {reason}"), path, Message(hindrance.message()));
}

Message saved(const std::filesystem::path& path)
{
    return {translatable("{file} was saved"), {{"file", path.filename().string()}}};
}

Message not_written(const std::filesystem::path& path, const std::string& reason)
{
    return of_file(translatable("{file} was not written: {reason}"), path, Message(reason));
}

Message not_written(const std::filesystem::path& path, const std::exception& error)
{
    const auto* const of_system = dynamic_cast<const std::system_error*>(&error);
    return not_written(path, of_system != nullptr ? of_system->code().message() : std::string(error.what()));
}

std::string file_name(const std::optional<std::filesystem::path>& path, const Catalogue& tr)
{
    return path ? path->filename().string() : tr("Untitled");
}

} // namespace ui
