#include "femoop/methods/influence/train/extreme_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace femoop::influence {

namespace {

constexpr double shortest_part = 1e-9;   ///< of a length
constexpr double equal_extremes = 1e-10; ///< of the largest value
constexpr double one_section = 1e-6;     ///< of the member: sections that are one
constexpr int n_looked_at = 32;
constexpr std::size_t n_peaks = 6; ///< that are looked at closely

struct Tried {
    double x = 0.0, value = 0.0; ///< value: times the sign of what is sought
};

bool has_only_fixed_axles(const MovingTrain& train)
{
    return train.uniform == 0.0 && train.concentrated.empty() &&
           std::ranges::all_of(train.spacings, [](const auto& spacing) { return spacing.least == spacing.most; });
}

class SectionSearch {
public:
    SectionSearch(const SectionLines& lines, const std::vector<double>& ends, const MovingTrain& train,
                  ExtremeKind kind, const Permanent* permanent)
        : lines_(lines),
          ends_(ends),
          train_(train),
          permanent_(permanent),
          kind_(kind),
          sign_(kind == ExtremeKind::Max ? 1.0 : -1.0)
    {}

    WorstSection run()
    {
        look_at(0.0);
        look_at(lines_.length());
        std::vector<Tried> with_axle = axle_sections();
        if (is_exact()) {
            for (const Tried& section : with_axle) sections_.push_back(section);
            sort();
        } else {
            for (int i = 1; i < n_looked_at; ++i) {
                look_at(lines_.length() * i / n_looked_at);
                note_bend(sections_.back());
            }
            for (std::size_t i = 0; i < std::min(with_axle.size(), n_peaks); ++i) look_at(with_axle[i].x);
            if (permanent_ != nullptr)
                for (const double x : permanent_->breaks) look_at(x);
            look_towards_ends();
            sort();
            look_where_more_may_be();
            sort();
            for (const auto& [from, to] : peaks()) close_in(from, to);
            sort();
        }
        return worst();
    }

private:
    /// A force is linear in x between the axles.
    bool is_exact() const { return lines_.is_linear() && has_only_fixed_axles(train_) && permanent_ == nullptr; }

    Placing placing_at(double x) const
    {
        const TrainSearch search(lines_.at(x), ends_, train_);
        if (permanent_ == nullptr) return kind_ == ExtremeKind::Max ? search.largest() : search.least();
        Placing placing = (permanent_->factor > 0.0) == (kind_ == ExtremeKind::Max) ? search.largest() : search.least();
        placing.value = permanent_->value(x) + permanent_->factor * placing.value;
        return placing;
    }

    double value_at(double x) const { return sign_ * placing_at(x).value; }
    void look_at(double x) { sections_.push_back({x, value_at(x)}); }
    double hair() const { return hair_within(lines_.length(), ends_.back()); }
    /// The limits there, from two places.
    void look_towards_ends()
    {
        const double length = lines_.length(), near = hair();
        sections_.push_back({0.0, 2.0 * value_at(near) - value_at(2.0 * near)});
        sections_.push_back({length, 2.0 * value_at(length - near) - value_at(length - 2.0 * near)});
    }
    void sort() { std::ranges::sort(sections_, {}, &Tried::x); }

    /// The worst first.
    std::vector<Tried> axle_sections() const
    {
        std::vector<Tried> found;
        for (const PositionFunction& effect : lines_.with_axle_at_section(train_, shortest_part * ends_.back()))
            for (const PositionFunction::Candidate& candidate : inner(effect))
                found.push_back({std::clamp(candidate.x, 0.0, lines_.length()), sign_ * candidate.value});
        std::ranges::sort(found, std::greater<>(), &Tried::value);
        return found;
    }

    /// Without the nothing that is beyond the member.
    static std::vector<PositionFunction::Candidate> inner(const PositionFunction& effect)
    {
        std::vector<PositionFunction::Candidate> all = effect.candidates();
        if (!all.empty()) {
            all.erase(all.begin());
            all.pop_back();
        }
        return all;
    }

    /// The value is the largest of many smooth functions of x, one for each way in which the train may stand: it can
    /// turn up in a kink, but turn down no more sharply than one of them does. That is looked for between kinks.
    void note_bend(const Tried& at)
    {
        constexpr double hair = 1e-3, safety = 3.0;
        const double d = hair * lines_.length();
        const double turn = 2.0 * at.value - value_at(at.x - d) - value_at(at.x + d);
        sharpest_bend_ = std::max(sharpest_bend_, safety * turn / (d * d));
    }

