// SPDX-License-Identifier: MIT
// The games of the playground in a terminal, played by a script: for tests, and for people without the page.
#include "../games/Drawing.h"
#include "../games/Game.h"

#include <algorithm>
#include <fstream>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

using namespace Shapes::Games;

namespace {

const char* const g_pHelp = R"(shapes-pinball [OPTION VALUE]...
  --frames N       frames of 1/60 s to play (3600)
  --seed S         of the scripted player and of what is random (1)
  --game NAME      pinball, pile, billiard or breakout (pinball)
  --press N        the action key in every N-th frame, besides what the player does (0: never)
  --engine NAME    native, native-approximate, box2d or box2d-tuned (native)
  --trace FILE     a line for each frame: frame, score, and the bits of the positions and velocities of the balls
  --svg FILE       the last frame as a picture
)";

struct COptions {
  unsigned m_nFrames = 3600, m_nSeed = 1, m_nPress = 0;
  std::string m_sGame = "pinball", m_sEngine = "native", m_sTrace, m_sSvg;
};

unsigned ReadNumber(const std::string& option, const std::string& text) {
  const bool isNumber = !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
  if (!isNumber || text.size() > 9)
    throw std::invalid_argument(option + " is '" + text + "': expected a whole number from 0 to 999999999");
  return static_cast<unsigned>(std::stoul(text));
}

COptions Read(const std::vector<std::string>& arguments) {
  COptions options;
  for (std::size_t i = 0; i < arguments.size(); i += 2) {
    const std::string& option = arguments[i];
    if (i + 1 == arguments.size()) throw std::invalid_argument(option + " has no value");
    const std::string& value = arguments[i + 1];
    if (option == "--frames")
      options.m_nFrames = ReadNumber(option, value);
    else if (option == "--seed")
      options.m_nSeed = ReadNumber(option, value);
    else if (option == "--press")
      options.m_nPress = ReadNumber(option, value);
    else if (option == "--game")
      options.m_sGame = value;
    else if (option == "--engine")
      options.m_sEngine = value;
    else if (option == "--trace")
      options.m_sTrace = value;
    else if (option == "--svg")
      options.m_sSvg = value;
    else
      throw std::invalid_argument("there is no option '" + option + "'");
  }
  return options;
}

// A full disk may show only when the file is closed.
void Close(std::ofstream& file, const std::string& path) {
  file.close();
  if (!file) throw std::runtime_error("cannot write " + path);
}

std::ofstream Open(const std::string& path) {
  std::ofstream file(path);
  if (!file) throw std::invalid_argument("cannot write " + path);
  return file;
}

void Run(const COptions& options) {
  std::unique_ptr<CGame> pGame;
  for (const CMode& mode : g_stdModes)
    if (mode.m_pName == options.m_sEngine) pGame = MakeGame(options.m_sGame, mode, options.m_nSeed);
  if (!pGame)
    throw std::invalid_argument("--game " + options.m_sGame + " --engine " + options.m_sEngine +
                                ": no such game or engine here");
  std::ofstream trace;
  if (!options.m_sTrace.empty()) trace = Open(options.m_sTrace);
  for (unsigned i = 0; i < options.m_nFrames; ++i) {
    const bool isPressed = options.m_nPress > 0 && i % options.m_nPress == 0;
    pGame->Frame(pGame->Play() | (isPressed ? g_nAction : 0u));
    if (trace.is_open()) trace << pGame->GetTrace() << '\n';
  }
  if (trace.is_open()) Close(trace, options.m_sTrace);
  if (!options.m_sSvg.empty()) {
    std::ofstream svg = Open(options.m_sSvg);
    svg << ToSvg(*pGame);
    Close(svg, options.m_sSvg);
  }
  std::cout << options.m_sGame << " on " << options.m_sEngine << ": " << pGame->GetFrame() << " frames, "
            << pGame->GetScore() << " points, " << pGame->GetLost() << " balls lost by the engine\n"
            << pGame->GetStatus() << '\n';
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const bool asksForHelp = std::any_of(arguments.begin(), arguments.end(), [](const std::string& text) {
    return text == "--help" || text == "-h";
  });
  try {
    if (asksForHelp)
      std::cout << g_pHelp;
    else
      Run(Read(arguments));
    if (!std::cout.flush()) throw std::runtime_error("cannot write to the standard output");
  } catch (const std::exception& error) {
    std::cerr << "shapes-pinball: " << error.what() << '\n' << g_pHelp;
    return 2;
  }
}
