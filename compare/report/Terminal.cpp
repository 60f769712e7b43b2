// SPDX-License-Identifier: MIT
#include "Terminal.h"

#include <algorithm>

namespace Shapes::Compare {

std::string Wrap(std::string_view text, std::size_t first, std::size_t rest) {
  std::string wrapped(first, ' ');
  std::size_t column = first;
  bool atStart = true;
  while (!text.empty()) {
    const std::size_t end = std::min({text.find(' '), text.size(), g_nWidth - rest});
    if (!atStart && column + 1 + end > g_nWidth) {
      wrapped += '\n' + std::string(rest, ' ');
      column = rest;
    } else if (!atStart) {
      wrapped += ' ';
      ++column;
    }
    atStart = false;
    wrapped += text.substr(0, end);
    column += end;
    text.remove_prefix(end);
    if (text.starts_with(' ')) text.remove_prefix(1);
  }
  return wrapped + '\n';
}

std::string Ascii(std::string text) {
  for (char& c : text)
    if (c < ' ' || c > '~') c = '?';
  return text;
}

} // namespace Shapes::Compare
