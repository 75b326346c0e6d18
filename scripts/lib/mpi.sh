# SPDX-License-Identifier: LGPL-2.1-or-later
# The environment of a run. Open MPI refuses to start as root, which is what a
# container's user is, unless told twice.
if [ "$(id -u)" -eq 0 ]; then
  export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
fi
# More processes than cores is a test's normal case: let those that wait yield.
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_mpi_yield_when_idle=1
# Busy waiting makes solves many times slower on a shared core.
export OMP_WAIT_POLICY=passive
export OPENBLAS_THREAD_TIMEOUT=${OPENBLAS_THREAD_TIMEOUT:-4}
