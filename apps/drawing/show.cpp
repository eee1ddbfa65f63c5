#include "apps/drawing/show.h"

#include "ui/text/catalogue.h"
#include "ui/text/trimmed.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace drawing {

namespace {

using ui::translatable;

const std::array<ShowWord, 22>& words()
{
    static const std::array<ShowWord, 22> list{{
        {"loads", {Show::Loads}, translatable("the loads of the case")},
        {"reactions", {Show::Reactions}, translatable("what the supports do to the structure")},
        {"N", {Show::N}, translatable("axial force diagram")},
        {"V", {Show::V}, translatable("shear force diagram (in space Vy and Vz)")},
        {"M", {Show::M}, translatable("bending moment diagram (in space My and Mz)")},
        {"T", {Show::T}, translatable("torsional moment diagram")},
        {"Vy", {Show::Vy}, translatable("shear force along y'")},
        {"Vz", {Show::Vz}, translatable("shear force along z'")},
        {"My", {Show::My}, translatable("bending moment about y'")},
        {"Mz", {Show::Mz}, translatable("bending moment about z'")},
        {"deformed", {Show::Deformed}, translatable("deformed shape")},
        {"thrust", {Show::Thrust}, translatable("line of thrust of a plane frame")},
        {"values", {Show::Values}, translatable("numbers beside loads, reactions and diagrams")},
        {"steps", {Show::StepValues}, translatable("numbers at every tenth of a diagram")},
        {"nodes", {Show::NodeNames}, translatable("names of the nodes")},
        {"members", {Show::MemberNames}, translatable("names of the members")},
        {"dimensions", {Show::Dimensions}, translatable("chains of dimension lines around the structure")},
        {"drawn", {Show::DrawnDimensions}, translatable("dimension lines that were drawn by hand")},
        {"axes", {Show::LocalAxes}, translatable("the members' own axes")},
        {"counting", {Show::Counting}, translatable("what the degree of indeterminacy is made of")},
        {"legend", {Show::Legend}, translatable("title, case, scales, signs")},
        {"labels", labels, translatable("values, nodes, members, drawn and legend together")},
    }};
    return list;
}

bool same_letters(std::string_view a, std::string_view b)
{
    const auto same = [](unsigned char c, unsigned char d) { return std::tolower(c) == std::tolower(d); };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), same);
}

std::string all_text()
{
    std::string list;
    for (const ShowWord& known : words()) list += (list.empty() ? "" : ", ") + std::string(known.word);
    return list;
}

ShowSet shown_by(std::string_view word)
{
    const auto known = std::find_if(words().begin(), words().end(),
                                    [&](const ShowWord& w) { return same_letters(w.word, word); });
    if (known != words().end()) return known->shows;
    throw ShowError(std::string(word));
}

} // namespace

std::span<const ShowWord> show_text() { return words(); }

ShowError::ShowError(std::string word)
    : std::runtime_error("--show: no \"" + word + "\"; choose from " + all_text()), word_(std::move(word))
{}

ShowSet parse_show(std::string_view list)
{
    ShowSet set;
    while (!list.empty()) {
        const std::size_t comma = std::min(list.find(','), list.size());
        const std::string_view word = ui::trimmed(list.substr(0, comma));
        if (!word.empty()) set = set | shown_by(word);
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return set;
}

std::string words_of(ShowSet set)
{
    std::string list;
    for (const ShowWord& known : words()) {
        const bool is_several = known.shows == labels;
        if (is_several || known.shows - set != ShowSet{}) continue;
        list += (list.empty() ? "" : ",") + std::string(known.word);
    }
    return list;
}

} // namespace drawing
