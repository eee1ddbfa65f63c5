#include "femoop/io/plane/mesh_vtu.h"

#include <limits>
#include <sstream>
#include <string_view>

namespace femoop::plane {

namespace {

/// VTK's number of a cell, whose nodes it lists in our order: corners, middle nodes, the centre.
int vtk_type(ShapeKind kind)
{
    switch (kind) {
    case ShapeKind::T3: return 5;
    case ShapeKind::T6: return 22;
    case ShapeKind::Q4: return 9;
    case ShapeKind::Q8: return 23;
    case ShapeKind::Q9: return 28;
    default: return 0;
    }
}

/// A DataArray in plain text, one line of values for each entry.
template <class Parts, class Write>
void add_array(std::ostream& out, std::string_view attributes, const Parts& parts, const Write& write)
{
    out << "        <DataArray " << attributes << " format=\"ascii\">\n";
    for (const auto& part : parts) {
        out << "          ";
        write(part);
        out << '\n';
    }
    out << "        </DataArray>\n";
}

} // namespace

std::string mesh_vtu(const PlaneModel& model)
{
    std::ostringstream out;
    out.precision(std::numeric_limits<double>::max_digits10);
    out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\">\n  <UnstructuredGrid>\n"
        << "    <Piece NumberOfPoints=\"" << model.points.size() << "\" NumberOfCells=\"" << model.elements.size()
        << "\">\n      <Points>\n";
    add_array(out, R"(type="Float64" NumberOfComponents="3")", model.points,
              [&](const PlanePoint& point) { out << point.at[0].value() << ' ' << point.at[1].value() << " 0"; });
    out << "      </Points>\n      <Cells>\n";
    add_array(out, R"(type="Int64" Name="connectivity")", model.elements, [&](const PlaneElement& element) {
        for (const NodeId node : element.points) out << node.index << ' ';
    });
    std::size_t end = 0;
    add_array(out, R"(type="Int64" Name="offsets")", model.elements,
              [&](const PlaneElement& element) { out << (end += element.points.size()); });
    add_array(out, R"(type="UInt8" Name="types")", model.elements,
              [&](const PlaneElement& element) { out << vtk_type(element.kind); });
    out << "      </Cells>\n      <CellData Scalars=\"region\">\n";
    add_array(out, R"(type="Int32" Name="region")", model.elements,
              [&](const PlaneElement& element) { out << element.region.index; });
    out << "      </CellData>\n    </Piece>\n  </UnstructuredGrid>\n</VTKFile>\n";
    return out.str();
}

} // namespace femoop::plane
