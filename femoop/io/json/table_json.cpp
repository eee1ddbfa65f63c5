#include "femoop/io/json/table_json.h"

#include "femoop/io/json/json_writer.h"

namespace femoop {

namespace {

void write_cells(JsonWriter& json, const tabular::Row& row)
{
    json.begin_array();
    for (const tabular::Cell& cell : row.cells) {
        if (cell.number) json.value(*cell.number);
        else json.value(cell.shown);
    }
    json.end();
}

} // namespace

std::string table_json(const tabular::Table& table)
{
    JsonWriter json;
    json.begin_object(JsonWriter::Layout::Block);
    if (!table.title.empty()) json.member("title", table.title);
    if (!table.notes.empty()) {
        json.key("notes").begin_array();
        for (const std::string& note : table.notes) json.value(note);
        json.end();
    }
    json.key("columns").begin_array();
    for (const tabular::Column& column : table.columns) json.value(column.label());
    json.end().key("rows").begin_array(JsonWriter::Layout::Block);
    for (const tabular::Row& row : table.rows) write_cells(json, row);
    json.end().end();
    return json.take();
}

} // namespace femoop
