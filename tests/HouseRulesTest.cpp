// SPDX-License-Identifier: MIT
// The rules of the house, read off the sources: who may include whom, and what every file has.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// The name in one #include directive, without its quotes or brackets; empty if it is none.
std::string IncludeOf(const std::string& line) {
  static const std::regex pattern(R"([ \t]*#[ \t]*include[ \t]*["<]([^">]*))");
  std::smatch match;
  const auto atTheBeginning = std::regex_constants::match_continuous;
  return std::regex_search(line, match, pattern, atTheBeginning) ? match[1].str() : "";
}

bool IsIn(const std::string& path, std::string_view folder) { return path.starts_with(folder); }

/// Whether an include leads into a part of the sources, however it is spelled ("native/..", "../native/..").
bool LeadsInto(const std::string& include, std::string_view part) {
  return include.starts_with(part) || include.find("/" + std::string(part)) != std::string::npos;
}

/// Where an include of `path` that is written relative to it leads; as it is where it is not relative to a
/// file of this project.
std::string Resolve(const std::string& path, const std::string& include, const std::set<std::string>& files) {
  const std::string beside = (fs::path(path).parent_path() / include).lexically_normal().generic_string();
  return files.contains(beside) ? beside : include;
}

/// The folders of src that are engines, with a slash: all but those that know none.
std::set<std::string> EnginesIn(const std::set<std::string>& files) {
  std::set<std::string> engines;
  for (const std::string& path : files)
    if (const std::size_t end = path.find('/', 4); IsIn(path, "src/") && end != std::string::npos)
      engines.insert(path.substr(4, end + 1 - 4));
  for (const char* pFolder : {"geometry/", "shapes/", "traps/", "world/"})
    engines.erase(pFolder);
  return engines;
}

/// Every rule that the file breaks, one line each.
/// @param path   relative to the root, with slashes
/// @param files  all paths of the project
std::vector<std::string> BrokenRules(const std::string& path, const std::string& text,
                                     const std::set<std::string>& files) {
  std::vector<std::string> broken;
  const auto report = [&](const std::string& what) { broken.push_back(path + ": " + what); };

  const bool isHeader = path.ends_with(".h");
  const std::string stem = fs::path(path).stem().string();
  std::string lower = stem;
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? char(c + 32) : c; });
  for (const char* pWord : {"utils", "util", "common", "misc", "helper", "helpers"})
    if (lower == pWord) report("a file is named by what is in it");
  if (!text.starts_with("// SPDX-License-Identifier: MIT\n")) report("the first line is not the licence");
  if (isHeader && text.find("\n#pragma once\n") == std::string::npos) report("no #pragma once");

  const bool seesBox2D = IsIn(path, "src/box2d_backend/") || IsIn(path, "tests/box2d_backend/") ||
                         IsIn(path, "examples/box2d_game/") || path == "compare/benchmark/Box2DGame.cpp";
  const bool seesInterfaceOnly = IsIn(path, "tests/contract/") || IsIn(path, "compare/") ||
                                 IsIn(path, "examples/") || IsIn(path, "tests/consumer/");
  const bool knowsNoEngine = IsIn(path, "include/") || IsIn(path, "src/shapes/") ||
                             IsIn(path, "src/geometry/") || IsIn(path, "src/world/");
  const std::set<std::string> engines = EnginesIn(files);
  std::set<std::string> included;

  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string written = IncludeOf(line);
    if (written.empty()) continue;
    const std::string include = Resolve(path, written, files);
    const auto forbid = [&](bool isForbidden, const char* why) {
      if (isForbidden) report("includes " + written + ": " + why);
    };
    const auto toEngine = std::find_if(engines.begin(), engines.end(),
                                       [&](const std::string& engine) { return LeadsInto(include, engine); });
    const bool isToEngine = toEngine != engines.end(), toBox2D = LeadsInto(include, "box2d/");
    const bool toSrc = IsIn(include, "src/") || isToEngine || LeadsInto(include, "shapes/") ||
                       LeadsInto(include, "world/") || LeadsInto(include, "geometry/");
    const bool toWorld = LeadsInto(include, "world/") && !isToEngine;
    // Beside a test of its own folder, tests/native/X.h is no engine.
    const bool toTests = IsIn(include, "tests/");
    if (isToEngine && !toTests) included.insert(*toEngine);
    forbid(toBox2D && !seesBox2D, "only src/box2d_backend and a game know Box2D");
    forbid(knowsNoEngine && isToEngine, "interface, geometry, shapes and world know no engine");
    for (const std::string& engine : engines)
      forbid(IsIn(path, "src/" + engine) && isToEngine && engine != *toEngine,
             "the engines do not know each other");
    forbid(IsIn(path, "src/geometry/") && toWorld, "geometry knows no world");
    forbid(IsIn(path, "src/shapes/") && toWorld, "shapes know no world");
    forbid(seesInterfaceOnly && toSrc && !toTests, "only <Shapes/...> is seen here");
    forbid(IsIn(path, "include/") && toSrc, "the interface is whole without the sources");
  }
  if (included.size() > 1 && path != "src/Engines.cpp")
    report("includes several engines, as only src/Engines.cpp does");
  return broken;
}

