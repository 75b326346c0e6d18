// SPDX-License-Identifier: LGPL-2.1-or-later
// The grammar of values: lists, items with keys, numbers.

#include <setsudan/parameters/lists.h>

#include <limits>

#include "../test_setup.h"
#include "check.h"

using namespace Setsudan;

void
test_split()
{
  for (const std::string &text : {"a, b ,c", "one", "", " , ", "a,,b,", "a; b"})
    {
      std::cout << "'" << text << "':";
      for (const auto &part : split(text, ','))
        std::cout << " [" << part << "]";
      std::cout << std::endl;
    }
  for (const std::string &text :
       {"top : 1, 2; left:3", "y", ":1", "y:1:2", " ; "})
    {
      std::cout << "'" << text << "':";
      for (const auto &item : split_items(text, ';'))
        std::cout << " [" << item.first << "] is [" << item.second << "]";
      std::cout << std::endl;
    }
}


void
test_numbers()
{
  for (const std::string &text :
       {"1, -2.5e1 ,+3", "", "7", "1 2", "1, two", "0:1", "1,5.5.5"})
    {
      std::vector<double> values(1, 99.);
      std::cout << "'" << text << "':";
      if (parse_numbers(text, values))
        for (const double value : values)
          std::cout << " " << value;
      else
        std::cout << " no numbers";
      std::cout << std::endl;
    }
}


void
test_short_text()
{
  // numdiff takes texts for numbers, and would not see a digit too many.
  check("0.1", short_text(0.1) == "0.1");
  check("10", short_text(10) == "10");
  check("-2.5", short_text(-2.5) == "-2.5");
  check("1e-30", short_text(1e-30) == "1e-30");
  check("1234567", short_text(1234567.) == "1234567");
  check("0.30000000000000004", short_text(0.1 + 0.2) == "0.30000000000000004");
  bool same = true;
  for (const double value :
       {1. / 3, 2e300 / 3, 1e-300 / 7, std::numeric_limits<double>::max()})
    same = same && std::stod(short_text(value)) == value;
  check("read back as the same", same);
}


int
main(int argc, char **argv)
{
  return run_test(argc, argv, [] {
    test_split();
    test_numbers();
    test_short_text();
  });
}
