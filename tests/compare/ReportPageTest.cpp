// SPDX-License-Identifier: MIT
// report.html in a browser without a window and without a network: a script does what a reader does, and
// notes what is then to be seen.
#include "CommandCalls.h"
#include "page/PageDocuments.h"
#include "report/Report.h"

#include <cstdlib>

namespace Shapes::Compare {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

enum class eScheme { Dark, Light }; // in the browser's order

// Contrasts that WCAG 2.1 asks of text (1.4.3) and of drawings (1.4.11).
constexpr double g_fTextContrast = 4.5, g_fGraphicsContrast = 3.0;
// A thin line of a plot covers hundreds of pixels, most of them blended; some have the pure colour.
constexpr int g_nPixelsOfALine = 20;
// Sizes of letters, and the least of them in pixels.
constexpr std::size_t g_nLetterSizes = 5;
constexpr double g_fLeastLetters = 12.0;
// Pixels between two names of an axis.
constexpr double g_fNameGap = 4.0;

/// Puts a text before or behind the one place where the page has `mark`.
std::string Insert(std::string page, const std::string& mark, const std::string& text, bool isBehind) {
  const std::size_t at = page.rfind(mark);
  if (at == std::string::npos) throw std::runtime_error("the page has no " + mark);
  return page.insert(at + (isBehind ? mark.size() : 0), text);
}

class ReportPageTest : public Tests::CCommandTest {
protected:
  std::string ReadPart(const char* pName) const {
    const std::string text = Read(fs::path(SHAPES_SOURCE_DIR) / "tests/compare/page" / pName);
    EXPECT_FALSE(text.empty()) << pName;
    return "<script>\n" + text + "</script>\n";
  }

  /// The traces of the exercise.
  json Exercise(const std::string& page, eScheme scheme = eScheme::Light, int width = 1280) const {
    // rfind of "<head>" is right as long as the data has none: '<' is escaped in it.
    const std::string watched = Insert(page, "<head>\n", ReadPart("watch.js"), true);
    const std::string file = Write("page.html", Insert(watched, "</body>", ReadPart("exercise.js"), false));
    // Without a network where the system lets one do so, and without names to look up in any case.
    const std::string offline = std::system("unshare -rn true 2>/dev/null") == 0 ? "unshare -rn " : "";
    const Tests::CResult result =
        Call("", "(" + offline + "timeout 150 '" SHAPES_CHROMIUM "' --headless --no-sandbox --disable-gpu" +
                     " --no-first-run --disable-dev-shm-usage --host-resolver-rules='MAP * ~NOTFOUND'" +
                     " --force-device-scale-factor=1 --blink-settings=preferredColorScheme=" +
                     std::to_string(static_cast<int>(scheme)) + " --window-size=" + std::to_string(width) +
                     ",1000 --user-data-dir='" + (m_cFolder / "profile").string() +
                     "' --timeout=120000 --dump-dom 'file://" + file + "' 2>'" +
                     (m_cFolder / "log").string() + "')");
    const std::string &dom = result.m_sOutput, open = "<pre id=\"test-result\">";
    const std::size_t begin = dom.find(open), end = dom.find("</pre>", begin);
    if (result.m_nExit != 0 || begin == std::string::npos || end == std::string::npos)
      throw std::runtime_error("the page left no result; the browser says: " + Read("log"));
    return json::parse(dom.substr(begin + open.size(), end - begin - open.size()));
  }

  static void ExpectSound(const json& result) {
    EXPECT_TRUE(result.at("isDone").get<bool>());
    EXPECT_EQ(result.at("width"), 0); // nothing sticks out
    EXPECT_GE(result.at("seriesContrast").get<double>(), g_fGraphicsContrast);
    for (const char* pKey : {"errors", "resources", "cut", "overlaps"}) // resources: nothing was fetched
      EXPECT_EQ(result.at(pKey), json::array()) << pKey;
    for (const json& scene : result.at("scenes")) {
      SCOPED_TRACE(scene.at("name"));
      for (const char* pKey : {"cut", "overlaps", "repeated", "odd"})
        EXPECT_EQ(scene.at(pKey), json::array()) << pKey;
      EXPECT_LE(scene.at("sizes").size(), g_nLetterSizes) << scene.at("sizes");
      EXPECT_GE(scene.at("sizes").at(0).get<double>(), g_fLeastLetters);
      EXPECT_EQ(scene.at("hash"), "#scene=" + scene.at("name").get<std::string>());
      EXPECT_GE(scene.at("text").at("contrast").get<double>(), g_fTextContrast)
          << scene.at("text").at("where");
      if (scene.contains("replay")) ExpectReplay(scene);
    }
  }

