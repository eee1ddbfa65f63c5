#pragma once

#include "femoop/io/model_file.h"

/// A beam of 8 m on a pin and a roller: case P with 30 kN down at 2 m, case U with 12 kN up at 6 m, and P + U.
///
///      P |            ^ U
///   A ---v------------|---- B        R_A = 22.5 (P), -3 (U);  M under the load = 45 (P), -18 (U)
///   ^                       o
inline femoop::Model two_cases()
{
    return femoop::read_model(R"({"cremona": 1, "analysis": "frame2d", "units": {"length": "m", "force": "kN"},
      "materials": [{"id": "s", "E": 2e8}], "sections": [{"id": "c", "A": 0.01, "Iz": 2e-4}],
      "nodes": [{"id": "A", "at": [0, 0], "support": "pin"}, {"id": "B", "at": [8, 0], "support": "roller"}],
      "members": [{"id": "AB", "nodes": ["A", "B"], "material": "s", "section": "c"}],
      "load_cases": [{"id": "P", "members": [{"member": "AB", "kind": "point", "at": 2, "fy": -30}]},
                     {"id": "U", "members": [{"member": "AB", "kind": "point", "at": 6, "fy": 12}]}],
      "combinations": [{"id": "both", "factors": {"P": 1, "U": 1}}]})");
}
