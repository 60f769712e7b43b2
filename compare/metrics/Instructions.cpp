// SPDX-License-Identifier: MIT
#include "Instructions.h"

#include "Effects.h"
#include "app/Child.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <fstream>
#include <stdexcept>
#include <string_view>

namespace Shapes::Compare {
namespace {

// A program that takes longer than this will not end.
constexpr std::chrono::minutes g_cPatience(5);

// Callgrind writes a part at each end of PlayCounted, with the sum in a line "totals: N", and a last one at
// the end of the program.
std::vector<double> ReadTotals(const std::filesystem::path& file) {
  std::vector<double> totals;
  std::ifstream in(file);
  constexpr std::string_view mark = "totals: ";
  for (std::string line; std::getline(in, line);) {
    std::uint64_t n = 0;
    const char* const pEnd = line.data() + line.size();
    if (line.starts_with(mark) && std::from_chars(line.data() + mark.size(), pEnd, n).ec == std::errc())
      totals.push_back(static_cast<double>(n));
  }
  return totals;
}

// The program's own first line among those of valgrind.
std::string ReadFirstLine(const std::filesystem::path& errors) {
  std::ifstream in(errors);
  for (std::string line; std::getline(in, line);)
    if (!line.empty() && !line.starts_with("==")) return ": " + line;
  return "";
}

std::string Count(const std::string& valgrind, const CScene& scene, const std::vector<CEngine>& worlds,
                  const std::string& program, std::uint64_t seed, std::size_t steps,
                  const std::function<void()>& check, std::vector<double>& totals) {
  const CTemporaryFolder folder;
  const std::filesystem::path out = folder.GetPath() / "out", errors = folder.GetPath() / "errors";
  // Functions of shared libraries are found at the start and not when they are first called: the first
  // world would pay for all.
  std::vector<std::string> words{"/usr/bin/env",
                                 "LD_BIND_NOW=1",
                                 valgrind,
                                 "--tool=callgrind",
                                 "--toggle-collect=Shapes::Compare::CGame::Step*",
                                 "--dump-after=Shapes::Compare::PlayCounted*",
                                 "--combine-dumps=yes",
                                 "--callgrind-out-file=" + out.string(),
                                 program,
                                 "step-cost",
                                 scene.m_cPath.string(),
                                 std::to_string(seed),
                                 std::to_string(steps)};
  for (const CEngine& world : worlds)
    words.push_back(ToWord(world));
  const auto start = std::chrono::steady_clock::now();
  struct CTooLong {};
  try {
    const std::string end = RunProgram(words, errors, [&] {
      check();
      if (std::chrono::steady_clock::now() - start > g_cPatience) throw CTooLong();
    });
    if (!end.empty()) return "valgrind failed with " + end + ReadFirstLine(errors);
  } catch (const CTooLong&) {
    return "valgrind did not end";
  }
  totals = ReadTotals(out);
  // Without its names a program counts nothing.
  if (totals.size() <= worlds.size() || totals.front() == 0.0) return "valgrind counted nothing";
  totals.erase(totals.begin()); // the one that is played to warm up
  return "";
}

} // namespace

CInstructions CountInstructions(const CScene& scene, const std::vector<CEngine>& worlds,
                                const std::string& program, std::uint64_t seed, std::size_t steps,
                                const std::function<void()>& check) {
  const auto valgrind = FindProgram("valgrind");
  if (!valgrind) return {{}, "valgrind is not there"};
  CInstructions counted;
  std::vector<double> totals;
  try {
    counted.m_sWhyNot = Count(valgrind->string(), scene, worlds, program, seed, steps, check, totals);
  } catch (const std::runtime_error& e) {
    counted.m_sWhyNot = e.what();
  }
  if (!counted.m_sWhyNot.empty()) return counted;
  for (std::size_t i = 0; i < worlds.size(); ++i)
    counted.m_stdPerBallStep.push_back(totals[i] / static_cast<double>(steps * scene.m_stdBalls.size()));
  return counted;
}

std::string ToWord(const CEngine& world) {
  for (const eEffect e : g_stdEffects) {
    if (world.m_cEffects.m_cForced.Has(e)) return world.m_sName + "+" + std::string(GetName(e));
    if (world.m_cEffects.m_cForbidden.Has(e)) return world.m_sName + "~" + std::string(GetName(e));
  }
  return world.m_sName;
}

CEngine FromWord(const std::string& word) {
  for (CEngine engine : GetEngines()) {
    engine.m_cEffects = g_cAutomatic;
    if (word == engine.m_sName) return engine;
    for (const eEffect e : g_stdEffects)
      for (const bool forced : {true, false})
        if (const CEngine world = WithEffect(engine, e, forced); word == ToWord(world)) return world;
  }
  throw std::invalid_argument("there is no world '" + word + "'");
}

void PlayStepCost(const CScene& scene, std::span<const std::string> words, std::uint64_t seed,
                  std::size_t steps) {
  // The memory that the first one asks the system for is there for those after it: one more is played before.
  PlayCounted(scene, FromWord(words.front()), seed, steps);
  for (const std::string& word : words)
    PlayCounted(scene, FromWord(word), seed, steps);
}

void PlayCounted(const CScene& scene, const CEngine& world, std::uint64_t seed, std::size_t steps) {
  std::size_t left = steps;
  for (std::uint64_t trial = 0; left > 0; ++trial) {
    CGame game(scene, world, MakeStart(scene, seed, trial));
    const std::size_t n = std::min(left, GetStepsPerTrial(scene));
    for (std::size_t i = 0; i < n; ++i)
      game.Step();
    left -= n;
  }
}

} // namespace Shapes::Compare
