# SPDX-License-Identifier: MIT
# Writes files into a C++ header as a table of names and texts, so that they are part of a program.
# cmake -DOUT=HEADER -DFILES="a.css;b.js" -P EmbedText.cmake
set(arrays "")
set(table "")
set(i 0)
foreach(file IN LISTS FILES)
  get_filename_component(name "${file}" NAME)
  file(READ "${file}" hex HEX)
  string(REGEX REPLACE "([0-9a-f][0-9a-f])" "0x\\1," bytes "${hex}")
  string(APPEND arrays "inline constexpr unsigned char g_nText${i}[] = {${bytes}};\n")
  string(APPEND table "    {\"${name}\", g_nText${i}, sizeof g_nText${i}},\n")
  math(EXPR i "${i} + 1")
endforeach()
file(WRITE "${OUT}" "#pragma once
#include <cstddef>
#include <string_view>

${arrays}
struct CEmbeddedText {
  std::string_view m_sName;
  const unsigned char* m_pBytes;
  std::size_t m_nSize;
};
inline constexpr CEmbeddedText g_stdEmbeddedTexts[] = {
${table}};
")
