#include <doctest/doctest.h>

#include <stdexcept>
#include <string>

#include "femoop/io/model_file.h"
#include "femoop/io/plane/plane_file.h"
#include "femoop/model/quantity/in_units.h"
#include "femoop/plane/model/plane_in_units.h"

using namespace femoop;

TEST_SUITE_BEGIN("model");

namespace {

/// A model in m and kN that has a number of every dimension.
Model every_dimension()
{
    return read_model(R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "s", "E": 205000000, "nu": 0.3, "alpha": 1.2e-5, "density": 7.85, "fy": "250 MPa"}],
      "sections": [{"id": "c", "A": 0.0125, "Iz": 0.0002, "Asy": 0.005, "h": 0.3},
                   {"id": "r", "shape": "rectangle", "b": 0.2, "h": "400 mm"}],
      "nodes": [{"id": "A", "at": [0, 0], "support": "fixed"},
                {"id": "B", "at": [3, 4.5], "support": {"springs": {"ux": 800, "rz": 1500}}},
                {"id": "C", "at": [7, 4.5], "support": "pin"}],
      "members": [{"id": "AB", "nodes": ["A", "B"], "material": "s", "section": "c", "foundation": {"y": 5000}},
                  {"id": "BC", "nodes": ["B", "C"], "material": "s", "section": "r",
                   "start": {"spring": {"rz": 8000}}, "end": {"offset": [0.25, 0]}}],
      "load_cases": [{"id": "G", "self_weight": 1,
        "nodes": [{"node": "B", "fx": 12, "mz": 6}],
        "settlements": [{"node": "A", "uy": -0.015, "rz": 0.002}],
        "members": [{"member": "BC", "kind": "distributed", "qy": [-25, -30], "from": 0.5, "to": "90%"},
                    {"member": "BC", "kind": "point", "at": 1.5, "fy": -40, "mz": 7},
                    {"member": "AB", "kind": "ends", "start_mz": 9},
                    {"member": "AB", "kind": "temperature", "top": 10, "bottom": 30},
                    {"member": "AB", "kind": "misfit", "elongation": 0.002}]}],
      "expected": [{"quantity": "reaction", "node": "A", "component": "mz", "value": 11, "atol": 0.5},
                   {"quantity": "displacement", "node": "B", "component": "ux", "value": 0.003}]})");
}

} // namespace

TEST_CASE("Fields of a plane model are counted by the powers of their places")
{
    const plane::PlaneModel model = plane::read_plane_model(R"({"cremona": 1, "analysis": "plane_stress",
      "units": {"length": "m", "force": "kN"}, "snap": 0.001, "mesh": {"size": 0.5},
      "materials": [{"id": "s", "E": 205000000, "nu": 0.3, "alpha": 1.2e-5}],
      "points": [{"id": "A", "at": [3, 4.5], "size": 0.2}],
      "curves": [{"id": "c", "kind": "circle", "center": [7, 5], "radius": 2, "support": {"springs": {"ux": 800}}}],
      "regions": [{"id": "R", "material": "s", "thickness": 0.25}],
      "load_cases": [{"id": "P", "curves": [{"curve": "c", "kind": "traction", "qx": {"polynomial": [[6, 1, 1]]}}],
        "regions": [{"kind": "body", "by": -25},
                    {"kind": "temperature", "rise": {"along": "x", "table": [[1, 10], [2, 30]]}}]}]})");
    const plane::PlaneModel other = plane::in_units(model, {LengthUnit::mm, ForceUnit::N});
    CHECK(other.snap->value() == 1.0);
    CHECK(other.mesh.size->value() == 500.0);
    CHECK(other.points[0].at[1].value() == 4500.0);
    CHECK(other.points[0].size->value() == 200.0);
    CHECK(other.curves[0].shape->radius->value() == 2000.0);
    CHECK(other.curves[0].support->springs[0].stiffness.value() == 8.0e-4); // kN/m^3 -> N/mm^3: 1e3 / 1e9
    CHECK(other.regions[0].thickness->value() == 250.0);
    const plane::PlaneLoadCase& loads = other.load_cases[0];
    const auto& terms = std::get<plane::Field::Polynomial>(loads.curves[0].qx->form);
    CHECK(terms[0].factor.value() == 6.0e-9); // kN/m^4 -> N/mm^4: 1e3 / 1e12
    const auto& body = std::get<plane::BodyForce>(loads.regions[0].load);
    CHECK(std::get<Quantity>(body.by->form).value() == -2.5e-5); // kN/m^3 -> N/mm^3
    const auto& heat = std::get<plane::TemperatureRise>(loads.regions[1].load);
    const auto& table = std::get<plane::Field::Table>(heat.rise->form);
    CHECK(table.rows[1].first.value() == 2000.0);
    CHECK(table.rows[1].second.value() == 30.0);
}

