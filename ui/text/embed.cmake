# Writes a C++ source that holds the translation files: cmake -Dfiles=a.po,b.po -Doutput=x.cpp -P embed.cmake
# Bytes are written one by one, so that no compiler's limit on string literals is met.
string(REPLACE "," ";" files "${files}")
set(arrays "")
set(list "")
foreach(file IN LISTS files)
  cmake_path(GET file STEM stem)
  file(READ "${file}" bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(REGEX REPLACE "('..0a',)" "\\1\n" bytes "${bytes}")
  string(APPEND arrays "constexpr char ${stem}_po[] = {\n${bytes}};\n\n")
  string(APPEND list "        {${stem}_po, sizeof ${stem}_po},\n")
endforeach()
file(WRITE "${output}" "// Written by ui/text/embed.cmake; edit the .po files.
#include \"ui/text/compiled_translations.h\"

namespace {

${arrays}} // namespace

namespace ui {

std::vector<std::string_view> compiled_portuguese()
{
    return {
${list}    };
}

} // namespace ui
")
