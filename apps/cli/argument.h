#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/console.h"
#include "femoop/model/model.h"

namespace cli {

/// The value of an option, read as what it must be. \throws UsageError naming the option, what was found and what is
/// wanted
struct WholeRange {
    long least = 0, most = 0;
};
long whole_number(std::string_view option, const std::string& text, WholeRange range, const ui::Catalogue& tr);
double positive_number(std::string_view option, const std::string& text, const ui::Catalogue& tr);

/// The parts between the commas; blanks around them are left out.
std::vector<std::string> comma_list(std::string_view text);

/// What stands behind a key, such as "members=", of "cut=BC@2,DE@50%,beside=A".
struct KeyedList {
    std::string_view key;
    std::vector<std::string>* parts;
};
/// False where no key stands before a part.
bool read_keyed_lists(std::string_view text, std::span<const KeyedList> lists);

/// "G, Q, W", of many the first: "G, Q, ...".
std::string names_in_words(const std::vector<std::string>& names);

/// "--case: there is no "Gg"; did you mean "G"?", else with the list of what there is.
UsageError unknown_choice(std::string_view option, const std::string& found, const std::vector<std::string>& choices,
                          const ui::Catalogue& tr);

/// "--method: found "x", wanted one of joints, sections".
UsageError not_one_of(std::string_view option, const std::string& found, std::string_view names,
                      const ui::Catalogue& tr);
/// Sends to the help of the subcommand.
UsageError no_file(std::string_view subcommand, const ui::Catalogue& tr);
/// Two options that do not go together, by what they do.
UsageError print_different_things(std::string_view a, std::string_view b, const ui::Catalogue& tr);
UsageError ask_for_different_things(std::string_view a, std::string_view b, const ui::Catalogue& tr);
UsageError contradiction(std::string_view a, std::string_view b, const ui::Catalogue& tr);
/// The second one is missing.
UsageError needs_too(std::string_view a, std::string_view b, const ui::Catalogue& tr);

/// The load case or combination of this name, asked for by `--case` or another option. \throws UsageError
femoop::CaseId find_case(const femoop::Model& model, const std::string& name, const ui::Catalogue& tr);
femoop::CaseId find_case(std::string_view option, const femoop::Model& model, const std::string& name,
                         const ui::Catalogue& tr);
std::vector<femoop::CaseId> all_cases(const femoop::Model& model);

void tell_of_case_named_as_keyword(std::string_view name, const Console& console);
/// Says that `--case all` or `--case envelope` is the case of this name, where the file has one.
template <class Model>
void tell_of_case_named_as_keyword(const std::optional<std::string>& typed, const Model& model, const Console& console)
{
    if (typed && model.find_case(*typed)) tell_of_case_named_as_keyword(*typed, console);
}

/// The members of these names, each once. \throws UsageError naming the option
femoop::MemberId member_named(std::string_view option, const std::string& name, const femoop::Model& model,
                              const ui::Catalogue& tr);
std::vector<femoop::MemberId> members_named(std::string_view option, const std::vector<std::string>& names,
                                            const femoop::Model& model, const ui::Catalogue& tr);

/// Of nodes, members, paths.
template <class Parts> std::vector<std::string> ids_of(const Parts& parts)
{
    std::vector<std::string> ids;
    for (const auto& part : parts) ids.push_back(part.id);
    return ids;
}

} // namespace cli
