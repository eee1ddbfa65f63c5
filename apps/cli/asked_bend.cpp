#include "apps/cli/asked_bend.h"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "apps/cli/argument.h"
#include "apps/cli/asked_effect.h"
#include "femoop/edit/bend.h"

namespace cli {

namespace {

/// What stands behind each key of "members=BC,DE,curve=arc,rise=2,parts=12".
struct BendWords {
    std::vector<std::string> members, curve, rise, parts;
};

UsageError no_curve(const std::string& text, const ui::Catalogue& tr)
{
    return UsageError(
        tr("--bend: \"{found}\" says no curve; write it like \"members=BC,DE,curve=parabola,rise=2,parts=12\"",
           {{"found", femoop::printable(text)}}));
}

BendWords bend_words(const std::string& text, const ui::Catalogue& tr)
{
    BendWords words;
    const std::array<KeyedList, 4> keys{
        {{"members=", &words.members}, {"curve=", &words.curve}, {"rise=", &words.rise}, {"parts=", &words.parts}}};
    const bool is_read = read_keyed_lists(text, keys) && !words.members.empty() && words.rise.size() == 1;
    if (!is_read || words.curve.size() > 1 || words.parts.size() > 1) throw no_curve(text, tr);
    return words;
}

femoop::BendCurve curve_named(const std::string& name, const ui::Catalogue& tr)
{
    if (name == "arc") return femoop::BendCurve::Arc;
    if (name == "parabola") return femoop::BendCurve::Parabola;
    throw not_one_of("--bend curve", name, "arc, parabola", tr);
}

femoop::Bend bend_of(const BendWords& words, const femoop::Model& model, const ui::Catalogue& tr)
{
    femoop::Bend bend{.rise = length_named("--bend rise", words.rise.front(), model)};
    if (!words.curve.empty()) bend.curve = curve_named(words.curve.front(), tr);
    constexpr WholeRange range{femoop::least_bend_parts, femoop::most_bend_parts};
    if (!words.parts.empty())
        bend.n_parts = static_cast<std::size_t>(whole_number("--bend parts", words.parts.front(), range, tr));
    require_near("--bend rise", words.rise.front(), std::array{bend.rise}, model, tr);
    return bend;
}

std::string bent_text(const std::string& member, const femoop::Model& model, const femoop::BentMember& bent,
                      const ui::Catalogue& tr)
{
    std::string parts;
    for (const femoop::MemberId part : bent.members) parts += (parts.empty() ? "" : ", ") + model[part].id;
    return tr("{member} is bent; its parts are {parts}", {{"member", member}, {"parts", parts}});
}

} // namespace

void AskedBend::declare(OptionParser& options, const ui::Catalogue& tr)
{
    options
        .add_option(
            "--bend", bends_,
            tr("bend members into curves of straight parts, as the frame app does, with the loads on them: "
               "members=M,..,curve=arc|parabola,rise=F,parts=N; F is the rise of the middle over the chord, to the left "
               "of the way from the first end to the last, negative to the other side; N is 2 to 200 (default 12); may "
               "be given again"))
        .option_text("WHAT");
}

void AskedBend::apply(femoop::Model& model, const Console& console) const
{
    const ui::Catalogue& tr = console.tr();
    if (is_truss(model.analysis)) throw UsageError("--bend: " + tr("the bars of a truss stay straight"));
    for (const std::string& text : bends_) {
        const BendWords words = bend_words(text, tr);
        const femoop::Bend bend = bend_of(words, model, tr);
        for (const femoop::MemberId member : members_named("--bend", words.members, model, tr)) {
            if (std::abs(bend.rise) < least_bend_rise(model, member))
                throw UsageError("--bend: " + tr(femoop::no_rise));
            const std::string name = model[member].id;
            const femoop::BentMember bent = bend_member(model, member, bend);
            console.message(bent_text(name, model, bent, tr));
        }
    }
}

} // namespace cli
