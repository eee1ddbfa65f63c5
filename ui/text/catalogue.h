#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ui/text/message.h"
#include "ui/text/po_reader.h"

namespace ui {

/// Languages that the program speaks. The English sentences stand in the source, Brazilian Portuguese in
/// ui/text/pt_BR/.
enum class Language : std::uint8_t { English, Portuguese };

inline constexpr Language all_languages[] = {Language::English, Language::Portuguese};

std::string_view code(Language language);        ///< "en", "pt"
std::string_view native_name(Language language); ///< "English", "Português (Brasil)"
/// "en", "pt", also with a country: "pt_BR.UTF-8", "pt-BR", "en-GB". Nothing for a language that we lack.
std::optional<Language> language_named(std::string_view name);

/// Marks a sentence that is translated later, where it stands in a table: `translatable("Undo")`. The test of the
/// translation files looks for it, as it looks for `tr("...")`.
constexpr std::string_view translatable(std::string_view sentence) { return sentence; }

/// The words of one language: a value that is passed to whoever speaks. A copy is cheap.
///
/// By convention a catalogue is called `tr`, and is asked by the English sentence:
///
///     tr("Undo")
///     tr("{count} faults in {file}", {{"count", "3"}, {"file", "portal.json"}})
///
/// A sentence that the catalogue lacks comes back as it is, in English.
class Catalogue {
public:
    struct Argument {
        std::string_view name;
        std::string_view value;
    };

    Catalogue() = default; ///< English
    explicit Catalogue(Language language);
    Catalogue(Language language, const std::vector<PoEntry>& entries);

    Language language() const { return language_; }
    bool has(std::string_view sentence) const;

    std::string operator()(std::string_view sentence) const;
    std::string operator()(const char* sentence) const { return (*this)(std::string_view(sentence)); }
    /// Puts each value in the place of its {name}; a place without a value stays as it is.
    std::string operator()(std::string_view sentence, std::initializer_list<Argument> arguments) const;
    std::string operator()(const Message& message) const;

private:
    using Sentences = std::map<std::string, std::string, std::less<>>;

    Language language_ = Language::English;
    std::shared_ptr<const Sentences> sentences_;
};

/// The names of the places of a sentence, ascending, as often as they stand: "{a} of {b}" has a and b.
std::vector<std::string> places(std::string_view sentence);

/// Puts each value in the place of its {name}.
std::string filled(std::string_view sentence, std::span<const Catalogue::Argument> arguments);

/// The entries of every translation file of a language that is compiled into the program.
std::vector<PoEntry> compiled_entries(Language language);

} // namespace ui
