#pragma once

#include <csignal>
#include <string>
#include <vector>

namespace Setsudan
{
/**
 * What the program says, as its last words, where a library crashes on a file
 * as long as the object lives: without it a segmentation fault or an abort
 * would end the program without a sentence. There can be one at a time.
 */
class CrashSentence
{
public:
  /** @param sentence with its full stop and without the program's name. */
  explicit CrashSentence(const std::string &sentence);

  CrashSentence(const CrashSentence &) = delete;

  /** What a crash did before it does again. */
  ~CrashSentence();

private:
  /** A stack that has overflowed has no room for the handler. */
  std::vector<char> handler_stack;
  stack_t earlier_stack = {};
  std::vector<struct sigaction> earlier_actions;
};
} // namespace Setsudan
