// SPDX-License-Identifier: MIT
#include "Options.h"

#include "NearMatches.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace Shapes::Compare {
namespace {

template <class T>
std::vector<T> Select(std::vector<T> all, std::span<const std::string> names, std::string_view what) {
  std::vector<std::string> known;
  for (const T& item : all)
    known.push_back(item.m_sName);
  for (const std::string& name : names)
    if (std::find(known.begin(), known.end(), name) == known.end())
      throw std::invalid_argument(UnknownName(what, name, known));
  if (!names.empty())
    std::erase_if(all, [&](const T& item) {
      return std::find(names.begin(), names.end(), item.m_sName) == names.end();
    });
  return all;
}

} // namespace

std::vector<CScene> SelectScenes(std::vector<CScene> all, std::span<const std::string> names) {
  return Select(std::move(all), names, "scene");
}

std::vector<CEngine> SelectEngines(std::vector<CEngine> all, std::span<const std::string> names) {
  return Select(std::move(all), names, "engine");
}

std::string JoinCommand(std::span<const std::string> words) {
  constexpr std::string_view plain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./=,:+@%";
  std::string command;
  for (const std::string& word : words) {
    if (!command.empty()) command += ' ';
    if (!word.empty() && word.find_first_not_of(plain) == word.npos) {
      command += word;
      continue;
    }
    command += '\'';
    for (const char c : word)
      c == '\'' ? command += "'\\''" : command += c;
    command += '\'';
  }
  return command;
}

} // namespace Shapes::Compare