/// The names of the classes and structures that are defined at the beginning of a line: not nested ones.
std::set<std::string> ClassesOf(const std::string& text) {
  static const std::regex pattern(R"((?:^|\n)(?:class|struct) (C\w+)(?![\w:])[^;\n]*\{)");
  std::set<std::string> names;
  for (std::sregex_iterator it(text.begin(), text.end(), pattern), end; it != end; ++it)
    names.insert((*it)[1]);
  return names;
}

/// The faults of a header of the interface: protected members, but for those of CShapeCommon
/// and the constructors and assignments of bases; hooks for engines; and classes of the sources.
/// @param internal  the names of those
std::vector<std::string> ShownInside(const std::string& path, const std::string& text,
                                     const std::set<std::string>& internal) {
  std::vector<std::string> shown;
  std::string className;
  bool isProtected = false;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string code = line.substr(0, line.find("//"));
    const auto report = [&](const std::string& what) { shown.push_back(path + ": " + what + ": " + line); };
    std::smatch match;
    if (std::regex_search(code, match, std::regex(R"(^(?:class|struct) (C\w+).*\{)"))) className = match[1];
    if (code.starts_with("};") || code == "public:" || code == "private:") isProtected = false;
    if (code == "protected:") {
      isProtected = className != "CShapeCommon";
      continue;
    }
    // A constructor, its initializers, and an assignment have the name of the class at the beginning.
    const bool isOfBase =
        std::regex_search(code, std::regex(R"(^\s*(explicit )?)" + className + R"([(&])")) ||
        std::regex_search(code, std::regex(R"(^\s*:|^\s*$)"));
    if (isProtected && !isOfBase) report("a protected member");
    if (line.find("ngines only") != std::string::npos) report("a hook for engines");
    if (path.ends_with("/World.h") && std::regex_search(code, std::regex(R"(\bvirtual\b)")))
      report("a virtual function, and the world is closed");
    static const std::regex aClass(R"(\bC[A-Z]\w+)");
    for (std::sregex_iterator it(code.begin(), code.end(), aClass), end; it != end; ++it)
      if (internal.contains(it->str())) report("a class of the sources");
  }
  return shown;
}

bool IsSource(const fs::path& path) { return path.extension() == ".h" || path.extension() == ".cpp"; }

std::set<std::string> AllFiles() {
  const fs::path root = SHAPES_SOURCE_DIR;
  std::set<std::string> files;
  for (const char* pFolder : {"include", "src", "tests", "compare", "examples"}) {
    if (!fs::exists(root / pFolder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / pFolder))
      if (entry.is_regular_file() && IsSource(entry.path()))
        files.insert(fs::relative(entry.path(), root).generic_string());
  }
  return files;
}

