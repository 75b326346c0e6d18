// SPDX-License-Identifier: LGPL-2.1-or-later
#include <setsudan/body/gmsh/confinement.h>

#include <cerrno>
#include <memory>
#include <vector>

#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>

namespace Setsudan
{
bool
confine_process()
{
  const std::unique_ptr<void, decltype(&seccomp_release)> filter(
    seccomp_init(SCMP_ACT_ALLOW), seccomp_release);
  bool is_complete = filter != nullptr;
  // A rule for calls of the system, which can have conditions.
  const auto add = [&](const std::uint32_t action,
                       const int call,
                       const std::vector<scmp_arg_cmp> &conditions = {}) {
    is_complete =
      is_complete &&
      seccomp_rule_add_array(
        filter.get(), action, call, conditions.size(), conditions.data()) == 0;
  };

  // gmsh says nothing where directories cannot be made, and tries for long to
  // reach a server.
  for (const int call : {SCMP_SYS(execve),
                         SCMP_SYS(execveat),
                         SCMP_SYS(fork),
                         SCMP_SYS(vfork),
                         SCMP_SYS(mkdir),
                         SCMP_SYS(mkdirat),
                         SCMP_SYS(socket),
                         SCMP_SYS(socketpair),
                         SCMP_SYS(connect)})
    add(SCMP_ACT_KILL_PROCESS, call);
  // Threads are made by the same call as processes. The arguments of clone3 are
  // out of the filter's sight; without it, the C library takes clone.
  add(SCMP_ACT_KILL_PROCESS,
      SCMP_SYS(clone),
      {{0, SCMP_CMP_MASKED_EQ, CLONE_THREAD, 0}});
  add(SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3));

  const std::uint32_t refuse = SCMP_ACT_ERRNO(EROFS);
  for (const scmp_datum_t flag : {O_WRONLY, O_RDWR, O_CREAT, O_TRUNC})
    {
      add(refuse, SCMP_SYS(open), {{1, SCMP_CMP_MASKED_EQ, flag, flag}});
      add(refuse, SCMP_SYS(openat), {{2, SCMP_CMP_MASKED_EQ, flag, flag}});
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
    add(refuse, call);
  return is_complete && seccomp_load(filter.get()) == 0;
}
} // namespace Setsudan
