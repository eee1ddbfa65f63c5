#include "apps/cross/session/own_order.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace cross {

namespace fc = femoop::cross;
using ui::translatable;

namespace {

bool has_blank(const std::string& name) { return name.find(' ') != std::string::npos; }

std::vector<std::string> names_in(std::string_view words)
{
    const bool has_commas = words.find_first_of(",;") != std::string_view::npos;
    std::vector<std::string> names;
    while (!words.empty()) {
        const std::size_t end = std::min(words.find_first_of(has_commas ? ",;" : " "), words.size());
        std::string_view name = words.substr(0, end);
        words.remove_prefix(std::min(end + 1, words.size()));
        while (name.starts_with(' ')) name.remove_prefix(1);
        while (name.ends_with(' ')) name.remove_suffix(1);
        if (!name.empty()) names.emplace_back(name);
    }
    return names;
}

std::vector<std::string> joints_of(const Session& session)
{
    const auto& task = session.solution().task;
    return task ? fc::joint_names(session.document().model, task->problem) : std::vector<std::string>{};
}

std::string listed(const std::vector<std::string>& names)
{
    constexpr std::size_t most = 12;
    std::string list;
    for (std::size_t i = 0; i < std::min(most, names.size()); ++i) list += (i == 0 ? "" : ", ") + names[i];
    return names.size() > most ? list + " …" : list;
}

} // namespace

std::string own_order(const Method& method)
{
    const bool needs_commas = std::ranges::any_of(method.joints, has_blank);
    std::string words;
    for (const std::string& name : method.joints) words += (words.empty() ? "" : needs_commas ? ", " : " ") + name;
    return needs_commas && method.joints.size() == 1 ? words + "," : words;
}

std::optional<ui::Message> take_own_order(Session& session, std::string_view words)
{
    const std::vector<std::string> joints = joints_of(session);
    if (joints.empty()) return ui::Message(translatable("there is no joint to balance"));
    Method method = session.document().method;
    method.order = fc::Order::Listed;
    method.joints = names_in(words);
    if (method.joints.empty())
        return ui::Message(translatable("name the joints in their order, again and again: {names}"),
                           {{"names", listed(joints)}});
    for (const std::string& name : method.joints)
        if (std::ranges::find(joints, name) == joints.end())
            return ui::Message(translatable("{name} is no joint that can be balanced; there are {names}"),
                               {{"name", name}, {"names", listed(joints)}});
    session.set_method(method, translatable("Change the order"));
    return std::nullopt;
}

void choose_own_order(Session& session)
{
    Method method = session.document().method;
    const std::vector<std::string> joints = joints_of(session);
    const auto is_gone = [&](const std::string& name) { return std::ranges::find(joints, name) == joints.end(); };
    if (method.joints.empty() || std::ranges::any_of(method.joints, is_gone)) method.joints = joints;
    method.order = fc::Order::Listed;
    session.set_method(method, translatable("Change the order"));
}

} // namespace cross
