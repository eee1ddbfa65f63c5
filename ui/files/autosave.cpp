#include "ui/files/autosave.h"

#include <algorithm>

#include "femoop/files/whole_file.h"
#include "ui/files/in_background.h"

namespace ui {

UnsavedDocument unsaved_text(std::string text, const std::optional<std::filesystem::path>& original,
                             std::function<std::string(const Catalogue&)> about)
{
    return {.state = std::hash<std::string>()(text),
            .original = original,
            .copy =
                [text = std::move(text)] {
                    return [text](const std::filesystem::path& draft) { return files::write_whole_file(draft, text); };
                },
            .about = std::move(about)};
}

std::optional<Message> Autosave::tick(const std::function<std::vector<UnsavedDocument>()>& unsaved, double seconds)
{
    std::optional<Message> told = collect();
    waited_ += seconds;
    if (waited_ < interval) return told;
    waited_ = 0.0;
    const std::vector<UnsavedDocument> documents = unsaved();
    for (const UnsavedDocument& document : documents) keep(document);
    forget_all_but(documents);
    return told;
}

namespace {

std::vector<std::string> in_all_languages(const std::function<std::string(const Catalogue&)>& text)
{
    std::vector<std::string> texts;
    if (text)
        for (const Language language : all_languages) texts.push_back(text(Catalogue(language)));
    return texts;
}

} // namespace

void Autosave::keep(const UnsavedDocument& document)
{
    Kept& kept = kept_[document.document];
    if (kept.is_writing() || kept.state == document.state) return;
    if (!kept.draft) kept.draft = std::make_unique<Draft>(folder_);
    kept.state = document.state;
    const auto write = [draft = kept.draft.get(), copy = document.copy(), original = document.original,
                        about = in_all_languages(document.about)] { return draft->keep(copy, original, about); };
    kept.writing = std::async(in_background(), write);
}

std::optional<Message> Autosave::collect()
{
    std::optional<Message> sentence;
    for (auto& [document, kept] : kept_) {
        if (!kept.is_writing() || !is_ready(kept.writing)) continue;
        if (auto hindered = note_written(kept, kept.writing.get())) sentence = std::move(hindered);
    }
    return sentence;
}

// A full disk or a folder that is not writable must not hinder the work, and the next tick tries again.
std::optional<Message> Autosave::note_written(Kept& kept, const std::error_code& hindrance)
{
    if (hindrance) kept.state.reset();
    const bool was_told = std::ranges::any_of(kept_, [](const auto& entry) { return entry.second.is_hindered; });
    kept.is_hindered = static_cast<bool>(hindrance);
    if (!hindrance || was_told) return std::nullopt;
    return Message(
        translatable("what is not saved cannot be kept for the case of a crash: {folder}: {reason}; save often"),
        {{"folder", folder_.path.string()}, {"reason", Message(hindrance.message())}});
}

void Autosave::forget_all_but(const std::vector<UnsavedDocument>& documents)
{
    std::erase_if(kept_, [&](auto& entry) {
        const bool is_over = std::ranges::find(documents, entry.first, &UnsavedDocument::document) == documents.end();
        if (!is_over || entry.second.is_writing()) return false;
        entry.second.draft->forget();
        return true;
    });
}

std::vector<RecoverableFile> Autosave::new_recoverable_files()
{
    std::vector<RecoverableFile> found = recoverable_files(folder_);
    std::erase_if(found, [&](const RecoverableFile& recoverable) { return !told_.insert(recoverable.draft).second; });
    return found;
}

void Autosave::adopt(std::uint64_t document, std::unique_ptr<Draft> recoverable)
{
    wait();
    if (const auto former = kept_.find(document); former != kept_.end()) former->second.draft->forget();
    kept_[document] = {.draft = std::move(recoverable)};
}

void Autosave::wait() const
{
    for (const auto& [document, kept] : kept_)
        if (kept.is_writing()) kept.writing.wait();
}

void Autosave::forget_all()
{
    wait();
    for (auto& [document, kept] : kept_) kept.draft->forget();
    kept_.clear();
}

} // namespace ui