std::string Read(const std::string& path) {
  std::ifstream in(fs::path(SHAPES_SOURCE_DIR) / path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

TEST(HouseRulesTest, EveryFileKeepsThem) {
  const std::set<std::string> files = AllFiles();
  EXPECT_GT(files.size(), 50u); // found where they are
  EXPECT_TRUE(files.contains("src/Engines.cpp") && files.contains("tests/HouseRulesTest.cpp"));
  const std::set<std::string> engines = EnginesIn(files);
  EXPECT_TRUE(engines.contains("native/") && engines.contains("box2d_backend/"));
  for (const std::string& path : files)
    for (const std::string& broken : BrokenRules(path, Read(path), files))
      ADD_FAILURE() << broken;
}

TEST(HouseRulesTest, TheInterfaceShowsNothingOfTheInside) {
  const std::set<std::string> files = AllFiles();
  std::set<std::string> internal;
  for (const std::string& path : files)
    if (IsIn(path, "src/")) internal.merge(ClassesOf(Read(path)));
  EXPECT_TRUE(internal.contains("CEngine") && internal.contains("CWorldState"));
  for (const std::string& path : files)
    if (IsIn(path, "include/"))
      for (const std::string& shown : ShownInside(path, Read(path), internal))
        ADD_FAILURE() << shown;
}

bool IsThere(const std::string& path) { return fs::exists(fs::path(SHAPES_SOURCE_DIR) / path); }

// A path from the root, or the end of one: the name of a source, also behind its folder.
TEST(HouseRulesTest, ThePageOfTheHouseNamesWhatIsThere) {
  const std::set<std::string> files = AllFiles();
  const auto isThere = [&](const std::string& named) {
    static const std::regex fromTheRoot("(include|src|compare|tests|docs)/.*");
    if (std::regex_match(named, fromTheRoot)) return IsThere(named);
    return IsThere(named) || std::any_of(files.begin(), files.end(), [&](const std::string& file) {
             return file.ends_with("/" + named);
           });
  };
  const std::string page = Read("docs/architecture.md");
  const std::regex path(R"(`((?:include|src|compare|tests|docs)/[\w/.]+|[\w/]+\.(?:h|cpp))`)");
  std::size_t paths = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), path), end; it != end; ++it, ++paths)
    EXPECT_TRUE(isThere((*it)[1])) << it->str();
  EXPECT_GT(paths, 200u);
  // The control; the last one is in tests.
  EXPECT_FALSE(isThere("Gone.cpp") || isThere("src/gone") || isThere("compare/MadeScenes.h"));
}

std::vector<std::string> FilesNamedIn(const std::string& text) {
  static const std::regex path(R"(\b(?:src|tests|docs|scripts)/[\w/]+\.(?:h|cpp|md|sh|py)\b)");
  std::vector<std::string> named;
  for (std::sregex_iterator it(text.begin(), text.end(), path), end; it != end; ++it)
    named.push_back(it->str());
  return named;
}

TEST(HouseRulesTest, CommentsNameFilesThatThereAre) {
  std::size_t paths = 0;
  for (const std::string& file : AllFiles()) {
    if (file == "tests/HouseRulesTest.cpp") continue; // whose files are made up
    for (const std::string& named : FilesNamedIn(Read(file))) {
      EXPECT_TRUE(IsThere(named)) << file << ": " << named;
      ++paths;
    }
  }
  EXPECT_GT(paths, 20u);
  // The control.
  const std::vector<std::string> gone = FilesNamedIn("/// as src/world/Gone.h has it\n");
  EXPECT_TRUE(gone.size() == 1 && !IsThere(gone[0]));
}

// "Suite.Name" is a test, "Name" one of the hard cases.
TEST(HouseRulesTest, ThePageOfErrataNamesTestsThatThereAre) {
  std::string tests, cases;
  for (const std::string& path : AllFiles())
    if (IsIn(path, "tests/")) (IsIn(path, "tests/hard_cases/") ? cases : tests) += Read(path);
  const auto isThere = [&](const std::string& suite, const std::string& name) {
    return suite.empty() ? cases.find('"' + name + '"') != std::string::npos
                         : tests.find("TEST(" + suite + ", " + name + ")") != std::string::npos ||
                               tests.find("TEST_P(" + suite + ", " + name + ")") != std::string::npos;
  };
  const std::string page = Read("docs/errata.md");
  const std::regex test(R"(`(?:([A-Z]\w+)\.)?([A-Z]\w+)`)");
  std::size_t names = 0;
  for (std::sregex_iterator it(page.begin(), page.end(), test), end; it != end; ++it, ++names)
    EXPECT_TRUE(isThere((*it)[1], (*it)[2])) << it->str();
  EXPECT_GT(names, 30u);
  EXPECT_FALSE(isThere("LineSeg", "IsNoTest") || isThere("", "IsNoCase")); // the control
}

