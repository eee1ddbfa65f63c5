#include "apps/frame/view/predict/score_words.h"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "apps/drawing/sketch/scene.h"

namespace frame {

using ui::translatable;

namespace {

constexpr double good = 0.9; // a share that needs no words

std::string joined(const std::vector<std::string>& parts, std::string_view between)
{
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : std::string(between)) + part;
    return text;
}

std::string_view words_of(Outcome outcome, bool is_of_line)
{
    switch (outcome) {
    case Outcome::NotDrawn: return translatable("nothing drawn");
    case Outcome::DrawnAsZero:
        return is_of_line ? translatable("drawn as zero, but a load there has an effect")
                          : translatable("drawn as zero, but it is bent");
    case Outcome::NotZero:
        return is_of_line ? translatable("a load there has no effect") : translatable("it carries no moment");
    case Outcome::Judged:
    case Outcome::RightlyZero: break;
    }
    return {};
}

std::string_view straight_text(const Truth::Piece& piece)
{
    if (piece.degree == 2 && !piece.is_series) return translatable("straight where it is a parabola");
    if (piece.degree == 3 && !piece.is_series) return translatable("straight where it is a cubic parabola");
    return translatable("straight where it is curved");
}

std::string_view words_of(const PieceMark& mark)
{
    switch (mark.flaw) {
    case Flaw::None: break;
    case Flaw::NotDrawn: return translatable("not drawn");
    case Flaw::Straight: return straight_text(mark.piece);
    case Flaw::Curved: return translatable("curved where it is straight");
    case Flaw::Sloping: return translatable("sloping where it is constant");
    case Flaw::Level: return translatable("level where it slopes");
    case Flaw::OtherWay:
        return mark.piece.degree > 1 ? translatable("curved the other way") : translatable("sloping the other way");
    case Flaw::Uneven: return translatable("unevenly curved");
    }
    return {};
}

/// Collects what is wrong with one member's guess, in the order in which a teacher looks.
class Faults {
public:
    Faults(const ScoreWords& words, const MemberMark& mark, bool is_of_line)
        : words_(words), mark_(mark), score_(mark.score), is_of_line_(is_of_line)
    {}

    std::vector<std::string> all()
    {
        if (const std::string_view outcome = words_of(mark_.outcome, is_of_line_); !outcome.empty()) add(outcome);
        if (mark_.outcome != Outcome::Judged) return std::move(list_);
        add_sign();
        add_zeros();
        for (const PieceMark& piece : score_.pieces) add_piece(piece);
        add_jumps();
        if (score_.extreme < 0.5 && score_.drawn > good) add(translatable("largest at another place"));
        if (list_.empty() && score_.share < 0.95) add(translatable("nearly right"));
        return std::move(list_);
    }

private:
    void add(std::string_view words) { list_.push_back(words_.tr(words)); }
    void add(std::string_view words, std::initializer_list<ui::Catalogue::Argument> arguments)
    {
        list_.push_back(words_.tr(words, arguments));
    }

    void add_sign()
    {
        if (score_.is_mirrored) return add(translatable("on the wrong side throughout"));
        const double missing = 1.0 - score_.drawn, wrong = 1.0 - score_.sign - missing;
        if (missing > 1.0 - good)
            add(translatable("along {share} of its length nothing drawn"), {{"share", percent(missing, words_.tr)}});
        if (wrong > 1.0 - good)
            add(translatable("along {share} of its length on the wrong side"), {{"share", percent(wrong, words_.tr)}});
    }

    void add_zeros()
    {
        const PlaceCount& zeros = score_.zeros;
        const int n_missing = zeros.n_true - zeros.n_found,
                  n_extra = zeros.n_extra - n_missing; // the rest is misplaced
        if (zeros.n_true == 1 && n_missing == 1) add(translatable("the zero is not at its place"));
        else if (n_missing > 0)
            add(translatable("{found} of {total} zeros at their places"),
                {{"found", std::to_string(zeros.n_found)}, {"total", std::to_string(zeros.n_true)}});
        if (n_extra == 1) add(translatable("one zero too many"));
        if (n_extra > 1) add(translatable("{count} zeros too many"), {{"count", std::to_string(n_extra)}});
    }

    void add_piece(const PieceMark& mark)
    {
        if (mark.flaw == Flaw::None || (mark.flaw == Flaw::NotDrawn && score_.pieces.size() == 1)) return;
        if (score_.pieces.size() == 1) return add(words_of(mark));
        add(translatable("{words} (x = {from} to {to})"),
            {{"words", words_.tr(words_of(mark))}, {"from", place(mark.piece.from)}, {"to", place(mark.piece.to)}});
    }

    void add_jumps()
    {
        const PlaceCount& jumps = score_.jumps;
        if (jumps.n_true == 1 && jumps.n_found == 0) add(translatable("without the jump"));
        else if (jumps.n_found < jumps.n_true)
            add(translatable("{found} of {total} jumps at their places"),
                {{"found", std::to_string(jumps.n_found)}, {"total", std::to_string(jumps.n_true)}});
        if (jumps.n_extra > 0) add(translatable("a jump where there is none"));
    }

    std::string place(double x) const
    {
        return words_.units.text(x * words_.shape[mark_.member].length, ui::Measure::Length);
    }

    const ScoreWords& words_;
    const MemberMark& mark_;
    const Score& score_;
    bool is_of_line_;
    std::vector<std::string> list_;
};

} // namespace

std::string percent(double share, const ui::Catalogue& tr)
{
    return tr("{number} %", {{"number", std::to_string(std::lround(100.0 * share))}});
}

std::vector<std::string> ScoreWords::faults(const MemberMark& mark, bool is_of_line) const
{
    return Faults(*this, mark, is_of_line).all();
}

std::vector<std::string> ScoreWords::lines(const Assessment& assessment) const
{
    constexpr std::size_t most = 6;
    std::vector<MemberMark> marks = assessment.members;
    std::ranges::stable_sort(marks, {}, [](const MemberMark& mark) { return mark.score.share; });
    std::vector<std::string> wrong, right;
    for (const MemberMark& mark : marks) {
        const std::string& name = model[mark.member].id;
        const std::vector<std::string> list = faults(mark, assessment.is_of_line);
        if (list.empty()) right.push_back(name);
        else wrong.push_back(name + ":  " + percent(mark.score.share, tr) + "  " + joined(list, "; "));
    }
    std::vector<std::string> lines{tr("Prediction: {share}", {{"share", percent(assessment.share, tr)}})};
    const std::size_t room = most - 1 - (right.empty() ? 0 : 1);
    const bool is_full = wrong.size() > room;
    const std::size_t n = is_full ? room - 1 : wrong.size();
    lines.insert(lines.end(), wrong.begin(), wrong.begin() + static_cast<std::ptrdiff_t>(n));
    if (is_full) lines.push_back(tr("and {count} more", {{"count", std::to_string(wrong.size() - n)}}));
    if (!right.empty()) lines.push_back(tr("right: {names}", {{"names", joined(right, ", ")}}));
    return lines;
}

} // namespace frame
