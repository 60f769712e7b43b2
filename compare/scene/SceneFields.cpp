// SPDX-License-Identifier: MIT
#include "SceneFields.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Shapes::Compare {

CSceneFields::CSceneFields(const std::string& file, const CJson& doc, CJsonPath path, const char* expected)
    : m_sFile(file), m_cDoc(doc), m_cPath(std::move(path)), m_pObject(nullptr) {
  if (!m_cDoc.contains(m_cPath) || !m_cDoc.at(m_cPath).is_object()) Refuse(m_cPath, expected);
  m_pObject = &m_cDoc.at(m_cPath);
}

void CSceneFields::Refuse(const CJsonPath& path, const std::string& expected) const {
  RefuseField(m_sFile, path, expected, Got(m_cDoc, path));
}

const CJson* CSceneFields::Find(const char* name, const std::string& expected, eNeed need) {
  m_stdKnown.insert(name);
  const auto it = m_pObject->find(name);
  if (it != m_pObject->end()) return &*it;
  if (need == eNeed::Required) Refuse(m_cPath / name, expected);
  return nullptr;
}

double CSceneFields::ReadNumber(const CJsonPath& path, const CNumberRule& rule) const {
  const CJson& value = m_cDoc.at(path);
  if (!value.is_number()) Refuse(path, rule.m_sExpected);
  const auto number = value.get<double>();
  if (!(rule.m_fLeast <= number && number <= rule.m_fMost)) Refuse(path, rule.m_sExpected);
  return number;
}

float CSceneFields::ToFloat(const CJsonPath& path, double number) const {
  if (!(std::abs(number) <= std::numeric_limits<float>::max()))
    Refuse(path, "a number that a float can hold, at most 3.4e38 in size");
  return static_cast<float>(number);
}

void CSceneFields::Read(const char* name, float& value, const CNumberRule& rule, eNeed need) {
  if (Find(name, rule.m_sExpected, need) == nullptr) return;
  const CJsonPath path = m_cPath / name;
  value = ToFloat(path, ReadNumber(path, rule));
}

void CSceneFields::Read(const char* name, std::array<double, 2>& values, const CPairRule& rule, eNeed need) {
  const CJson* pList = Find(name, rule.m_sExpected, need);
  if (pList == nullptr) return;
  const CJsonPath path = m_cPath / name;
  if (!pList->is_array() || pList->size() != 2) Refuse(path, rule.m_sExpected);
  for (std::size_t i = 0; i < 2; ++i)
    values[i] = ReadNumber(path / i, rule.m_cNumber);
}

void CSceneFields::Read(const char* name, Vector2& value, const CPairRule& rule, eNeed need) {
  if (Find(name, rule.m_sExpected, need) == nullptr) return;
  std::array<double, 2> numbers;
  Read(name, numbers, rule, need);
  const CJsonPath path = m_cPath / name;
  value = {ToFloat(path / 0, numbers[0]), ToFloat(path / 1, numbers[1])};
}

template <class T>
void CSceneFields::ReadAs(const char* name, T& value, const char* expected, bool (CJson::*is)() const) {
  const CJson* pValue = Find(name, expected, eNeed::Optional);
  if (pValue == nullptr) return;
  if (!(pValue->*is)()) Refuse(m_cPath / name, expected);
  value = pValue->get<T>();
}

void CSceneFields::Read(const char* name, bool& value) {
  ReadAs(name, value, "true or false", &CJson::is_boolean);
}

void CSceneFields::Read(const char* name, std::string& value) {
  ReadAs(name, value, "a text", &CJson::is_string);
}

void CSceneFields::ReadName(const char* name, std::string& value) {
  const char* expected = "a text of at least one letter";
  const CJson* pValue = Find(name, expected, eNeed::Required);
  if (!pValue->is_string() || pValue->get_ref<const std::string&>().empty()) Refuse(m_cPath / name, expected);
  value = pValue->get<std::string>();
}

void CSceneFields::ReadWord(const char* name, std::string& value, std::span<const std::string_view> words,
                            eNeed need) {
  const std::string expected = fmt::format("one of \"{}\"", fmt::join(words, "\", \""));
  const CJson* pValue = Find(name, expected, need);
  if (pValue == nullptr) return;
  if (!pValue->is_string() ||
      std::find(words.begin(), words.end(), pValue->get_ref<const std::string&>()) == words.end())
    Refuse(m_cPath / name, expected);
  value = pValue->get<std::string>();
}

std::vector<CJsonPath> CSceneFields::ReadList(const char* name, const char* expected, std::size_t least) {
  const CJson* pList = Find(name, expected, least > 0 ? eNeed::Required : eNeed::Optional);
  if (pList == nullptr) return {};
  const CJsonPath path = m_cPath / name;
  if (!pList->is_array() || pList->size() < least) Refuse(path, expected);
  std::vector<CJsonPath> items;
  for (std::size_t i = 0; i < pList->size(); ++i)
    items.push_back(path / i);
  return items;
}

bool CSceneFields::Has(const char* name) {
  m_stdKnown.insert(name);
  return m_pObject->contains(name);
}

void CSceneFields::RefuseOthers() const {
  for (const auto& field : m_pObject->items())
    if (!m_stdKnown.contains(field.key()))
      Refuse(m_cPath / field.key(), fmt::format("no such field (known are {})", fmt::join(m_stdKnown, ", ")));
}

} // namespace Shapes::Compare
