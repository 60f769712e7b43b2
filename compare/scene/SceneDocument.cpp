// SPDX-License-Identifier: MIT
#include "SceneDocument.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <string_view>

namespace Shapes::Compare {

namespace {

// A scene nests 6 deep; the recursive parts of the JSON libraries would not survive a hundred thousand.
constexpr std::size_t g_nMaxDepth = 16;
constexpr std::size_t g_nMaxValueText = 60; // characters of a wrong value in a message
// Bytes of a scene file: some hundred thousand shapes.
constexpr std::uintmax_t g_nMaxFileSize = 64u << 20;

// As JSON writes it, because a name may hold anything, and a terminal obeys some of it.
std::string PathText(const CJsonPath& path) {
  if (path.empty()) return "/";
  const std::string quoted = CJson(path.to_string()).dump();
  return quoted.substr(1, quoted.size() - 2);
}

std::string ValueText(const CJson& value) {
  std::string text = value.dump(-1, ' ', true);
  if (text.size() > g_nMaxValueText) text = text.substr(0, g_nMaxValueText) + "...";
  return text;
}

} // namespace

void RefuseField(const std::string& file, const CJsonPath& path, const std::string& expected,
                 const std::string& got) {
  throw CSceneError(fmt::format("{}: {}: expected {}, got {}", file, PathText(path), expected, got));
}

std::string Got(const CJson& doc, const CJsonPath& path) {
  return doc.contains(path) ? ValueText(doc.at(path)) : "nothing";
}

namespace {

std::string ReadText(const std::filesystem::path& file) {
  const auto refuse = [&](const std::string& got) {
    throw CSceneError(fmt::format("{}: expected a file that can be read, got {}", file.string(), got));
  };
  std::error_code error;
  const auto status = std::filesystem::status(file, error);
  if (std::filesystem::is_directory(status)) refuse("a folder");
  // A device may have no end, and a pipe no writer.
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status))
    refuse("a device or a pipe");
  if (const auto size = std::filesystem::file_size(file, error); !error && size > g_nMaxFileSize)
    refuse(fmt::format("{} MB, more than the {} MB of the largest scene", size >> 20, g_nMaxFileSize >> 20));
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::string text;
  if (in) text.assign(std::istreambuf_iterator<char>(in), {});
  if (!in || in.bad()) refuse(errno != 0 ? std::strerror(errno) : "a read error");
  return text;
}

// ---- Text to JSON: what the parser alone would let through or not locate -------------------------------

// Walks through the text without building anything. Knows where it is, in the text and in the document.
class CTextCheck : public nlohmann::json_sax<CJson> {
public:
  CTextCheck(const std::string& file, std::string_view text) : m_sFile(file), m_sText(text) {}

  bool null() override { return Value(); }
  bool boolean(bool) override { return Value(); }
  bool number_integer(number_integer_t) override { return Value(); }
  bool number_unsigned(number_unsigned_t) override { return Value(); }
  bool number_float(number_float_t, const string_t&) override { return Value(); }
  bool string(string_t&) override { return Value(); }
  bool binary(binary_t&) override { return Value(); }
  bool start_object(std::size_t) override { return Open(false); }
  bool start_array(std::size_t) override { return Open(true); }
  bool end_object() override { return Close(); }
  bool end_array() override { return Close(); }

  bool key(string_t& name) override {
    CLevel& level = m_stdLevels.back();
    level.m_sKey = name;
    if (!level.m_stdKeys.insert(name).second)
      RefuseField(m_sFile, Here(), "each field once", "it a second time");
    return true;
  }

  bool parse_error(std::size_t position, const std::string& token,
                   const nlohmann::detail::exception& error) override {
    constexpr int numberOverflow = 406;
    if (error.id == numberOverflow) RefuseField(m_sFile, Here(), "a number that a double can hold", token);

    // The position counts the characters that were read, the wrong one included.
    const std::string_view before = m_sText.substr(0, position == 0 ? 0 : position - 1);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const std::size_t column = before.size() - (before.rfind('\n') + 1) + 1;
    std::string_view reason = error.what();
    if (const auto at = reason.find("column "); at != reason.npos)
      if (const auto colon = reason.find(": ", at); colon != reason.npos) reason.remove_prefix(colon + 2);
    if (m_sText.find_first_not_of(" \t\r\n") == m_sText.npos) reason = "expected a scene, got an empty file";
    throw CSceneError(fmt::format("{}:{}:{}: {}", m_sFile, line, column, reason));
  }

private:
  struct CLevel {
    bool m_bIsArray;
    std::size_t m_nIndex = 0;
    std::string m_sKey;
    std::set<std::string> m_stdKeys;
  };

  CJsonPath Here() const {
    CJsonPath path;
    for (const CLevel& level : m_stdLevels)
      path = level.m_bIsArray ? path / level.m_nIndex : path / level.m_sKey;
    return path;
  }

  bool Open(bool isArray) {
    if (m_stdLevels.size() >= g_nMaxDepth)
      RefuseField(m_sFile, Here(), fmt::format("at most {} levels", g_nMaxDepth), "another one");
    m_stdLevels.push_back({isArray, 0, {}, {}});
    return true;
  }
  bool Close() {
    m_stdLevels.pop_back();
    return Value();
  }
  bool Value() {
    if (!m_stdLevels.empty()) ++m_stdLevels.back().m_nIndex;
    return true;
  }

  std::string m_sFile;
  std::string_view m_sText;
  std::vector<CLevel> m_stdLevels;
};

} // namespace

CJson ReadSceneDocument(const std::filesystem::path& file) {
  return ParseSceneDocument(file.string(), ReadText(file));
}

CJson ParseSceneDocument(const std::string& file, const std::string& text) {
  CTextCheck check(file, text);
  CJson::sax_parse(text, &check);
  return CJson::parse(text);
}

} // namespace Shapes::Compare