  static void ExpectDrawn(const json& seen, const std::vector<std::string>& engines) {
    EXPECT_GT(seen.at("colours").get<int>(), 3);
    for (const std::string& engine : engines)
      EXPECT_GE(seen.at(engine).get<int>(), g_nPixelsOfALine) << engine;
  }
  static std::vector<std::string> GetNames(bool withExact = false) {
    std::vector<std::string> names;
    for (const CEngineRow& row : Tests::GetKnownRows())
      names.push_back(row.m_sName);
    if (withExact) names.push_back("exact");
    return names;
  }

  static void ExpectHas(const json& seen, const json& expected) {
    for (const auto& [key, value] : expected.items())
      EXPECT_EQ(seen.at(key), value) << key;
  }
  /// Whether the page shows this part of a text, or of one of several.
  static testing::AssertionResult Shows(const json& texts, const std::string& part) {
    return Says(texts.dump(), part);
  }

  // Controls that have to work with any recording.
  static void ExpectReplay(const json& scene) {
    EXPECT_GT(scene.at("replay").at("colours").get<int>(), 3);
    const json& play = scene.at("play");
    EXPECT_GT(play.at("after").get<int>(), play.at("before").get<int>());
    EXPECT_EQ(play.at("isPlaying"), "false");
    EXPECT_TRUE(play.at("rested").get<bool>());
    for (const json& worst : scene.at("worst")) {
      EXPECT_NEAR(worst.at("x").get<double>(), 0.5, 1.0 / 6);
      EXPECT_NEAR(worst.at("y").get<double>(), 0.5, 1.0 / 6);
      EXPECT_GT(worst.at("middle").at("exact").get<int>(), 0);
      EXPECT_GE(worst.at("ring").get<int>(), g_nPixelsOfALine);
      EXPECT_EQ(worst.at("ringBefore"), 0);
      int engines = 0;
      for (const std::string& engine : GetNames())
        engines += worst.at("middle").at(engine).get<int>();
      EXPECT_GT(engines, 0);
    }
    const json& keys = scene.at("keys");
    ExpectHas(keys, {{"plus", true}, {"minus", true}, {"all", true}, {"wheel", true}, {"hidden", 0}});
    ExpectHas(keys, {{"space", "true"}, {"spaceAgain", "false"}});
    EXPECT_NEAR(keys.at("dragged").get<double>(), 30,
                0.2); // as far as the pointer, and not after its release
    EXPECT_GT(keys.at("shown").get<int>(), 0);
  }

  // A group for each of two engines, and a row for each of six effects.
  static void ExpectEffects(const json& scene) {
    const json& rows = scene.at("effects");
    ASSERT_EQ(rows.size(), 14u);
    EXPECT_EQ(scene.at("uncalled"), 4);
    EXPECT_TRUE(Shows(rows[1], "gravityalways"));
    EXPECT_TRUE(Shows(rows[1], "+15.0% (+10.4% to +19.6%)"));
    EXPECT_TRUE(Shows(rows[1], "+15.0% (1,150 / 1,000)"));
    EXPECT_TRUE(Shows(rows[2], "kinematicsin 35.0% of the substeps"));
    EXPECT_TRUE(Shows(rows[3], "ball pairsno"));
    EXPECT_TRUE(Shows(rows[4], "none (\u22123.04% to +5.04%)")); // cannot be told
    EXPECT_TRUE(Shows(rows[5], "\u221210.0%"));
    EXPECT_TRUE(Shows(rows[6], "1.67 / 50.0"));
    // Flights without what is called for, losses without Continuous, and all that is not judged without
    // Events.
    EXPECT_EQ(scene.at("differing").size(), 2u * (4u + 1u + 3u));
  }

