#include "apps/euler/view/planar/spring_net.h"

#include <algorithm>

namespace euler {

namespace {

using Places = std::vector<ui::Point>;

/// The pulls of all springs on the free nodes, with the sign that pulls towards the neighbours are negative.
class Pulls {
public:
    explicit Pulls(const SpringNet& net) : net_(net) {}

    Places operator()(const Places& at) const
    {
        Places pull(at.size());
        for (const auto& [a, b] : net_.springs) {
            const ui::Point d = at[a] - at[b];
            if (!net_.held[a]) pull[a] = pull[a] + d;
            if (!net_.held[b]) pull[b] = pull[b] - d;
        }
        return pull;
    }

private:
    const SpringNet& net_;
};

double product(const Places& a, const Places& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += ui::dot(a[i], b[i]);
    return sum;
}

void add(Places& to, double factor, const Places& what)
{
    for (std::size_t i = 0; i < to.size(); ++i) to[i] = to[i] + factor * what[i];
}

} // namespace

std::vector<ui::Point> at_rest(const SpringNet& net)
{
    constexpr double at_rest_below = 1e-20; // square of all pulls together
    const Pulls pulls(net);
    Places at(net.held.size());
    for (std::size_t i = 0; i < at.size(); ++i) at[i] = net.held[i].value_or(ui::Point{});
    Places left(at.size());
    add(left, -1.0, pulls(at));
    Places step = left;
    double square = product(left, left);
    for (std::size_t i = 0; i < 4 * at.size() && square > at_rest_below; ++i) {
        const Places pull = pulls(step);
        const double share = square / product(step, pull);
        add(at, share, step);
        add(left, -share, pull);
        const double before = square;
        square = product(left, left);
        for (std::size_t k = 0; k < step.size(); ++k) step[k] = left[k] + (square / before) * step[k];
    }
    return at;
}

} // namespace euler
