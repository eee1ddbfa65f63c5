#include "apps/mohr/window/expectation.h"

#include <array>

#include "ui/app/expectation.h"
#include "ui/text/number_format.h"

namespace mohr {

namespace {

std::string state(const Session& session)
{
    std::string text;
    for (const std::string& number : session.document().state()) text += (text.empty() ? "" : ", ") + number;
    return text;
}

std::string principal(const Session& session)
{
    const Solution& s = session.solution();
    if (!is_in_space(session.document().subject))
        return ui::number_text(s.principal.first) + " " + ui::number_text(s.principal.second);
    std::string text;
    for (const double value : s.space_principal.values) text += (text.empty() ? "" : " ") + ui::number_text(value);
    return text;
}

std::string normal(const Session& session)
{
    std::string text;
    for (const double part : session.document().normal) text += (text.empty() ? "" : " ") + ui::number_text(part);
    return text;
}

std::string factor(const Session& session)
{
    const auto& safety = session.solution().safety;
    if (!safety) return "nothing";
    return safety->factor ? ui::number_text(*safety->factor) : "never";
}

std::string remark(const Session& session)
{
    const auto all = remarks(session.document(), session.solution());
    return all.empty() ? "nothing" : ui::Catalogue()(all.front());
}

std::string step(const Session& session)
{
    return session.step() ? std::to_string(*session.step()) + " of " + std::to_string(session.n_steps()) : "nothing";
}

/// What became of every answer.
std::string verdicts(const Session& session)
{
    if (!session.practice()) return "nothing";
    constexpr std::array words{"open", "right", "follows", "wrong", "shown"};
    std::string text;
    for (const Judgement& judgement : session.practice()->judgements())
        text += (text.empty() ? "" : " ") + std::string(words[static_cast<std::size_t>(judgement.verdict)]);
    return text;
}

/// What is said of the first wrong answer.
std::string slip(const Session& session)
{
    if (session.practice())
        for (const Judgement& judgement : session.practice()->judgements())
            if (judgement.verdict == Verdict::Wrong) return ui::Catalogue()(judgement.words);
    return "nothing";
}

const ui::Facts<Session>& facts()
{
    static const ui::Facts<Session> all(
        {
            {"state", state},
            {"principal", principal},
            {"angle", [](const Session& s) { return ui::number_text(s.document().angle); }},
            {"normal", normal},
            {"factor", factor},
            {"remark", remark},
            {"step", step},
            {"verdicts", verdicts},
            {"slip", slip},
            {"points",
             [](const Session& s) { return s.practice() ? std::to_string(s.practice()->points()) : "nothing"; }},
        },
        "");
    return all;
}

} // namespace

std::optional<std::string> why_not(std::string_view expectation, const Application& application)
{
    return facts().mismatch(expectation, application.session());
}

} // namespace mohr