  // Facts of the made-up scenes beyond that.
  static void ExpectFull(const json& scene) {
    SCOPED_TRACE(scene.at("name"));
    for (const auto& [pPlot, withExact] : {std::pair("error", true),
                                           {"tunneled", true},
                                           {"setback_error_histogram", false},
                                           {"penetration_histogram", false}})
      ExpectDrawn(scene.at("plots").at(pPlot), GetNames(withExact));
    ExpectHas(scene, {{"heatMaps", 4}, {"outcomes", 4}, {"folds", 6}, {"chart", true}});
    EXPECT_EQ(scene.at("answers").size(), 3u);
    EXPECT_TRUE(Shows(scene.at("answers")[1], "nothing that was tried"));
    EXPECT_TRUE(Shows(scene.at("verdict"), "within 1.1\u00b0"));
    EXPECT_GT(scene.at("metrics").get<int>(), 30);
    EXPECT_GT(scene.at("bins").get<int>(), 10);
    ExpectEffects(scene);
    for (const json& axes : scene.at("axes")) { // whose names do not run together
      EXPECT_GE(axes.at("names").get<int>(), 2);
      EXPECT_GE(axes.at("room").get<double>(), g_fNameGap);
    }
    EXPECT_TRUE(Shows(scene.at("work"), "A ball that is lost counts as \u03c0"));
    EXPECT_TRUE(Shows(scene.at("work"), "The exact reference is timed too"));
    EXPECT_TRUE(Shows(scene.at("settings"), "none in 95,000"));
    EXPECT_TRUE(Shows(scene.at("settings"), "< 0.00300")); // 3 in 100 000
    EXPECT_TRUE(Shows(scene.at("heatCells"), "< 0.15%"));  // 3 in 2000
    EXPECT_TRUE(Shows(scene.at("counts"), "ghost 0 (< 0.375% of quiet steps)"));
    // Nothing of what comes is drawn: at the beginning there is no way yet.
    EXPECT_GT(scene.at("end").get<int>(), 2 * scene.at("start").get<int>());
    ASSERT_TRUE(scene.contains("replay"));
    EXPECT_TRUE(Shows(scene.at("worstFirst"), "worst "));
    for (const std::string& engine : GetNames()) {
      const json& worst = scene.at("worst").at(engine);
      ExpectHas(worst, {{"clip", "worst " + engine}, {"frame", g_nWorstContact}});
      EXPECT_TRUE(Shows(worst.at("text"), ": s")); // title: what goes wrong
    }
    ExpectHas(scene.at("keys"), {{"right", 1}, {"left", -1}, {"scrubbed", 5}});
  }

