#include "ui/workbench/file_sentences.h"

#include <span>
#include <utility>

namespace ui {

namespace {

Message of_file(std::string_view sentence, const std::filesystem::path& path, Message reason)
{
    return {sentence, {{"file", path.filename().string()}, {"reason", std::move(reason)}}};
}

Message with_line(Message list, Message next)
{
    return {"{list}\n{next}", {{"list", std::move(list)}, {"next", std::move(next)}}};
}

} // namespace

Message not_opened(const std::filesystem::path& path, const Message& reason)
{
    return of_file(translatable("{file} was not opened: {reason}"), path, reason);
}

Message not_opened(const std::filesystem::path& path, const std::vector<Message>& reasons)
{
    Message list = reasons.front();
    for (const Message& next : std::span(reasons).subspan(1)) list = with_line(std::move(list), next);
    return not_opened(path, list);
}

Message not_opened(const std::filesystem::path& path, const std::error_code& hindrance)
{
    if (hindrance == std::errc::operation_not_supported) return not_opened(path, translatable("it is no regular file"));
    return not_opened(path, Message(hindrance.message()));
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
    const auto* const hindrance = dynamic_cast<const std::system_error*>(&error); // what() names the file again
    return not_written(path, hindrance != nullptr ? hindrance->code().message() : error.what());
}

std::string file_name(const std::optional<std::filesystem::path>& path, const Catalogue& tr)
{
    return path ? path->filename().string() : tr("Untitled");
}

} // namespace ui
