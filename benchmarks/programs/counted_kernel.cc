// SPDX-License-Identifier: LGPL-2.1-or-later
#include "counted_kernel.h"

#include <vector>

namespace
{
double n_operations = 0;

struct CountedNumber
{
  double value;

  double &
  operator[](int)
  {
    return value;
  }

  double
  operator[](int) const
  {
    return value;
  }
};


CountedNumber
counted(const double value)
{
  ++n_operations;
  return {value};
}


CountedNumber
operator+(const CountedNumber a, const CountedNumber b)
{
  return counted(a.value + b.value);
}


CountedNumber
operator-(const CountedNumber a, const CountedNumber b)
{
  return counted(a.value - b.value);
}


/** This is how the kernel makes all lanes the same, which is no operation. */
CountedNumber
operator-(const double a, const CountedNumber)
{
  return {a};
}


CountedNumber
operator+(const CountedNumber a, const double b)
{
  return counted(a.value + b);
}


CountedNumber
operator-(const CountedNumber a, const double b)
{
  return counted(a.value - b);
}


CountedNumber
operator*(const CountedNumber a, const CountedNumber b)
{
  return counted(a.value * b.value);
}


/** To take a number as it is, or not at all, is no operation. */
CountedNumber
operator*(const double a, const CountedNumber b)
{
  if (a == 0 || a == 1 || a == -1)
    return {a * b.value};
  return counted(a * b.value);
}


CountedNumber
operator/(const double a, const CountedNumber b)
{
  return counted(a / b.value);
}


CountedNumber
operator-(const CountedNumber a)
{
  return {-a.value};
}


CountedNumber &
operator+=(CountedNumber &a, const CountedNumber b)
{
  return a = a + b;
}


CountedNumber &
operator-=(CountedNumber &a, const CountedNumber b)
{
  return a = a - b;
}
} // namespace


#define SETSUDAN_KIND counted
#define SETSUDAN_LANES 1
#define SETSUDAN_LANE_TYPE CountedNumber
#include "../../source/kernel/batch_kernel.cc"


double
counted_operations(const Setsudan::CellBatch &batch)
{
  // Only the number of the nodes counts, not where they are.
  std::vector<unsigned int> nodes(27, 0);
  std::vector<double> gradients(27 * 9, 1.), moduli(2, 1.), u(3, 1.), f(3, 0.);
  const Setsudan::CellBatch one{nodes.data(),
                                gradients.data(),
                                moduli.data(),
                                nullptr,
                                batch.is_uniform,
                                1};
  n_operations = 0;
  Setsudan::counted::kernel<3>().apply_serendipity(one, u.data(), f.data());
  return n_operations;
}
