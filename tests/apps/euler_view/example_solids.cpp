#include "tests/apps/euler_view/example_solids.h"
#include "tests/source_folder.h"

#include <fstream>
#include <sstream>

namespace view_test {

Made::Made(std::string_view script) { topology::run_script(runner_, script, {}); }

std::vector<euler::Subject> Made::subjects(const euler::Marks& marks) const
{
    std::vector<euler::Subject> subjects;
    for (const topology::NamedSolid& made : runner_.solids()) subjects.push_back({&made.solid, &made.names});
    subjects.front().marks = marks;
    return subjects;
}

topology::VertexId Made::vertex(std::string_view name) const
{
    return topology::find_vertex(runner_.solids().front().named(), name);
}

topology::FaceId Made::face(std::string_view name) const
{
    return topology::find_face(runner_.solids().front().named(), name);
}

topology::Change Made::last_change() const
{
    const topology::NamedSolid& made = runner_.solids().front();
    return topology::change(made.solid.tables(), made.journal[made.journal.n_done() - 1]);
}

std::string example(std::string_view name, std::size_t n_operators)
{
    std::ifstream in((source_folder() + "/examples/").append(name).append(".eul"));
    std::string text, line;
    while (std::getline(in, line)) {
        const bool is_operator = !line.empty() && line.front() != '#';
        if (is_operator && n_operators-- == 0) break;
        text += line + '\n';
    }
    return text;
}

} // namespace view_test