  static std::string ToPage(const CPageDocuments& sample) {
    return MakeHtml(sample.m_cRun.dump(), sample.m_cReplay.dump(), sample.m_cCharts.dump());
  }
};

TEST_F(ReportPageTest, AFullReportInTheLight) {
  const std::string wordy =
      "a name & a <b> in more words than stand beside each other, and one of many letters " +
      std::string(300, 'x');
  const json result = Exercise(ToPage(MakePageDocuments({"bowl", "corner", wordy})));
  ExpectSound(result);
  ExpectHas(result, {{"isDark", false}, {"isInterrupted", false}, {"rows", 3}});
  EXPECT_EQ(result.at("tiles").size(), 4u);
  EXPECT_EQ(result.at("labels"), json({4})); // the chart that fits, and not the other one
  EXPECT_LE(result.at("firstScreen").get<double>(), 800);
  EXPECT_TRUE(Shows(result.at("text"), "Take native: 7.1 times as fast as Box2D"));
  EXPECT_TRUE(Shows(result.at("text"), "within 12\u00b0") || Shows(result.at("text"), "Box2D 12\u00b0"));
  EXPECT_TRUE(Shows(result.at("tiles"), "impacts lost1 in 83"));
  EXPECT_TRUE(Shows(result.at("tiles"), "<0.001\u00b0"));
  EXPECT_TRUE(Shows(result.at("matrix"), "\u2713")); // readable without colour
  EXPECT_TRUE(Shows(result.at("matrix"), "\u2717"));
  for (const char* pFact :
       {"shapes-compare run", "seed 1", "0.1.0 (1234567)", "2.4.1", "g++ 12.2.0", "Some CPU"})
    EXPECT_TRUE(Shows(result.at("footer"), pFact));
  EXPECT_EQ(result.at("links"), json({"bowl", "corner", "bowl", "#scene=bowl"})); // card, next, before, top
  ASSERT_EQ(result.at("scenes").size(), 3u);
  for (const json& scene : result.at("scenes"))
    ExpectFull(scene);
}

TEST_F(ReportPageTest, AFullReportInTheDarkInANarrowWindowAndOnAPhone) {
  for (const auto& [pName, width, height] :
       {std::tuple("bowl", 800, 1280), {"bowl_that_has_a_rather_long_name", 390, 844}}) {
    SCOPED_TRACE(width);
    const json result = Exercise(ToPage(MakePageDocuments({pName})), eScheme::Dark, width);
    ExpectSound(result);
    EXPECT_TRUE(result.at("isDark").get<bool>());
    EXPECT_EQ(result.at("labels"), json({4}));
    EXPECT_LE(result.at("firstScreen").get<double>(), height);
    EXPECT_EQ(result.at("print").at("paper"), json({255, 255, 255}));
    EXPECT_NE(result.at("print").at("screen"), json({255, 255, 255}));
    EXPECT_GE(result.at("print").at("plot").get<int>(), g_nPixelsOfALine);
    EXPECT_GE(result.at("print").at("plotAfter").get<int>(), g_nPixelsOfALine);
    ExpectFull(result.at("scenes").at(0));
  }
}

TEST_F(ReportPageTest, WhatARunMayLeaveOut) {
  const json result = Exercise(ToPage(MakeSparsePageDocuments()));
  ExpectSound(result);
  EXPECT_TRUE(result.at("isInterrupted").get<bool>());
  EXPECT_EQ(result.at("rows"), 5);
  const json& scenes = result.at("scenes");
  ASSERT_EQ(scenes.size(), 5u);
  const json &full = scenes[0], &noContacts = scenes[1], &oneEngine = scenes[2], &nulls = scenes[3],
             &noClips = scenes[4];
  EXPECT_EQ(noClips.at("name"), "no_clips");
  ExpectFull(full);
  EXPECT_EQ(noContacts.at("outcomes"), 0);
  EXPECT_FALSE(noContacts.at("plots").contains("setback_error_histogram"));
  EXPECT_EQ(oneEngine.at("outcomes"), 1);
  ExpectDrawn(oneEngine.at("plots").at("setback_error_histogram"), {"native"});
  EXPECT_TRUE(oneEngine.at("effects").empty());
  EXPECT_FALSE(nulls.at("plots").contains("error"));
  EXPECT_TRUE(nulls.contains("replay"));
  EXPECT_EQ(nulls.at("effects").size(), 14u);
  EXPECT_FALSE(noClips.contains("replay"));

  // How far the ball goes in a step says little where the shapes move.
  const std::string far = "right of the double line";
  EXPECT_TRUE(Shows(noClips.at("heatNote"), far));
  EXPECT_GT(noClips.at("farCells").get<int>(), 0);
  EXPECT_FALSE(Shows(full.at("heatNote"), far));
  EXPECT_EQ(full.at("farCells"), 0);
}

TEST_F(ReportPageTest, NoSceneAtAll) {
  const json result = Exercise(ToPage(MakePageDocuments({})));
  ExpectSound(result);
  EXPECT_TRUE(result.at("tiles").empty());
  EXPECT_TRUE(result.at("scenes").empty());
}

TEST_F(ReportPageTest, WhatTheProgramWrites) {
  ASSERT_EQ(Run("run --contacts 50 --scenes bowl,pinball").m_nExit, 0);
  const json result = Exercise(Read("report.html"));
  ExpectSound(result);
  ASSERT_EQ(result.at("scenes").size(), 2u);
  for (const json& scene : result.at("scenes")) {
    SCOPED_TRACE(scene.at("name"));
    ExpectDrawn(scene.at("plots").at("error"), GetNames(true));
    ASSERT_TRUE(scene.contains("replay"));
    EXPECT_EQ(scene.at("worst").size(), GetEngineRows().size());
    EXPECT_EQ(scene.at("effects").size(), 7u * GetBackends().size());
    for (const json& worst : scene.at("worst"))
      EXPECT_GT(worst.at("frame").get<int>(), 0);
  }
}

// The controls: pages with a fault each, which has to be seen.

TEST_F(ReportPageTest, ControlBrokenData) {
  CPageDocuments sample = MakePageDocuments({"bowl"});
  const std::string run = sample.m_cRun.dump();
  const json result = Exercise(MakeHtml(run.substr(0, run.size() / 2), sample.m_cReplay.dump(), "{}"));
  EXPECT_GE(result.at("errors").size(), 1u);
  EXPECT_TRUE(Shows(result.at("errors").at(0), "\"error: "));
  EXPECT_FALSE(result.at("isDone").get<bool>());
  EXPECT_TRUE(Shows(result.at("text"), "cannot be shown"));
}

TEST_F(ReportPageTest, ControlSomethingIsFetched) {
  const std::string page = ToPage(MakePageDocuments({"bowl"}));
  const std::string picture = "<img alt='' src='http://example.invalid/picture.png'>";
  const json blocked = Exercise(Insert(page, "</body>", picture, false));
  ASSERT_EQ(blocked.at("errors").size(), 1u);
  EXPECT_TRUE(Shows(blocked.at("errors")[0], "blocked: img-src"));

  // Without the policy it is tried, and that is seen as well.
  std::string open = page;
  const std::string policy = "http-equiv=\"Content-Security-Policy\"";
  open.replace(open.find(policy), policy.size(), "name=\"none\"");
  EXPECT_EQ(Exercise(Insert(open, "</body>", picture, false)).at("resources").size(), 1u);
}

// Something that is too wide, letters that are too small or too pale, a label on another one, a sentence that
// is there twice, a word that is no figure, and an engine that is not drawn.
TEST_F(ReportPageTest, ControlAPageThatIsBroken) {
  const std::string style =
      "<style>.verdict { width: 200vw; max-width: none } .facts { font-size: 11px }"
      ".kicker { color: #999 !important } .label { transform: translate(0, 0) } "
      "#overall-chart .label[data-of=native] { transform: translate(40px, -330px) }</style>";
  CPageDocuments sample = MakePageDocuments({"bowl"});
  json& told = sample.m_cRun.at("scenes")[0];
  told.at("remarks")[0] = "This is a sentence that is told more than once.";
  told.at("remarks").push_back(told.at("remarks")[0]);
  told.at("verdict")[0] = "Native takes NaN ns.";
  for (json& row : sample.m_cRun.at("work_precision"))
    if (row.at("engine") == "box2d-tuned") row["direction_error_p95"] = nullptr;
  // Over the label of box2d, wherever that is.
  std::string& svg = sample.m_cCharts.at("overall")[0].get_ref<std::string&>();
  svg.replace(svg.rfind("</svg>"), 6,
              "<text x=\"74\" y=\"24\" font-size=\"12\" textLength=\"600\">over it</text></svg>");
  const json result = Exercise(Insert(ToPage(sample), "</head>", style, false));
  EXPECT_EQ(result.at("errors"), json::array());
  EXPECT_FALSE(result.at("overlaps").empty());
  const json& scene = result.at("scenes").at(0);
  EXPECT_FALSE(scene.at("cut").empty());
  EXPECT_EQ(scene.at("sizes").at(0), 11);
  EXPECT_LT(scene.at("text").at("contrast").get<double>(), g_fTextContrast);
  EXPECT_FALSE(scene.at("repeated").empty());
  EXPECT_EQ(scene.at("odd"), json({"NaN"}));
  EXPECT_EQ(scene.at("plots").at("error").at("box2d-tuned"), 0);
}

} // namespace
} // namespace Shapes::Compare
