// SPDX-License-Identifier: LGPL-2.1-or-later
// Checks whose outcome is printed, for numdiff to see.
#pragma once

#include <setsudan/parameters/scene_file.h>

#include <functional>
#include <iostream>
#include <string>

/** Print `name`, and whether it holds. */
inline void
check(const std::string &name, const bool holds)
{
  std::cout << name << ": " << (holds ? "yes" : "FAILED") << std::endl;
}

/** Print the message with which `action` refuses a scene. */
inline void
print_refusal(const std::function<void()> &action)
{
  try
    {
      action();
      std::cout << "FAILED: accepted" << std::endl;
    }
  catch (const Setsudan::SceneError &error)
    {
      std::cout << error.what() << std::endl;
    }
}
