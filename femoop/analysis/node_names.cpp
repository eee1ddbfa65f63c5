#include "femoop/analysis/node_names.h"

#include "femoop/model/fault/fault.h"

namespace femoop {

std::string names_of(const Model& model, const std::vector<NodeId>& nodes)
{
    constexpr std::size_t listed_names = 12; // a sentence names so many nodes, then counts
    std::vector<std::string> list;
    for (const NodeId node : nodes) {
        if (list.size() + 1 == listed_names && nodes.size() > listed_names) {
            list.push_back("+" + std::to_string(nodes.size() - list.size()));
            break;
        }
        list.push_back(model[node].id);
    }
    return listed(list);
}

} // namespace femoop
