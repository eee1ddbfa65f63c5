#include "apps/euler/view/planar/spring_net.h"

#include <functional>
#include <iterator>
#include <queue>
#include <unordered_map>
#include <utility>

namespace euler {

namespace {

/// What pulls a free node: springs to other free nodes, and all those to held ones taken together.
struct Node {
    std::unordered_map<std::size_t, double> springs; ///< stiffness by node
    double held = 0.0;                               ///< stiffness of those to held nodes
    ui::Point pull{};                                ///< of these: the sum of stiffness times place
};

class Elimination {
public:
    explicit Elimination(const SpringNet& net) : nodes_(net.held.size()), places_(net.held.size())
    {
        for (std::size_t i = 0; i < places_.size(); ++i) places_[i] = net.held[i].value_or(ui::Point{});
        for (const SpringNet::Spring& spring : net.springs) {
            const bool is_a_held = net.held[spring.a].has_value(), is_b_held = net.held[spring.b].has_value();
            if (!is_a_held && !is_b_held) add_spring(spring.a, spring.b, spring.stiffness);
            if (!is_a_held && is_b_held) add_pull(spring.a, spring.stiffness, places_[spring.b]);
            if (is_a_held && !is_b_held) add_pull(spring.b, spring.stiffness, places_[spring.a]);
        }
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            if (!net.held[i]) turns_.push({nodes_[i].springs.size(), i});
    }

    std::vector<ui::Point> at_rest()
    {
        while (!turns_.empty()) {
            const auto [n_springs, i] = turns_.top();
            turns_.pop();
            if (is_out_[i] || n_springs != nodes_[i].springs.size()) continue; // it had another turn since
            take_out(i);
        }
        for (auto i = order_.rbegin(); i != order_.rend(); ++i) put_back(*i);
        return std::move(places_);
    }

private:
    using Turn = std::pair<std::size_t, std::size_t>; ///< how many springs, node

    void add_spring(std::size_t a, std::size_t b, double stiffness)
    {
        nodes_[a].springs[b] += stiffness;
        nodes_[b].springs[a] += stiffness;
    }
    void add_pull(std::size_t i, double stiffness, ui::Point at)
    {
        nodes_[i].held += stiffness;
        nodes_[i].pull = nodes_[i].pull + stiffness * at;
    }
    double stiffness(std::size_t i) const
    {
        double sum = nodes_[i].held;
        for (const auto& [j, k] : nodes_[i].springs) sum += k;
        return sum;
    }

    /// Its neighbours j and l get a spring of k_ij k_il / k_i, the star becoming a mesh.
    void take_out(std::size_t i)
    {
        const Node& node = nodes_[i];
        is_out_[i] = true;
        order_.push_back(i);
        const double all = stiffness(i);
        for (const auto& [j, k] : node.springs) {
            nodes_[j].springs.erase(i);
            if (node.held > 0.0) add_pull(j, k * node.held / all, (1.0 / node.held) * node.pull);
        }
        for (auto j = node.springs.begin(); j != node.springs.end(); ++j)
            for (auto l = std::next(j); l != node.springs.end(); ++l)
                add_spring(j->first, l->first, j->second * l->second / all);
        for (const auto& [j, k] : node.springs) turns_.push({nodes_[j].springs.size(), j});
    }
    /// In the middle of those that pulled it when it was taken out.
    void put_back(std::size_t i)
    {
        const double all = stiffness(i);
        if (!(all > 0.0)) return;
        ui::Point sum = nodes_[i].pull;
        for (const auto& [j, k] : nodes_[i].springs) sum = sum + k * places_[j];
        places_[i] = (1.0 / all) * sum;
    }

    std::vector<Node> nodes_;
    std::vector<ui::Point> places_;
    std::vector<bool> is_out_ = std::vector<bool>(nodes_.size());
    std::vector<std::size_t> order_;
    std::priority_queue<Turn, std::vector<Turn>, std::greater<>> turns_;
};

} // namespace

std::vector<ui::Point> at_rest(const SpringNet& net) { return Elimination(net).at_rest(); }

} // namespace euler