TEST_CASE("A region of plane strain without a thickness is as thick in other units, which is then written")
{
    const plane::PlaneModel model = plane::read_plane_model(R"({"cremona": 1, "analysis": "plane_strain",
      "units": {"length": "m", "force": "kN"}, "materials": [{"id": "s", "E": 205000000, "nu": 0.3}],
      "curves": [{"id": "c", "kind": "circle", "center": [7, 5], "radius": 2}],
      "regions": [{"id": "R", "material": "s"}]})");
    const plane::PlaneModel other = plane::in_units(model, {LengthUnit::mm, ForceUnit::N});
    CHECK(other.thickness(plane::RegionId(0)) == 1000.0);
    CHECK(other.regions[0].thickness->value() == 1000.0);
}

TEST_CASE("From m and kN to mm and N a stress is divided by 1000 and a second moment multiplied by 1e12")
{
    const Model model = in_units(every_dimension(), {LengthUnit::mm, ForceUnit::N});
    CHECK(model.materials[0].E.value() == 205000.0);                      // kN/m^2 -> N/mm^2: 1e3 / 1e6
    CHECK(model.materials[0].density->value() == 7.85e-9);                // kN s^2/m^4 -> N s^2/mm^4: 1e3 / 1e12
    CHECK(model.sections[0].A->value() == 12500.0);                       // 1e6
    CHECK(model.sections[0].Iz->value() == 2.0e8);                        // 1e12
    CHECK(model.nodes[1].at[1].value() == 4500.0);                        // 1e3
    CHECK(model.nodes[1].support->springs[0].stiffness.value() == 800.0); // kN/m -> N/mm: 1
    CHECK(model.nodes[1].support->springs[1].stiffness.value() == 1.5e9); // kN m -> N mm: 1e6
    CHECK(model.members[0].foundation->value() == 5.0);                   // kN/m^2 -> N/mm^2
    CHECK(model.members[1].end.offset[0].value() == 250.0);
    const LoadCase& loads = model.load_cases[0];
    CHECK(loads.nodes[0].components[0].value.value() == 12000.0);
    CHECK(loads.nodes[0].components[1].value.value() == 6.0e6);
    CHECK(loads.settlements[0].components[0].value.value() == -15.0);
    CHECK(loads.settlements[0].components[1].value.value() == 0.002); // rad
    const auto& spread = std::get<DistributedLoad>(loads.members[0].load);
    CHECK(spread.values[0].start.value() == -25.0); // kN/m -> N/mm
    CHECK(std::get<Quantity>(*spread.from).value() == 500.0);
    CHECK(std::get<Percent>(*spread.to).value == 90.0);
    CHECK(std::get<Misfit>(loads.members[4].load).elongation.value() == 2.0);
    CHECK(std::get<TemperatureLoad>(loads.members[3].load).bottom.value() == 30.0);
    CHECK(model.expected[0].value.value() == 11.0e6);
    CHECK(model.expected[0].atol->value() == 0.5e6);
    CHECK(model.expected[1].value.value() == 3.0);
}

TEST_CASE("A quantity typed with a unit keeps its text, and its value follows the base units")
{
    const Model model = in_units(every_dimension(), {LengthUnit::cm, ForceUnit::kN});
    CHECK(model.materials[0].fy->text() == "250 MPa");
    CHECK(model.materials[0].fy->value() == 25.0); // kN/cm^2
    CHECK(model.sections[1].shape->h->text() == "400 mm");
    CHECK(model.sections[1].shape->h->value() == 40.0);
}

TEST_CASE("There and back again is the same model")
{
    const Model model = every_dimension();
    CHECK(write_model(in_units(in_units(model, {LengthUnit::mm, ForceUnit::N}), model.units)) == write_model(model));
}

TEST_CASE("A block whose numbers only its own analysis understands is refused")
{
    Model model = every_dimension();
    model.extra.push_back({"train", R"({"axles": [8, 32]})"});
    CHECK_THROWS_WITH_AS(in_units(model, {LengthUnit::ft, ForceUnit::kip}),
                         "in_units: block \"train\" cannot be recounted", std::invalid_argument);
}

TEST_SUITE_END();
