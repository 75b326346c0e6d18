#pragma once

#include <stdexcept>

namespace Setsudan
{
/** A body's file cannot be used; the message says what is wrong with it. */
class BodyFileError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace Setsudan
