// SPDX-License-Identifier: MIT
#include "SceneDocument.h"

#include "SceneSchema.h"

#include <fmt/format.h>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validator.hpp>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <memory>
#include <set>
#include <string_view>

namespace Shapes::Compare {

using nlohmann::json;
using CPath = json::json_pointer;

namespace {

// A scene nests 6 deep; the recursive parts of the JSON libraries would not survive a hundred thousand.
constexpr std::size_t g_nMaxDepth = 16;
constexpr std::size_t g_nMaxValueText = 60; // characters of a wrong value in a message

std::string PathText(const CPath& path) { return path.empty() ? "/" : path.to_string(); }

std::string ValueText(const json& value) {
  std::string text = value.dump(-1, ' ', true);
  if (text.size() > g_nMaxValueText) text = text.substr(0, g_nMaxValueText) + "...";
  return text;
}

} // namespace

void RefuseField(const std::string& file, const CPath& path, const std::string& expected,
                 const std::string& got) {
  throw CSceneError(fmt::format("{}: {}: expected {}, got {}", file, PathText(path), expected, got));
}

std::string Got(const json& doc, const CPath& path) {
  return doc.contains(path) ? ValueText(doc.at(path)) : "nothing";
}

namespace {

std::string ReadText(const std::filesystem::path& file) {
  std::error_code error;
  const bool isFolder = std::filesystem::is_directory(file, error);
  errno = 0;
  std::ifstream in(file, std::ios::binary);
  std::string text;
  if (in && !isFolder) {
    text.assign(std::istreambuf_iterator<char>(in), {});
    if (!in.bad()) return text;
  }
  throw CSceneError(fmt::format("{}: expected a file that can be read, got {}", file.string(),
                                isFolder     ? "a folder"
                                : errno != 0 ? std::strerror(errno)
                                             : "a read error"));
}

// ---- Text to JSON: what the parser alone would let through or not locate -------------------------------

// Walks through the text without building anything. Knows where it is, in the text and in the document.
class CTextCheck : public nlohmann::json_sax<json> {
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

  CPath Here() const {
    CPath path;
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

json ParseText(const std::string& file, const std::string& text) {
  CTextCheck check(file, text);
  json::sax_parse(text, &check);
  return json::parse(text);
}

// ---- JSON against the schema ---------------------------------------------------------------------------

const json& SchemaJson() {
  static const json schema = json::parse(g_sSceneSchema);
  return schema;
}

const valijson::Schema& Schema() {
  static const auto pSchema = [] {
    auto p = std::make_unique<valijson::Schema>();
    const valijson::adapters::NlohmannJsonAdapter adapter(SchemaJson());
    valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(adapter, *p);
    return p;
  }();
  return *pSchema;
}

const json& Resolved(const json& schema) {
  const json* pSchema = &schema;
  while (pSchema->contains("$ref"))
    pSchema = &SchemaJson().at(CPath(pSchema->at("$ref").get<std::string>().substr(1)));
  return *pSchema;
}

// The schema that holds for this value: of "if type is ... then ... else ..." the branch that applies.
const json& Applying(const json& schema, const json& value) {
  const json* pSchema = &Resolved(schema);
  while (pSchema->contains("if")) {
    const json& type = pSchema->at("if").at("properties").at("type").at("const");
    const bool is = value.is_object() && value.contains("type") && value.at("type") == type;
    if (!is && !pSchema->contains("else")) break;
    pSchema = &Resolved(pSchema->at(is ? "then" : "else"));
  }
  return *pSchema;
}

// A place in the document that fails the schema, the deeper the more to the point.
struct CFault {
  CPath m_cPath;
  std::size_t m_nDepth;
};

// A field that is missing or unknown is a fault of the field; the validator reports it with its object.
CFault FindFault(const valijson::ValidationResults::Error& error) {
  CFault fault{CPath(), error.context.size() - 1};
  for (std::size_t i = 1; i < error.context.size(); ++i)
    fault.m_cPath /= error.context[i].substr(1, error.context[i].size() - 2);
  for (const std::string_view before :
       {"Missing required property '", "Object contains a property that could not be validated using "
                                       "'properties' or 'additionalProperties' constraints: '"}) {
    if (!error.description.starts_with(before)) continue;
    const std::size_t close = error.description.rfind('\'');
    fault.m_cPath /= error.description.substr(before.size(), close - before.size());
    ++fault.m_nDepth;
  }
  return fault;
}

// What the schema expects at a path.
std::string Expected(const json& doc, const CPath& path) {
  std::vector<std::string> steps;
  for (CPath p = path; !p.empty(); p.pop_back())
    steps.insert(steps.begin(), p.back());

  const json* pValue = &doc;
  const json* pSchema = &SchemaJson();
  for (const std::string& step : steps) {
    const json& schema = Applying(*pSchema, *pValue);
    if (pValue->is_array()) {
      pSchema = &schema.at("items");
      pValue = &pValue->at(std::stoul(step));
      continue;
    }
    const json& fields =
        schema.contains("properties") ? schema.at("properties") : Resolved(*pSchema).at("properties");
    if (!fields.contains(step)) {
      std::string known;
      for (const auto& field : fields.items())
        known += (known.empty() ? "" : ", ") + field.key();
      return "no such field (known are " + known + ")";
    }
    pSchema = &fields.at(step);
    static const json nothing;
    pValue = pValue->contains(step) ? &pValue->at(step) : &nothing;
  }
  return Resolved(*pSchema).at("description").get<std::string>();
}

void CheckSchema(const std::string& file, const json& doc) {
  valijson::ValidationResults results;
  const valijson::adapters::NlohmannJsonAdapter adapter(doc);
  if (valijson::Validator().validate(Schema(), adapter, &results)) return;

  CFault deepest{CPath(), 0};
  for (const auto& error : results)
    if (const CFault fault = FindFault(error); fault.m_nDepth > deepest.m_nDepth) deepest = fault;
  RefuseField(file, deepest.m_cPath, Expected(doc, deepest.m_cPath), Got(doc, deepest.m_cPath));
}

} // namespace

json ReadSceneDocument(const std::filesystem::path& file) {
  return ParseSceneDocument(file.string(), ReadText(file));
}

json ParseSceneDocument(const std::string& file, const std::string& text) {
  json doc = ParseText(file, text);
  CheckSchema(file, doc);
  return doc;
}

} // namespace Shapes::Compare
