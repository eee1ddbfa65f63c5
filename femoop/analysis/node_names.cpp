#include "femoop/analysis/node_names.h"

#include "femoop/model/fault/fault.h"

namespace femoop {

std::string names_of(const Model& model, const std::vector<NodeId>& nodes)
{
    constexpr std::size_t names_in_words = 12; // a sentence names so many nodes, then counts
    std::vector<std::string> list;
    for (const NodeId node : nodes) {
        if (list.size() + 1 == names_in_words && nodes.size() > names_in_words) {
            list.push_back("+" + std::to_string(nodes.size() - list.size()));
            break;
        }
        list.push_back(model[node].id);
    }
    return listed(list);
}

} // namespace femoop