TEST(HouseRulesTest, TheInterfaceThatShowsTheInsideIsNoticed) {
  const auto count = [](const std::string& text) {
    return ShownInside("include/Shapes/World.h", text, {"CEngine"}).size();
  };
  EXPECT_EQ(count("class CWorld {\nprotected:\n  CWorld(int n);\n};\n"), 0u);
  EXPECT_EQ(count("class CWorld {\nprotected:\n  int m_nSteps;\n};\n"), 1u);
  EXPECT_EQ(count("class CWorld {\nprotected:\n  void Report();\nprivate:\n  int m_nSteps;\n};\n"), 1u);
  EXPECT_EQ(count("class CShapeCommon {\nprotected:\n  static float m_fGravity;\n};\n"), 0u);
  EXPECT_EQ(count("class CWorld {\n  virtual void Step();\n};\n"), 1u);
  EXPECT_EQ(count("class CWorld {\n  CEngine* m_pEngine;\n};\n"), 1u);
  EXPECT_EQ(count("class CWorld {\n  int m_nSteps; // of CEngine\n};\n"), 0u);
  EXPECT_EQ(count("  /// For engines only: the state.\n"), 1u);
  EXPECT_EQ(ClassesOf("class CA {\n  struct CB {};\n};\nstruct CC : CA {\nclass CD;\n"),
            (std::set<std::string>{"CA", "CC"}));
}

// The controls: made-up files, each of which breaks one rule, and their neighbours that break none.
class CHouseRulesControl : public testing::Test {
protected:
  static std::size_t Count(const std::string& path, const std::string& lines) {
    const std::string head = "// SPDX-License-Identifier: MIT\n";
    return BrokenRules(path, head + (path.ends_with(".h") ? "#pragma once\n" : "") + lines, m_stdFiles)
        .size();
  }
  static inline const std::set<std::string> m_stdFiles{
      "src/native/narrowphase/Collide.h", "src/box2d_backend/world/FixtureShapes.h",
      "src/third/world/ThirdEngine.h", "src/shapes/Response.h", "compare/scene/Scene.h"};
};

TEST_F(CHouseRulesControl, Box2DOutsideOfItsFolder) {
  EXPECT_EQ(Count("src/native/X.cpp", "#include <box2d/box2d.h>\n"), 1u);
  EXPECT_EQ(Count("include/Shapes/X.h", "  #  include \"box2d/b2_math.h\"\n"), 1u);
  EXPECT_EQ(Count("compare/X.cpp", "#include<box2d/box2d.h>\n"), 1u);
  EXPECT_EQ(Count("src/box2d_backend/X.cpp", "#include <box2d/box2d.h>\n"), 0u);
  EXPECT_EQ(Count("tests/box2d_backend/X.cpp", "#include <box2d/box2d.h>\n"), 0u);
  EXPECT_EQ(Count("examples/quickstart/main.cpp", "#include <box2d/box2d.h>\n"), 1u);
  EXPECT_EQ(Count("examples/box2d_game/main.cpp", "#include <box2d/box2d.h>\n"), 0u);
  EXPECT_EQ(Count("examples/box2d_game/main.cpp", "#include \"box2d_backend/world/FixtureShapes.h\"\n"), 1u);
  EXPECT_EQ(Count("src/native/X.cpp", "// #include <box2d/box2d.h>\n"), 0u);
}

TEST_F(CHouseRulesControl, EnginesInWhatKnowsNone) {
  EXPECT_EQ(Count("src/shapes/X.cpp", "#include \"../native/narrowphase/Collide.h\"\n"), 1u);
  EXPECT_EQ(Count("src/shapes/X.cpp", "#include \"native/narrowphase/Collide.h\"\n"), 1u);
  EXPECT_EQ(Count("src/shapes/X.cpp", "#include \"../box2d_backend/world/FixtureShapes.h\"\n"), 1u);
  EXPECT_EQ(Count("src/shapes/X.cpp", "#include \"Response.h\"\n"), 0u);
  EXPECT_EQ(Count("src/shapes/X.cpp", "#include \"../world/WorldState.h\"\n"), 1u);
  EXPECT_EQ(Count("src/geometry/X.cpp", "#include \"../world/WorldState.h\"\n"), 1u);
  EXPECT_EQ(Count("src/geometry/X.cpp", "#include \"../native/narrowphase/Collide.h\"\n"), 1u);
  EXPECT_EQ(Count("src/world/X.cpp", "#include \"../native/narrowphase/Collide.h\"\n"), 1u);
  EXPECT_EQ(Count("src/world/X.cpp", "#include \"../geometry/Turn.h\"\n"), 0u);
  EXPECT_GE(Count("include/Shapes/X.h", "#include \"../../src/native/narrowphase/Collide.h\"\n"), 1u);
  EXPECT_GE(Count("include/Shapes/X.h", "#include \"../../src/shapes/Response.h\"\n"), 1u);
}

