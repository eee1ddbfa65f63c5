#include "femoop/result/structure_words.h"

#include "femoop/model/fault/fault.h"

namespace femoop {

std::string kind_text(AnalysisKind kind, const Translator& tr)
{
    switch (kind) {
    case AnalysisKind::Truss2d: return tr("plane truss");
    case AnalysisKind::Frame2d: return tr("plane frame");
    case AnalysisKind::Grillage: return tr("grillage");
    case AnalysisKind::Truss3d: return tr("space truss");
    case AnalysisKind::Frame3d: break;
    }
    return tr("space frame");
}

std::string size_text(const Model& model, const Translator& tr)
{
    return counted(model.nodes.size(), tr("{0} node"), tr("{0} nodes")) + ", " +
           counted(model.members.size(), tr("{0} member"), tr("{0} members"));
}

std::string title_and_size_text(const Model& model, const Translator& tr)
{
    return model.title.empty() ? size_text(model, tr) : model.title + ": " + size_text(model, tr);
}

std::string counted(std::size_t n, std::string_view one, std::string_view many)
{
    return fill(n == 1 ? one : many, {std::to_string(n)});
}

} // namespace femoop
