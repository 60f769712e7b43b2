// SPDX-License-Identifier: MIT
#include "Child.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <thread>

extern char** environ;

namespace Shapes::Compare {
namespace {

constexpr std::chrono::milliseconds g_cPollInterval(10); // between two looks

// Kills what still runs.
class CProcess {
public:
  explicit CProcess(pid_t id) : m_nId(id) {}
  ~CProcess() {
    if (m_nId <= 0) return;
    kill(m_nId, SIGKILL);
    waitpid(m_nId, nullptr, 0);
  }
  CProcess(const CProcess&) = delete;
  CProcess& operator=(const CProcess&) = delete;

  std::optional<int> GetStatus() {
    int status = 0;
    if (waitpid(m_nId, &status, WNOHANG) != m_nId) return std::nullopt;
    m_nId = -1;
    return status;
  }

private:
  pid_t m_nId;
};

pid_t Start(const std::vector<std::string>& words, const std::filesystem::path& errors) {
  std::vector<char*> arguments;
  for (const std::string& word : words)
    arguments.push_back(const_cast<char*>(word.c_str())); // posix_spawn writes to none of them
  arguments.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDERR_FILENO, errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  pid_t id = -1;
  const int error = posix_spawn(&id, words.at(0).c_str(), &files, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&files);
  if (error != 0) throw std::runtime_error(words[0] + ": cannot be started (" + std::strerror(error) + ")");
  return id;
}

} // namespace

std::optional<std::filesystem::path> FindProgram(const std::string& name) {
  const char* pPath = std::getenv("PATH");
  for (std::string_view rest = pPath == nullptr ? "" : pPath; !rest.empty();) {
    const std::size_t end = std::min(rest.find(':'), rest.size());
    const std::filesystem::path file = std::filesystem::path(rest.substr(0, end)) / name;
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error) && access(file.c_str(), X_OK) == 0) return file;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return std::nullopt;
}

std::string RunProgram(const std::vector<std::string>& words, const std::filesystem::path& errors,
                       const std::function<void()>& check) {
  CProcess process(Start(words, errors));
  for (;;) {
    if (const auto status = process.GetStatus()) {
      if (WIFSIGNALED(*status)) return "signal " + std::to_string(WTERMSIG(*status));
      const int code = WEXITSTATUS(*status);
      return code == 0 ? "" : "exit code " + std::to_string(code);
    }
    check();
    std::this_thread::sleep_for(g_cPollInterval);
  }
}

void StartProgram(const std::vector<std::string>& words) { Start(words, "/dev/null"); }

CTemporaryFolder::CTemporaryFolder() {
  std::string name = (std::filesystem::temp_directory_path() / "shapes-compare-XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(name + ": cannot be made (" + std::strerror(errno) + ")");
  m_cPath = name;
}

CTemporaryFolder::~CTemporaryFolder() {
  std::error_code error;
  std::filesystem::remove_all(m_cPath, error);
}

} // namespace Shapes::Compare