    /// The largest value that was found, and the largest without its sign.
    struct Size {
        double most = -std::numeric_limits<double>::infinity();
        double scale = 0.0;
    };
    Size size() const
    {
        Size found;
        for (const Tried& section : sections_) {
            found.most = std::max(found.most, section.value);
            found.scale = std::max(found.scale, std::abs(section.value));
        }
        return found;
    }

    /// Neighbouring sections, and the most that a value between them can be: that of a parabola over the higher one.
    struct Stretch {
        Tried from, to;
        double bound = 0.0;

        friend bool operator<(const Stretch& a, const Stretch& b) { return a.bound < b.bound; }
    };
    Stretch stretch(const Tried& from, const Tried& to) const
    {
        const double width = to.x - from.x;
        return {from, to, std::max(from.value, to.value) + sharpest_bend_ * width * width / 8.0};
    }

    /// By branch and bound: halves the stretch that promises most until none promises more than there is.
    void look_where_more_may_be()
    {
        constexpr int most_halvings = 400; // where the value is level over a stretch
        auto [most, scale] = size();
        std::priority_queue<Stretch> stretches;
        for (std::size_t i = 0; i + 1 < sections_.size(); ++i) stretches.push(stretch(sections_[i], sections_[i + 1]));
        for (int i = 0; i < most_halvings && stretches.top().bound > most + equal_extremes * scale; ++i) {
            const auto [from, to, bound] = stretches.top();
            stretches.pop();
            look_at(0.5 * (from.x + to.x));
            const Tried middle = sections_.back();
            most = std::max(most, middle.value);
            stretches.push(stretch(from, middle));
            stretches.push(stretch(middle, to));
        }
    }

    /// No neighbour is above it by more than rounding.
    bool is_peak(std::size_t i, double rounding) const
    {
        const double most = sections_[i].value + rounding;
        return (i == 0 || sections_[i - 1].value <= most) &&
               (i + 1 == sections_.size() || sections_[i + 1].value <= most);
    }

    /// Nothing beside it can be as large as what was found.
    bool is_hopeless(std::size_t i, const Size& found) const
    {
        const Tried& at = sections_[i];
        const double before = i > 0 ? stretch(sections_[i - 1], at).bound : at.value;
        const double after = i + 1 < sections_.size() ? stretch(at, sections_[i + 1]).bound : at.value;
        return std::max(before, after) < found.most - equal_extremes * found.scale;
    }

    /// Stretches around the largest values of neighbours.
    std::vector<std::pair<double, double>> peaks() const
    {
        std::vector<std::size_t> found;
        const Size largest = size();
        for (std::size_t i = 0; i < sections_.size(); ++i)
            if (is_peak(i, 0.0) && !is_hopeless(i, largest)) found.push_back(i);
        std::ranges::sort(found, [&](std::size_t i, std::size_t j) { return sections_[i].value > sections_[j].value; });
        if (found.size() > n_peaks) found.resize(n_peaks);
        std::vector<std::pair<double, double>> stretches;
        for (const std::size_t i : found)
            stretches.emplace_back(sections_[i == 0 ? 0 : i - 1].x, sections_[std::min(i + 1, sections_.size() - 1)].x);
        return stretches;
    }

    /// By the golden section.
    void close_in(double from, double to)
    {
        constexpr double golden = 0.6180339887498949;
        double a = to - golden * (to - from), b = from + golden * (to - from);
        double at_a = value_at(a), at_b = value_at(b);
        while (to - from > 1e-10 * lines_.length()) {
            if (at_a >= at_b) {
                to = std::exchange(b, a);
                at_b = at_a;
                a = to - golden * (to - from);
                at_a = value_at(a);
            } else {
                from = std::exchange(a, b);
                at_a = at_b;
                b = from + golden * (to - from);
                at_b = value_at(b);
            }
        }
        sections_.push_back(at_a >= at_b ? Tried{snapped(a), at_a} : Tried{snapped(b), at_b});
    }

    /// The limit towards an end of the member is at that end.
    double snapped(double x) const
    {
        const double length = lines_.length(), near = 0.1 * one_section * length;
        if (x < near) return 0.0;
        return x > length - near ? length : x;
    }

