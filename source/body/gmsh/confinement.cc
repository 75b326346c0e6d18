// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/confinement.h>

#include <cerrno>
#include <memory>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>

namespace Setsudan
{
namespace
{
/** Rules for calls of the system, which a filter is made of. */
class Filter
{
public:
  Filter()
    : context(seccomp_init(SCMP_ACT_ALLOW), seccomp_release)
    , is_complete(context != nullptr)
  {
  }

  void
  add(const std::uint32_t action, const int call)
  {
    is_complete =
      is_complete && seccomp_rule_add(context.get(), action, call, 0) == 0;
  }

  /** A rule for calls with an argument of which the bits `mask` are `bits`. */
  void
  add(const std::uint32_t action,
      const int call,
      const unsigned int argument,
      const scmp_datum_t mask,
      const scmp_datum_t bits)
  {
    const scmp_arg_cmp condition = {argument, SCMP_CMP_MASKED_EQ, mask, bits};
    is_complete =
      is_complete &&
      seccomp_rule_add_array(context.get(), action, call, 1, &condition) == 0;
  }

  bool
  load() const
  {
    return is_complete && seccomp_load(context.get()) == 0;
  }

private:
  const std::unique_ptr<void, decltype(&seccomp_release)> context;
  bool is_complete;
};

void
deny_commands(Filter &filter)
{
  for (const int call :
       {SCMP_SYS(execve), SCMP_SYS(execveat), SCMP_SYS(fork), SCMP_SYS(vfork)})
    filter.add(SCMP_ACT_KILL_PROCESS, call);
  // gmsh says nothing where directories cannot be made, and tries for long to
  // reach a server.
  for (const int call : {SCMP_SYS(mkdir),
                         SCMP_SYS(mkdirat),
                         SCMP_SYS(socket),
                         SCMP_SYS(socketpair),
                         SCMP_SYS(connect)})
    filter.add(SCMP_ACT_KILL_PROCESS, call);
  // Threads are made by the same call as processes. The arguments of clone3 are
  // out of the filter's sight; without it, the C library takes clone.
  filter.add(SCMP_ACT_KILL_PROCESS, SCMP_SYS(clone), 0, CLONE_THREAD, 0);
  filter.add(SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3));
}

void
deny_changes(Filter &filter)
{
  const std::uint32_t refuse = SCMP_ACT_ERRNO(EROFS);
  for (const int flag : {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC})
    {
      filter.add(refuse, SCMP_SYS(open), 1, flag, flag);
      filter.add(refuse, SCMP_SYS(openat), 2, flag, flag);
    }
  for (const int call :
       {SCMP_SYS(creat),    SCMP_SYS(openat2),   SCMP_SYS(truncate),
        SCMP_SYS(unlink),   SCMP_SYS(unlinkat),  SCMP_SYS(rename),
        SCMP_SYS(renameat), SCMP_SYS(renameat2), SCMP_SYS(rmdir),
        SCMP_SYS(mknod),    SCMP_SYS(mknodat),   SCMP_SYS(link),
        SCMP_SYS(linkat),   SCMP_SYS(symlink),   SCMP_SYS(symlinkat),
        SCMP_SYS(chmod),    SCMP_SYS(fchmodat),  SCMP_SYS(chown),
        SCMP_SYS(lchown),   SCMP_SYS(fchownat),  SCMP_SYS(utimensat),
        SCMP_SYS(setxattr), SCMP_SYS(ptrace),    SCMP_SYS(io_uring_setup)})
    filter.add(refuse, call);
}
} // namespace


bool
confine_process()
{
  Filter filter;
  deny_commands(filter);
  deny_changes(filter);
  return filter.load();
}
} // namespace Setsudan
