// SPDX-License-Identifier: LGPL-2.1-or-later
#pragma once

/** What this process has sent through MPI since the program began, counted
 * between the libraries and MPI by its profiling interface. */
struct MessageCount
{
  /** Messages from one process to another. */
  double messages = 0;
  double bytes    = 0;
  /** Operations in which all processes take part. */
  double collectives = 0;
};

const MessageCount &
message_count();