TEST_F(CHouseRulesControl, EnginesInEachOther) {
  EXPECT_EQ(Count("src/native/X.cpp", "#include \"../box2d_backend/world/FixtureShapes.h\"\n"), 1u);
  EXPECT_EQ(Count("src/box2d_backend/X.cpp", "#include \"native/narrowphase/Collide.h\"\n"), 1u);
  EXPECT_EQ(
      Count("src/native/X.cpp", "#include \"narrowphase/Collide.h\"\n#include \"../shapes/Response.h\"\n"),
      0u);
  const std::string both =
      "#include \"native/narrowphase/Collide.h\"\n#include \"box2d_backend/world/FixtureShapes.h\"\n";
  EXPECT_EQ(Count("src/Other.cpp", both), 1u);
  EXPECT_EQ(Count("tests/XTest.cpp", both), 1u);
  EXPECT_EQ(Count("src/Engines.cpp", both), 0u);
}

TEST_F(CHouseRulesControl, AnotherEngineIsOneByItsFolder) {
  const std::string third = "#include \"../third/world/ThirdEngine.h\"\n";
  EXPECT_EQ(Count("src/native/X.cpp", third), 1u);
  EXPECT_EQ(Count("src/world/X.cpp", third), 1u);
  EXPECT_EQ(Count("src/third/X.cpp", "#include \"world/ThirdEngine.h\"\n"), 0u);
  EXPECT_EQ(Count("src/third/X.cpp", "#include \"../native/narrowphase/Collide.h\"\n"), 1u);
}

TEST_F(CHouseRulesControl, TheInsidesInWhatSeesTheInterface) {
  for (const char* pPath :
       {"tests/contract/X.cpp", "compare/X.cpp", "examples/quickstart/main.cpp", "tests/consumer/main.cpp"}) {
    EXPECT_EQ(Count(pPath, "#include \"shapes/Response.h\"\n"), 1u) << pPath;
    EXPECT_EQ(Count(pPath, "#include \"../../src/shapes/Response.h\"\n"), 1u) << pPath;
    EXPECT_EQ(Count(pPath, "#include \"native/narrowphase/Collide.h\"\n"), 1u) << pPath;
    EXPECT_EQ(Count(pPath, "#include <Shapes/World.h>\n#include <vector>\n"), 0u) << pPath;
  }
  EXPECT_EQ(Count("compare/X.cpp", "#include \"scene/Scene.h\"\n#include \"reference/Reference.h\"\n"), 0u);
  EXPECT_EQ(Count("tests/shapes/X.cpp", "#include \"shapes/Response.h\"\n"), 0u);
}

TEST_F(CHouseRulesControl, WhatEveryFileHas) {
  EXPECT_EQ(BrokenRules("src/X.cpp", "#include <vector>\n", {}).size(), 1u);
  EXPECT_EQ(BrokenRules("src/X.cpp", "\n// SPDX-License-Identifier: MIT\n", {}).size(),
            1u); // not on the first line
  EXPECT_EQ(BrokenRules("src/X.h", "// SPDX-License-Identifier: MIT\n", {}).size(), 1u);
  EXPECT_EQ(BrokenRules("src/X.h", "// SPDX-License-Identifier: MIT\n// #pragma once\n", {}).size(), 1u);
  EXPECT_EQ(BrokenRules("src/X.h", "// SPDX-License-Identifier: MIT\n#pragma once\n", {}).size(), 0u);
  for (const char* pName :
       {"src/Utils.cpp", "tests/common.cpp", "compare/Misc.cpp", "src/native/Helpers.cpp"})
    EXPECT_EQ(Count(pName, ""), 1u) << pName;
  EXPECT_EQ(Count("src/ShapeCommon.cpp", ""), 0u);
}

} // namespace
