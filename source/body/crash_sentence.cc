#include <deal.II/base/exceptions.h>

#include <setsudan/body/crash_sentence.h>

#include <array>
#include <cstdlib>

#include <unistd.h>

namespace Setsudan
{
namespace
{
constexpr std::array<int, 4> crash_signals = {
  {SIGSEGV, SIGBUS, SIGFPE, SIGABRT}};

constexpr std::size_t handler_stack_size = 1 << 16;

// A handler has no other way to its data, and may not allocate memory.
std::string last_words;

void
say_last_words(const int)
{
  const auto written =
    write(STDERR_FILENO, last_words.data(), last_words.size());
  (void)written; // There is nobody left to be told of a failure.
  _exit(EXIT_FAILURE);
}
} // namespace


CrashSentence::CrashSentence(const std::string &sentence)
  : handler_stack(handler_stack_size)
  , earlier_actions(crash_signals.size())
{
  Assert(last_words.empty(), dealii::ExcMessage("One crash at a time."));
  last_words    = "setsudan: " + sentence + "\n";
  stack_t stack = {};
  stack.ss_sp   = handler_stack.data();
  stack.ss_size = handler_stack.size();
  sigaltstack(&stack, &earlier_stack);
  struct sigaction action = {};
  action.sa_handler       = say_last_words;
  action.sa_flags         = SA_ONSTACK;
  for (unsigned int i = 0; i < crash_signals.size(); ++i)
    sigaction(crash_signals[i], &action, &earlier_actions[i]);
}



CrashSentence::~CrashSentence()
{
  for (unsigned int i = 0; i < crash_signals.size(); ++i)
    sigaction(crash_signals[i], &earlier_actions[i], nullptr);
  sigaltstack(&earlier_stack, nullptr);
  last_words.clear();
}
} // namespace Setsudan
