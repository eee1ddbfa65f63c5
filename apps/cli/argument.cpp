#include "apps/cli/argument.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "femoop/model/check/suggestion.h"
#include "ui/text/trimmed.h"

namespace cli {

namespace {

template <class Number> bool reads_as(const std::string& text, Number& number)
{
    const char* end = text.data() + text.size();
    const auto result = std::from_chars(text.data(), end, number);
    return result.ec == std::errc() && result.ptr == end && !text.empty();
}

std::string quoted(const std::string& text) { return '"' + text + '"'; }

} // namespace

long whole_number(std::string_view option, const std::string& text, WholeRange range, const ui::Catalogue& tr)
{
    long number = 0;
    if (reads_as(text, number) && number >= range.least && number <= range.most) return number;
    throw UsageError(tr("{option}: found {found}; wanted a whole number from {least} to {most}",
                        {{"option", option},
                         {"found", quoted(text)},
                         {"least", std::to_string(range.least)},
                         {"most", std::to_string(range.most)}}));
}

double positive_number(std::string_view option, const std::string& text, const ui::Catalogue& tr)
{
    double number = 0.0;
    if (reads_as(text, number) && std::isfinite(number) && number > 0.0) return number;
    throw UsageError(
        tr("{option}: found {found}; wanted a number greater than 0", {{"option", option}, {"found", quoted(text)}}));
}

std::vector<std::string> comma_list(std::string_view text)
{
    std::vector<std::string> parts;
    while (true) {
        const auto comma = text.find(',');
        parts.emplace_back(ui::trimmed(text.substr(0, comma)));
        if (comma == std::string_view::npos) return parts;
        text.remove_prefix(comma + 1);
    }
}

bool read_keyed_lists(std::string_view text, std::span<const KeyedList> lists)
{
    std::vector<std::string>* list = nullptr;
    for (const std::string& part : comma_list(text)) {
        const auto keyed = std::ranges::find_if(lists, [&](const KeyedList& one) { return part.starts_with(one.key); });
        if (keyed != lists.end()) list = keyed->parts;
        if (list == nullptr) return false;
        list->push_back(keyed != lists.end() ? part.substr(keyed->key.size()) : part);
    }
    return true;
}

std::string names_in_words(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 20;
    std::string list;
    for (std::size_t i = 0; i < names.size() && i < most; ++i) list += (i == 0 ? "" : ", ") + names[i];
    return names.size() > most ? list + ", ..." : list;
}

UsageError unknown_choice(std::string_view option, const std::string& found, const std::vector<std::string>& choices,
                          const ui::Catalogue& tr)
{
    const std::vector<std::string_view> candidates(choices.begin(), choices.end());
    std::string text = tr("{option}: there is no {found}", {{"option", option}, {"found", quoted(found)}});
    if (const auto near = femoop::nearest(found, candidates))
        return UsageError(text + "; " + tr("did you mean {word}?", {{"word", quoted(*near)}}));
    if (choices.empty()) return UsageError(text + "; " + tr("the file has none"));
    return UsageError(text + "; " + tr("choose from: {list}", {{"list", names_in_words(choices)}}));
}

UsageError not_one_of(std::string_view option, const std::string& found, std::string_view names,
                      const ui::Catalogue& tr)
{
    return UsageError(tr("{option}: found \"{found}\", wanted one of {names}",
                         {{"option", option}, {"found", found}, {"names", names}}));
}

UsageError no_file(std::string_view subcommand, const ui::Catalogue& tr)
{
    const std::string help = "cremona " + std::string(subcommand) + " --help";
    return UsageError(tr("no file is given; see {command}", {{"command", help}}));
}

UsageError print_different_things(std::string_view a, std::string_view b, const ui::Catalogue& tr)
{
    return UsageError(tr("{a} and {b} print different things; give one of them", {{"a", a}, {"b", b}}));
}

UsageError ask_for_different_things(std::string_view a, std::string_view b, const ui::Catalogue& tr)
{
    return UsageError(tr("{a} and {b} ask for different things; give one of them", {{"a", a}, {"b", b}}));
}

UsageError contradiction(std::string_view a, std::string_view b, const ui::Catalogue& tr)
{
    return UsageError(tr("{a} and {b} contradict one another; give one of them", {{"a", a}, {"b", b}}));
}

UsageError needs_too(std::string_view a, std::string_view b, const ui::Catalogue& tr)
{
    return UsageError(tr("{a} needs {b} too; add it", {{"a", a}, {"b", b}}));
}

femoop::CaseId find_case(const femoop::Model& model, const std::string& name, const ui::Catalogue& tr)
{
    return find_case("--case", model, name, tr);
}

femoop::CaseId find_case(std::string_view option, const femoop::Model& model, const std::string& name,
                         const ui::Catalogue& tr)
{
    if (const auto id = model.find_case(name)) return *id;
    std::vector<std::string> names;
    for (const femoop::CaseId id : all_cases(model)) names.push_back(model.case_name(id));
    if (names.empty())
        throw UsageError(tr("{option}: there is no {found}: the model has no load case",
                            {{"option", std::string(option)}, {"found", quoted(name)}}));
    throw unknown_choice(option, name, names, tr);
}

femoop::MemberId member_named(std::string_view option, const std::string& name, const femoop::Model& model,
                              const ui::Catalogue& tr)
{
    if (const auto member = model.find_member(name)) return *member;
    throw unknown_choice(option, name, ids_of(model.members), tr);
}

std::vector<femoop::MemberId> members_named(std::string_view option, const std::vector<std::string>& names,
                                            const femoop::Model& model, const ui::Catalogue& tr)
{
    std::vector<femoop::MemberId> members;
    for (const std::string& name : names) {
        const femoop::MemberId member = member_named(option, name, model, tr);
        if (std::ranges::find(members, member) == members.end()) members.push_back(member);
    }
    return members;
}

void tell_of_case_named_as_keyword(std::string_view name, const Console& console)
{
    if (name == "all")
        console.message(console.tr()(
            "--case all: this is the load case or combination named \"all\"; leave --case out for all of them"));
    else if (name == "envelope")
        console.message(console.tr()(
            "--case envelope: this is the load case or combination named \"envelope\"; give it another name for the "
            "envelope of all of them"));
}

std::vector<femoop::CaseId> all_cases(const femoop::Model& model)
{
    std::vector<femoop::CaseId> cases;
    for (std::size_t i = 0; i < model.n_cases(); ++i) cases.emplace_back(i);
    return cases;
}

} // namespace cli
