#include "femoop/io/json/model_json.h"

namespace femoop {

void begin_output(JsonWriter& json, const Units& units)
{
    json.begin_object(JsonWriter::Layout::Block).member("cremona", 1);
    json.key("units").begin_object();
    json.member("length", name(units.length)).member("force", name(units.force)).end();
}

void write_rows(JsonWriter& json, const Eigen::MatrixXd& matrix, JsonWriter::Layout layout)
{
    json.begin_array(layout);
    for (Eigen::Index row = 0; row < matrix.rows(); ++row) {
        json.begin_array();
        for (Eigen::Index column = 0; column < matrix.cols(); ++column) json.value(matrix(row, column));
        json.end();
    }
    json.end();
}

} // namespace femoop
