// SPDX-License-Identifier: LGPL-2.1-or-later
// The table of statistics.csv's columns in doc/results.md: the expected output
// is that table, and `scripts/document` writes both.

#include <setsudan/output/tables/statistics_columns.h>

#include <iostream>

int
main()
{
  Setsudan::document_columns(std::cout);
  return 0;
}
