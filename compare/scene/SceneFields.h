// SPDX-License-Identifier: MIT
// One object of a scene file, read field by field. Each read checks type and range; a field that no read
// asked for is refused at the end. compare/scene.schema.json says the same for editors, and the tests hold
// both together.
#pragma once

#include "SceneDocument.h"

#include <Shapes/ShapeMath.h>

#include <array>
#include <limits>
#include <set>
#include <span>
#include <string>
#include <string_view>

namespace Shapes::Compare {

/// The numbers that a field may hold, and how a message describes them.
struct CNumberRule {
  const char* m_sExpected;
  double m_fLeast = -std::numeric_limits<double>::infinity();
  double m_fMost = std::numeric_limits<double>::infinity();
};

/// The lists of two numbers that a field may hold.
struct CPairRule {
  const char* m_sExpected;
  CNumberRule m_cNumber;
};

enum class eNeed { Required, Optional };

/// An optional field that is missing leaves the value as it is. A read throws CSceneError if a required field
/// is missing or a field breaks its rule.
class CSceneFields {
public:
  /// @param doc       the whole file; it and the name of the file have to outlive this
  /// @param path      of the object in it
  /// @param expected  "an object with ..." for the message
  /// @throws CSceneError if there is no object at the path
  CSceneFields(const std::string& file, const CJson& doc, CJsonPath path, const char* expected);

  const CJsonPath& GetPath() const { return m_cPath; }

  void Read(const char* name, float& value, const CNumberRule& rule, eNeed need = eNeed::Optional);
  void Read(const char* name, Vector2& value, const CPairRule& rule, eNeed need = eNeed::Optional);
  /// The numbers as they are written, not rounded to float.
  void Read(const char* name, std::array<double, 2>& values, const CPairRule& rule,
            eNeed need = eNeed::Optional);
  void Read(const char* name, bool& value);
  void Read(const char* name, std::string& value);
  /// A text of at least one letter; required.
  void ReadName(const char* name, std::string& value);
  /// One of these words.
  void ReadWord(const char* name, std::string& value, std::span<const std::string_view> words,
                eNeed need = eNeed::Optional);
  /// The paths of the items of a list.
  /// @param least  0 for a list that may be missing or empty, 1 for a required one with at least one item
  std::vector<CJsonPath> ReadList(const char* name, const char* expected, std::size_t least);
  /// Whether a field that holds an object is there; the object has a CSceneFields of its own.
  bool Has(const char* name);

  /// Called after the last read. @throws CSceneError if the object has a field that was not read
  void RefuseOthers() const;

private:
  // The value of a field; null if it is optional and missing.
  const CJson* Find(const char* name, const std::string& expected, eNeed need);
  // An optional value of a type that `is` tells.
  template <class T>
  void ReadAs(const char* name, T& value, const char* expected, bool (CJson::*is)() const);
  [[noreturn]] void Refuse(const CJsonPath& path, const std::string& expected) const;
  double ReadNumber(const CJsonPath& path, const CNumberRule& rule) const;
  float ToFloat(const CJsonPath& path, double number) const;

  const std::string& m_sFile;
  const CJson& m_cDoc;
  CJsonPath m_cPath;
  const CJson* m_pObject;
  std::set<std::string> m_stdKnown;
};

} // namespace Shapes::Compare