    WorstSection worst() const
    {
        const auto [most, scale] = size();
        if (scale == 0.0) return {.sections = {0.0, lines_.length()}, .placing = placing_at(0.0)}; // nothing anywhere
        std::vector<Tried> equal;
        for (std::size_t i = 0; i < sections_.size(); ++i)
            if (sections_[i].value >= most - equal_extremes * scale && is_peak(i, 0.01 * equal_extremes * scale))
                add(equal, sections_[i]);
        std::vector<double> sections = without_inner(equal, most - equal_extremes * scale);
        Placed first = first_placed(sections, most - 10.0 * equal_extremes * scale);
        first.placing.value = sign_ * most + 0.0;
        return {std::move(sections), std::move(first.placing), first.section, first.inside};
    }

    /// Sections that are one: the better of them.
    void add(std::vector<Tried>& sections, const Tried& next) const
    {
        if (sections.empty() || next.x - sections.back().x > one_section * lines_.length()) sections.push_back(next);
        else if (next.value > sections.back().value) sections.back() = next;
    }

    /// Of a stretch that has the value the two ends alone.
    std::vector<double> without_inner(const std::vector<Tried>& sections, double least) const
    {
        std::vector<double> places;
        bool is_level = false;
        for (std::size_t i = 0; i < sections.size(); ++i) {
            const bool goes_on = i + 1 < sections.size() &&
                                 value_at(0.5 * (sections[i].x + sections[i + 1].x)) >= least;
            if (!(is_level && goes_on)) places.push_back(sections[i].x);
            is_level = goes_on;
        }
        return places;
    }

    struct Placed {
        Placing placing;
        double section, inside;
    };
    /// At a section, or at an end of the member in the limit towards it, where what stands by a hair beside an end of the
    /// path's members stands at that end.
    Placed placed_near(double x, double least) const
    {
        Placed placed{placing_at(x), x, x};
        if (sign_ * placed.placing.value >= least) return placed;
        const double near = hair();
        placed.inside = x > 0.5 * lines_.length() ? x - near : x + near;
        placed.placing = placing_at(placed.inside);
        if (!placed.placing.position) return placed;
        for (const double end : ends_)
            if (std::abs(*placed.placing.position - end) <= 2.0 * near) placed.placing.position = end;
        return placed;
    }

    Placed first_placed(const std::vector<double>& sections, double least) const
    {
        Placed first = placed_near(sections.front(), least);
        for (std::size_t i = 1; i < sections.size(); ++i) {
            Placed other = placed_near(sections[i], least);
            if (is_before(other.placing, first.placing)) first = std::move(other);
        }
        return first;
    }

    static bool is_before(const Placing& a, const Placing& b)
    {
        if (!a.position || !b.position) return a.position.has_value();
        if (a.reversed != b.reversed) return !a.reversed;
        return a.reversed ? *a.position > *b.position : *a.position < *b.position;
    }

    const SectionLines& lines_;
    const std::vector<double>& ends_;
    const MovingTrain& train_;
    const Permanent* permanent_;
    ExtremeKind kind_;
    double sign_;
    double sharpest_bend_ = 0.0; ///< [value / length^2]
    std::vector<Tried> sections_;
};

} // namespace

double search_size(const MovingTrain& train, std::size_t n_members)
{
    constexpr double n_sections = 1600.0, n_exact = 16.0; // that are searched, of both extremes
    constexpr double of_three_axles = 0.04; // one at the section, one at a border, one whose ordinate counts
    const auto n_varying = std::ranges::count_if(train.spacings, [](const auto& one) { return one.most > one.least; });
    const double of_one_section = static_cast<double>((n_members + 1) * (train.axles.size() + 1)) *
                                  static_cast<double>(1 + n_varying);
    const double n_axles = static_cast<double>(train.axles.size()), n_ways = train.both_directions ? 2.0 : 1.0;
    const double with_axle_at_section = of_three_axles * n_ways * static_cast<double>(n_members + 1) *
                                        std::pow(n_axles, 3);
    return of_one_section * (has_only_fixed_axles(train) ? n_exact : n_sections) + with_axle_at_section;
}

double hair_within(double member_length, double path_length)
{
    return std::max(0.05 * one_section * member_length, 2.0 * shortest_part * path_length);
}

WorstSection worst_section(const SectionLines& lines, const std::vector<double>& ends, const MovingTrain& train,
                           ExtremeKind kind, const Permanent* permanent)
{
    return SectionSearch(lines, ends, train, kind, permanent).run();
}

} // namespace femoop::influence
