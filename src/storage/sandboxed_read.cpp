#include "storage/sandboxed_read.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <string>

#include "model/errors.hpp"

namespace zenosphere {
namespace {

constexpr std::int64_t mebibyte = 1'048'576;

/// How the copy tells its end.
enum Ending : std::uint8_t { went_well = 0, refused = 10, too_large = 11, failed = 12 };

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define ZENOSPHERE_IS_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define ZENOSPHERE_IS_SANITIZED
#endif
#endif

/// Address space that this process has now, bytes.
std::int64_t address_space() {
  long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%ld", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return pages * sysconf(_SC_PAGESIZE);
}

void limit(__rlimit_resource resource, std::int64_t most) {
  const auto value = static_cast<rlim_t>(most);
  const rlimit soft_and_hard{value, value + 2};  // seconds between SIGXCPU and SIGKILL
  setrlimit(resource, &soft_and_hard);
}

/// What the copy may take and do.
void confine(std::int64_t bytes) {
  limit(RLIMIT_CORE, 0);
  limit(RLIMIT_FSIZE, 0);
  limit(RLIMIT_CPU, 2 + bytes / (32 * mebibyte));
#ifndef ZENOSPHERE_IS_SANITIZED  // sanitizers map terabytes
  limit(RLIMIT_AS, address_space() + 256 * mebibyte + 4 * bytes);
#endif
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
  const itimerval soon{{0, 0}, {0, 250'000}};  // many inputs make HDF5 spin
  setitimer(ITIMER_PROF, &soon, nullptr);
#endif
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGXFSZ}) {
    std::signal(signal, SIG_DFL);
  }
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);  // last words of a crashing library
}

[[noreturn]] void read_in_copy(std::int64_t bytes, const std::function<void()>& reading,
                               int messages) {
  confine(bytes);
  Ending ending = went_well;
  try {
    reading();
  } catch (const InputError& error) {
    const std::size_t length = std::strlen(error.what());
    ending = write(messages, error.what(), length) < 0 ? failed : refused;
  } catch (const std::bad_alloc&) {
    ending = too_large;
  } catch (...) {
    ending = failed;
  }
  _exit(ending);
}

/// Everything that the copy writes until it ends.
std::string message_from(int messages) {
  std::string message;
  std::array<char, 4096> block{};
  for (;;) {
    const ssize_t count = read(messages, block.data(), block.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return message;
    message.append(block.data(), static_cast<std::size_t>(count));
  }
}

int status_of(pid_t copy) {
  int status = 0;
  while (waitpid(copy, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

/// Why a copy that did not end by itself was ended, or what it could not do.
std::string reason_of(int status) {
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU) return "reading it takes too long";
  if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL) return "reading it was stopped";
  if (WIFEXITED(status) && WEXITSTATUS(status) == too_large)
    return "reading it takes too much memory";
  return "HDF5 fails while it reads it";
}

}  // namespace

void sandboxed_read(const std::filesystem::path& path, std::int64_t bytes,
                    const std::function<void()>& reading) {
  std::array<int, 2> ends{-1, -1};
  const pid_t copy = pipe2(ends.data(), O_CLOEXEC) == 0 ? fork() : -1;
  if (copy == 0) read_in_copy(bytes, reading, ends[1]);
  const int failure = errno;
  close(ends[1]);
  const std::string message = copy > 0 ? message_from(ends[0]) : "";
  close(ends[0]);
  if (copy < 0) {
    throw InputError(fmt::format("{}: cannot be read safely (no process for it: {}); try again",
                                 path.string(), std::strerror(failure)));
  }
  const int status = status_of(copy);
  if (WIFEXITED(status) && WEXITSTATUS(status) == went_well) return;
  if (WIFEXITED(status) && WEXITSTATUS(status) == refused) {
#ifdef FUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION
    return;  // the fuzzer sees what this process runs through, refusals too
#endif
    throw InputError(message);
  }
  throw InputError(
      fmt::format("{}: cannot be read ({}); it is damaged", path.string(), reason_of(status)));
}

}  // namespace zenosphere
