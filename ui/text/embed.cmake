# Writes a C++ source that holds files:
#   cmake -Dfiles=a.po,b.po -Dfunction=ui::compiled_portuguese -Dheader=ui/text/compiled_translations.h -Doutput=x.cpp
#         -P embed.cmake
# The function, which the header declares, gives their texts in the order of `files`. Bytes are written one by one, so
# that no compiler's limit on string literals is met.
string(REPLACE "," ";" files "${files}")
set(arrays "")
set(list "")
foreach(file IN LISTS files)
  cmake_path(GET file STEM stem)
  file(READ "${file}" bytes HEX)
  string(REGEX REPLACE "(..)" "'\\\\x\\1'," bytes "${bytes}")
  string(REGEX REPLACE "('..0a',)" "\\1\n" bytes "${bytes}")
  string(APPEND arrays "constexpr char ${stem}_text[] = {\n${bytes}};\n\n")
  string(APPEND list "        {${stem}_text, sizeof ${stem}_text},\n")
endforeach()
file(WRITE "${output}" "// Written by ui/text/embed.cmake; edit the files that it holds.
#include \"${header}\"

namespace {

${arrays}} // namespace

std::vector<std::string_view> ${function}()
{
    return {
${list}    };
}
")
